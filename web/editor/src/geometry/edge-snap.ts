// Curves moved to the edges of a photo, their nodes kept: as many, and corners and smooth ones as
// they were.
import type { Point } from "./affine.js";
import { pieceAt, pieceCount, pointAt, type CubicPath } from "./cubic.js";
import { locate, pathLength } from "./length.js";
import { magnet, type EdgeMap } from "./magnet.js";
import { kindOf } from "./nodekind.js";
import { add, distance, dot, scaled, size, subtract, unit } from "./vector.js";

/** Between places that look for an edge, pixels. */
const SPACING = 1.5;
const MOST_PLACES = 4000;
/** Moves that each begin where the one before ended: within these shares of the reach. */
const TURNS = [1, 1, 1, 0.5, 0.25];
/** How much a place counts that has no edge within reach: its neighbours take it along. */
const LOST = 0.05;
/** How strongly control points hold to their places and to their neighbours'; a place on the edge counts 1. */
const HOLD = 0.02;
const EVEN = 0.3;
/** Steps of conjugate gradients to a control point, and their relative end. */
const STEPS = 4;
const END = 1e-8;
/** Less is no move, pixels. */
const LEAST = 0.05;

interface Place {
  /** The first control point of its piece. */
  readonly first: number;
  /** Weights of the piece's four control points at that place. */
  readonly weights: readonly [number, number, number, number];
  /** How much the place counts. */
  readonly share: number;
}

function placeOf(path: CubicPath, at: number, share: number): Place {
  const { piece, t } = locate(path, at);
  const s = 1 - t;
  return { first: 3 * piece, weights: [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t], share };
}

/** Places about SPACING apart, ends among them. */
function placesOn(path: CubicPath): number[] {
  const pieces = pieceCount(path);
  const each = Math.min(MOST_PLACES / pieces, pathLength(path) / SPACING / pieces);
  const count = Math.max(4, Math.ceil(each)) * pieces;
  return Array.from({ length: count + 1 }, (_, i) => (i * pieces) / count);
}

/** The equations of moves: of places, of holding still, and of moving as neighbours do. */
class Moves {
  readonly #places: readonly Place[];
  readonly #count: number;
  readonly #isClosed: boolean;

  constructor(path: CubicPath, places: readonly Place[]) {
    this.#places = places;
    this.#count = path.points.length;
    this.#isClosed = path.closed;
  }

  /** The node that ends a closed path is the one that begins it. */
  #tied(values: Float64Array): Float64Array {
    if (!this.#isClosed) return values;
    const last = this.#count - 1;
    values[0] += values[last];
    values[last] = 0;
    return values;
  }

  #spread(values: Float64Array): Float64Array {
    const spread = values.slice();
    if (this.#isClosed) spread[this.#count - 1] = spread[0];
    return spread;
  }

  rightSide(wanted: readonly number[]): Float64Array {
    const sums = new Float64Array(this.#count);
    this.#places.forEach(({ first, weights, share }, i) =>
      weights.forEach((weight, k) => (sums[first + k] += share * weight * wanted[i])),
    );
    return this.#tied(sums);
  }

  times(moves: Float64Array): Float64Array {
    const all = this.#spread(moves);
    const sums = new Float64Array(this.#count);
    for (const { first, weights, share } of this.#places) {
      const there = share * weights.reduce((sum, weight, k) => sum + weight * all[first + k], 0);
      weights.forEach((weight, k) => (sums[first + k] += weight * there));
    }
    for (let i = 0; i < this.#count; ++i) {
      sums[i] += HOLD * all[i];
      if (i + 1 === this.#count) continue;
      const apart = EVEN * (all[i] - all[i + 1]);
      sums[i] += apart;
      sums[i + 1] -= apart;
    }
    return this.#tied(sums);
  }

  /** By conjugate gradients. */
  solve(wanted: readonly number[]): Float64Array {
    const right = this.rightSide(wanted);
    const x = new Float64Array(this.#count);
    const rest = right.slice();
    let way = right.slice();
    const product = (a: Float64Array, b: Float64Array) => a.reduce((sum, value, i) => sum + value * b[i], 0);
    let left = product(rest, rest);
    const end = left * END;
    for (let step = 0; step < STEPS * this.#count && left > end; ++step) {
      const image = this.times(way);
      const far = left / product(way, image);
      for (let i = 0; i < x.length; ++i) {
        x[i] += far * way[i];
        rest[i] -= far * image[i];
      }
      const next = product(rest, rest);
      way = way.map((value, i) => rest[i] + (next / left) * value);
      left = next;
    }
    return this.#spread(x);
  }
}

/** Aligns the handles of a node that was smooth; a symmetric node's handles get equal lengths. */
function straightened(before: CubicPath, points: Point[]): void {
  const pieces = pieceCount(before);
  for (let node = 0; node < pieces; ++node) {
    const kind = kindOf(before, node);
    if (kind === "corner") continue;
    const into = node === 0 ? points.length - 2 : 3 * node - 1;
    const [at, out] = [points[3 * node], 3 * node + 1];
    const along = unit(subtract(points[out], points[into]));
    if (!along) continue;
    const lengths = [into, out].map((handle) => Math.max(0, Math.abs(dot(subtract(points[handle], at), along))));
    const [a, b] = kind === "symmetric" ? [0, 1].map(() => (lengths[0] + lengths[1]) / 2) : lengths;
    points[into] = add(at, scaled(along, -a));
    points[out] = add(at, scaled(along, b));
  }
}

function moved(edges: EdgeMap, path: CubicPath, reach: number): CubicPath {
  const at = placesOn(path);
  const from = at.map((place) => {
    const { piece, t } = locate(path, place);
    return pointAt(pieceAt(path, piece), t);
  });
  const to = magnet(edges, from, reach);
  // A curve without an edge keeps exactly its points.
  const moves = new Moves(
    path,
    at.map((place, i) => placeOf(path, place, to[i] === from[i] ? LOST : 1)),
  );
  const by = [0, 1].map((axis) => moves.solve(to.map((point, i) => point[axis] - from[i][axis])));
  const points = path.points.map((point, i): Point => add(point, [by[0][i], by[1][i]]));
  straightened(path, points);
  return { ...path, points };
}

/**
 * A path whose points have gone along its normal to the strongest edge within reach.
 * @param path in pixels of the photo
 * @returns null where it stays
 */
export function snappedPath(edges: EdgeMap, path: CubicPath, reach: number): CubicPath | null {
  if (!(pathLength(path) > 0)) return null;
  let now = path;
  // From nearer in the end, so that an edge beside the right one is not taken for it.
  for (const share of TURNS) now = moved(edges, now, share * reach);
  const most = Math.max(...now.points.map((point, i) => distance(point, path.points[i])));
  return most < LEAST || !now.points.every((point) => Number.isFinite(size(point))) ? null : now;
}
