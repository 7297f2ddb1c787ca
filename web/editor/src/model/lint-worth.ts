// Selects the hints to show.
import type { Drawing, Item } from "./types.js";

/** Before the first curve a layer is empty because nothing has been drawn yet. */
export function isWorthTelling(d: Drawing, { rule }: { readonly rule: string }): boolean {
  const isDrawn = ({ kind }: Item) => kind === "curve" || kind === "stroke";
  return rule !== "empty-layer" || [...d.all()].some(isDrawn);
}
