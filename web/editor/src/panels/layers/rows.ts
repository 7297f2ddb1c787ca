// The rows of the tree: the unfolded ones, the uppermost item first.
import type { Drawing, Handle, Item } from "../../model/types.js";

export interface Row {
  readonly item: Item;
  readonly depth: number;
  /** null: it holds nothing. */
  readonly isOpen: boolean | null;
  /** Place among its siblings as they are shown, from 1, and how many they are. */
  readonly position: number;
  readonly siblings: number;
}

export function rowsOf(drawing: Drawing, open: ReadonlySet<Handle>): readonly Row[] {
  const rows: Row[] = [];
  const add = (items: readonly Item[], depth: number) => {
    for (let index = items.length - 1; index >= 0; index -= 1) {
      const item = items[index];
      const isOpen = item.children.length === 0 ? null : open.has(item.handle);
      rows.push({ item, depth, isOpen, position: items.length - index, siblings: items.length });
      if (isOpen) add(item.children, depth + 1);
    }
  };
  add(drawing.items, 0);
  return rows;
}

export function ancestors(item: Item): readonly Item[] {
  const found: Item[] = [];
  for (let at = item.parent; at; at = at.parent) found.push(at);
  return found;
}

export const siblingsOf = (drawing: Drawing, item: Item) => item.parent?.children ?? drawing.items;

/** Curves within, at most `most` of them. */
export function curvesWithin(item: Item, most = Infinity): Item[] {
  const found: Item[] = [];
  const add = (at: Item) => {
    if (found.length >= most) return;
    if (at.kind === "curve" || at.kind === "stroke") found.push(at);
    else at.children.forEach(add);
  };
  add(item);
  return found;
}

/** Returns the number of a container's row: curves, and instances as one each. */
export function countWithin(item: Item): number {
  if (item.kind === "curve" || item.kind === "stroke" || item.kind === "use") return 1;
  return item.children.reduce((sum, child) => sum + countWithin(child), 0);
}
