// A subpath of a curve exchanged, in the attributes of its element.
import { segmentsOf, type CubicPath } from "../../../geometry/cubic.js";
import type { Edited } from "../../../geometry/nodes.js";
import { editedByNodes } from "../../../geometry/natural.js";
import { readPath, rewritePath, shapeData } from "../../../geometry/path.js";
import { patchOf, valueOf } from "../../../source/attributes.js";
import type { Edit } from "../../../source/patch.js";
import type { ElementNode } from "../../../source/tree.js";
import { readArtboard } from "../../artboard.js";
import type { CurveItem, Drawing, Handle, Outcome } from "../../types.js";
import { dataEdits } from "../data-edits.js";
import { onlySubpaths, partedElement } from "../structure/parting.js";
import { removal } from "../structure/removal.js";
import { followedLists } from "../paint/stop-follow.js";

export function curveOf(drawing: Drawing, handle: Handle): CurveItem | null {
  const item = drawing.item(handle);
  return item?.kind === "curve" || item?.kind === "stroke" ? item : null;
}

/** The path data of an element: its own, or what draws the same as its shape. */
export function dataOf(drawing: Drawing, element: ElementNode): string {
  const { viewBox } = readArtboard(drawing.root);
  return shapeData(element.local, (name) => valueOf(element, name), viewBox);
}

/** Nodes by their subpath. */
export type NodesBySubpath = ReadonlyMap<number, readonly number[]>;

/** Returns the edited subpath, given its nodePath(): "gone", another one, or null if it stays as it is. */
export type ShapeEdit = (nodes: CubicPath, path: CubicPath) => Edited | "gone" | null;

/** A subpath that is another now. */
interface Changed {
  readonly index: number;
  readonly isRecounted: boolean;
  /** Edits of the lists that must follow it. */
  readonly lists: readonly Edit[];
}

/** Path data after edits of some of its subpaths. */
interface Edition {
  readonly data: string;
  readonly changed: readonly Changed[];
  readonly gone: ReadonlySet<number>;
}

function editionOf(
  drawing: Drawing,
  { element, paths }: CurveItem,
  step: number,
  edits: ReadonlyMap<number, ShapeEdit>,
): Edition | null {
  let data = dataOf(drawing, element);
  const changed: Changed[] = [];
  const gone = new Set<number>();
  // From the last on: subpaths that go leave those before them their numbers.
  for (const index of [...edits.keys()].sort((a, b) => b - a)) {
    const before = paths[index];
    const change = before ? editedByNodes(before, edits.get(index)!) : null;
    if (!change) continue;
    if (change === "gone") {
      data = rewritePath(data, index, before, null, step);
      gone.add(index);
      continue;
    }
    const d = rewritePath(data, index, before, change.path, step);
    if (d === data) continue;
    data = d;
    const after = readPath(d)[index];
    // Pulled to a point, it is no curve any more: that is for deleting.
    if (!after || after.points.length !== change.path.points.length) return null;
    changed.unshift({
      index,
      isRecounted: segmentsOf(after).length !== segmentsOf(before).length,
      lists: followedLists(drawing, element, before, after, change),
    });
  }
  return { data, changed, gone };
}

/**
 * Changes of subpaths, as a patch. null: nothing would change, or there are no such subpaths. With
 * the last of its subpaths the element goes. Where several subpaths share lists that must follow one
 * of them, that one becomes an element of its own, and is selected.
 */
export function editShapes(
  drawing: Drawing,
  handle: Handle,
  step: number,
  edits: ReadonlyMap<number, ShapeEdit>,
): Outcome | null {
  const item = curveOf(drawing, handle);
  const edition = item && editionOf(drawing, item, step, edits);
  if (!item || !edition) return null;
  const { element, paths } = item;
  const { data, changed, gone } = edition;
  if (gone.size === paths.length) return { patch: [removal(drawing.text, element)], select: [] };
  if (changed.length === 0 && gone.size === 0) return null;
  const following = changed.filter(({ lists }) => lists.length > 0);
  if (following.length > 0 && paths.length - gone.size > 1)
    return parted(drawing, element, edition, paths.length, following, step);
  const isRecounted = gone.size > 0 || changed.some((one) => one.isRecounted);
  const lists = following.flatMap((one) => one.lists);
  return { patch: patchOf([...dataEdits(drawing.text, element, data, isRecounted), ...lists]) };
}

/** Lists with "@" serve all subpaths: those whose segments change leave the others theirs. */
function parted(
  drawing: Drawing,
  element: ElementNode,
  { data, gone }: Edition,
  count: number,
  following: readonly Changed[],
  step: number,
): Outcome {
  const kept = Array.from({ length: count }, (_, i) => i).filter((i) => !gone.has(i));
  const followingOnes = new Set(following.map(({ index }) => index));
  const staying = kept.filter((i) => !followingOnes.has(i));
  // Where all of them change, the first is what remains of the element.
  const [first, ...rest] = following;
  const own = staying.length > 0 ? { indices: staying, lists: [] } : { ...first, indices: [first.index] };
  const others = staying.length > 0 ? following : rest;
  const part = (indices: readonly number[], lists: readonly Edit[]) => ({
    data: onlySubpaths(data, (i) => indices.includes(kept[i]), step),
    edits: lists,
  });
  const made = partedElement(
    drawing,
    element,
    part(own.indices, own.lists),
    others.map(({ index, lists }) => part([index], lists)),
  );
  const patch = patchOf(made.edits);
  const grown = patch
    .slice(0, -1)
    .reduce((sum, edit) => sum + edit.inserted.length - edit.removed.length, 0);
  const copies = made.copyOffsets.map((offset) => ({ at: element.range.end + grown + offset }));
  return { patch, select: staying.length > 0 ? copies : [{ at: element.range.start }, ...copies] };
}

/** A change of one subpath, as a patch. */
export function editShape(
  drawing: Drawing,
  handle: Handle,
  index: number,
  step: number,
  edit: ShapeEdit,
): Outcome | null {
  return editShapes(drawing, handle, step, new Map([[index, edit]]));
}
