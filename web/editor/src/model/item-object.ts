// Items as objects that a drawing changes in place where nobody sees it.
import type { ContainerItem, CurveItem, Item, ReferenceItem, UseItem } from "./types.js";

/** What holds a parent for all of its children, so that one of thousands changes without them. */
export interface Inside {
  item: Item | null;
}

/** Items while they are built, and where a drawing changes them in place. */
export type Building<T> = { -readonly [Key in keyof T]: T[Key] };
export type Within<T> = Building<T> & { around: Inside; readonly inside: Inside };
export type BuildingItem =
  Within<ContainerItem> | Within<UseItem> | Within<CurveItem> | Within<ReferenceItem>;

/** All items: their parent is whatever stands around them now. */
class ItemObject {
  declare readonly around: Inside;

  get parent(): Item | null {
    return this.around.item;
  }
}

/** The item that fields make; a copy of an item takes its place as the parent of its children. */
export function itemOf<T extends Item>(fields: Omit<T, "parent"> & { inside: Inside }): Within<T> {
  const item = Object.assign(new ItemObject(), fields) as unknown as Within<T>;
  item.inside.item = item as Item;
  return item;
}
