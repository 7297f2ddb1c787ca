// Checks that the page that the editor exports equals the command's page, except for the picture in it.
//
//   node tests/editor/page.mjs SFUMATO
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { inflateSync } from "node:zlib";
import { viewerPage } from "../../web/editor/tools/viewer-page.mjs";

const name = "the editor's template is the page of `sfumato render -o page.html`";
const drawing = fileURLToPath(new URL("../../examples/portrait.svg", import.meta.url));
const folder = mkdtempSync(join(tmpdir(), "sfumato-page-"));

/** Returns the texts in the places of the template's marks in a page of the command. */
function partsOf(page) {
  const part = (pattern) => pattern.exec(page)?.[1] ?? "";
  return {
    title: part(/<title>([^<]*)<\/title>/),
    fallback: part(/(<img id="fallback"[^>]*>)/),
    payload: part(/id="payload">([^<]*)</),
  };
}

/** Unpacks the shaders, because versions of zlib pack the same text into different bytes. */
function unpacked(page) {
  return page.replace(/(id="shaders">)([^<]*)/, (_, mark, packed) => `${mark}${inflateSync(Buffer.from(packed, "base64"))}`);
}

try {
  const file = join(folder, "page.html");
  execFileSync(process.argv[2], ["render", drawing, "-o", file], { stdio: "inherit" });
  const page = unpacked(readFileSync(file, "utf8"));
  const parts = partsOf(page);
  const filled = unpacked(viewerPage()).replace(/\{\{(\w+)\}\}/g, (mark, part) => parts[part] ?? mark);
  const isSame = filled === page && Object.values(parts).every((part) => part !== "");
  console.log(`${isSame ? "ok" : "not ok"} - ${name}`);
  if (!isSame) {
    const at = [...page].findIndex((c, i) => c !== filled[i]);
    console.log(`# at ${at}: ${JSON.stringify(page.slice(at, at + 80))} and ${JSON.stringify(filled.slice(at, at + 80))}`);
    process.exitCode = 1;
  }
} finally {
  rmSync(folder, { recursive: true });
}
