// Content of the Sample tool's loupe: the pixels around the pointer, and the colours that are sampled there.
import { nameOfSide } from "../app/side-names.js";
import { inverted, mapped, type Point } from "../geometry/affine.js";
import type { Rgb } from "../geometry/color.js";
import { hexOf } from "../geometry/colortext.js";
import type { Photo } from "../geometry/photo.js";
import { sidesInOrder } from "../model/sides.js";
import type { CurveItem } from "../model/types.js";
import * as en from "../strings/en.js";
import type { Canvas } from "./canvas.js";
import type { CurveHit, PointerKind } from "./hit.js";
import type { PlacedPhoto } from "./photo.js";
import { photoColor, sampledAt } from "./sampled.js";
import type { Loupe } from "./sketch.js";
import { pixelsOf, rgbOf, stillOf } from "./still.js";

/** Pixels on each side of the one in the middle. */
export const REACH = 5;
export const LOUPE_PIXELS = 2 * REACH + 1;
/** The index of the middle pixel's first number. */
const MIDDLE = 4 * (REACH * LOUPE_PIXELS + REACH);

export interface LoupeWish {
  readonly at: Point;
  readonly kind: PointerKind;
  /** The photo to sample, where it has a colour; otherwise the picture is sampled. */
  readonly photo: PlacedPhoto | null;
  /** The curve whose sides are sampled there. */
  readonly hit: CurveHit | null;
  /** The stop's colour before it took another one. */
  readonly old: Rgb | null;
  /** The picture that is sampled; absent: as it was drawn last. */
  readonly still?: OffscreenCanvas | null;
}

/** null: nothing is to be seen there. */
export function loupeOf(canvas: Canvas, wish: LoupeWish): Loupe | null {
  const { photo, hit } = wish;
  const sides = photo && hit && sidesOf(canvas, photo, hit);
  return sides ? besideCurve(canvas, wish, photo, sides, hit.place.item) : ofPoint(canvas, wish);
}

type Sides = NonNullable<ReturnType<typeof sampledAt>>;

/** Samples beside a curve. Only the photo counts, also where it has no pixels. */
function besideCurve(
  canvas: Canvas,
  { at, kind }: LoupeWish,
  photo: PlacedPhoto,
  sides: Sides,
  item: CurveItem,
): Loupe {
  const middle = pixelOf(photo, canvas.toArtboard(at));
  const named = (color: Rgb | null) => (color ? hexOf(color) : en.canvas.clear);
  return {
    at,
    kind,
    pixels: cut(photo, middle),
    ring: [sides.left, sides.right],
    turn: Math.atan2(sides.normal[0], -sides.normal[1]),
    spots: sides.spots.map(([x, y]): Point => [x - middle[0], y - middle[1]]),
    text: en.canvas.sampled(sidesInOrder(item).map((side) => [nameOfSide(item, side), named(sides[side])])),
  };
}

function ofPoint(canvas: Canvas, { at, kind, photo, old, still }: LoupeWish): Loupe | null {
  const point = canvas.toArtboard(at);
  const traced = photo && photoColor(photo, point);
  const shown = still ?? stillOf(canvas.editor);
  const pixels = traced ? cut(photo, pixelOf(photo, point)) : shown && pixelsOf(shown, at, REACH);
  if (!pixels) return null;
  const taken = traced ?? rgbOf(pixels.subarray(MIDDLE));
  return { at, kind, pixels, turn: 0, spots: [], ring: [taken, old ?? taken], text: taken ? hexOf(taken) : en.canvas.clear };
}

function sidesOf(canvas: Canvas, photo: PlacedPhoto, { place, path, at }: CurveHit) {
  return sampledAt(photo, place.item, path, at, canvas.editor.settings.sampleDistance.peek());
}

/** A point of the artboard in the photo, pixels. */
function pixelOf(photo: PlacedPhoto, point: Point): Point {
  const back = inverted(photo.artboardFromPixel);
  return back ? mapped(back, point) : [NaN, NaN];
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
