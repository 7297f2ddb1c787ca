// Closed curves as regions that are combined.
import { inverted } from "../../../geometry/affine.js";
import { mappedPath, reversedPath } from "../../../geometry/cubic.js";
import { fractionAtParameter, parameterAtSegment } from "../../../geometry/length.js";
import { insideSign } from "../../../geometry/orientation.js";
import { readPath, writePath } from "../../../geometry/path.js";
import { setAttribute, sf } from "../../../source/attributes.js";
import type { CurveItem, Drawing, Handle, Item, Outcome } from "../../types.js";
import { dataEdits } from "../data-edits.js";
import { finestStep } from "../mapping.js";
import { editedLists, segmentCount } from "../paint/stop-follow.js";
import { deleteItems } from "../structure/structure.js";
import { outcomeOf, together } from "../structure/together.js";
import { curveOf } from "./shape-edit.js";

/** Returns whether an item encloses a region: a diffusion curve whose subpaths are closed. */
export function canCombine(item: Item): item is CurveItem {
  return item.kind === "curve" && item.paths.length > 0 && item.paths.every(({ closed }) => closed);
}

/** Returns the path data of a curve in artboard units. */
export function shapePaths(d: Drawing, { paths, artboardFromItem }: CurveItem): string {
  const step = finestStep(d);
  return paths.map((path) => writePath(mappedPath(artboardFromItem, path), step)).join(" ");
}

/** Returns an item, or its layer if that would have nothing else. */
function withEmptied(d: Drawing, handle: Handle, gone: ReadonlySet<Handle>): Handle {
  const parent = d.item(handle)?.parent;
  const isEmptied = parent?.kind === "layer" && parent.children.every((child) => gone.has(child.handle));
  return isEmptied ? parent.handle : handle;
}

/**
 * Gives a closed curve the shape of a region, and deletes the other curves, with their layers where nothing else is in
 * them. Its sides stay inside and outside; stops keep their shares of the length.
 * @param data path data in artboard units, its inside on the right
 */
export function replaceByRegion(
  d: Drawing,
  h: Handle,
  data: string,
  others: readonly Handle[],
  step: number,
): Outcome | null {
  const item = curveOf(d, h);
  const back = item && inverted(item.artboardFromItem);
  if (!item || !back) return null;
  const made = readPath(data).map((path) => mappedPath(back, path));
  if (made.length === 0) return null;
  const isTurned = insideSign(made) !== insideSign(item.paths);
  const paths = isTurned ? made.map(reversedPath) : made;
  const [before] = item.paths;
  const lists = editedLists(d, item.element, segmentCount(before), (side) => {
    if (side.space === "arc") return null;
    const stops = side.stops.map((stop) => ({
      ...stop,
      offset: fractionAtParameter(before, parameterAtSegment(before, stop.offset)),
    }));
    return { ...side, space: "arc", stops };
  });
  const text = paths.map((path) => writePath(path, step)).join(" ");
  const edits = [
    ...dataEdits(d.text, item.element, text, true),
    ...[...lists].flatMap(([name, list]) => setAttribute(d.text, item.element, sf(name), list)),
  ];
  const gone = new Set(others);
  const removed = [...new Set(others.map((other) => withEmptied(d, other, gone)))];
  return together([outcomeOf(edits), deleteItems(d, removed)]);
}
