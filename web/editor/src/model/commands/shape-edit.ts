// A subpath of a curve exchanged, in the attributes of its element.
import { segmentsOf, type CubicPath } from "../../geometry/cubic.js";
import type { Edited } from "../../geometry/nodes.js";
import { geometryAttributes, readPath, rewritePath, shapeData } from "../../geometry/path.js";
import { attributeOf, patchOf, setAttribute, SODIPODI, valueOf } from "../../source/attributes.js";
import { encodeValue } from "../../source/entities.js";
import type { Edit } from "../../source/patch.js";
import type { ElementNode } from "../../source/tree.js";
import { readArtboard } from "../artboard.js";
import type { CurveItem, Drawing, Handle, Outcome } from "../types.js";
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

/** Inkscape's own words for a shape go before d when it opens the file; its kinds of nodes count them. */
function stale(text: string, element: ElementNode, isRecounted: boolean): Edit[] {
  const remove = (local: string) => setAttribute(text, element, { namespace: SODIPODI, local }, null);
  return [...remove("type"), ...(isRecounted ? remove("nodetypes") : [])];
}

/** The element's own name exchanged, in both of its tags. */
function renamed(text: string, element: ElementNode, local: string): Edit[] {
  const { name, range, closesItself } = element;
  const inserted = name.slice(0, name.length - element.local.length) + local;
  const edits = [{ at: range.start + 1, removed: name, inserted }];
  if (closesItself) return edits;
  return [...edits, { at: text.lastIndexOf("</", range.end) + 2, removed: name, inserted }];
}

/** Attributes of the shape give way to one, in the place of the first of them. */
function exchanged(text: string, element: ElementNode, d: string): Edit[] {
  const found = geometryAttributes(element.local)
    .flatMap((name) => attributeOf(element, name) ?? [])
    .sort((a, b) => a.range.start - b.range.start);
  const [first, ...rest] = found;
  const { start, end } = first.range;
  const inserted = `d=${first.quote}${encodeValue(d, first.quote)}${first.quote}`;
  return [
    { at: start, removed: text.slice(start, end), inserted },
    ...rest.flatMap(({ name }) => setAttribute(text, element, name, null)),
  ];
}

/** The edits that give an element path data; another shape becomes a path. */
export function dataEdits(text: string, element: ElementNode, d: string, isRecounted: boolean): Edit[] {
  const edits = stale(text, element, isRecounted);
  if (element.local === "path") return [...edits, ...setAttribute(text, element, "d", d)];
  return [...edits, ...renamed(text, element, "path"), ...exchanged(text, element, d)];
}

/** A change of one subpath, as a patch. null: nothing would change, or there is no such subpath. */
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
  const edits = [
    ...dataEdits(drawing.text, element, d, isRecounted),
    ...followedLists(drawing, element, before, after, change),
  ];
  return { patch: patchOf(edits) };
}
