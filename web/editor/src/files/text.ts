// The bytes of a drawing's file as text, and back to the same bytes.
import * as en from "../strings/en.js";

const words = en.files;

/** How a file holds its text; saving keeps it. */
export interface TextForm {
  readonly encoding: "utf-8" | "utf-8-bom" | "utf-16le" | "utf-16be";
  /** gzip, as in .svgz. */
  readonly packed: boolean;
}

export const plainForm: TextForm = { encoding: "utf-8", packed: false };

/** An error with a message for the user. */
export class FileProblem extends Error {}

/** Bytes that a drawing may have, unpacked; the engine reads no more. */
export const mostTextBytes = 64 * 2 ** 20;

const begins = (bytes: Uint8Array, ...first: number[]) => first.every((byte, i) => bytes[i] === byte);

function encodingOf(bytes: Uint8Array): TextForm["encoding"] {
  if (begins(bytes, 0xef, 0xbb, 0xbf)) return "utf-8-bom";
  if (begins(bytes, 0xff, 0xfe)) return "utf-16le";
  if (begins(bytes, 0xfe, 0xff)) return "utf-16be";
  return "utf-8";
}

/** Text and form of a file, without its byte order mark. @throws FileProblem */
export async function textOf(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<{ text: string; form: TextForm }> {
  const packed = begins(bytes, 0x1f, 0x8b);
  const plain = packed ? await unpacked(bytes, name) : bytes;
  const encoding = encodingOf(plain);
  try {
    const decoder = new TextDecoder(encoding === "utf-8-bom" ? "utf-8" : encoding, { fatal: true });
    return { text: decoder.decode(plain), form: { encoding, packed } };
  } catch {
    throw new FileProblem(words.notText(name));
  }
}

async function unpacked(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<Uint8Array<ArrayBuffer>> {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let count = 0;
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  try {
    for (const reader = stream.getReader(); ; ) {
      const { value, done } = await reader.read();
      if (done) break;
      count += value.length;
      if (count > mostTextBytes) {
        void reader.cancel().catch(() => undefined);
        throw new FileProblem(words.unpacksTooLarge(name));
      }
      parts.push(value);
    }
  } catch (error) {
    if (error instanceof FileProblem) throw error;
    throw new FileProblem(words.brokenGzip(name));
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

function encoded(text: string, encoding: TextForm["encoding"]): Uint8Array<ArrayBuffer> {
  if (encoding === "utf-8") return new TextEncoder().encode(text);
  if (encoding === "utf-8-bom") return new TextEncoder().encode(`\ufeff${text}`);
  const bytes = new Uint8Array(2 * text.length + 2);
  const view = new DataView(bytes.buffer);
  const isLittle = encoding === "utf-16le";
  view.setUint16(0, 0xfeff, isLittle);
  for (let i = 0; i < text.length; ++i) view.setUint16(2 * i + 2, text.charCodeAt(i), isLittle);
  return bytes;
}

/** The file of a text. */
export async function bytesOf(text: string, form: TextForm): Promise<Uint8Array<ArrayBuffer>> {
  const plain = encoded(text, form.encoding);
  if (!form.packed) return plain;
  const stream = new Blob([plain]).stream().pipeThrough(new CompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
