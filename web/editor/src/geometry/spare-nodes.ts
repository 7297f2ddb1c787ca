// Nodes that a shape does not need.
import { nodeCount, pieceAt, pieceCount, pointAt, type Cubic, type CubicPath } from "./cubic.js";
import { nearestOn } from "./nearest.js";
import { merged } from "./nodes.js";

/** Points of a piece that are compared. */
const SAMPLES = 8;
/** The most pieces that become one. */
const MOST = 32;

function canMerge(pieces: readonly Cubic[], tolerance: number): boolean {
  const one = { points: merged(pieces), closed: false };
  return pieces.every((piece) =>
    Array.from({ length: SAMPLES }, (_, i) => pointAt(piece, (i + 1) / SAMPLES)).every(
      (point) => nearestOn(one, point).distance <= tolerance,
    ),
  );
}

/** Returns nodes without which the path, fitted to its shape, stays within `tolerance` of it. */
export function spareNodes(path: CubicPath, tolerance: number): number[] {
  const pieces = Array.from({ length: pieceCount(path) }, (_, i) => pieceAt(path, i));
  const spare: number[] = [];
  let left = nodeCount(path) - 2;
  for (let from = 0; from < pieces.length; ) {
    let to = from + 1;
    while (to < pieces.length && to - from < MOST && left > 0) {
      if (!canMerge(pieces.slice(from, to + 1), tolerance)) break;
      spare.push(to);
      left -= 1;
      to += 1;
    }
    from = to;
  }
  return spare;
}
