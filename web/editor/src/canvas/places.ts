// Where the curves of a drawing are seen: each in its place, and through every <use> once more.
import { composed, inverted, type Affine } from "../geometry/affine.js";
import type { Editor } from "../app/types.js";
import { shiftOf } from "../model/commands/structure/items.js";
import { isHidden, isLocked, isWithin } from "../model/standing.js";
import type { CurveItem, Drawing, Handle, Item } from "../model/types.js";

/** A drawing, and the isolated item, if there is one. Tools edit only what is within that item. */
export type Reach = Pick<Editor, "drawing" | "isolated">;

export interface Place {
  readonly item: CurveItem;
  /** The item that a click selects: the curve, or the outermost <use> that shows it. */
  readonly owner: Item;
  readonly artboardFromItem: Affine;
}

/**
 * Returns the item to edit at a place: the curve that stands there, even if only a <use> shows it there;
 * otherwise the <use>.
 */
export function editedAt({ item, owner, artboardFromItem }: Place): Item {
  const isInPlace = item.artboardFromItem.every(
    (value, k) => Math.abs(value - artboardFromItem[k]) <= SAME * Math.max(1, Math.abs(value)),
  );
  return isInPlace ? item : owner;
}

/** Maps that were multiplied in another order differ by rounding. */
const SAME = 1e-9;

/** <use> in <use>: deeper ones are not drawn here. A circle of them is an error of the document. */
const DEEPEST = 16;
export function isCurve(item: Item | undefined): item is CurveItem {
  return item?.kind === "curve" || item?.kind === "stroke";
}

/** Whether an item is out of reach of the tools: locked, or outside the isolated item. */
export function isOutOfReach({ isolated: { value: handle } }: Pick<Reach, "isolated">, item: Item): boolean {
  return isLocked(item) || (handle !== null && !isWithin(item, new Set([handle])));
}

const kept = new WeakMap<Drawing, { key: string; places: readonly Place[] }>();

/** The places that can be seen and are in reach of the tools, the last on top. */
export function placesOf({ drawing, isolated: { value: handle } }: Reach): readonly Place[] {
  const key = `${drawing.revision} ${handle}`;
  const known = kept.get(drawing);
  if (known?.key === key) return known.places;
  const places: Place[] = [];
  for (const item of itemsWithin(drawing, handle)) collect(item, null, null, 0, places);
  kept.set(drawing, { key, places });
  return places;
}

function itemsWithin(drawing: Drawing, handle: Handle | null): readonly Item[] {
  const item = handle === null ? undefined : drawing.item(handle);
  if (!item) return drawing.items;
  return isHidden(item) || isLocked(item) ? [] : [item];
}

/** Curves where the text has them: of thousands one has changed, and is another object. */
const inPlace = new WeakMap<CurveItem, Place | null>();

function placeInText(item: CurveItem): Place | null {
  let place = inPlace.get(item);
  if (place === undefined) {
    place = inverted(item.artboardFromItem) && { item, owner: item, artboardFromItem: item.artboardFromItem };
    inPlace.set(item, place);
  }
  return place;
}

function placeBy(item: CurveItem, owner: Item | null, shift: Affine | null): Place | null {
  if (!owner && !shift) return placeInText(item);
  const map = shift ? composed(shift, item.artboardFromItem) : item.artboardFromItem;
  return inverted(map) && { item, owner: owner ?? item, artboardFromItem: map };
}

/** @param shift from where an item stands in the text to where a <use> shows it; null: it is there */
function collect(
  item: Item,
  owner: Item | null,
  shift: Affine | null,
  depth: number,
  to: Place[],
): void {
  if (item.hidden || item.locked || depth > DEEPEST) return;
  if (isCurve(item)) {
    const place = placeBy(item, owner, shift);
    if (place) to.push(place);
  } else if (item.kind === "use" && item.target) {
    const inner = shiftOf(item, item.target);
    if (inner)
      collect(item.target, owner ?? item, shift ? composed(shift, inner) : inner, depth + 1, to);
  } else {
    for (const child of item.children) collect(child, owner, shift, depth, to);
  }
}
