// The picture as it was drawn last, for the loupe: what WebGL has drawn can be read in the same task
// alone.
import type { Editor } from "../app/types.js";
import type { Point } from "../geometry/affine.js";
import type { Rgb } from "../geometry/color.js";

const stills = new WeakMap<Editor, OffscreenCanvas>();

/** Keeps a copy of a canvas that has just been drawn. */
export function keepStill(editor: Editor, drawn: HTMLCanvasElement): void {
  const { width, height } = drawn;
  const known = stills.get(editor);
  const still = known ?? new OffscreenCanvas(width, height);
  if (still.width !== width) still.width = width;
  if (still.height !== height) still.height = height;
  still.getContext("2d", { willReadFrequently: true })?.drawImage(drawn, 0, 0);
  stills.set(editor, still);
}

/** Returns the picture that was kept last; null: none. */
export function stillOf(editor: Editor): OffscreenCanvas | null {
  return stills.get(editor) ?? null;
}

/** A copy that later pictures do not change. */
export function heldStill(editor: Editor): OffscreenCanvas | null {
  const still = stillOf(editor);
  if (!still) return null;
  const held = new OffscreenCanvas(still.width, still.height);
  held.getContext("2d", { willReadFrequently: true })?.drawImage(still, 0, 0);
  return held;
}

/**
 * Returns the RGBA pixels of a square around a point of the stage. Pixels outside are clear. @param reach
 * pixels to each side
 */
export function pixelsOf(still: OffscreenCanvas, [x, y]: Point, reach: number): Uint8ClampedArray | null {
  const ratio = globalThis.devicePixelRatio || 1;
  const [left, top] = [x, y].map((k) => Math.floor(k * ratio) - reach);
  const size = 2 * reach + 1;
  return still.getContext("2d")?.getImageData(left, top, size, size).data ?? null;
}

/** The colour of the first of some pixels; null: it is clear. */
export function rgbOf([r, g, b, a]: Uint8ClampedArray): Rgb | null {
  return a > 0 ? { r: r / 255, g: g / 255, b: b / 255 } : null;
}
