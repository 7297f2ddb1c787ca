// Properties of CSS that are asked for, and which values they have.
import { parseColor } from "./colors.js";
import { keywordOf, shareOf, solid, tokensOf } from "./css.js";
import type { Token } from "./css.js";

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

function isPaint(text: string): boolean {
  return isColor(text) || keywordOf(text) === "none" || /^\s*url\(/i.test(text);
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

/** Whether CSS keeps a declaration of a property with this value. */
export const IS_VALUE = {
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

export const INHERITED: ReadonlySet<Property> = new Set([
  "visibility",
  "fill",
  "stroke",
  "fill-opacity",
  "color",
]);
/** Words that any property takes. */
export const WIDE = ["inherit", "initial", "unset", "revert", "revert-layer"];
