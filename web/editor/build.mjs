// Makes build/editor/ and build/editor.html of this folder and sfumato.wasm, and says how large they are.
// Run it by `npm run build`; `make editor` installs and builds what it needs before.
import { mkdirSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { brotliCompressSync, gzipSync } from "node:zlib";
import { buildOneFile } from "./tools/one-file.mjs";
import { buildSite } from "./tools/site.mjs";

const path = (relative) => fileURLToPath(new URL(relative, import.meta.url));
const module = process.env.SFUMATO_WASM ?? path("../../build-wasm/sfumato.wasm");
const site = path("../../build/editor");
const oneFile = path("../../build/editor.html");

const kilobytes = (count) => `${(count / 1000).toFixed(1)} kB`;

/** The script that the site's page names: what the first page waits for. */
const firstScript = () => /<script type="module"[^>]* src="\.\/assets\/([^"]+)"/.exec(readFileSync(join(site, "index.html"), "utf8"))[1];

function report() {
  const wasm = readFileSync(module);
  const assets = readdirSync(join(site, "assets"));
  const packed = (name) => gzipSync(readFileSync(join(site, "assets", name)), { level: 9 }).length;
  const scripts = assets.filter((name) => name.endsWith(".js")).map((name) => [name, packed(name)]);
  console.log(`the first page    ${kilobytes(packed(firstScript()))} gz`);
  console.log(`sfumato.wasm      ${kilobytes(brotliCompressSync(wasm).length)} br, ${kilobytes(gzipSync(wasm, { level: 9 }).length)} gz`);
  for (const [name, size] of scripts) console.log(`${name.padEnd(24)} ${kilobytes(size)} gz`);
  console.log(`build/editor.html ${kilobytes(readFileSync(oneFile).length)}`);
}

mkdirSync(path("../../build"), { recursive: true });
await buildSite(site);
await buildOneFile(oneFile, module);
report();
