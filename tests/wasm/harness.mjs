// Tests as TAP, and the native library's answers.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const root = new URL("../../", import.meta.url);
export const pathOf = (relative) => fileURLToPath(new URL(relative, root));
export const textOf = (relative) => readFileSync(pathOf(relative));

export class Tap {
  failures = 0;

  /** Runs one test; it fails if body() throws or returns a text that is not empty. */
  async test(name, body) {
    let problem;
    try {
      problem = await body();
    } catch (error) {
      problem = error.stack ?? String(error);
    }
    console.log(problem ? `not ok - ${name}\n# ${problem.replaceAll("\n", "\n# ")}` : `ok - ${name}`);
    if (problem) this.failures += 1;
  }

  skip(name, why) {
    console.log(`ok - ${name} # SKIP ${why}`);
  }
}

export function check(holds, complaint) {
  if (!holds) throw new Error(complaint);
}

export function same(actual, expected, what) {
  check(actual === expected, `${what} is ${JSON.stringify(actual)}, not ${JSON.stringify(expected)}`);
}

/** Returns the error that body() throws, which must have this code. */
export function refusal(code, body) {
  try {
    body();
  } catch (error) {
    if (error.code !== code) throw error;
    return error;
  }
  throw new Error("it was not refused");
}

/** Returns the native library's answer as bytes. */
export function nativeAnswer(program, question, path, options = "") {
  return execFileSync(program, [question, path, options], { maxBuffer: 1 << 30 });
}

/** Returns the difference between bytes; empty if there is none. */
export function difference(actual, expected) {
  if (expected.length === 0) return "the native library gave nothing";
  if (actual.length !== expected.length) return `${actual.length} bytes, not ${expected.length}`;
  let count = 0;
  for (let i = 0; i < actual.length; ++i) count += actual[i] !== expected[i];
  return count > 0 ? `${count} of ${actual.length} bytes differ` : "";
}

export function bytesOf(array) {
  return new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
}

/** Returns every table of a picture, row after row, in the form of native_answers. */
export function tablesOf(picture, tables) {
  const parts = [];
  for (let layer = 0; layer < picture.layerCount; ++layer) {
    for (const table of Object.values(tables)) {
      parts.push(Buffer.from(bytesOf(picture.table(layer, table).data)));
    }
  }
  return Buffer.concat(parts);
}
