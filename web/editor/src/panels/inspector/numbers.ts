// Numbers that a curve bears as a whole.
import type { CurveItem } from "../../model/types.js";

/**
 * sf:weight of a diffusion curve, sf:alpha of a local one: what is missing, or none, counts as 1.
 */
export function numberOf({ element }: CurveItem, name: "alpha" | "weight"): number {
  const text = element.attributes.find(
    ({ local, namespace }) => local === name && namespace !== "",
  )?.value;
  const value = text === undefined || text.trim() === "" ? 1 : Number(text);
  return Number.isFinite(value) ? value : 1;
}
