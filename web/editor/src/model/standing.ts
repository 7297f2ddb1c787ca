// How an item stands in the drawing: what surrounds it decides, too.
import type { Handle, Item } from "./types.js";

export const isHidden = (item: Item): boolean => item.hidden || (item.parent !== null && isHidden(item.parent));

export const isLocked = (item: Item): boolean => item.locked || (item.parent !== null && isLocked(item.parent));

/** Whether an item, or something around it, is one of these. */
export const isWithin = (item: Item | null, handles: ReadonlySet<Handle>): boolean =>
  item !== null && (handles.has(item.handle) || isWithin(item.parent, handles));
