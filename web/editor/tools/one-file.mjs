// build/editor.html: the editor as one file, which works from disk.
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { build } from "vite";
import { hashOf, intoHead, policyTag } from "./policy.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

/** src/engine/host.file.ts in the place of host.ts. */
const hostPlugin = {
  name: "host-of-one-file",
  enforce: "pre",
  resolveId: (id) => (/\/host\.js$/.test(id) ? here("../src/engine/host.file.ts") : null),
};

/** A script as the content of an element: what would end or nest it is written otherwise. */
const inScript = (text) => text.replace(/<\/(script)/gi, "<\\/$1").replace(/<!--/g, "<\\!--");

const iconUri = () => {
  const text = readFileSync(here("../public/icon.svg"), "utf8").replace(/\s*\n\s*/g, " ").trim();
  return `data:image/svg+xml,${encodeURIComponent(text)}`;
};

function contentOf(output) {
  const code = output.filter(({ type }) => type === "chunk");
  const styles = output.filter(({ fileName }) => fileName.endsWith(".css"));
  const others = output.filter(({ type, fileName }) => type === "asset" && !/\.(css|html)$/.test(fileName));
  const names = [...code.slice(1), ...others].map(({ fileName }) => fileName);
  if (names.length > 0) throw new Error(`the one file would need others: ${names.join(", ")}`);
  return { script: `\n${inScript(code[0].code)}`, style: styles.map(({ source }) => String(source)).join("\n") };
}

/** @param module path of sfumato.wasm */
function pageOf({ script, style }, module) {
  const policy = policyTag(hashOf(script), hashOf(style));
  const packed = gzipSync(readFileSync(module), { level: 9 }).toString("base64");
  const body = `<script type="application/octet-stream" id="sfumato-module">${packed}</script>`;
  const icon = `<link rel="icon" href="${iconUri()}" />`;
  return intoHead(readFileSync(here("../index.html"), "utf8"), policy)
    .replace("</head>", () => `  ${icon}\n    <style>${style}</style>\n  </head>`)
    .replace(/<script type="module" src="[^"]*"><\/script>/, () => `${body}\n    <script type="module">${script}</script>`);
}

/** @param file where it goes */
export async function buildOneFile(file, module) {
  const { output } = await build({
    configFile: here("../vite.config.ts"),
    logLevel: "warn",
    plugins: [hostPlugin],
    publicDir: false,
    worker: { format: "iife" },
    build: {
      write: false,
      cssCodeSplit: false,
      assetsInlineLimit: Number.MAX_SAFE_INTEGER,
      rolldownOptions: { output: { codeSplitting: false } },
    },
  });
  writeFileSync(file, pageOf(contentOf(output), module));
}
