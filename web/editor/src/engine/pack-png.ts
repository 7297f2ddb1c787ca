// Pixels as the bytes of a PNG; runs in png.worker.ts.
import { encode } from "fast-png";
import type { PngPixels } from "./png.js";

function isOpaque({ data }: PngPixels): boolean {
  const full = data.BYTES_PER_ELEMENT === 1 ? 255 : 65535;
  for (let i = 3; i < data.length; i += 4) if (data[i] !== full) return false;
  return true;
}

/** Without every fourth value. */
function withoutAlpha<Values extends Uint8ClampedArray | Uint16Array>(data: Values, out: Values): Values {
  for (let from = 0, to = 0; from < data.length; from += 4) {
    out[to++] = data[from];
    out[to++] = data[from + 1];
    out[to++] = data[from + 2];
  }
  return out;
}

/** @param pixels as encodePng() takes them */
export function packPng(pixels: PngPixels): Uint8Array<ArrayBuffer> {
  const { width, height } = pixels;
  const channels = isOpaque(pixels) ? 3 : 4;
  const depth = pixels.data.BYTES_PER_ELEMENT === 1 ? 8 : 16;
  const { data: all } = pixels;
  const count = 3 * width * height;
  let data: Uint8ClampedArray | Uint16Array = all;
  if (channels === 3) {
    data = all instanceof Uint16Array ? withoutAlpha(all, new Uint16Array(count)) : withoutAlpha(all, new Uint8ClampedArray(count));
  }
  return new Uint8Array(encode({ width, height, data, channels, depth }));
}
