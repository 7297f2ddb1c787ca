// An element taken out of the text.
import type { Edit } from "../../../source/patch.js";
import type { ElementNode } from "../../../source/tree.js";
import { removalOf } from "./layout.js";

/** The edit that takes an element away, with its line where it has one. */
export function removal(text: string, { range }: ElementNode): Edit {
  const { start, end } = removalOf(text, range);
  return { at: start, removed: text.slice(start, end), inserted: "" };
}
