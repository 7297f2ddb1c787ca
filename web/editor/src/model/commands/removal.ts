// An element taken out of the text.
import { blanksBefore } from "../../source/attributes.js";
import type { Edit } from "../../source/patch.js";
import type { ElementNode } from "../../source/tree.js";

/** The edit that takes an element away, with the blanks before it. */
export function removal(text: string, { range, parent }: ElementNode): Edit {
  const at = blanksBefore(text, range.start, parent?.startTag.end ?? 0);
  return { at, removed: text.slice(at, range.end), inserted: "" };
}
