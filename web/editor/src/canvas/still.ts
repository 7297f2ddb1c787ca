// The picture as it was drawn last, for the loupe: what WebGL has drawn can be read in the same task
// alone.
import type { Editor } from "../app/types.js";

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

/** Its pixels in a square around one of them; null: there is no copy. What is outside is clear. */
export function stillAround(
  editor: Editor,
  [x, y]: readonly [number, number],
  reach: number,
): Uint8ClampedArray | null {
  const context = stills.get(editor)?.getContext("2d");
  if (!context) return null;
  const size = 2 * reach + 1;
  return context.getImageData(Math.floor(x) - reach, Math.floor(y) - reach, size, size).data;
}
