// The attributes that any item's element can have.
import { INKSCAPE, SODIPODI, valueOf } from "../source/attributes.js";
import { keywordOf, shareOf } from "../source/css.js";
import { BLEND_MODES } from "../source/styles.js";
import type { Styles } from "../source/styles.js";
import type { ElementNode } from "../source/tree.js";

/** Returns the values that any item has, without its place among others. */
export function readCommon(element: ElementNode, styles: Styles) {
  const isDisplayed = keywordOf(styles.value(element, "display") ?? "") !== "none";
  const visibility = keywordOf(styles.value(element, "visibility") ?? "visible");
  const blend = keywordOf(styles.value(element, "mix-blend-mode") ?? "normal") ?? "";
  return {
    hidden: !isDisplayed || visibility !== "visible",
    locked: valueOf(element, { namespace: SODIPODI, local: "insensitive" }) === "true",
    opacity: shareOf(styles.value(element, "opacity") ?? "1") ?? 1,
    blend: (BLEND_MODES as readonly string[]).includes(blend) ? blend : "normal",
  };
}

/** inkscape:label or the id, or null. */
export function saidName(element: ElementNode): string | null {
  const label = valueOf(element, { namespace: INKSCAPE, local: "label" });
  return label || valueOf(element, "id") || null;
}
