// Properties of elements set so that they hold, whatever styles say.
import { attributeOf, setAttribute } from "./attributes.js";
import type { Edit } from "./patch.js";
import { declarationsOf } from "./styles.js";
import type { Property, Styles } from "./styles.js";
import type { ElementNode } from "./tree.js";

/** style="" with a declaration set, or taken away; null where nothing is left of it. */
function withDeclaration(style: string, property: string, written: string | null): string | null {
  const own = declarationsOf(style).filter(({ name }) => name === property);
  let text = style;
  for (const { start, end } of own.reverse()) {
    const isLast = own[0].start === start;
    const behind = /^\s*;?\s*/.exec(text.slice(end))?.[0].length ?? 0;
    text = isLast && written !== null
      ? `${text.slice(0, start)}${property}:${written}${text.slice(end)}`
      : text.slice(0, start) + text.slice(end + behind);
  }
  if (own.length === 0 && written !== null) {
    const trimmed = text.trimEnd();
    const mark = trimmed === "" || trimmed.endsWith(";") ? "" : ";";
    text = `${trimmed}${mark}${property}:${written}`;
  }
  return text.trim().replace(/^;+$/, "") === "" ? null : text;
}

/**
 * The edits that give a property a value; null takes away what the element itself says. It goes
 * into style="" where that or a style sheet would win, else into an attribute.
 */
export function setStyle(
  text: string,
  styles: Styles,
  element: ElementNode,
  property: Property,
  value: string | null,
): Edit[] {
  const inStyle = styles.inStyle(element, property);
  const inSheets = styles.inSheets(element, property);
  const style = attributeOf(element, "style")?.value ?? "";
  const isDeclared = declarationsOf(style).some(({ name }) => name === property);
  if (value === null) {
    const edits = setAttribute(text, element, property, null);
    if (!isDeclared) return edits;
    const left = withDeclaration(style, property, null);
    return [...edits, ...setAttribute(text, element, "style", left)];
  }
  if (!inStyle && !inSheets && !isDeclared) return setAttribute(text, element, property, value);
  const isImportant = inStyle?.isImportant || inSheets?.isImportant;
  const written = isImportant ? `${value}!important` : value;
  return setAttribute(text, element, "style", withDeclaration(style, property, written));
}
