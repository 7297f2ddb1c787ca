// Bytes that the page of one file holds as text, as tools/pack.mjs writes them: the page is said to be
// windows-1252, where every byte is a character.
import { decompress } from "fzstd";

/** Stands before a byte that HTML would change, to which 64 was added. */
const ESCAPE = 0x1b;
const SHIFT = 64;

/** Characters of windows-1252 beyond Latin-1, by their bytes 128 to 159. */
const beyondLatin = () => new TextDecoder("windows-1252").decode(Uint8Array.from({ length: 32 }, (_, i) => 128 + i));

export function bytesOfText(text: string): Uint8Array {
  const byteOf = new Map([...beyondLatin()].map((character, i) => [character.charCodeAt(0), 128 + i]));
  const bytes = new Uint8Array(text.length);
  let count = 0;
  let shift = 0;
  for (let i = 0; i < text.length; i += 1) {
    const code = text.charCodeAt(i);
    const byte = code < 256 ? code : byteOf.get(code)!;
    if (byte === ESCAPE && shift === 0) {
      shift = SHIFT;
      continue;
    }
    bytes[count++] = byte - shift;
    shift = 0;
  }
  return bytes.subarray(0, count);
}

/**
 * Returns the content of an element of the page. Removes the element: it holds a megabyte that is read only
 * once.
 */
export function takePacked(id: string): string {
  const element = document.getElementById(id);
  if (!element?.textContent) throw new Error(`${id} is missing in the page`);
  element.remove();
  return element.textContent;
}

/** @throws Error where the text is not packed whole */
export function unpacked(text: string): Uint8Array<ArrayBuffer> {
  return decompress(bytesOfText(text)) as Uint8Array<ArrayBuffer>;
}
