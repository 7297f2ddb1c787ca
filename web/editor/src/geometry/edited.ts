// Curves after an edit.
import type { Point } from "./affine.js";
import { pieceCount, type CubicPath } from "./cubic.js";

/** A path after an edit, and what became of places (piece + t) on the path before. */
export interface Edited {
  readonly path: CubicPath;
  readonly follow: (place: number) => number;
  /** Places before, at which the speed of `follow` changes. */
  readonly bends: readonly number[];
  /** Returns where a share of the arc length lies in a path that became longer; absent: shares stay. */
  readonly shares?: (share: number) => number;
}

/** Each piece is still where it was. */
export const STAYS = { follow: (place: number) => place, bends: [] } as const;

/** The same pieces with other points. */
export function withPoints(path: CubicPath, points: readonly Point[]): Edited {
  return { path: { points, closed: path.closed }, ...STAYS };
}

/** Pieces before and after a node; null where the path ends there. */
export function piecesAround(
  path: CubicPath,
  node: number,
): { into: number | null; out: number | null } {
  const pieces = pieceCount(path);
  if (path.closed) return { into: (node - 1 + pieces) % pieces, out: node % pieces };
  return { into: node > 0 ? node - 1 : null, out: node < pieces ? node : null };
}
