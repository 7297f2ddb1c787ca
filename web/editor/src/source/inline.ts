// What style sheets say of elements, written on the elements themselves: for where the sheets are not.
import { patchOf } from "./attributes.js";
import { elementsOf } from "./nodes.js";
import { applied } from "./patch.js";
import type { Edit } from "./patch.js";
import { INHERITED, IS_VALUE } from "./properties.js";
import { setStyles } from "./set-style.js";
import { isSvg, type Property, type Styles } from "./styles.js";
import type { ElementNode } from "./tree.js";

const PROPERTIES = Object.keys(IS_VALUE) as Property[];

/**
 * The edits by which an element and all within look the same without style sheets, and without what
 * stands around it. They stand in style="", which holds against the sheets of another drawing, too.
 */
export function inlineEdits(text: string, styles: Styles, element: ElementNode): Edit[] {
  return [...elementsOf(element)].flatMap((it) =>
    isSvg(it) ? editsOf(text, styles, it, it === element) : [],
  );
}

function editsOf(text: string, styles: Styles, element: ElementNode, isOutermost: boolean): Edit[] {
  const values: Partial<Record<Property, string>> = {};
  for (const property of PROPERTIES) {
    const sheet = styles.inSheets(element, property);
    const own = styles.own(element, property);
    if (sheet && own !== null && own === sheet.value) values[property] = own;
    else if (isOutermost && own === null && element.parent && INHERITED.has(property)) {
      const inherited = styles.value(element.parent, property);
      if (inherited !== null) values[property] = inherited;
    }
  }
  return setStyles(text, styles, element, values);
}

/** A document of which each element says itself what its style sheets say of it. */
export function withoutSheets(text: string, styles: Styles, root: ElementNode): string {
  if (styles.isEmpty) return text;
  const edits = inlineEdits(text, styles, root);
  return edits.length === 0 ? text : applied(text, patchOf(edits));
}
