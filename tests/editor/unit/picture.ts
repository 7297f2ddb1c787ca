// Pictures of texts, drawn by the module.
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { file, modulePath } from "./drawings.js";

/**
 * Code values: red, green, blue and alpha in turn. Colours are premultiplied, so that invisible ones do not count.
 */
export type Pixels = Float64Array;

export interface Painter {
  /** Reads a text. @throws SfumatoError if the text is not a valid drawing */
  read(text: string): void;
  /** Draws the artboard. @throws SfumatoError if the text is not a valid drawing */
  paint(text: string, width?: number): Pixels;
}

/** Replaces every image, because the effect of commands on drawings does not depend on images. */
const STAND_IN = { width: 2, height: 2, data: new Uint8Array([200, 90, 40, 255, 30, 80, 160, 255, 60, 120, 50, 255, 240, 230, 200, 255]) };

/** Returns null if there is no module. */
export async function painter(): Promise<Painter | null> {
  const path = modulePath();
  if (!path) return null;
  const { loadSfumato } = await import(file("../../../web/wasm/sfumato.mjs"));
  const library = await loadSfumato(readFileSync(path));
  const folder = file("../../../examples/");
  const load = (context: { addImage(file: Uint8Array, image: typeof STAND_IN): void }) => (href: string) => {
    const path = join(folder, href);
    const bytes = new Uint8Array(readFileSync(existsSync(path) ? path : join(folder, "wood.png")));
    context.addImage(bytes, STAND_IN);
    return bytes;
  };
  const read = (text: string) => {
    const context = library.context();
    try {
      context.read(text, { load: load(context) }).free();
    } finally {
      context.free();
    }
  };
  const paint = (text: string, width = 128): Pixels => {
    const context = library.context();
    try {
      const document = context.read(text, { load: load(context) });
      const [, , w, h] = document.artboard;
      const height = Math.max(1, Math.round((width * h) / w));
      const picture = context.solve(document, `width=${width}`);
      const rgba = context.raster(picture, { width, height, format: "rgba16" });
      document.free();
      picture.free();
      return premultiplied(rgba);
    } finally {
      context.free();
    }
  };
  return { read, paint };
}

function premultiplied(rgba: Uint16Array): Pixels {
  return Float64Array.from(rgba, (value, i) => {
    const alpha = rgba[i | 3] / 65535;
    return (i % 4 === 3 ? value : value * alpha) / 257;
  });
}

/** Returns the largest and the mean difference, in code values. */
export function difference(a: Pixels, b: Pixels): { most: number; mean: number } {
  if (a.length !== b.length) return { most: Infinity, mean: Infinity };
  let most = 0;
  let sum = 0;
  a.forEach((value, i) => {
    const apart = Math.abs(value - b[i]);
    most = Math.max(most, apart);
    sum += apart;
  });
  return { most, mean: sum / a.length };
}

