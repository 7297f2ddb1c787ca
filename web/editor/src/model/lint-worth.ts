// Selects the hints to show.
import type { Drawing, Item } from "./types.js";

/**
 * Returns whether the editor shows a hint. It hides hints at empty layers in two cases: the drawing has no curve yet, or
 * the only empty layer is the active one, which gets the next curve.
 * @param atWork the active layer
 */
export function isWorthTelling(d: Drawing, { rule }: { readonly rule: string }, atWork: Item | null): boolean {
  const isDrawn = ({ kind }: Item) => kind === "curve" || kind === "stroke";
  const isLeft = (item: Item) => item.kind === "layer" && item.children.length === 0 && item.handle !== atWork?.handle;
  const all = [...d.all()];
  return rule !== "empty-layer" || (all.some(isDrawn) && all.some(isLeft));
}
