// Edits of the palette that the document has.
import type { Rgb } from "../../../geometry/color.js";
import { hexOf } from "../../../geometry/colortext.js";
import { declare, INKSCAPE, nameWithin, setAttribute } from "../../../source/attributes.js";
import { colorText } from "../../../source/colors.js";
import type { Drawing, Outcome } from "../../types.js";
import { sidesWithPaint } from "../../gradients.js";
import { SWATCH, swatchesOf, type Swatch } from "../../swatches.js";
import { Draft } from "../curves/draft.js";
import { opening, svgName } from "../markup.js";
import { freeId } from "../structure/references.js";
import { removal } from "../structure/removal.js";
import { outcomeOf } from "../structure/together.js";
import { intoDefs } from "./defs.js";

/** Adds colours to the palette. null: it has all of them. */
export function addSwatches(d: Drawing, colors: readonly Rgb[]): Outcome | null {
  const known = new Set(swatchesOf(d).map(({ color }) => hexOf(color)));
  const fresh = new Map(colors.map((color) => [hexOf(color), color]));
  for (const hex of known) fresh.delete(hex);
  if (fresh.size === 0) return null;
  const taken = new Set(d.ids.keys());
  const draft = new Draft(d.text);
  draft.add(declare(d.text, d.root, INKSCAPE));
  const pieces = [...fresh].map(([hex, color]) => {
    const id = freeId(`color-${hex.replace("#", "")}`, taken);
    const gradient = opening(d.root, "linearGradient", [
      ["id", id],
      [nameWithin(d.root, INKSCAPE, SWATCH.local), "solid"],
    ]);
    const stop = opening(d.root, "stop", [["stop-color", colorText(color)]]);
    return `${gradient}>${stop}/></${svgName(d.root, "linearGradient")}>`;
  });
  intoDefs(d, draft, pieces);
  return draft.outcome();
}

/** Removes a colour from the palette. Where a side shows it as a gradient, the gradient stays. */
export function removeSwatch(d: Drawing, { name, element }: Swatch): Outcome | null {
  const isShown = name !== "" && sidesWithPaint(d, `#${name}`) > 0;
  return outcomeOf(isShown ? setAttribute(d.text, element, SWATCH, null) : [removal(d.text, element)]);
}
