// Nodes and handles of a path: which control point is whose, and how they move together.
import type { Point } from "../geometry/affine.js";
import { pieceCount, type CubicPath } from "../geometry/cubic.js";

/** Lines whose directions differ by less are one line: the sine of the angle. */
const COLLINEAR = 0.02;
/** Handles nearer to their node, as a share of the other's length, have no direction. */
const SHORT = 1e-6;

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

/** The node of a handle, a control point that is no node. */
export function nodeOfHandle(path: CubicPath, handle: number): number {
  const node = Math.round(handle / 3);
  return path.closed && 3 * node === path.points.length - 1 ? 0 : node;
}

/** The other handle of the same node, or null. */
export function oppositeOf(path: CubicPath, handle: number): number | null {
  const { before, after } = handlesOf(path, nodeOfHandle(path, handle));
  return handle === before ? after : before;
}

export type Joint = "corner" | "smooth" | "symmetric";

/** How the handles of a node lie: on one line, and also alike long. */
export function jointOf(path: CubicPath, node: number): Joint {
  const { before, after } = handlesOf(path, node);
  if (before === null || after === null) return "corner";
  const [x, y] = path.points[3 * node];
  const [ax, ay] = [path.points[before][0] - x, path.points[before][1] - y];
  const [bx, by] = [path.points[after][0] - x, path.points[after][1] - y];
  const [a, b] = [Math.hypot(ax, ay), Math.hypot(bx, by)];
  if (Math.min(a, b) <= SHORT * Math.max(a, b) || ax * bx + ay * by >= 0) return "corner";
  if (Math.abs(ax * by - ay * bx) > COLLINEAR * a * b) return "corner";
  return Math.abs(a - b) <= COLLINEAR * Math.max(a, b) ? "symmetric" : "smooth";
}

/** A path with some control points elsewhere; the end of a closed path follows its beginning. */
export function withPoints(path: CubicPath, moved: ReadonlyMap<number, Point>): CubicPath {
  const points = path.points.map((point, k) => moved.get(k) ?? point);
  const last = points.length - 1;
  if (path.closed) points[last] = moved.get(0) ?? moved.get(last) ?? points[0];
  if (path.closed) points[0] = points[last];
  return { ...path, points };
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
  const moved = new Map<number, Point>([[handle, to]]);
  const opposite = oppositeOf(path, handle);
  const node = nodeOfHandle(path, handle);
  const joint = isBroken ? "corner" : jointOf(path, node);
  if (opposite !== null && joint !== "corner") {
    const [x, y] = path.points[3 * node];
    const [dx, dy] = [to[0] - x, to[1] - y];
    const length = Math.hypot(dx, dy);
    const [ox, oy] = path.points[opposite];
    const wanted = joint === "symmetric" ? length : Math.hypot(ox - x, oy - y);
    if (length > 0) moved.set(opposite, [x - (dx / length) * wanted, y - (dy / length) * wanted]);
  }
  return withPoints(path, moved);
}

/** Where both handles of a piece weigh alike, so near its ends they would fly off. */
const NEAREST_END = 0.12;

/**
 * A piece bent so that its point at t moves by a vector: its two handles share the way in the
 * proportion of their weights there. Smooth nodes stay smooth.
 */
export function bent(path: CubicPath, at: number, [dx, dy]: Point): CubicPath {
  const piece = Math.min(pieceCount(path) - 1, Math.floor(at));
  const t = Math.min(1 - NEAREST_END, Math.max(NEAREST_END, at - piece));
  const first = 3 * t * (1 - t) * (1 - t);
  const second = 3 * t * t * (1 - t);
  const norm = first * first + second * second;
  const shifted = (handle: number, weight: number): Point => [
    path.points[handle][0] + (dx * weight) / norm,
    path.points[handle][1] + (dy * weight) / norm,
  ];
  const [a, b] = [3 * piece + 1, 3 * piece + 2];
  const once = withHandle(path, a, shifted(a, first), false);
  return withHandle(once, b, shifted(b, second), false);
}
