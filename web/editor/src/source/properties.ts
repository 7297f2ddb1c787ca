// Properties of CSS that the editor reads, and the values that they have.
import { parseColor } from "./colors.js";
import { keywordOf, shareOf, solid, tokensOf, urlAmong } from "./css.js";
import type { Token } from "./css.js";
import { variablesIn } from "./variables.js";
import type { VariableName } from "./variables.js";

export const BLEND_MODES = [
  "normal",
  "multiply",
  "screen",
  "overlay",
  "darken",
  "lighten",
  "color-dodge",
  "color-burn",
  "hard-light",
  "soft-light",
  "difference",
  "exclusion",
  "hue",
  "saturation",
  "color",
  "luminosity",
] as const;

const isShare = (text: string) => shareOf(text) !== null;
const isColor = (text: string) => keywordOf(text) === "currentcolor" || parseColor(text) !== null;
const isOneOf =
  (...words: string[]) =>
  (text: string) =>
    words.includes(keywordOf(text) ?? "");

const PAINT_WORDS = ["none", "context-fill", "context-stroke"];

/** A paint, perhaps behind url(…): what to paint where that leads nowhere. */
function isPaint(text: string): boolean {
  const tokens = solid(tokensOf(text));
  let at = 0;
  for (let url = urlAmong(tokens, at); url; url = urlAmong(tokens, at)) at = url.behind;
  if (at > 0 && at === tokens.length) return true;
  const rest = at === 0 ? text : text.slice(tokens[at].start);
  return isColor(rest) || PAINT_WORDS.includes(keywordOf(rest) ?? "");
}

/** The words of `display`, up to three of them. */
const DISPLAYS: ReadonlySet<string> = new Set([
  "none",
  "inline",
  "block",
  "contents",
  "flow",
  "flow-root",
  "inline-block",
  "list-item",
  "run-in",
  "table",
  "inline-table",
  "table-row-group",
  "table-header-group",
  "table-footer-group",
  "table-row",
  "table-cell",
  "table-column-group",
  "table-column",
  "table-caption",
  "flex",
  "inline-flex",
  "grid",
  "inline-grid",
  "ruby",
  "ruby-base",
  "ruby-text",
  "ruby-base-container",
  "ruby-text-container",
]);

function isDisplay(text: string): boolean {
  const words = solid(tokensOf(text));
  const isKnown = ({ kind, value }: Token) => kind === "ident" && DISPLAYS.has(value.toLowerCase());
  return words.length > 0 && words.length <= 3 && words.every(isKnown);
}

/** Whether a text without var() is a value of a property. */
const IS_VALUE = {
  display: isDisplay,
  visibility: isOneOf("visible", "hidden", "collapse"),
  opacity: isShare,
  "mix-blend-mode": isOneOf(...BLEND_MODES),
  fill: isPaint,
  stroke: isPaint,
  "fill-opacity": isShare,
  color: isColor,
  "stop-color": isColor,
  "stop-opacity": isShare,
} as const;

export type Property = keyof typeof IS_VALUE;

/** With custom properties. */
export type PropertyName = Property | VariableName;

export const PROPERTIES = Object.keys(IS_VALUE) as Property[];

export function isProperty(name: string): name is Property {
  return Object.hasOwn(IS_VALUE, name);
}

export const INHERITED: ReadonlySet<Property> = new Set([
  "visibility",
  "fill",
  "stroke",
  "fill-opacity",
  "color",
]);
/** Words that any property takes. */
const WIDE = ["inherit", "initial", "unset", "revert", "revert-layer"] as const;
export type Wide = (typeof WIDE)[number];

/** Returns the CSS-wide keyword that a value is, or null. */
export function wideOf(text: string): Wide | null {
  const word = keywordOf(text);
  return WIDE.find((one) => one === word) ?? null;
}

/** Whether CSS keeps a declaration of a property with this value. */
export function isValue(property: Property, text: string): boolean {
  if (wideOf(text) !== null) return true;
  const variables = variablesIn(text);
  return variables === "none" ? IS_VALUE[property](text) : variables === "valid";
}
