// A patch in the making: edits in any order, and what is selected after them.
import { patchOf } from "../../../source/attributes.js";
import type { Edit, Patch } from "../../../source/patch.js";
import type { ElementNode, Range } from "../../../source/tree.js";
import type { Outcome } from "../../types.js";

/** Edits of one text, and places that are to be selected. Edits at one place stay in their order. */
export class Draft {
  readonly #text: string;
  readonly #edits: Edit[] = [];
  readonly #selected: { readonly edit: Edit | null; readonly offset: number }[] = [];

  constructor(text: string) {
    this.#text = text;
  }

  replace({ start, end }: Range, inserted: string): Edit {
    const edit = { at: start, removed: this.#text.slice(start, end), inserted };
    this.add([edit]);
    return edit;
  }

  add(edits: readonly Edit[]): void {
    this.#edits.push(...edits.filter(({ removed, inserted }) => removed !== inserted));
  }

  /** The text of an element as edits leave it, to stand elsewhere. Those outside of it are added. */
  rewritten(element: ElementNode, edits: readonly Edit[]): string {
    const { start, end } = element.range;
    const isWithin = ({ at, removed }: Edit) => at > start && at + removed.length <= end;
    this.add(edits.filter((edit) => !isWithin(edit)));
    let at = start;
    let out = "";
    for (const edit of patchOf(edits.filter(isWithin))) {
      out += this.#text.slice(at, edit.at) + edit.inserted;
      at = edit.at + edit.removed.length;
    }
    return out + this.#text.slice(at, end);
  }

  /** An element that begins at `offset` of what an edit inserts. */
  selectWithin(edit: Edit, offset: number): void {
    this.#selected.push({ edit, offset });
  }

  /** An element that stays, by its place in the text before. */
  selectAt(offset: number): void {
    this.#selected.push({ edit: null, offset });
  }

  /** null where nothing changes. @throws RangeError where edits overlap */
  outcome(): Outcome | null {
    const patch = patchOf(this.#edits);
    if (patch.length === 0) return null;
    if (this.#selected.length === 0) return { patch };
    const select = this.#selected.map(({ edit, offset }) => ({
      at: placeAfter(patch, edit, offset),
    }));
    return { patch, select };
  }
}

/** Where in the text after a patch something stands: within an edit, or what the edits left alone. */
function placeAfter(patch: Patch, within: Edit | null, offset: number): number {
  let shift = 0;
  for (const edit of patch) {
    if (edit === within) return edit.at + shift + offset;
    if (!within && edit.at + edit.removed.length > offset) break;
    shift += edit.inserted.length - edit.removed.length;
  }
  return offset + shift;
}
