// Path data given to an element.
import { geometryAttributes } from "../../geometry/path.js";
import { attributeOf, setAttribute, SODIPODI } from "../../source/attributes.js";
import { encodeValue } from "../../source/entities.js";
import type { Edit } from "../../source/patch.js";
import type { ElementNode } from "../../source/tree.js";

/**
 * Inkscape's own words for a shape go before d when it opens the file; its kinds of nodes count
 * them.
 */
function stale(text: string, element: ElementNode, isRecounted: boolean): Edit[] {
  const remove = (local: string) =>
    setAttribute(text, element, { namespace: SODIPODI, local }, null);
  return [...remove("type"), ...(isRecounted ? remove("nodetypes") : [])];
}

/** The element's own name exchanged, in both of its tags. */
function renamed(text: string, element: ElementNode, local: string): Edit[] {
  const { name, range, closesItself } = element;
  const inserted = name.slice(0, name.length - element.local.length) + local;
  const edits = [{ at: range.start + 1, removed: name, inserted }];
  if (closesItself) return edits;
  return [...edits, { at: text.lastIndexOf("</", range.end) + 2, removed: name, inserted }];
}

/** Attributes of the shape give way to one, in the place of the first of them. */
function exchanged(text: string, element: ElementNode, d: string): Edit[] {
  const found = geometryAttributes(element.local)
    .flatMap((name) => attributeOf(element, name) ?? [])
    .sort((a, b) => a.range.start - b.range.start);
  const [first, ...rest] = found;
  const { start, end } = first.range;
  const inserted = `d=${first.quote}${encodeValue(d, first.quote)}${first.quote}`;
  return [
    { at: start, removed: text.slice(start, end), inserted },
    ...rest.flatMap(({ name }) => setAttribute(text, element, name, null)),
  ];
}

/** The edits that give an element path data; another shape becomes a path. */
export function dataEdits(
  text: string,
  element: ElementNode,
  d: string,
  isRecounted: boolean,
): Edit[] {
  const edits = stale(text, element, isRecounted);
  if (element.local === "path") return [...edits, ...setAttribute(text, element, "d", d)];
  return [...edits, ...renamed(text, element, "path"), ...exchanged(text, element, d)];
}
