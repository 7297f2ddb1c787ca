// Selects the hints to show.
import type { Drawing, Item } from "./types.js";

/**
 * Before the first curve a layer is empty because nothing has been drawn yet, and so is the layer at work, in which the
 * next curve will be drawn.
 */
export function isWorthTelling(d: Drawing, { rule }: { readonly rule: string }, atWork: Item | null): boolean {
  const isDrawn = ({ kind }: Item) => kind === "curve" || kind === "stroke";
  const isLeft = (item: Item) => item.kind === "layer" && item.children.length === 0 && item.handle !== atWork?.handle;
  const all = [...d.all()];
  return rule !== "empty-layer" || (all.some(isDrawn) && all.some(isLeft));
}
