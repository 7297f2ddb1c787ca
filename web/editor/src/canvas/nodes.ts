// Nodes and handles of a path: which control points belong to which node, and how they follow the pointer.
import type { Point } from "../geometry/affine.js";
import { pieceAt, pieceCount, pointAt, type CubicPath } from "../geometry/cubic.js";
import { locate } from "../geometry/length.js";
import { bent as bentPiece, kindOf, movedHandle, nodeOfHandle } from "../geometry/nodes.js";
import { add } from "../geometry/vector.js";

/** Control points of the handles towards the beginning and the end; null where the path ends. */
export function handlesOf(
  path: CubicPath,
  node: number,
): { before: number | null; after: number | null } {
  const last = path.points.length - 1;
  const at = 3 * node;
  return {
    before: at > 0 ? at - 1 : path.closed ? last - 1 : null,
    after: at < last ? at + 1 : path.closed ? 1 : null,
  };
}

/** The other end of an open path, where a node is one of its ends; null: it is none. */
export function otherEnd(path: CubicPath, node: number): Point | null {
  const last = pieceCount(path);
  if (path.closed || last < 2 || (node !== 0 && node !== last)) return null;
  return path.points[node === 0 ? 3 * last : 0];
}

/** Returns the handle, of a node's two, whose piece leads to where it is pulled. */
export function pulledHandle(path: CubicPath, node: number, [dx, dy]: Point): number | null {
  const { before, after } = handlesOf(path, node);
  if (before === null || after === null) return after ?? before;
  const [x, y] = path.points[3 * node];
  const last = path.points.length - 1;
  const towards = (index: number) => {
    const [nx, ny] = path.points[(index + last) % last];
    return ((nx - x) * dx + (ny - y) * dy) / Math.max(Math.hypot(nx - x, ny - y), 1e-12);
  };
  return towards(3 * node - 3) > towards(3 * node + 3) ? before : after;
}

/**
 * A path with one handle moved. Where the node was smooth the opposite handle turns with it, and
 * where it was symmetric is as long; unless `isBroken`.
 */
export function withHandle(
  path: CubicPath,
  handle: number,
  to: Point,
  isBroken: boolean,
): CubicPath {
  const kind = isBroken ? "corner" : kindOf(path, nodeOfHandle(path, handle));
  return movedHandle(path, handle, to, kind === "corner" ? "free" : kind).path;
}

/** Both handles weigh alike so near the ends of a piece that they would fly off. */
const NEAREST_END = 0.12;

/** A path bent so that its point at a place moves by a vector. Smooth nodes stay smooth. */
export function bent(path: CubicPath, at: number, by: Point): CubicPath {
  const { piece, t: exact } = locate(path, at);
  const t = Math.min(1 - NEAREST_END, Math.max(NEAREST_END, exact));
  const to = add(pointAt(pieceAt(path, Math.min(piece, pieceCount(path) - 1)), t), by);
  const { points } = bentPiece(path, piece, t, to).path;
  const [a, b] = [3 * piece + 1, 3 * piece + 2];
  return withHandle(withHandle(path, a, points[a], false), b, points[b], false);
}
