// Corners and smooth nodes: determined by their handles, and made by them.
import type { Point } from "./affine.js";
import { isLine, lineBetween, pieceAt, type Cubic, type CubicPath } from "./cubic.js";
import { piecesAround, withPoints, type Edited } from "./edited.js";
import { add, distance, isSame, scaled, size, subtract, unit } from "./vector.js";

export type NodeKind = "corner" | "smooth" | "symmetric";

/** Returns a node's kind from its handles: a node at a line or an end is not smooth. */
export function kindOf(path: CubicPath, node: number): NodeKind {
  const { into, out } = piecesAround(path, node);
  if (into === null || out === null) return "corner";
  const at = path.points[3 * node];
  const [a, b] = [subtract(at, path.points[3 * into + 2]), subtract(path.points[3 * out + 1], at)];
  const [from, to] = [unit(a), unit(b)];
  const isBothLines = isLine(pieceAt(path, into)) && isLine(pieceAt(path, out));
  if (!from || !to || isBothLines || distance(from, to) > 1e-3) return "corner";
  return Math.abs(size(a) - size(b)) <= 1e-3 * Math.max(size(a), size(b)) ? "symmetric" : "smooth";
}

/** Gives nodes a kind: a corner has no handles, the others have them in one line. */
export function withKind(path: CubicPath, nodes: readonly number[], kind: NodeKind): Edited {
  const points = [...path.points];
  for (const node of nodes) {
    const { into, out } = piecesAround(path, node);
    const handles = { path, points, node, into, out };
    if (kind === "corner") retract(handles);
    else align(handles, kind === "symmetric");
  }
  return withPoints(path, points);
}

interface Handles {
  readonly path: CubicPath;
  /** As they are so far; changed. */
  readonly points: Point[];
  readonly node: number;
  readonly into: number | null;
  readonly out: number | null;
}

const pieceOf = (points: readonly Point[], i: number): Cubic => [
  points[3 * i],
  points[3 * i + 1],
  points[3 * i + 2],
  points[3 * i + 3],
];

function retract({ points, node, into, out }: Handles): void {
  const at = points[3 * node];
  for (const [piece, own] of [
    [into, 2],
    [out, 1],
  ] as const) {
    if (piece === null || isLine(pieceOf(points, piece))) continue;
    points[3 * piece + own] = at;
    const [from, first, second, to] = pieceOf(points, piece);
    // Without a handle at either end it is a line, in equal parts.
    if (!isSame(first, from) || !isSame(second, to)) continue;
    [, points[3 * piece + 1], points[3 * piece + 2]] = lineBetween(from, to);
  }
}

function align({ points, node, into, out }: Handles, isSymmetric: boolean): void {
  if (into === null || out === null) return;
  const at = points[3 * node];
  const [before, after] = [pieceOf(points, into), pieceOf(points, out)];
  const [isLineBefore, isLineAfter] = [isLine(before), isLine(after)];
  const arm = (cubic: Cubic, own: 1 | 2): number => {
    const length = distance(at, cubic[own]);
    return length > 0 ? length : distance(cubic[0], cubic[3]) / 3;
  };
  let [back, ahead] = [arm(before, 2), arm(after, 1)];
  if (isSymmetric) back = ahead = (back + ahead) / 2;
  const direction = alignment(at, before, after);
  if (!direction) return;
  // Beside a curve a line stays, and gives the direction; symmetry bends it.
  const keepsLine = isLineBefore !== isLineAfter && !isSymmetric;
  if (!(keepsLine && isLineBefore)) points[3 * into + 2] = add(at, scaled(direction, -back));
  if (!(keepsLine && isLineAfter)) points[3 * out + 1] = add(at, scaled(direction, ahead));
}

/**
 * The common direction of a node's handles: of the line beside it, else the mean of what they have.
 */
function alignment(at: Point, before: Cubic, after: Cubic): Point | null {
  const [isLineBefore, isLineAfter] = [isLine(before), isLine(after)];
  if (isLineBefore !== isLineAfter) {
    const [from, , , to] = isLineBefore ? before : after;
    return unit(subtract(to, from));
  }
  const into = unit(subtract(at, before[2]));
  const out = unit(subtract(after[1], at));
  const chord = unit(subtract(after[3], before[0]));
  if (isLineBefore || !into || !out) return chord ?? into ?? out;
  return unit(add(into, out)) ?? chord;
}
