// build/editor.html: the editor as one file, which works from disk.
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { build } from "vite";
import { licencesPlugin } from "./licences.mjs";
import { packedElement } from "./pack.mjs";
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

/** The script that unpacks the others. */
async function unpackScript(module) {
  const { output } = await build({
    configFile: false,
    logLevel: "warn",
    plugins: [licencesPlugin(module)],
    worker: { format: "iife" },
    build: { write: false, target: "es2022", modulePreload: false, rolldownOptions: { input: here("unpack.ts") } },
  });
  return output[0].code.trim();
}

const utf8 = '<meta charset="utf-8" />';
/** Browsers look for it in the first kilobyte. */
const byteForCharacter = '<meta charset="windows-1252" />';

/** Replaces a part of a page by bytes. */
function withBytes(page, part, bytes) {
  if (/[^\0-\x7f]/.test(page)) throw new Error("the page beside its packed parts must be ASCII");
  const [before, after] = page.split(part);
  return Buffer.concat([Buffer.from(before), ...bytes, Buffer.from(after)]);
}

/** @param module path of sfumato.wasm */
async function pageOf({ script, style }, module) {
  const page = readFileSync(here("../index.html"), "utf8").replace(`    ${utf8}\n`, "");
  const unpack = await unpackScript(module);
  const policy = policyTag([...inlineScripts(page), unpack, script].map(hashOf).join(" "), hashOf(style));
  const icon = `<link rel="icon" href="${iconUri()}" />`;
  const frame = intoHead(page, `${byteForCharacter}\n    ${policy}`)
    .replace("</head>", () => `  ${icon}\n  </head>`)
    .replace(/<script type="module" src="[^"]*"><\/script>/, () => `{{packed}}<script type="module">${unpack}</script>`);
  return withBytes(frame, "{{packed}}", [
    packedElement("packed-style", style),
    packedElement("packed-script", script),
    packedElement("sfumato-module", readFileSync(module)),
  ]);
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
  writeFileSync(file, await pageOf(contentOf(output), module));
}
