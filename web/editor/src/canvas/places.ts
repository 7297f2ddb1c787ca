// Where the curves of a drawing are seen: each in its place, and through every <use> once more.
import { composed, inverted, type Affine } from "../geometry/affine.js";
import { shiftOf } from "../model/commands/structure/items.js";
import type { CurveItem, Drawing, Handle, Item } from "../model/types.js";

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

/** Whether it, or something around it, is locked. */
export function isLocked(item: Item): boolean {
  return item.locked || (item.parent !== null && isLocked(item.parent));
}

export function isHidden(item: Item): boolean {
  return item.hidden || (item.parent !== null && isHidden(item.parent));
}

/** Whether an item, or something around it, is one of these. */
export function isWithin(item: Item | null, handles: ReadonlySet<Handle>): boolean {
  return item !== null && (handles.has(item.handle) || isWithin(item.parent, handles));
}

const kept = new WeakMap<Drawing, { revision: number; places: readonly Place[] }>();

/** The places that can be seen and are not locked, the last on top. */
export function placesOf(drawing: Drawing): readonly Place[] {
  const known = kept.get(drawing);
  if (known?.revision === drawing.revision) return known.places;
  const places: Place[] = [];
  for (const item of drawing.items) collect(item, null, null, 0, places);
  kept.set(drawing, { revision: drawing.revision, places });
  return places;
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
