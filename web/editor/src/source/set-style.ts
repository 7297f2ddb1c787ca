// Properties of elements set so that they hold, whatever styles say.
import { attributeOf, setAttribute } from "./attributes.js";
import type { Edit } from "./patch.js";
import { declarationsOf } from "./declarations.js";
import type { Property, Styles } from "./styles.js";
import type { ElementNode } from "./tree.js";

/** style="" with a declaration set, in the place of its last one, or taken away. */
function withDeclaration(style: string, property: string, written: string | null): string {
  const own = declarationsOf(style).filter(({ name }) => name === property);
  if (own.length === 0) {
    if (written === null) return style;
    const trimmed = style.trimEnd();
    const mark = trimmed === "" || trimmed.endsWith(";") ? "" : ";";
    return `${trimmed}${mark}${property}:${written}`;
  }
  let text = style;
  own.reverse().forEach(({ start, end, valueStart }, i) => {
    if (i === 0 && written !== null) {
      text = text.slice(0, valueStart) + written + text.slice(end);
    } else {
      const behind = /^\s*;?\s*/.exec(text.slice(end))?.[0].length ?? 0;
      text = text.slice(0, start) + text.slice(end + behind);
    }
  });
  return text;
}

/** Whether nothing is declared, and style="" may go. */
function isEmpty(style: string): boolean {
  return /^[\s;]*$/.test(style);
}

/** Properties that programs read in style="" only. */
const STYLE_ONLY: ReadonlySet<Property> = new Set(["mix-blend-mode"]);

/**
 * The edits that give properties values; null takes away what the element itself says. A value goes
 * into style="" where that or a style sheet would win or might then, else into an attribute.
 */
export function setStyles(
  text: string,
  styles: Styles,
  element: ElementNode,
  values: Partial<Record<Property, string | null>>,
): Edit[] {
  const before = attributeOf(element, "style")?.value ?? "";
  let style = before;
  const edits: Edit[] = [];
  for (const [property, value] of Object.entries(values) as [Property, string | null][]) {
    const inStyle = styles.inStyle(element, property);
    const inSheets = styles.inSheets(element, property);
    const isDeclared = declarationsOf(style).some(({ name }) => name === property);
    // A rule that tests the text written here may set the property once it stands here.
    const mayMatch = styles.asksFor("style") || styles.asksFor(property);
    if (value === null) {
      style = withDeclaration(style, property, null);
      edits.push(...setAttribute(text, element, property, null));
    } else if (inStyle || inSheets || isDeclared || mayMatch || STYLE_ONLY.has(property)) {
      const isImportant = inStyle?.isImportant || inSheets?.isImportant || mayMatch;
      style = withDeclaration(style, property, isImportant ? `${value}!important` : value);
    } else {
      edits.push(...setAttribute(text, element, property, value));
    }
  }
  if (style === before) return edits;
  return [...edits, ...setAttribute(text, element, "style", isEmpty(style) ? null : style)];
}

/** The edits for one property: see setStyles. */
export function setStyle(
  text: string,
  styles: Styles,
  element: ElementNode,
  property: Property,
  value: string | null,
): Edit[] {
  return setStyles(text, styles, element, { [property]: value });
}
