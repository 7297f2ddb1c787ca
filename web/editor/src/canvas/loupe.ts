// What the loupe of the Sample tool shows: the pixels around the pointer, and what is sampled there.
import { inverted, mapped, type Point } from "../geometry/affine.js";
import type { Rgb } from "../geometry/color.js";
import { hexOf } from "../geometry/colortext.js";
import type { Photo } from "../geometry/photo.js";
import { en } from "../strings/en.js";
import type { Canvas } from "./canvas.js";
import type { CurveHit, PointerKind } from "./hit.js";
import type { PlacedPhoto } from "./photo.js";
import { photoColor, sampledAt } from "./sampled.js";
import { stillAround } from "./still.js";

/** Pixels on each side of the one in the middle. */
export const REACH = 5;
export const LOUPE_PIXELS = 2 * REACH + 1;

export interface Loupe {
  /** Of the pointer, on the stage. */
  readonly at: Point;
  readonly kind: PointerKind;
  /** RGBA, in rows. */
  readonly pixels: Uint8ClampedArray;
  /** The halves of its ring: new above old; beside a curve left and right of it. */
  readonly ring: readonly [Rgb | null, Rgb | null];
  /** Where the first half's middle is, radians from above, clockwise. */
  readonly turn: number;
  /** Where the sides are sampled, in pixels from the middle. */
  readonly spots: readonly Point[];
  readonly text: string;
}

export interface LoupeWish {
  readonly at: Point;
  readonly kind: PointerKind;
  readonly photo: PlacedPhoto | null;
  /** The curve whose sides are sampled there. */
  readonly hit: CurveHit | null;
  /** What a stop had before it took another colour. */
  readonly old: Rgb | null;
}

/** null: nothing is to be seen there. */
export function loupeOf(canvas: Canvas, wish: LoupeWish): Loupe | null {
  const { at, kind, photo, hit, old } = wish;
  const pixels = pixelsAround(canvas, at, photo);
  if (!pixels) return null;
  const middle = colorOfMiddle(pixels);
  const point = canvas.toArtboard(at);
  const taken = (photo && photoColor(photo, point)) ?? middle;
  const base = { at, kind, pixels, turn: 0, spots: [] };
  const sides = photo && hit && sidesOf(canvas, photo, hit);
  if (!sides) return { ...base, ring: [taken, old ?? taken], text: taken ? hexOf(taken) : en.canvas.clear };
  const [middleX, middleY] = pixelOf(photo, point);
  const spots = sides.spots.map(([x, y]): Point => [x - middleX, y - middleY]);
  const named = (color: Rgb | null) => (color ? hexOf(color) : en.canvas.clear);
  return {
    ...base,
    ring: [sides.left, sides.right],
    turn: Math.atan2(sides.normal[0], -sides.normal[1]),
    spots,
    text: en.canvas.sampled(named(sides.left), named(sides.right)),
  };
}

function sidesOf(canvas: Canvas, photo: PlacedPhoto, { place, path, at }: CurveHit) {
  return sampledAt(photo, place.item, path, at, canvas.editor.settings.sampleDistance.peek());
}

/** A point of the artboard in the photo, pixels. */
function pixelOf(photo: PlacedPhoto, point: Point): Point {
  const back = inverted(photo.artboardFromPixel);
  return back ? mapped(back, point) : [NaN, NaN];
}

/** Those of the photo where there is one, else of the picture as the screen has it. */
function pixelsAround(canvas: Canvas, at: Point, photo: PlacedPhoto | null): Uint8ClampedArray | null {
  const [x, y] = photo ? pixelOf(photo, canvas.toArtboard(at)) : [NaN, NaN];
  if (photo && x >= 0 && y >= 0 && x < photo.width && y < photo.height) return cut(photo, [x, y]);
  const ratio = globalThis.devicePixelRatio || 1;
  return stillAround(canvas.editor, [at[0] * ratio, at[1] * ratio], REACH);
}

/** A square of a photo; what is beside it is clear. */
export function cut({ width, height, data }: Photo, [x, y]: Point): Uint8ClampedArray {
  const pixels = new Uint8ClampedArray(4 * LOUPE_PIXELS * LOUPE_PIXELS);
  const [left, top] = [Math.floor(x) - REACH, Math.floor(y) - REACH];
  for (let row = 0; row < LOUPE_PIXELS; row += 1) {
    const v = top + row;
    if (v < 0 || v >= height) continue;
    const from = Math.max(left, 0);
    const to = Math.min(left + LOUPE_PIXELS, width);
    if (from >= to) continue;
    const line = data.subarray(4 * (v * width + from), 4 * (v * width + to));
    pixels.set(line, 4 * (row * LOUPE_PIXELS + from - left));
  }
  return pixels;
}

function colorOfMiddle(pixels: Uint8ClampedArray): Rgb | null {
  const at = 4 * (REACH * LOUPE_PIXELS + REACH);
  const [r, g, b, a] = pixels.subarray(at, at + 4);
  return a === 0 ? null : { r: r / 255, g: g / 255, b: b / 255 };
}
