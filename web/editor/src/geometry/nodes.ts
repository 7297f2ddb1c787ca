// Curves edited by their nodes. Node i is control point 3 i; of a closed path the last is the
// first.
import type { Point } from "./affine.js";
import {
  directionAt,
  isLine,
  lineBetween,
  nodeCount,
  pieceAt,
  pieceCount,
  pointAt,
  reversedPath,
  split,
  type Cubic,
  type CubicPath,
} from "./cubic.js";
import { STAYS, withPoints, type Edited } from "./edited.js";
import { fittedOnce } from "./fitcubic.js";
import { cubicLength, parameterAtLength } from "./length.js";
import { add, distance, isSame, scaled, subtract, unit } from "./vector.js";

export { piecesAround, withPoints, type Edited } from "./edited.js";
export { kindOf, withKind, type NodeKind } from "./nodekind.js";

export function pathOf(cubics: readonly Cubic[], closed: boolean): CubicPath {
  const points = [cubics[0][0], ...cubics.flatMap((cubic) => cubic.slice(1))];
  if (closed) points[points.length - 1] = points[0];
  return { points, closed };
}

/** Lines whose ends moved are lines again. */
function straightened(before: CubicPath, points: Point[]): void {
  for (let i = 0; i < pieceCount(before); ++i) {
    const cubic = pieceAt(before, i);
    const [from, to] = [points[3 * i], points[3 * i + 3]];
    if (!isLine(cubic) || (isSame(from, cubic[0]) && isSame(to, cubic[3]))) continue;
    [, points[3 * i + 1], points[3 * i + 2]] = lineBetween(from, to);
  }
}

/** Moves nodes, and their handles with them. Lines stay lines. */
export function movedNodes(path: CubicPath, nodes: readonly number[], by: Point): Edited {
  const last = path.points.length - 1;
  const moving = new Set<number>();
  for (const node of nodes) {
    const at = path.closed && node === pieceCount(path) ? 0 : 3 * node;
    for (const i of [at - 1, at, at + 1]) {
      if (i >= 0 && i <= last) moving.add(i);
      else if (path.closed && i < 0) moving.add(last - 1);
    }
    if (path.closed && at === 0) moving.add(last);
  }
  const points = path.points.map((p, i) => (moving.has(i) ? add(p, by) : p));
  straightened(path, points);
  return withPoints(path, points);
}

/** The node of a handle, a control point that is no node. */
export function nodeOfHandle(path: CubicPath, handle: number): number {
  const node = Math.round(handle / 3);
  return path.closed && 3 * node === path.points.length - 1 ? 0 : node;
}

/** How the other handle of a node answers when one moves. */
export type HandleLink = "free" | "smooth" | "symmetric";

/** Moves a handle: control point `index`, which is no node. */
export function movedHandle(path: CubicPath, index: number, to: Point, link: HandleLink): Edited {
  const points = [...path.points];
  points[index] = to;
  const node = Math.round(index / 3);
  const other = oppositeHandle(path, index);
  if (link !== "free" && other !== null) {
    const at = points[3 * node];
    const direction = unit(subtract(at, to));
    const length = link === "symmetric" ? distance(at, to) : distance(at, points[other]);
    const piece = Math.floor(other / 3);
    // The other side of a line has no handle that could answer.
    if (direction && !isLine(pieceAt(path, piece)))
      points[other] = add(at, scaled(direction, length));
  }
  return withPoints(path, points);
}

/** The handle on the other side of a handle's node; null at the end of an open path. */
export function oppositeHandle(path: CubicPath, index: number): number | null {
  const node = Math.round(index / 3);
  const other = 6 * node - index;
  const last = path.points.length - 1;
  if (other > 0 && other < last) return other;
  if (!path.closed) return null;
  return other < 0 ? last + other : other - last;
}

/** Bends a piece so that its point at t comes to lie at `to`; nodes stay. */
export function bent(path: CubicPath, piece: number, t: number, to: Point): Edited {
  const cubic = pieceAt(path, piece);
  const by = subtract(to, pointAt(cubic, t));
  const [b1, b2] = [3 * t * (1 - t) ** 2, 3 * t * t * (1 - t)];
  // The nearer handle takes the greater part; together they move the point by the whole.
  const weight = b1 * b1 + b2 * b2;
  if (!(weight > 1e-6)) return withPoints(path, path.points);
  const points = [...path.points];
  points[3 * piece + 1] = add(cubic[1], scaled(by, b1 / weight));
  points[3 * piece + 2] = add(cubic[2], scaled(by, b2 / weight));
  return withPoints(path, points);
}

/** A new node on a piece at t, 0 < t < 1. The shape stays. */
export function splitAt(path: CubicPath, piece: number, t: number): Edited {
  const [first, second] = split(pieceAt(path, piece), t);
  const points = [
    ...path.points.slice(0, 3 * piece),
    ...first.slice(0, 3),
    ...second.slice(0, 3),
    ...path.points.slice(3 * piece + 3),
  ];
  const follow = (place: number) => {
    const u = place - piece;
    if (u <= 0) return place;
    if (u >= 1) return place + 1;
    return u <= t ? piece + u / t : piece + 1 + (u - t) / (1 - t);
  };
  return { path: { points, closed: path.closed }, follow, bends: [piece, piece + t, piece + 1] };
}

/** One piece in the place of several: a line for lines, else fitted to their shape. */
export function merged(cubics: readonly Cubic[]): Cubic {
  const [first, last] = [cubics[0], cubics[cubics.length - 1]];
  const [from, to] = [first[0], last[3]];
  if (cubics.length === 1) return first;
  if (cubics.every(isLine)) return lineBetween(from, to);
  const count = 12;
  const points: Point[] = [from];
  for (const cubic of cubics) {
    for (let i = 1; i <= count; ++i) {
      const point = pointAt(cubic, i / count);
      if (!isSame(point, points[points.length - 1])) points.push(point);
    }
  }
  const out = directionAt(first, 0);
  const into = directionAt(last, 1);
  if (!out || !into || points.length < 3) return lineBetween(from, to);
  return fittedOnce(points, out, scaled(into, -1)).cubic;
}

/**
 * Takes nodes away: the pieces beside them become one that is fitted to their shape, and an open
 * path ends at what is left. null: less than two nodes are left.
 */
export function withoutNodes(path: CubicPath, nodes: readonly number[]): Edited | null {
  const pieces = pieceCount(path);
  const count = nodeCount(path);
  const gone = new Set(nodes.map((node) => (path.closed ? node % pieces : node)));
  const kept = Array.from({ length: count }, (_, i) => i).filter((i) => !gone.has(i));
  if (kept.length < 2) return null;
  const runs = kept.map((from, i) => ({ from, to: kept[i + 1] ?? kept[0] + pieces }));
  if (!path.closed) runs.pop();
  const cubicAt = (i: number) => pieceAt(path, i % pieces);
  const groups = runs.map(({ from, to }) =>
    Array.from({ length: to - from }, (_, k) => cubicAt(from + k)),
  );
  const cubics = groups.map(merged);
  const follow = (place: number) => {
    // In a closed path that begins elsewhere now, the pieces before the new beginning come last.
    const within = path.closed && place < kept[0] ? place + pieces : place;
    const i = runs.findIndex(({ to }) => within <= to);
    if (within <= runs[0].from) return 0;
    return i < 0 ? cubics.length : i + shareIn(groups[i], cubics[i], within - runs[i].from);
  };
  return { path: pathOf(cubics, path.closed), follow, bends: [] };
}

/** Returns the position on a piece that corresponds to a place on the pieces that it replaces, by arc length. */
function shareIn(group: readonly Cubic[], cubic: Cubic, place: number): number {
  if (group.length === 1) return place;
  const lengths = group.map((piece) => cubicLength(piece));
  const whole = lengths.reduce((sum, length) => sum + length, 0);
  const i = Math.min(Math.floor(place), group.length - 1);
  const before = lengths.slice(0, i).reduce((sum, length) => sum + length, 0);
  const reached = before + cubicLength(group[i], 0, place - i);
  return whole > 0 ? parameterAtLength(cubic, (reached / whole) * cubicLength(cubic)) : 0;
}

/**
 * Closes a path, by a line where its ends differ by more than `gap`; or opens it where it begins.
 */
export function withClosed(path: CubicPath, closed: boolean, gap: number): Edited {
  if (closed === path.closed) return withPoints(path, path.points);
  const points = [...path.points];
  if (closed) {
    const [begin, end] = [points[0], points[points.length - 1]];
    if (distance(begin, end) <= gap) points[points.length - 1] = begin;
    else points.push(...lineBetween(end, begin).slice(1));
  }
  return { path: { points, closed }, ...STAYS };
}

/** Returns the path with an open end moved to its other end, which closes it; null: it is no such end. */
export function closedByEnd(path: CubicPath, node: number): Edited | null {
  const last = pieceCount(path);
  if (path.closed || last < 2 || (node !== 0 && node !== last)) return null;
  const to = path.points[node === 0 ? 3 * last : 0];
  const points = [...movedNodes(path, [node], subtract(to, path.points[3 * node])).path.points];
  points[3 * node] = to;
  return { path: { points, closed: true }, ...STAYS };
}

/** An end of an open path. */
export type PathEnd = "start" | "end";

/**
 * Continues an open path at one of its ends.
 * @param added begins at that end; if it ends within `gap` of the other end, the path is closed
 * @param share of the arc length that the path has of the whole
 */
export function extended(
  path: CubicPath,
  end: PathEnd,
  added: CubicPath,
  share: number,
  gap: number,
): Edited {
  const isStart = end === "start";
  const more = isStart ? reversedPath(added).points : added.points;
  const points = isStart
    ? [...more.slice(0, -1), ...path.points]
    : [...path.points, ...more.slice(1)];
  const closed = distance(points[0], points[points.length - 1]) <= gap;
  const kept = path.points[isStart ? path.points.length - 1 : 0];
  if (closed) [points[0], points[points.length - 1]] = [kept, kept];
  return {
    path: { points, closed },
    follow: (place) => (isStart ? place + pieceCount(added) : place),
    bends: [],
    shares: (offset) => (isStart ? 1 - (1 - offset) * share : offset * share),
  };
}

/** Two open paths as one: `gap` is bridged by a line, or with null the second's beginning moves. */
export function joined(first: CubicPath, second: CubicPath, weld: boolean): CubicPath {
  const end = first.points[first.points.length - 1];
  const [begin] = second.points;
  const moved = weld ? movedNodes(second, [0], subtract(end, begin)).path.points : second.points;
  const bridge = weld || isSame(end, begin) ? [] : lineBetween(end, begin).slice(1);
  return { points: [...first.points, ...bridge, ...moved.slice(1)], closed: false };
}
