// Elliptical arcs as cubics, by the engine's construction (src/formats/svg/shapes/path.cpp).
import type { Point } from "./affine.js";
import { add, cross, dot, scaled, size, subtract } from "./vector.js";

/** How far the pieces stray from the arc, in radii, at most. */
const ARC_ERROR = 1e-7;
/** Tolerance for the sine or cosine of an arc's angle. */
const TURN_SLACK = 1e-12;

export type ArcPiece = readonly [control1: Point, control2: Point, end: Point];

function normalized(v: Point): Point {
  const length = size(v);
  return [v[0] / length, v[1] / length];
}

/** A quarter turn, clockwise on the screen where `sweep`. */
const quarterTurn = ([x, y]: Point, sweep: boolean): Point => (sweep ? [-y, x] : [y, -x]);

/** Unit vectors between which the arc runs in equal parts of at most a quarter turn. */
function quarters(from: Point, to: Point, sweep: boolean): Point[] {
  const turn = sweep ? cross(from, to) : -cross(from, to);
  const cosine = dot(from, to);
  // Exact quarter and half turns are common: rounding must not give them a piece more.
  if (turn > 0 && cosine >= -TURN_SLACK) return [from, to];
  const chordMiddle = add(from, to);
  const aside = quarterTurn(subtract(to, from), !sweep);
  // Towards the middle of the half turn that the arc is nearest to: well defined near 180 degrees.
  const middle = normalized(turn > 0 ? add(chordMiddle, aside) : subtract(aside, chordMiddle));
  if (turn >= (cosine < 0 ? -TURN_SLACK : 0)) return [from, middle, to];
  return [from, normalized(add(from, middle)), middle, normalized(add(middle, to)), to];
}

/** 4/3 of the tangent of a quarter of the angle between two unit vectors. */
function handleLength(from: Point, to: Point): number {
  const halfTangent = Math.abs(cross(from, to)) / (1 + dot(from, to));
  return ((4 / 3) * halfTangent) / (1 + Math.sqrt(1 + halfTangent * halfTangent));
}

/** How far that cubic strays from the arc, in radii. */
function arcError(handle: number): number {
  const square = (0.75 * handle) ** 2;
  const sineSquared = square / (1 + square);
  return (2 / 27) * sineSquared * sineSquared * square;
}

function stationsOf(from: Point, to: Point, sweep: boolean): Point[] {
  let stations = quarters(from, to, sweep);
  while (arcError(handleLength(stations[0], stations[1])) > ARC_ERROR) {
    const coarse = stations;
    stations = [coarse[0]];
    for (let i = 1; i < coarse.length; ++i) {
      stations.push(normalized(add(coarse[i - 1], coarse[i])), coarse[i]);
    }
  }
  return stations;
}

/** Exact at multiples of 90 degrees. */
function sineAndCosine(degrees: number): Point {
  const turn = degrees % 360;
  const quarter = Math.floor(turn / 90 + 0.5);
  const rest = (turn - 90 * quarter) * (Math.PI / 180);
  const s = Math.sin(rest);
  const c = Math.cos(rest);
  return (
    [
      [s, c],
      [c, -s],
      [-s, -c],
      [-c, s],
    ] as const
  )[quarter & 3];
}

/**
 * SVG 1.1, appendix F.6: from `from` to `point` on an ellipse; the number of pieces is a power of
 * two. null: it is a straight line.
 */
export function arcPieces(
  from: Point,
  written: Point,
  degrees: number,
  large: boolean,
  sweep: boolean,
  point: Point,
): ArcPiece[] | null {
  let radii: Point = [Math.abs(written[0]), Math.abs(written[1])];
  if ((point[0] === from[0] && point[1] === from[1]) || radii[0] === 0 || radii[1] === 0)
    return null;
  const [sin, cos] = sineAndCosine(degrees);
  const [hx, hy] = scaled(subtract(from, point), 0.5);
  let half: Point = [(cos * hx + sin * hy) / radii[0], (cos * hy - sin * hx) / radii[1]];
  const tooFar = size(half);
  if (tooFar > 1) {
    // No such ellipse: the smallest similar one that reaches (F.6.6).
    radii = scaled(radii, tooFar);
    half = [half[0] / tooFar, half[1] / tooFar];
  }
  if (!Number.isFinite(tooFar) || tooFar === 0) return null;
  const away = Math.sqrt(Math.max(0, 1 - dot(half, half)));
  const center = scaled(quarterTurn(normalized(half), large === sweep), away);
  const [unitFrom, unitTo] = [subtract(half, center), subtract(scaled(half, -1), center)];
  const stations = stationsOf(normalized(unitFrom), normalized(unitTo), sweep);
  const handle = handleLength(stations[0], stations[1]);
  const middle = scaled(add(from, point), 0.5);
  const toUser = (unit: Point): Point => {
    const [x, y] = add(unit, center);
    return [
      middle[0] + cos * radii[0] * x - sin * radii[1] * y,
      middle[1] + sin * radii[0] * x + cos * radii[1] * y,
    ];
  };
  return stations
    .slice(1)
    .map((to, i) => [
      toUser(add(stations[i], scaled(quarterTurn(stations[i], sweep), handle))),
      toUser(subtract(to, scaled(quarterTurn(to, sweep), handle))),
      i === stations.length - 2 ? point : toUser(to),
    ]);
}
