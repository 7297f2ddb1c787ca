// build/editor.html: the editor as one file, which works from disk.
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { build } from "vite";
import { hashOf, inlineScripts, intoHead, policyTag } from "./policy.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

/** src/engine/host.file.ts in the place of host.ts. */
const hostPlugin = {
  name: "host-of-one-file",
  enforce: "pre",
  resolveId: (id) => (/\/host\.js$/.test(id) ? here("../src/engine/host.file.ts") : null),
};

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
  return { script: code[0].code, style: styles.map(({ source }) => String(source)).join("\n") };
}

/** An element that holds bytes, packed. */
function packedElement(id, content) {
  const packed = gzipSync(content, { level: 9 }).toString("base64");
  return `<script type="application/octet-stream" id="${id}">${packed}</script>`;
}

/** @param module path of sfumato.wasm */
function pageOf({ script, style }, module) {
  const page = readFileSync(here("../index.html"), "utf8");
  const unpack = `\n${readFileSync(here("unpack.js"), "utf8")}`;
  const policy = policyTag([...inlineScripts(page), unpack, script].map(hashOf).join(" "), hashOf(style));
  const icon = `<link rel="icon" href="${iconUri()}" />`;
  const elements = [
    packedElement("packed-style", style),
    packedElement("packed-script", script),
    packedElement("sfumato-module", readFileSync(module)),
    `<script type="module">${unpack}</script>`,
  ];
  return intoHead(page, policy)
    .replace("</head>", () => `  ${icon}\n  </head>`)
    .replace(/<script type="module" src="[^"]*"><\/script>/, () => elements.join("\n    "));
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
