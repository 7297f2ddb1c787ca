// The box around what items show on the artboard.
import { composed, mappedBox, type Affine, type Box } from "../geometry/affine.js";
import { boundsOf, mappedPath, unionOf } from "../geometry/cubic.js";
import { shiftOf } from "./commands/structure/items.js";
import type { CurveItem, Item } from "./types.js";

/** A curve that changes, or is placed elsewhere, is another object. */
const boxes = new WeakMap<CurveItem, Box | null>();

function boxOfCurve(curve: CurveItem): Box | null {
  const known = boxes.get(curve);
  if (known !== undefined) return known;
  const { artboardFromItem, paths } = curve;
  const box = unionOf(paths.map((path) => boundsOf(mappedPath(artboardFromItem, path))));
  boxes.set(curve, box);
  return box;
}

/** <use> in <use>: deeper ones are not drawn. */
const DEEPEST = 16;

/** @param shift from where an item stands in the text to where a <use> shows it; null: it is there */
function boxesOf(item: Item, shift: Affine | null, depth: number): (Box | null)[] {
  if (item.kind === "curve" || item.kind === "stroke") {
    if (!shift) return [boxOfCurve(item)];
    const map = composed(shift, item.artboardFromItem);
    return [unionOf(item.paths.map((path) => boundsOf(mappedPath(map, path))))];
  }
  if (item.kind === "reference")
    return [mappedBox(shift ? composed(shift, item.artboardFromItem) : item.artboardFromItem, item.box)];
  if (item.kind !== "use") return item.children.flatMap((child) => boxesOf(child, shift, depth));
  const inner = item.target && depth < DEEPEST ? shiftOf(item, item.target) : null;
  if (!item.target || !inner) return [];
  return boxesOf(item.target, shift ? composed(shift, inner) : inner, depth + 1);
}

/** The box around what items show, artboard units; null: they show nothing. */
export function boxOf(items: readonly Item[]): Box | null {
  return unionOf(items.flatMap((item) => boxesOf(item, null, 0)).filter((box) => box !== null));
}
