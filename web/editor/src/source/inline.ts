// Writes the effect of style sheets and ancestors onto the elements, for places without them.
import { patchOf } from "./attributes.js";
import { svgElementsOf } from "./matching.js";
import { applied } from "./patch.js";
import type { Edit } from "./patch.js";
import { INHERITED, PROPERTIES } from "./properties.js";
import type { Property } from "./properties.js";
import { setStyles } from "./set-style.js";
import type { Styles } from "./styles.js";
import type { ElementNode } from "./tree.js";

/**
 * The edits by which an element and all within look the same without style sheets, and without what
 * stands around it. They stand in style="", which holds against the sheets of another drawing, too.
 */
export function inlineEdits(text: string, styles: Styles, element: ElementNode): Edit[] {
  return [...svgElementsOf(element)].flatMap((it) => editsOf(text, styles, it, it === element));
}

function editsOf(text: string, styles: Styles, element: ElementNode, isOutermost: boolean): Edit[] {
  const values: Partial<Record<Property, string>> = {};
  for (const property of PROPERTIES) {
    const { wide, value, isOwn } = styles.own(element, property);
    const said = value ?? wide;
    if (said !== null && !isOwn) values[property] = said;
    else if (isOutermost && said === null && element.parent && INHERITED.has(property)) {
      const inherited = styles.value(element.parent, property);
      if (inherited !== null) values[property] = inherited;
    }
  }
  return setStyles(text, styles, element, values);
}

/** Returns a document whose elements carry the settings of its style sheets themselves. */
export function withoutSheets(text: string, styles: Styles, root: ElementNode): string {
  const edits = inlineEdits(text, styles, root);
  return edits.length === 0 ? text : applied(text, patchOf(edits));
}
