// Parts of a path from node to node.
import { pieceAt, pieceCount, type CubicPath } from "./cubic.js";
import { cumulativeLengths } from "./length.js";
import { pathOf } from "./nodes.js";

/** Nodes at which a part begins and ends. In a closed path the end may be beyond the last node. */
export interface Stretch {
  readonly from: number;
  readonly to: number;
}

/** Returns the parts of a path that is cut at nodes, in its direction; none if no node cuts it. */
export function stretchesOf(path: CubicPath, nodes: readonly number[]): readonly Stretch[] {
  const count = pieceCount(path);
  const isCut = (node: number) => (path.closed ? node >= 0 : node > 0) && node < count;
  const wrapped = nodes.map((node) => (path.closed && node === count ? 0 : node));
  const cuts = [...new Set(wrapped)].filter(isCut).sort((a, b) => a - b);
  if (cuts.length === 0) return [];
  const bounds = path.closed ? [...cuts, cuts[0] + count] : [0, ...cuts, count];
  return bounds.slice(1).map((to, i) => ({ from: bounds[i], to }));
}

/** Returns a part as an open path. */
export function partOf(path: CubicPath, { from, to }: Stretch): CubicPath {
  const count = pieceCount(path);
  const pieces = Array.from({ length: to - from }, (_, i) => pieceAt(path, (from + i) % count));
  return pathOf(pieces, false);
}

/** Returns the share of the arc length before a node; beyond the last node it is more than 1. */
export function shareAtNode(path: CubicPath, node: number): number {
  const count = pieceCount(path);
  const lengths = cumulativeLengths(path);
  const laps = Math.floor(node / count);
  return laps + lengths[node - laps * count] / lengths[count];
}
