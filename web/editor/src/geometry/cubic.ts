// Curves as cubic Bézier pieces, measured as the engine measures them (src/curves/bezier.cpp).
import { mapped, type Affine, type Box, type Point } from "./affine.js";
import { distance, isSame, lerp, scaled, size, subtract, unit } from "./vector.js";

/** contract. A piecewise cubic: 3 n + 1 control points; every third one lies on the curve. */
export interface CubicPath {
  /** Piece i has control points 3 i to 3 i + 3. */
  readonly points: readonly Point[];
  /** Whether the path ends by Z; the last point then equals the first. */
  readonly closed: boolean;
  /**
   * The first piece of each segment that stop offsets "@i" count, then the number of pieces. Absent
   * where each piece is a segment: only an arc is a segment of several pieces.
   */
  readonly segments?: readonly number[];
}

/** A piece by its control points. */
export type Cubic = readonly [Point, Point, Point, Point];

export function pieceCount(path: CubicPath): number {
  return (path.points.length - 1) / 3;
}

/** Nodes that can be chosen: of a closed path the last is the first. */
export function nodeCount(path: CubicPath): number {
  return pieceCount(path) + (path.closed ? 0 : 1);
}

export function pieceAt(path: CubicPath, i: number): Cubic {
  const { points } = path;
  return [points[3 * i], points[3 * i + 1], points[3 * i + 2], points[3 * i + 3]];
}

export function isSameCubic(a: Cubic, b: Cubic): boolean {
  return a.every((point, k) => isSame(point, b[k]));
}

export function endsOf({ points }: CubicPath): readonly [Point, Point] {
  return [points[0], points[points.length - 1]];
}

/** Returns whether the ends of a path are at different points. */
export function isOpen(path: CubicPath): boolean {
  return !path.closed && !isSame(...endsOf(path));
}

export function segmentsOf(path: CubicPath): readonly number[] {
  return path.segments ?? Array.from({ length: pieceCount(path) + 1 }, (_, i) => i);
}

/** The straight line as a piece. */
export function lineBetween(from: Point, to: Point): Cubic {
  return [from, lerp(from, to, 1 / 3), lerp(to, from, 1 / 3), to];
}

/** Whether the piece is what a line command draws: handles at the thirds of the chord. */
export function isLine([p0, p1, p2, p3]: Cubic): boolean {
  const slack = 1e-9 * Math.max(...[...p0, ...p3].map(Math.abs));
  const [, third1, third2] = lineBetween(p0, p3);
  return distance(p1, third1) <= slack && distance(p2, third2) <= slack;
}

/** By de Casteljau: exact at both ends. */
export function pointAt([p0, p1, p2, p3]: Cubic, t: number): Point {
  if (t === 1) return p3;
  const ab = lerp(p0, p1, t);
  const bc = lerp(p1, p2, t);
  const cd = lerp(p2, p3, t);
  return lerp(lerp(ab, bc, t), lerp(bc, cd, t), t);
}

export function derivativeAt([p0, p1, p2, p3]: Cubic, t: number): Point {
  const [ab, bc, cd] = [subtract(p1, p0), subtract(p2, p1), subtract(p3, p2)];
  return scaled(lerp(lerp(ab, bc, t), lerp(bc, cd, t), t), 3);
}

export function secondDerivativeAt([p0, p1, p2, p3]: Cubic, t: number): Point {
  const from: Point = [p2[0] - 2 * p1[0] + p0[0], p2[1] - 2 * p1[1] + p0[1]];
  const to: Point = [p3[0] - 2 * p2[0] + p1[0], p3[1] - 2 * p2[1] + p1[1]];
  return scaled(lerp(from, to, t), 6);
}

/**
 * The direction of the curve at t, of length 1; where handles coincide with their node, that in
 * which it leaves or arrives. null: the piece is a point.
 */
export function directionAt(cubic: Cubic, t: number): Point | null {
  const extent = Math.max(...cubic.map((p) => distance(p, cubic[0])));
  const along = derivativeAt(cubic, t);
  if (size(along) > 1e-9 * extent) return unit(along);
  const back = pointAt(cubic, Math.max(0, t - 1e-4));
  const ahead = pointAt(cubic, Math.min(1, t + 1e-4));
  return unit(subtract(ahead, back));
}

/** Both parts together are the piece, by de Casteljau. */
export function split([p0, p1, p2, p3]: Cubic, t: number): [Cubic, Cubic] {
  const ab = lerp(p0, p1, t);
  const bc = lerp(p1, p2, t);
  const cd = lerp(p2, p3, t);
  const abc = lerp(ab, bc, t);
  const bcd = lerp(bc, cd, t);
  const middle = lerp(abc, bcd, t);
  return [
    [p0, ab, abc, middle],
    [middle, bcd, cd, p3],
  ];
}

/** The stretch from t0 to t1. */
export function subcurve(cubic: Cubic, t0: number, t1: number): Cubic {
  const from = pointAt(cubic, t0);
  const to = pointAt(cubic, t1);
  const third = (t1 - t0) / 3;
  const [out, into] = [derivativeAt(cubic, t0), derivativeAt(cubic, t1)];
  return [
    from,
    [from[0] + out[0] * third, from[1] + out[1] * third],
    [to[0] - into[0] * third, to[1] - into[1] * third],
    to,
  ];
}

/** Where one coordinate stands still, in (0, 1). */
function extremaOf(a0: number, a1: number, a2: number, a3: number): number[] {
  const a = a3 - 3 * a2 + 3 * a1 - a0;
  const halfB = a2 - 2 * a1 + a0;
  const c = a1 - a0;
  const discriminant = halfB * halfB - a * c;
  if (discriminant < 0) return [];
  const q = -(halfB + (halfB < 0 ? -1 : 1) * Math.sqrt(discriminant));
  return [a !== 0 ? q / a : 2, q !== 0 ? c / q : 2].filter((t) => t > 0 && t < 1);
}

/** Returns the bounds of the curve itself, not of its control points. */
export function cubicBounds(cubic: Cubic): Box {
  const [p0, p1, p2, p3] = cubic;
  const axis = (k: 0 | 1): number[] => [
    p0[k],
    p3[k],
    ...extremaOf(p0[k], p1[k], p2[k], p3[k]).map((t) => pointAt(cubic, t)[k]),
  ];
  const [xs, ys] = [axis(0), axis(1)];
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

/** The box around boxes; null for none. */
export function unionOf(boxes: Iterable<Box>): Box | null {
  let union: Box | null = null;
  for (const [x0, y0, x1, y1] of boxes) {
    union = union
      ? [
          Math.min(union[0], x0),
          Math.min(union[1], y0),
          Math.max(union[2], x1),
          Math.max(union[3], y1),
        ]
      : [x0, y0, x1, y1];
  }
  return union;
}

export function* piecesOf(path: CubicPath): Generator<Cubic> {
  for (let i = 0; i < pieceCount(path); ++i) yield pieceAt(path, i);
}

export function boundsOf(path: CubicPath): Box {
  const [[x, y]] = path.points;
  const boxes = Array.from(piecesOf(path), cubicBounds);
  return unionOf(boxes) ?? [x, y, x, y];
}

export function mappedPath(map: Affine, path: CubicPath): CubicPath {
  return { ...path, points: path.points.map((p) => mapped(map, p)) };
}

/** The same curve, walked the other way. */
export function reversedPath(path: CubicPath): CubicPath {
  const points = [...path.points].reverse();
  if (!path.segments) return { ...path, points };
  const pieces = pieceCount(path);
  return { ...path, points, segments: path.segments.map((first) => pieces - first).reverse() };
}
