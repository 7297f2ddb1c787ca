// Colours as panels show and mix them.
import { mixed, type Rgb } from "../geometry/color.js";
import { hexOf } from "../geometry/colortext.js";
import type { Drawing } from "../model/types.js";
import type { Mix } from "./stops.js";

/** As the document mixes between stops. */
export const mixerOf =
  (space: Drawing["interpolation"]): Mix<Rgb> =>
  (a, b, t) =>
    mixed(a, b, t, space);

/** The same, as CSS names it in gradients. */
export const cssSpaces: Readonly<
  Record<Drawing["interpolation"], "srgb" | "srgb-linear" | "oklab">
> = {
  srgb: "srgb",
  linear: "srgb-linear",
  oklab: "oklab",
};

/** All colours of stops in the drawing, each once, at most `most`. */
export function colorsOf(drawing: Drawing, most: number): readonly Rgb[] {
  const found = new Map<string, Rgb>();
  for (const item of drawing.all()) {
    if (item.kind !== "curve" && item.kind !== "stroke") continue;
    for (const { color } of [item.left, item.right]) {
      if (color.kind === "stops")
        color.stops.forEach(({ value }) => found.set(hexOf(value), value));
    }
    if (found.size >= most) break;
  }
  return [...found.values()].slice(0, most);
}
