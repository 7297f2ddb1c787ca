// tools/pack.mjs writes data into the single-file page, and the page reads it.
import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { bytesOfText, unpacked } from "../../../../web/editor/src/engine/packed.js";
import { escaped, packed } from "../../../../web/editor/tools/pack.mjs";
import { randomFrom } from "../random.js";

/** Decodes the bytes of an element like a browser. */
const asText = (bytes: Uint8Array) => new TextDecoder("windows-1252").decode(bytes);
const comesBack = (bytes: Uint8Array) =>
  Buffer.compare(unpacked(asText(packed(bytes))), bytes) === 0;

describe("packed bytes in a page", () => {
  const all = Uint8Array.from({ length: 65536 }, (_, i) => (i & 1 ? i >> 9 : i >> 1));

  test("every byte comes back, whatever stands beside it", () => {
    expect(bytesOfText(asText(escaped(all)))).toEqual(all);
  });

  test("nothing ends the element, begins a comment, or is read as another byte", () => {
    const text = asText(escaped(Buffer.concat([all, Buffer.from("</script><!--\r\n\0")])));
    expect(text).not.toMatch(/<[/!]|\r|\0/);
  });

  test("what is repeated near and far, and what is not, comes back", () => {
    const random = randomFrom(7);
    for (const size of [0, 1, 17, 300_000]) {
      const noise = Uint8Array.from({ length: size }, () => random() * 256);
      const words = Uint8Array.from({ length: size }, (_, i) => (random() < 0.02 ? random() * 256 : noise[(i * 7) % 97]));
      expect(comesBack(Buffer.concat([noise, words, noise]))).toBe(true);
    }
  });

  test("a frame says its size, so that no more room is made", () => {
    const descriptor = bytesOfText(asText(packed(Uint8Array.from({ length: 5000 }, (_, i) => i & 255))))[4];
    // Bit 5: a single segment, whose window is its content.
    expect(descriptor & 0x20).toBe(0x20);
  });

  test("a program comes back", () => {
    const module = process.env.SFUMATO_WASM ?? new URL("../../../../build-wasm/sfumato.wasm", import.meta.url);
    expect(comesBack(readFileSync(module))).toBe(true);
  });
});
