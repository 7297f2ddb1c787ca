// Affine maps as [a, b, c, d, e, f] of SVG's matrix(): (x, y) -> (a x + c y + e, b x + d y + f).
// The viewer's functions, typed for the editor, and what it asks beyond them.
import * as viewer from "../../../viewer/affine.js";

export type Affine = readonly number[];
export type Point = readonly [number, number];
/** Minimum x, y, maximum x, y. */
export type Box = readonly [number, number, number, number];

export const IDENTITY: Affine = [1, 0, 0, 1, 0, 0];

/** First `inner`, then `outer`. */
export const composed: (outer: Affine, inner: Affine) => Affine = viewer.composed;
export const translation: (x: number, y: number) => Affine = viewer.translation;
/** The box around the image of a box. */
export const mappedBox: (map: Affine, box: Box) => Box = viewer.mappedBox;

/** A linear map about a point that stays. */
export function about([x, y]: Point, linear: Affine): Affine {
  return composed(translation(x, y), composed(linear, translation(-x, -y)));
}

/** The map that turns about a point. @param angle rad, clockwise on the screen */
export function turning(middle: Point, angle: number): Affine {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return about(middle, [c, s, -s, c, 0, 0]);
}

export function determinant([a, b, c, d]: Affine): number {
  return a * d - b * c;
}

/** The map back; null where there is none. */
export function inverted(map: Affine): Affine | null {
  const back: Affine = viewer.inverted(map);
  return back.every(Number.isFinite) ? back : null;
}

export function mapped([a, b, c, d, e, f]: Affine, [x, y]: Point): Point {
  return [a * x + c * y + e, b * x + d * y + f];
}

/** A direction or a distance: without the map's translation. */
export function mappedVector([a, b, c, d]: Affine, [x, y]: Point): Point {
  return [a * x + c * y, b * x + d * y];
}

/** The factor by which the map makes radii of blur grow: √|determinant|, as the format says. */
export function lengthScale(map: Affine): number {
  return Math.sqrt(Math.abs(determinant(map)));
}
