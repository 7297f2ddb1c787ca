// Cubic pieces through points of a smooth stretch: P. J. Schneider, "An Algorithm for Automatically
// Fitting Digitized Curves", Graphics Gems, 1990.
import type { Point } from "./affine.js";
import { derivativeAt, directionAt, lineBetween, pointAt, secondDerivativeAt, type Cubic } from "./cubic.js";
import { add, distance, dot, isSame, lerp, scaled, subtract, unit } from "./vector.js";

export interface FittedPiece {
  readonly cubic: Cubic;
  /** Parameter of each point of the stretch, including the first and the last. */
  readonly parameters: readonly number[];
}

const ROUNDS = 12;
/** Other parameters cannot repair an error of more tolerances than this. */
const HOPELESS = 6;
/** Beyond this depth stretches are halved, so that none is deep for long. */
const DEEP = 32;
/** Length over which the direction at a point is measured, tolerances. */
const REACH = 4;

function chordParameters(points: readonly Point[]): number[] {
  const lengths = [0];
  for (let i = 1; i < points.length; ++i) {
    lengths.push(lengths[i - 1] + distance(points[i - 1], points[i]));
  }
  const whole = lengths[lengths.length - 1];
  return lengths.map((length) => length / whole);
}

/**
 * The cubic of least squares with these ends and end directions (`into` points back from the end).
 */
function leastSquares(
  points: readonly Point[],
  t: readonly number[],
  out: Point,
  into: Point,
): Cubic {
  const from = points[0];
  const to = points[points.length - 1];
  let [c00, c01, c11, x0, x1] = [0, 0, 0, 0, 0];
  points.forEach((point, i) => {
    const [u, s] = [t[i], 1 - t[i]];
    const [b1, b2] = [3 * u * s * s, 3 * u * u * s];
    const rest = subtract(point, lerp(from, to, u * u * (3 - 2 * u)));
    c00 += b1 * b1;
    c01 += b1 * b2 * dot(out, into);
    c11 += b2 * b2;
    x0 += b1 * dot(out, rest);
    x1 += b2 * dot(into, rest);
  });
  const determinant = c00 * c11 - c01 * c01;
  let first = (x0 * c11 - x1 * c01) / determinant;
  let second = (c00 * x1 - c01 * x0) / determinant;
  const chord = distance(from, to);
  const length = points.slice(1).reduce((sum, p, i) => sum + distance(p, points[i]), 0);
  const isSound = (a: number) => a > 1e-6 * chord && a <= length;
  // Wu and Barsky's choice where the equations say nothing.
  if (!isSound(first) || !isSound(second)) first = second = (chord > 0 ? chord : length) / 3;
  return [from, add(from, scaled(out, first)), add(to, scaled(into, second)), to];
}

/** Parameters moved by one step of Newton's towards the nearest points, in order. */
function reparametrized(cubic: Cubic, points: readonly Point[], t: readonly number[]): number[] {
  const last = points.length - 1;
  let least = 0;
  return points.map((point, i) => {
    if (i === 0 || i === last) return t[i];
    const off = subtract(pointAt(cubic, t[i]), point);
    const along = derivativeAt(cubic, t[i]);
    const slope = dot(along, along) + dot(off, secondDerivativeAt(cubic, t[i]));
    const moved = slope > 0 ? t[i] - dot(off, along) / slope : t[i];
    least = Math.min(Math.max(moved, least), 1);
    return least;
  });
}

function worst(cubic: Cubic, points: readonly Point[], t: readonly number[]): [number, number] {
  let [index, most] = [points.length >> 1, 0];
  for (let i = 1; i + 1 < points.length; ++i) {
    const miss = distance(pointAt(cubic, t[i]), points[i]);
    if (miss > most) [index, most] = [i, miss];
  }
  return [index, most];
}

/** The direction through point i, from its neighbours. */
function centerDirection(points: readonly Point[], i: number, reach: number): Point {
  let [a, b] = [i - 1, i + 1];
  while (a > 0 && distance(points[a], points[i]) < reach) --a;
  while (b < points.length - 1 && distance(points[b], points[i]) < reach) ++b;
  const through = isSame(points[a], points[b])
    ? subtract(points[i], points[i - 1])
    : subtract(points[b], points[a]);
  return unit(through) ?? [1, 0];
}

/**
 * One piece as near to the points as it gets with these ends and end directions.
 * @param points at least 3, no two neighbours the same
 */
export function fittedOnce(points: readonly Point[], out: Point, into: Point): FittedPiece {
  let parameters = chordParameters(points);
  let cubic = leastSquares(points, parameters, out, into);
  for (let round = 0; round < 4 * ROUNDS; ++round) {
    parameters = reparametrized(cubic, points, parameters);
    cubic = leastSquares(points, parameters, out, into);
  }
  return { cubic, parameters };
}

/** One piece with these end directions, where it passes each point within the tolerance, and what not. */
function single(points: readonly Point[], out: Point, into: Point, tolerance: number) {
  let parameters = chordParameters(points);
  let cubic = leastSquares(points, parameters, out, into);
  let [index, miss] = worst(cubic, points, parameters);
  for (let round = 0; round < ROUNDS && miss > tolerance && miss < HOPELESS * tolerance; ++round) {
    parameters = reparametrized(cubic, points, parameters);
    cubic = leastSquares(points, parameters, out, into);
    [index, miss] = worst(cubic, points, parameters);
  }
  return { cubic, parameters, index, isNear: miss <= tolerance };
}

/** The straight line, where each point is within the tolerance of it; null: one is not. */
export function straight(points: readonly Point[], tolerance: number): FittedPiece | null {
  const [from, to] = [points[0], points[points.length - 1]];
  const way = subtract(to, from);
  const square = dot(way, way);
  if (!(square > 0)) return null;
  let least = 0;
  const parameters = points.map((point) => {
    least = Math.min(Math.max(dot(subtract(point, from), way) / square, least), 1);
    return least;
  });
  parameters[points.length - 1] = 1;
  const isNear = points.every((p, i) => distance(p, lerp(from, to, parameters[i])) <= tolerance);
  return isNear ? { cubic: lineBetween(from, to), parameters } : null;
}

/**
 * Pieces, smooth where they meet, that pass each point within `tolerance`.
 * @param points at least 2, no two neighbours the same
 * @param out direction at the beginning, of length 1
 * @param into direction back from the end, of length 1
 */
export function fitted(
  points: readonly Point[],
  out: Point,
  into: Point,
  tolerance: number,
): FittedPiece[] {
  return fewer(points, parted(points, out, into, tolerance, 0), tolerance);
}

function parted(
  points: readonly Point[],
  out: Point,
  into: Point,
  tolerance: number,
  depth: number,
): FittedPiece[] {
  if (points.length === 2) {
    const third = distance(points[0], points[1]) / 3;
    const controls = [add(points[0], scaled(out, third)), add(points[1], scaled(into, third))];
    return [{ cubic: [points[0], controls[0], controls[1], points[1]], parameters: [0, 1] }];
  }
  const { cubic, parameters, index, isNear } = single(points, out, into, tolerance);
  if (isNear) return [{ cubic, parameters }];
  const at = depth < DEEP ? index : points.length >> 1;
  const through = centerDirection(points, at, REACH * tolerance);
  return [
    ...parted(points.slice(0, at + 1), out, scaled(through, -1), tolerance, depth + 1),
    ...parted(points.slice(at), through, into, tolerance, depth + 1),
  ];
}

/** Neighbouring pieces become one wherever one passes their points, too. */
function fewer(
  points: readonly Point[],
  pieces: readonly FittedPiece[],
  tolerance: number,
): FittedPiece[] {
  const kept = [...pieces];
  let begin = 0;
  for (let i = 0; i + 1 < kept.length;) {
    const [a, b] = [kept[i], kept[i + 1]];
    const end = begin + a.parameters.length + b.parameters.length - 2;
    const [out, into] = [directionAt(a.cubic, 0), directionAt(b.cubic, 1)];
    const one =
      out && into && single(points.slice(begin, end + 1), out, scaled(into, -1), tolerance);
    if (one && one.isNear) {
      kept.splice(i, 2, { cubic: one.cubic, parameters: one.parameters });
      // A stretch that grew may absorb the one before it.
      if (i > 0) {
        i -= 1;
        begin -= kept[i].parameters.length - 1;
      }
    } else {
      begin += a.parameters.length - 1;
      i += 1;
    }
  }
  return kept;
}
