// Arc lengths, and places on a curve by them: what stop offsets count.
import type { Point } from "./affine.js";
import {
  derivativeAt,
  directionAt,
  pieceAt,
  pieceCount,
  piecesOf,
  pointAt,
  segmentsOf,
  type Cubic,
  type CubicPath,
} from "./cubic.js";
import { leftOf, size } from "./vector.js";

const NODES = [0.5384693101056831, 0.906179845938664];
const WEIGHTS = [0.5688888888888889, 0.4786286704993665, 0.2369268850561891];

/** Five-point Gauss–Legendre quadrature of the speed. */
function quadrature(cubic: Cubic, t0: number, t1: number): number {
  const middle = 0.5 * (t0 + t1);
  const half = 0.5 * (t1 - t0);
  const speed = (t: number) => size(derivativeAt(cubic, t));
  let sum = WEIGHTS[0] * speed(middle);
  NODES.forEach((node, i) => {
    sum += WEIGHTS[i + 1] * (speed(middle - half * node) + speed(middle + half * node));
  });
  return sum * half;
}

/** Length of the stretch from t0 to t1: on halves until it settles to 1e-9 of it. */
export function cubicLength(cubic: Cubic, t0 = 0, t1 = 1): number {
  let coarse = quadrature(cubic, t0, t1);
  for (let parts = 2; parts <= 256; parts *= 2) {
    const step = (t1 - t0) / parts;
    let fine = 0;
    for (let i = 0; i < parts; ++i) fine += quadrature(cubic, t0 + i * step, t0 + (i + 1) * step);
    if (Math.abs(fine - coarse) <= 1e-9 * fine) return fine;
    coarse = fine;
  }
  return coarse;
}

/** The parameter in [0, 1] at a length from the start: Newton's steps, halving where they fail. */
export function parameterAtLength(cubic: Cubic, wanted: number): number {
  const settled = 2 ** -48;
  let low = 0;
  let high = 1;
  let lowLength = 0;
  let t = 0.5;
  for (let i = 1; i <= 64 && high - low > settled; ++i) {
    const reached = lowLength + cubicLength(cubic, low, t);
    const step = (wanted - reached) / size(derivativeAt(cubic, t));
    if (Math.abs(step) <= settled) return Math.min(Math.max(t + step, low), high);
    if (reached < wanted) {
      low = t;
      lowLength = reached;
    } else {
      high = t;
    }
    t += step;
    if (!(t > low && t < high) || i % 4 === 0) t = 0.5 * (low + high);
  }
  return 0.5 * (low + high);
}

/** Paths do not change: each is measured once. */
const measured = new WeakMap<CubicPath, readonly number[]>();

/** Entry i is the length before piece i, the last the whole length. */
export function cumulativeLengths(path: CubicPath): readonly number[] {
  const known = measured.get(path);
  if (known) return known;
  const lengths = [0];
  for (const cubic of piecesOf(path))
    lengths.push(lengths[lengths.length - 1] + cubicLength(cubic));
  measured.set(path, lengths);
  return lengths;
}

export function pathLength(path: CubicPath): number {
  return cumulativeLengths(path)[pieceCount(path)];
}

/** A place on a path: its piece, and t on it in [0, 1]. `at` is piece + t, clamped to the path. */
export function locate(path: CubicPath, at: number): { piece: number; t: number } {
  const pieces = pieceCount(path);
  const clamped = Math.min(Math.max(at, 0), pieces);
  const piece = Math.min(Math.floor(clamped), pieces - 1);
  return { piece, t: clamped - piece };
}

export function pathPointAt(path: CubicPath, at: number): Point {
  const { piece, t } = locate(path, at);
  return pointAt(pieceAt(path, piece), t);
}

/** The walking direction, of length 1; null only where a piece is a point. */
export function pathDirectionAt(path: CubicPath, at: number): Point | null {
  const { piece, t } = locate(path, at);
  return directionAt(pieceAt(path, piece), t);
}

/** The unit vector to the left of the walk, as seen on the screen. */
export function leftNormalAt(path: CubicPath, at: number): Point | null {
  const direction = pathDirectionAt(path, at);
  return direction && leftOf(direction);
}

/** The place (piece + t) at a share, 0 to 1, of the arc length. */
export function parameterAtFraction(
  path: CubicPath,
  fraction: number,
  lengths: readonly number[] = cumulativeLengths(path),
): number {
  const pieces = pieceCount(path);
  if (!(fraction > 0)) return 0;
  if (fraction >= 1) return pieces;
  const wanted = fraction * lengths[pieces];
  let [low, high] = [0, pieces];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (lengths[middle] <= wanted) low = middle;
    else high = middle;
  }
  return low + parameterAtLength(pieceAt(path, low), wanted - lengths[low]);
}

/** The share of the arc length before a place. 0 for a path of no length. */
export function fractionAtParameter(path: CubicPath, at: number): number {
  const lengths = cumulativeLengths(path);
  const { piece, t } = locate(path, at);
  const whole = lengths[pieceCount(path)];
  if (!(whole > 0)) return 0;
  const before = t === 0 ? 0 : cubicLength(pieceAt(path, piece), 0, t);
  return Math.min(1, (lengths[piece] + before) / whole);
}

/** From what "@" counts to a place: the engine's piece_parameter. */
export function parameterAtSegment(path: CubicPath, offset: number): number {
  const segments = segmentsOf(path);
  const whole = Math.floor(offset);
  if (!(whole >= 0)) return 0;
  if (whole >= segments.length - 1) return pieceCount(path);
  return segments[whole] + (offset - whole) * (segments[whole + 1] - segments[whole]);
}

/** From a place to what "@" counts. */
export function segmentAtParameter(path: CubicPath, at: number): number {
  if (!path.segments) return Math.min(Math.max(at, 0), pieceCount(path));
  const { segments } = path;
  if (!(at > 0)) return 0;
  if (at >= pieceCount(path)) return segments.length - 1;
  let i = 0;
  while (segments[i + 1] <= at) ++i;
  return i + (at - segments[i]) / (segments[i + 1] - segments[i]);
}

/** Where a stop stands (piece + t), by its offset in the document. */
export function placeOfOffset(path: CubicPath, space: "arc" | "parameter", offset: number): number {
  return space === "arc" ? parameterAtFraction(path, offset) : parameterAtSegment(path, offset);
}

/** The offset of a stop that stands at a place. */
export function offsetOfPlace(path: CubicPath, space: "arc" | "parameter", at: number): number {
  return space === "arc" ? fractionAtParameter(path, at) : segmentAtParameter(path, at);
}
