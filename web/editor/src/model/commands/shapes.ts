// Edits of curves by their nodes, as patches of the present text.
import type { Point } from "../../geometry/affine.js";
import type { CubicPath } from "../../geometry/cubic.js";
import { pieceCount } from "../../geometry/cubic.js";
import {
  movedNodes,
  splitAt,
  withClosed,
  withKind,
  withoutNodes,
  withPoints,
  type NodeKind,
} from "../../geometry/nodes.js";
import { rewritePath } from "../../geometry/path.js";
import { patchOf } from "../../source/attributes.js";
import type { Drawing, Handle, Outcome } from "../types.js";
import { dataEdits } from "./data-edits.js";
import { curveOf, dataOf, editShape } from "./shape-edit.js";
import { removal } from "./removal.js";

export { joinCurves } from "./join.js";
export { reverseCurves } from "./reverse.js";
export type { NodeKind } from "../../geometry/nodes.js";

/** Replaces one subpath; segments whose points are as before keep how they are written. */
export function setPath(
  d: Drawing,
  h: Handle,
  path: number,
  to: CubicPath,
  step: number,
): Outcome | null {
  return editShape(d, h, path, step, (before) => {
    const isLess = pieceCount(to) < pieceCount(before);
    // Stops stay at their pieces, those of pieces that are gone at the end.
    const follow = (place: number) => (isLess ? Math.min(place, pieceCount(to)) : place);
    return { ...withPoints(before, to.points), path: to, follow };
  });
}

/** Moves nodes by a vector of the element's coordinates, their handles with them. */
export function moveNodes(
  d: Drawing,
  h: Handle,
  path: number,
  nodes: readonly number[],
  by: Point,
  step: number,
): Outcome | null {
  return editShape(d, h, path, step, (before) => movedNodes(before, nodes, by));
}

/** Adds a node on piece `piece` at t without changing the shape. Offsets "@" of stops follow. */
export function splitPiece(
  d: Drawing,
  h: Handle,
  path: number,
  piece: number,
  t: number,
  step: number,
): Outcome | null {
  return editShape(d, h, path, step, (before) => {
    const isOnIt = piece >= 0 && piece < pieceCount(before) && t > 0 && t < 1;
    return isOnIt ? splitAt(before, piece, t) : null;
  });
}

/**
 * Takes nodes away and fits what is left to the shape. A subpath without two nodes goes, and with
 * the last of them the element.
 */
export function deleteNodes(
  d: Drawing,
  h: Handle,
  path: number,
  nodes: readonly number[],
  step: number,
): Outcome | null {
  const item = curveOf(d, h);
  const before = item?.paths[path];
  if (!item || !before || nodes.length === 0) return null;
  if (withoutNodes(before, nodes)) {
    return editShape(d, h, path, step, () => withoutNodes(before, nodes));
  }
  if (item.paths.length === 1) return { patch: [removal(d.text, item.element)], select: [] };
  const data = rewritePath(dataOf(d, item.element), path, before, null, step);
  return { patch: patchOf(dataEdits(d.text, item.element, data, true)) };
}

export function setNodeKind(
  d: Drawing,
  h: Handle,
  path: number,
  nodes: readonly number[],
  kind: NodeKind,
  step: number,
): Outcome | null {
  return editShape(d, h, path, step, (before) => withKind(before, nodes, kind));
}

/**
 * Closes a subpath, by a line where its ends differ; or opens it, with both ends where it began.
 */
export function setClosed(
  d: Drawing,
  h: Handle,
  path: number,
  closed: boolean,
  step: number,
): Outcome | null {
  return editShape(d, h, path, step, (before) =>
    before.closed === closed ? null : withClosed(before, closed, step),
  );
}
