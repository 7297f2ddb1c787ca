// Subpaths of one element that need lists of their own, as elements of their own.
import { readPath, rewritePath } from "../../../geometry/path.js";
import { blanksBefore, patchOf, setAttribute, valueOf } from "../../../source/attributes.js";
import { applied, type Edit } from "../../../source/patch.js";
import type { ElementNode } from "../../../source/tree.js";
import type { Drawing } from "../../types.js";
import { dataEdits } from "../data-edits.js";

/** Some subpaths, and the edits of other attributes that go with them. */
export interface ElementPart {
  readonly data: string;
  readonly edits: readonly Edit[];
}

/** Path data without some of its subpaths, as readPath() counts them. */
export function onlySubpaths(
  data: string,
  isKept: (index: number) => boolean,
  step: number,
): string {
  let rest = data;
  for (let i = readPath(data).length - 1; i >= 0; --i) {
    if (!isKept(i)) rest = rewritePath(rest, i, readPath(rest)[i], null, step);
  }
  return rest;
}

/** Ids with numbers that are nowhere in the text. */
function* freeIds(text: string, id: string): Generator<string, never> {
  for (let number = 2; ; ++number) {
    if (!text.includes(`${id}-${number}`)) yield `${id}-${number}`;
  }
}

function copied(
  text: string,
  element: ElementNode,
  { data, edits }: ElementPart,
  id: string | null,
): string {
  const { start, end } = element.range;
  const all = [
    ...dataEdits(text, element, data, true),
    ...edits,
    ...(id === null ? [] : setAttribute(text, element, "id", id)),
  ];
  return applied(
    text.slice(start, end),
    patchOf(all).map((edit) => ({ ...edit, at: edit.at - start })),
  );
}

/**
 * The edits that make several elements of one: it keeps `own`, copies behind it have the others.
 * @returns also where the copies begin, counted from the end of the element as it becomes
 */
export function partedElement(
  drawing: Drawing,
  element: ElementNode,
  own: ElementPart,
  others: readonly ElementPart[],
): { edits: Edit[]; copyOffsets: number[] } {
  const { text } = drawing;
  const { start, end } = element.range;
  const lead = text.slice(blanksBefore(text, start, element.parent?.startTag.end ?? 0), start);
  const id = valueOf(element, "id");
  const ids = id === undefined ? null : freeIds(text, id);
  const copies = others.map((part) => lead + copied(text, element, part, ids && ids.next().value));
  const before = copies.map((_, i) => copies.slice(0, i).join("").length);
  return {
    edits: [
      ...dataEdits(text, element, own.data, true),
      ...own.edits,
      { at: end, removed: "", inserted: copies.join("") },
    ],
    copyOffsets: before.map((length) => length + lead.length),
  };
}
