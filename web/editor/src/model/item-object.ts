// Items as objects that a drawing changes in place where no one can notice.
import type { ContainerItem, CurveItem, Item, ReferenceItem, UseItem } from "./types.js";

/** Holds the parent of all of its children, so that one of thousands changes without the others. */
export interface Inside {
  item: Item | null;
}

/** Items while they are built, and where a drawing changes them in place. */
export type Building<T> = { -readonly [Key in keyof T]: T[Key] };
export type Within<T> = Building<T> & { around: Inside; readonly inside: Inside };
export type BuildingItem =
  Within<ContainerItem> | Within<UseItem> | Within<CurveItem> | Within<ReferenceItem>;

/** The fields of an item; its parent is whatever surrounds it now. */
export type Fields<T> = Omit<T, "parent"> & { around: Inside; inside: Inside };

// Classes that name each field: thousands of objects of one shape, which are small and quick.
class ItemObject<T extends Item> {
  kind: T["kind"];
  handle: T["handle"];
  element: T["element"];
  around: Inside;
  inside: Inside;
  children: T["children"];
  name: string;
  artboardFromItem: T["artboardFromItem"];
  hidden: boolean;
  locked: boolean;
  opacity: number;
  blend: string;

  constructor(fields: Fields<T>) {
    this.kind = fields.kind;
    this.handle = fields.handle;
    this.element = fields.element;
    this.around = fields.around;
    this.inside = fields.inside;
    this.children = fields.children;
    this.name = fields.name;
    this.artboardFromItem = fields.artboardFromItem;
    this.hidden = fields.hidden;
    this.locked = fields.locked;
    this.opacity = fields.opacity;
    this.blend = fields.blend;
  }

  get parent(): Item | null {
    return this.around.item;
  }
}

class CurveObject extends ItemObject<CurveItem> {
  paths: CurveItem["paths"];
  isPath: boolean;
  left: CurveItem["left"];
  right: CurveItem["right"];
  radius: CurveItem["radius"];
  layerFromItem: CurveItem["layerFromItem"];
  copies: number;

  constructor(fields: Fields<CurveItem>) {
    super(fields);
    this.paths = fields.paths;
    this.isPath = fields.isPath;
    this.left = fields.left;
    this.right = fields.right;
    this.radius = fields.radius;
    this.layerFromItem = fields.layerFromItem;
    this.copies = fields.copies;
  }
}

class UseObject extends ItemObject<UseItem> {
  target: Item | null;

  constructor(fields: Fields<UseItem>) {
    super(fields);
    this.target = fields.target;
  }
}

class ReferenceObject extends ItemObject<ReferenceItem> {
  href: string;
  box: ReferenceItem["box"];

  constructor(fields: Fields<ReferenceItem>) {
    super(fields);
    this.href = fields.href;
    this.box = fields.box;
  }
}

function objectOf(fields: Fields<Item>): unknown {
  switch (fields.kind) {
    case "curve":
    case "stroke":
      return new CurveObject(fields as Fields<CurveItem>);
    case "use":
      return new UseObject(fields as Fields<UseItem>);
    case "reference":
      return new ReferenceObject(fields as Fields<ReferenceItem>);
    default:
      return new ItemObject(fields);
  }
}

/** The item of these fields; a copy of an item takes its place as the parent of its children. */
export function itemOf<T extends Item>(fields: Fields<T>): Within<T> {
  const item = objectOf(fields as Fields<Item>) as Within<T>;
  item.inside.item = item as Item;
  return item;
}
