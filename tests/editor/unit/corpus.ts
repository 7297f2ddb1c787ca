// Documents for property tests: the examples, the fuzzers' finds, the paper's scenes.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const repository = fileURLToPath(new URL("../../..", import.meta.url));

export interface Source {
  readonly name: string;
  readonly bytes: Buffer;
  readonly text: string;
}

function source(name: string, bytes: Buffer): Source {
  return { name, bytes, text: new TextDecoder("utf-8", { ignoreBOM: true }).decode(bytes) };
}

function filesOf(folder: string, ending: string): Source[] {
  const names = readdirSync(folder).filter((name) => name.endsWith(ending));
  return names.sort().map((name) => source(name, readFileSync(join(folder, name))));
}

/** examples/*.svg */
export function examples(): Source[] {
  return filesOf(join(repository, "examples"), ".svg");
}

/** Returns the files of a tar archive, whose headers are blocks of 512 bytes. */
function filesOfTar(path: string): Source[] {
  const tar = readFileSync(path);
  const found: Source[] = [];
  for (let at = 0; at + 512 <= tar.length && tar[at] !== 0;) {
    const field = (from: number, length: number) =>
      tar
        .toString("latin1", at + from, at + from + length)
        .replace(/\0.*$/s, "")
        .trim();
    const size = parseInt(field(124, 12), 8);
    const isFile = field(156, 1) === "0" || field(156, 1) === "";
    if (isFile) found.push(source(field(0, 100), tar.subarray(at + 512, at + 512 + size)));
    at += 512 + 512 * Math.ceil(size / 512);
  }
  return found;
}

/** Returns the corpora of the fuzzers for SVG readers. */
export function fuzzed(): Source[] {
  return ["svg", "round_trip", "import"].flatMap((name) =>
    filesOfTar(join(repository, "fuzz/corpus", `${name}.tar`)),
  );
}

/** The folder of the paper's scenes: SFUMATO_SCENES; null if it is missing. */
export const scenesFolder = ((): string | null => {
  const folder = process.env.SFUMATO_SCENES ?? "";
  return folder !== "" && existsSync(folder) ? folder : null;
})();

/** Returns Orzan's XML of the paper's scenes. */
export function scenes(): Source[] {
  return scenesFolder === null ? [] : filesOf(scenesFolder, ".xml");
}

/** Returns numbers from 0 up to 1, the same each time, by a linear congruential generator. */
export function randomNumbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    // Scrambled, because the low bits of such a generator are poor.
    let value = state;
    value = Math.imul(value ^ (value >>> 16), 0x45d9f3b);
    value = Math.imul(value ^ (value >>> 16), 0x45d9f3b);
    return ((value ^ (value >>> 16)) >>> 0) / 2 ** 32;
  };
}

export function pick<T>(from: readonly T[], random: () => number): T {
  return from[Math.floor(random() * from.length)];
}
