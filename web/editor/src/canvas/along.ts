// The place on a path that is nearest to a point.
import { mapped, type Affine, type Point } from "../geometry/affine.js";
import { mappedPath, pieceCount, type CubicPath } from "../geometry/cubic.js";
import { pathDirectionAt, pathPointAt } from "../geometry/length.js";

/** Samples of each piece, and thirds that are cut off around the nearest. */
const SAMPLES = 32;
const REFINEMENTS = 24;

export interface Nearest {
  /** Piece + t. */
  readonly at: number;
  readonly point: Point;
  readonly distance: number;
}

/** @param map from the path's coordinates to the point's, in which distances are measured */
export function nearestAt(path: CubicPath, map: Affine, [x, y]: Point): Nearest {
  const seen = mappedPath(map, path);
  const pieces = pieceCount(path);
  const distanceAt = (at: number) => {
    const [px, py] = pathPointAt(seen, at);
    return Math.hypot(px - x, py - y);
  };
  let best = 0;
  let least = Infinity;
  for (let k = 0; k <= pieces * SAMPLES; k += 1) {
    const distance = distanceAt(k / SAMPLES);
    if (distance < least) [best, least] = [k, distance];
  }
  let low = Math.max(0, (best - 1) / SAMPLES);
  let high = Math.min(pieces, (best + 1) / SAMPLES);
  for (let k = 0; k < REFINEMENTS; k += 1) {
    const third = (high - low) / 3;
    if (distanceAt(low + third) <= distanceAt(high - third)) high -= third;
    else low += third;
  }
  const ends = [(low + high) / 2, low, high].sort((a, b) => distanceAt(a) - distanceAt(b));
  return { at: ends[0], point: pathPointAt(seen, ends[0]), distance: distanceAt(ends[0]) };
}

/**
 * Where a place of a path is on the stage, and the unit vector to a side of it there.
 * @param sign 1: what is left in the path's own coordinates, -1: right
 */
export function standing(path: CubicPath, map: Affine, at: number, sign: 1 | -1): { foot: Point; normal: Point } {
  const foot = mapped(map, pathPointAt(path, at));
  const [dx, dy] = pathDirectionAt(path, at) ?? [1, 0];
  const along: Point = [map[0] * dx + map[2] * dy, map[1] * dx + map[3] * dy];
  const length = Math.hypot(...along) || 1;
  // A map that mirrors turns left to right.
  const turned = (map[0] * map[3] - map[1] * map[2] < 0 ? -sign : sign) / length;
  return { foot, normal: [along[1] * turned, -along[0] * turned] };
}
