// Curves as polylines, and the points of curves that are nearest to others.
import type { Box, Point } from "./affine.js";
import {
  derivativeAt,
  pieceAt,
  pieceCount,
  piecesOf,
  pointAt,
  secondDerivativeAt,
  split,
  type Cubic,
  type CubicPath,
} from "./cubic.js";
import { distance, dot, subtract } from "./vector.js";

export interface Polyline {
  readonly points: readonly Point[];
  /** The place of each on the path: piece + t. */
  readonly places: readonly number[];
}

const MOST_CHORDS = 1024;

/** Chords at most `tolerance` from the curve. */
export function flatten(path: CubicPath, tolerance: number): Polyline {
  const points: Point[] = [path.points[0]];
  const places = [0];
  let piece = 0;
  for (const cubic of piecesOf(path)) {
    const count = chordCount(cubic, tolerance);
    for (let i = 1; i <= count; ++i) {
      points.push(pointAt(cubic, i / count));
      places.push(piece + i / count);
    }
    ++piece;
  }
  return { points, places };
}

/** A chord over h of t is at most h²/8 of the largest second derivative from its arc. */
function chordCount(cubic: Cubic, tolerance: number): number {
  const bend = Math.max(...[0, 1].map((t) => Math.hypot(...secondDerivativeAt(cubic, t))));
  const count = Math.ceil(Math.sqrt(bend / (8 * Math.max(tolerance, Number.MIN_VALUE))));
  return Math.min(Math.max(Number.isFinite(count) ? count : MOST_CHORDS, 1), MOST_CHORDS);
}

export interface Nearest {
  /** piece + t */
  readonly at: number;
  readonly point: Point;
  readonly distance: number;
}

/** The box of the control points, within which the piece lies. */
function hullBox([p0, p1, p2, p3]: Cubic): Box {
  return [
    Math.min(p0[0], p1[0], p2[0], p3[0]),
    Math.min(p0[1], p1[1], p2[1], p3[1]),
    Math.max(p0[0], p1[0], p2[0], p3[0]),
    Math.max(p0[1], p1[1], p2[1], p3[1]),
  ];
}

/** 0 within the box. */
export function distanceToBox([x, y]: Point, [x0, y0, x1, y1]: Box): number {
  return Math.hypot(Math.max(x0 - x, 0, x - x1), Math.max(y0 - y, 0, y - y1));
}

/** Newton's steps towards the foot of the perpendicular, from a parameter close to it. */
function polished(cubic: Cubic, point: Point, from: number): number {
  let t = from;
  for (let i = 0; i < 4; ++i) {
    const off = subtract(pointAt(cubic, t), point);
    const along = derivativeAt(cubic, t);
    const slope = dot(along, along) + dot(off, secondDerivativeAt(cubic, t));
    if (!(slope > 0)) break;
    t = Math.min(Math.max(t - dot(off, along) / slope, 0), 1);
  }
  return distance(pointAt(cubic, t), point) <= distance(pointAt(cubic, from), point) ? t : from;
}

/** Halves pieces, and leaves out those whose hull is farther than what was found. */
class Search {
  at = 0;
  #whole: Cubic;
  #piece: number;

  constructor(
    readonly path: CubicPath,
    readonly point: Point,
    /** That of what was found, or of what is looked for. */
    public distance: number,
  ) {
    this.#whole = pieceAt(path, 0);
    this.#piece = 0;
  }

  run(): void {
    const order = Array.from(piecesOf(this.path), (cubic, i) => ({
      cubic,
      i,
      bound: distanceToBox(this.point, hullBox(cubic)),
    }));
    order.sort((a, b) => a.bound - b.bound);
    for (const { cubic, i, bound } of order) {
      if (bound >= this.distance) return;
      [this.#whole, this.#piece] = [cubic, i];
      this.#look(cubic, 0, 1, 0);
    }
  }

  #look(cubic: Cubic, t0: number, t1: number, depth: number): void {
    const middle = 0.5 * (t0 + t1);
    for (const t of [t0, middle, t1]) this.#try(t);
    const extent = distance(cubic[0], cubic[3]);
    if (depth >= 24 || extent + deviation(cubic) === 0) return;
    if (depth > 2 && deviation(cubic) < 1e-3 * extent)
      return this.#try(polished(this.#whole, this.point, this.#onChord(cubic, t0, t1)));
    const [first, second] = split(cubic, 0.5);
    const halves = [
      { half: first, t0, t1: middle },
      { half: second, t0: middle, t1 },
    ].map((part) => ({ ...part, bound: distanceToBox(this.point, hullBox(part.half)) }));
    halves.sort((a, b) => a.bound - b.bound);
    for (const part of halves) {
      if (part.bound < this.distance) this.#look(part.half, part.t0, part.t1, depth + 1);
    }
  }

  #onChord([from, , , to]: Cubic, t0: number, t1: number): number {
    const chord = subtract(to, from);
    const share = dot(subtract(this.point, from), chord) / dot(chord, chord);
    return t0 + Math.min(Math.max(share, 0), 1) * (t1 - t0);
  }

  #try(t: number): void {
    const found = distance(pointAt(this.#whole, t), this.point);
    if (found >= this.distance) return;
    this.distance = found;
    this.at = this.#piece + t;
  }
}

/** How far the control points are from thirds of the chord: the curve is no farther from it. */
function deviation([p0, p1, p2, p3]: Cubic): number {
  const third = (k: number): Point => [
    p0[0] + ((p3[0] - p0[0]) * k) / 3,
    p0[1] + ((p3[1] - p0[1]) * k) / 3,
  ];
  return Math.max(distance(p1, third(1)), distance(p2, third(2)));
}

/** The point of a path that is nearest to another, all of the curve considered. */
export function nearestOn(path: CubicPath, point: Point): Nearest;
/** The same where it is nearer than `within`; else null, which takes less time to see. */
export function nearestOn(path: CubicPath, point: Point, within: number): Nearest | null;
export function nearestOn(path: CubicPath, point: Point, within = Infinity): Nearest | null {
  const search = new Search(path, point, within);
  search.run();
  if (within < Infinity && search.distance === within) return null;
  const piece = Math.min(Math.floor(search.at), pieceCount(path) - 1);
  const found = pointAt(pieceAt(path, piece), search.at - piece);
  return { at: search.at, point: found, distance: search.distance };
}

/** Returns the greatest distance of a curve from another, measured at `samples` places of each piece. */
export function farthestFrom(path: CubicPath, other: CubicPath, samples = 16): number {
  let most = 0;
  for (const cubic of piecesOf(path)) {
    for (let i = 0; i <= samples; ++i) {
      most = Math.max(most, nearestOn(other, pointAt(cubic, i / samples)).distance);
    }
  }
  return most;
}
