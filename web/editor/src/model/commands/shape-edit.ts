// A subpath of a curve exchanged, in the attributes of its element.
import { segmentsOf, type CubicPath } from "../../geometry/cubic.js";
import type { Edited } from "../../geometry/nodes.js";
import { readPath, rewritePath, shapeData } from "../../geometry/path.js";
import { patchOf, valueOf } from "../../source/attributes.js";
import type { ElementNode } from "../../source/tree.js";
import { readArtboard } from "../artboard.js";
import type { CurveItem, Drawing, Handle, Outcome } from "../types.js";
import { dataEdits } from "./data-edits.js";
import { onlySubpaths, partedElement } from "./parting.js";
import { followedLists } from "./stop-follow.js";

export function curveOf(drawing: Drawing, handle: Handle): CurveItem | null {
  const item = drawing.item(handle);
  return item?.kind === "curve" || item?.kind === "stroke" ? item : null;
}

/** The path data of an element: its own, or what draws the same as its shape. */
export function dataOf(drawing: Drawing, element: ElementNode): string {
  const { viewBox } = readArtboard(drawing.root);
  return shapeData(element.local, (name) => valueOf(element, name), viewBox);
}

/**
 * A change of one subpath, as a patch. null: nothing would change, or there is no such subpath.
 * Where several subpaths share lists that must follow one of them, that one becomes an element of
 * its own, and is selected.
 */
export function editShape(
  drawing: Drawing,
  handle: Handle,
  index: number,
  step: number,
  edit: (path: CubicPath) => Edited | null,
): Outcome | null {
  const item = curveOf(drawing, handle);
  const before = item?.paths[index];
  const change = before && edit(before);
  if (!item || !before || !change) return null;
  const { element } = item;
  const data = dataOf(drawing, element);
  const d = rewritePath(data, index, before, change.path, step);
  if (d === data) return null;
  const after = readPath(d)[index];
  // Pulled to a point, it is no curve any more: that is for deleting.
  if (!after || after.points.length !== change.path.points.length) return null;
  const isRecounted = segmentsOf(after).length !== segmentsOf(before).length;
  const lists = followedLists(drawing, element, before, after, change);
  if (lists.length === 0 || item.paths.length === 1) {
    const edits = [...dataEdits(drawing.text, element, d, isRecounted), ...lists];
    return { patch: patchOf(edits) };
  }
  // Lists with "@" serve all subpaths: one whose segments change leaves the others theirs.
  const own = { data: onlySubpaths(data, (i) => i !== index, step), edits: [] };
  const other = { data: onlySubpaths(d, (i) => i === index, step), edits: lists };
  const parted = partedElement(drawing, element, own, [other]);
  const patch = patchOf(parted.edits);
  const grown = patch
    .slice(0, -1)
    .reduce((sum, edit) => sum + edit.inserted.length - edit.removed.length, 0);
  return { patch, select: [{ at: element.range.end + grown + parted.copyOffset }] };
}
