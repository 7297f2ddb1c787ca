// Edits of curves by their nodes, as patches of the present text.
import type { Point } from "../../../geometry/affine.js";
import type { CubicPath } from "../../../geometry/cubic.js";
import { mappedPath, pieceCount } from "../../../geometry/cubic.js";
import { pathLength } from "../../../geometry/length.js";
import {
  closedByEnd,
  extended,
  movedNodes,
  withClosed,
  withKind,
  withoutNodes,
  withPoints,
  type NodeKind,
  type PathEnd,
} from "../../../geometry/nodes.js";
import { splitNodes } from "../../../geometry/natural.js";
import { spareNodes } from "../../../geometry/spare-nodes.js";
import type { Drawing, Handle, Outcome } from "../../types.js";
import { curveOf, editShape, editShapes, type NodesBySubpath, type ShapeEdit } from "./shape-edit.js";

/** The same edit of each subpath, with its nodes. */
function editNodes(
  d: Drawing,
  h: Handle,
  nodes: NodesBySubpath,
  step: number,
  edit: (path: CubicPath, nodes: readonly number[]) => ReturnType<ShapeEdit>,
): Outcome | null {
  const edits = [...nodes].map(
    ([path, of]): [number, ShapeEdit] => [path, (before) => edit(before, of)],
  );
  return editShapes(d, h, step, new Map(edits));
}

export { cutCurve } from "./cut.js";
export { joinCurves } from "./join.js";
export { reverseCurves } from "./reverse.js";
export type { NodesBySubpath } from "./shape-edit.js";
export type { NodeKind, PathEnd } from "../../../geometry/nodes.js";

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
    // Stops stay at their pieces; stops of removed pieces go to the end.
    const follow = (place: number) => (isLess ? Math.min(place, pieceCount(to)) : place);
    return { ...withPoints(before, to.points), path: to, follow };
  });
}

/** Gives subpaths other points, as many as they have. */
export function setPoints(
  d: Drawing,
  h: Handle,
  paths: ReadonlyMap<number, CubicPath>,
  step: number,
): Outcome | null {
  const edits = [...paths].map(
    ([path, { points }]): [number, ShapeEdit] => [
      path,
      (before) => (points.length === before.points.length ? withPoints(before, points) : null),
    ],
  );
  return editShapes(d, h, step, new Map(edits));
}

/** Moves nodes by a vector of the element's coordinates, their handles with them. */
export function moveNodes(
  d: Drawing,
  h: Handle,
  nodes: NodesBySubpath,
  by: Point,
  step: number,
): Outcome | null {
  return editNodes(d, h, nodes, step, (before, of) => movedNodes(before, of, by));
}

/** Adds a node on piece `piece` at t without changing the shape. Offsets "@" of stops follow. */
export function splitPiece(
  d: Drawing,
  h: Handle,
  index: number,
  piece: number,
  t: number,
  step: number,
): Outcome | null {
  return editShape(d, h, index, step, (before, path) => {
    const isOnIt = piece >= 0 && piece < pieceCount(before) && t > 0 && t < 1;
    return isOnIt ? splitNodes(path, piece, t) : null;
  });
}

/**
 * Takes nodes away and fits what is left to the shape. A subpath without two nodes goes, and with
 * the last of them the element.
 */
export function deleteNodes(
  d: Drawing,
  h: Handle,
  nodes: NodesBySubpath,
  step: number,
): Outcome | null {
  return editNodes(d, h, nodes, step, (before, of) =>
    of.length === 0 ? null : (withoutNodes(before, of) ?? "gone"),
  );
}

/**
 * Takes away nodes that the shape does not need.
 * @param tolerance largest distance from the shape before, units of the element
 */
export function simplifyCurve(d: Drawing, h: Handle, tolerance: number, step: number): Outcome | null {
  const edit: ShapeEdit = (before) => {
    const spare = spareNodes(before, tolerance);
    return spare.length > 0 ? withoutNodes(before, spare) : null;
  };
  const paths = curveOf(d, h)?.paths ?? [];
  return editShapes(d, h, step, new Map([...paths.keys()].map((path) => [path, edit])));
}

export function setNodeKind(
  d: Drawing,
  h: Handle,
  nodes: NodesBySubpath,
  kind: NodeKind,
  step: number,
): Outcome | null {
  return editNodes(d, h, nodes, step, (before, of) => withKind(before, of, kind));
}

/** Brings an end of an open subpath to its other end, which closes it. Its first node is selected. */
export function closeByEnd(
  d: Drawing,
  h: Handle,
  path: number,
  node: number,
  step: number,
): Outcome | null {
  const made = editShape(d, h, path, step, (before) => closedByEnd(before, node));
  const at = d.item(h)?.element.range.start;
  if (!made || made.select || at === undefined) return made;
  return { ...made, select: [{ at, part: { kind: "node", path, index: 0 } }] };
}

/**
 * Continues an open subpath at one of its ends. Its stops stay where they are, and the last colour
 * continues. If the added path ends at the other end, the subpath is closed.
 * @param added in coordinates of the element; it begins at that end
 */
export function extendCurve(
  d: Drawing,
  h: Handle,
  path: number,
  end: PathEnd,
  added: CubicPath,
  step: number,
): Outcome | null {
  const item = curveOf(d, h);
  if (!item) return null;
  const lengthOf = (one: CubicPath) => pathLength(mappedPath(item.layerFromItem, one));
  const made = editShape(d, h, path, step, (nodes, before) => {
    if (before.closed) return null;
    const own = lengthOf(before);
    return extended(nodes, end, added, own / (own + lengthOf(added)), step);
  });
  return made && { select: [{ at: item.element.range.start }], ...made };
}

/**
 * Closes subpaths, by a line where the ends differ; or opens them, with both ends where they began.
 */
export function setClosed(
  d: Drawing,
  h: Handle,
  paths: readonly number[],
  closed: boolean,
  step: number,
): Outcome | null {
  const edit: ShapeEdit = (before) =>
    before.closed === closed ? null : withClosed(before, closed, step);
  return editShapes(d, h, step, new Map(paths.map((path) => [path, edit])));
}
