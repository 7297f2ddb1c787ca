// Compares the WebAssembly module with the native library and with its documents: node run.mjs sfumato.wasm
// native_answers. Prints TAP.
import { readFileSync } from "node:fs";
import { loadSfumato } from "../../web/wasm/sfumato.mjs";
import { testAnswers } from "./answers.mjs";
import { testCalls } from "./calls.mjs";
import { testFace } from "./face.mjs";
import { Tap } from "./harness.mjs";

const [wasmPath, nativePath] = process.argv.slice(2);
const module = await WebAssembly.compile(readFileSync(wasmPath));
const tap = new Tap();
await testFace(tap, module);
await testCalls(tap, await loadSfumato(module), module);
await testAnswers(tap, await loadSfumato(module), nativePath);
process.exitCode = tap.failures > 0 ? 1 : 0;
