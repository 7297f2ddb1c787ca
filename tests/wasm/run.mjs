// Holds the WebAssembly module against the native library: node run.mjs sfumato.wasm dump_nodes
// Prints TAP. The node values have to be the same bit for bit.
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { basename } from "node:path";
import { fileURLToPath } from "node:url";
import { loadSfumato, SfumatoError } from "../../web/wasm/sfumato.mjs";

const [wasmPath, dumpPath] = process.argv.slice(2);
const root = new URL("../../", import.meta.url);
const pathOf = (relative) => fileURLToPath(new URL(relative, root));
let failures = 0;

function report(name, problem) {
  console.log(problem ? `not ok - ${name}\n# ${problem}` : `ok - ${name}`);
  if (problem) failures += 1;
}

function nativeNodeValues(path, maxError) {
  const bytes = execFileSync(dumpPath, [path, String(maxError)], { maxBuffer: 1 << 30 });
  return new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

/// What differs between two arrays of floats; empty where they are the same bits.
function difference(actual, expected) {
  if (expected.length === 0) return "the native library gave no node";
  if (actual.length !== expected.length) {
    return `${actual.length} values, expected ${expected.length}`;
  }
  const [a, b] = [actual, expected].map((values) => new Uint32Array(values.buffer));
  let count = 0;
  let largest = 0;
  for (let i = 0; i < a.length; ++i) {
    if (a[i] === b[i]) continue;
    count += 1;
    largest = Math.max(largest, Math.abs(actual[i] - expected[i]));
  }
  return count ? `${count} of ${a.length} values differ, by ${largest} at most` : "";
}

function checkScene(sfumato, path, maxError) {
  const name = `${basename(path)} has the native nodes, bit for bit (max error ${maxError})`;
  if (!existsSync(path)) {
    console.log(`ok - ${name} # SKIP the public scenes are not here`);
    return;
  }
  try {
    const actual = sfumato.nodeValues(readFileSync(path), maxError);
    report(name, difference(actual, nativeNodeValues(path, maxError)));
  } catch (error) {
    report(name, String(error).replaceAll("\n", " "));
  }
}

function checkError(sfumato) {
  const name = "a document that is not XML is refused with the library's message";
  try {
    sfumato.nodeValues(new TextEncoder().encode("not XML"));
    report(name, "it was taken");
  } catch (error) {
    const fine = error instanceof SfumatoError && error.message.startsWith("document: ");
    report(name, fine ? "" : String(error));
  }
}

const sfumato = await loadSfumato(readFileSync(wasmPath));
checkScene(sfumato, pathOf("examples/evening.xml"), 0);
checkScene(sfumato, pathOf("examples/evening.xml"), 1);
checkScene(sfumato, pathOf("tests/wasm/controls.svg"), 0);
checkScene(sfumato, pathOf("tests/wasm/controls.svg"), 1);
for (const scene of ["lady_bug", "endcap"]) {
  checkScene(sfumato, pathOf(`../shared/scenes/${scene}.xml`), 0);
}
checkScene(sfumato, pathOf("../shared/scenes/lady_bug.xml"), 1);
checkError(sfumato);
process.exitCode = failures > 0 ? 1 : 0;
