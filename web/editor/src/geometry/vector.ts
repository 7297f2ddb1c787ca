// Points as vectors.
import type { Point } from "./affine.js";

export const add = (a: Point, b: Point): Point => [a[0] + b[0], a[1] + b[1]];
export const subtract = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1]];
export const scaled = (a: Point, k: number): Point => [a[0] * k, a[1] * k];
export const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1];
export const cross = (a: Point, b: Point): number => a[0] * b[1] - a[1] * b[0];
/** As the engine measures, to the bit. */
export const size = ([x, y]: Point): number => Math.sqrt(x * x + y * y);
export const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);
export const isSame = (a: Point, b: Point): boolean => a[0] === b[0] && a[1] === b[1];

/** The engine's: exact at t = 0. */
export const lerp = (a: Point, b: Point, t: number): Point => [
  a[0] + (b[0] - a[0]) * t,
  a[1] + (b[1] - a[1]) * t,
];

/** Returns the vector with length 1; null for a vector without a direction. */
export function unit(a: Point): Point | null {
  const length = size(a);
  return length > 0 && Number.isFinite(length) ? [a[0] / length, a[1] / length] : null;
}

/** The left of a walking direction, as seen on the screen: (dy, -dx), y down. */
export const leftOf = ([x, y]: Point): Point => [y, -x];
