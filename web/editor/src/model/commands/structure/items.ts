// Queries of commands about items: which items are meant, where they stand, which map leads where.
import { composed, inverted, translation } from "../../../geometry/affine.js";
import type { Affine, Point } from "../../../geometry/affine.js";
import { valueOf } from "../../../source/attributes.js";
import { parseLength } from "../../../source/lengths.js";
import type { ElementNode } from "../../../source/tree.js";
import { readArtboard } from "../../artboard.js";
import { ownTransform } from "../../building.js";
import type { Drawing, Handle, Item, UseItem } from "../../types.js";

/** The items of these handles in the order of the text, without those within another of them. */
export function outermost(d: Drawing, handles: readonly Handle[]): Item[] {
  const chosen = new Set(handles);
  const isWithinChosen = ({ parent }: Item) => {
    for (let outer = parent; outer; outer = outer.parent) if (chosen.has(outer.handle)) return true;
    return false;
  };
  return [...chosen]
    .flatMap((handle) => d.item(handle) ?? [])
    .filter((item) => item.element.parent && !isWithinChosen(item))
    .sort((a, b) => a.element.range.start - b.element.range.start);
}

/** The layer that an item is or stands in. */
export function layerOf(item: Item | null): Item | null {
  let outer = item;
  while (outer && outer.kind !== "layer") outer = outer.parent;
  return outer;
}

/** Whether an item stands on the artboard itself, not only where uses show it. */
export function isShown(d: Drawing, item: Item): boolean {
  let outer = item;
  while (outer.parent) outer = outer.parent;
  return d.items.includes(outer);
}

/** Whether a photo lies below all that is drawn, by its place in the text. */
export function isLowest({ items }: Drawing, item: Item): boolean {
  const at = items.indexOf(item);
  const isPhoto = ({ kind }: Item) => kind === "reference";
  return at >= 0 && items.slice(0, at).every(isPhoto) && !items.slice(at).every(isPhoto);
}

/** Siblings of an item, the lowest first; itself among them. */
export function siblingsOf(d: Drawing, item: Item): readonly Item[] {
  return item.parent ? item.parent.children : d.items;
}

/** The artboard from the coordinates that an item's transform leads to. */
export function outerFrame({ parent, artboardFromItem, element }: Item): Affine {
  if (parent) return parent.artboardFromItem;
  const back = inverted(ownTransform(element));
  return back ? composed(artboardFromItem, back) : artboardFromItem;
}

/** Where x and y of a <use> put what it copies. */
export function usePlace(use: ElementNode): Point {
  const number = (name: string) => parseLength(valueOf(use, name) ?? "0", 0) ?? 0;
  return [number("x"), number("y")];
}

/** From where the target of a <use> stands to where the <use> shows it; null: it cannot be said. */
export function shiftOf(use: UseItem, target: Item): Affine | null {
  const placed = composed(use.artboardFromItem, translation(...usePlace(use.element)));
  const back = inverted(outerFrame(target));
  return back && composed(placed, back);
}

/** The artboard from the coordinates of a container's children; of the outermost level, with null. */
export function innerFrame(d: Drawing, container: Item | null): Affine {
  return container ? container.artboardFromItem : readArtboard(d.root).artboardFromUser;
}

/** The element that stands before another among its parent's children. */
export function elementBefore(
  element: ElementNode,
  isPassedOver: (other: ElementNode) => boolean = () => false,
): ElementNode | null {
  const { children } = element.parent as ElementNode;
  let i = children.indexOf(element) - 1;
  while (i >= 0 && isPassedOver(children[i])) i -= 1;
  return i < 0 ? null : children[i];
}
