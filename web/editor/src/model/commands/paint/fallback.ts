// The look of a curve in other programs: a thin line in the mean of its colours.
import type { Rgb } from "../../../geometry/color.js";
import { colorText } from "../../../source/colors.js";
import type { Drawing, SideValue } from "../../types.js";
import type { WrittenAttributes } from "../markup.js";
import { numberText } from "../../../geometry/path.js";

function colorsOf(side: SideValue<Rgb>): Rgb[] {
  return side.kind === "stops" ? side.stops.map(({ value }) => value) : [];
}

/** Gray where the sides bear no colours. */
function meanColor(sides: readonly SideValue<Rgb>[]): Rgb {
  const colors = sides.flatMap(colorsOf);
  if (colors.length === 0) return { r: 0.5, g: 0.5, b: 0.5 };
  const mean = (channel: keyof Rgb) => {
    const sum = colors.reduce((total, color) => total + color[channel], 0);
    return Math.round((255 * sum) / colors.length) / 255;
  };
  return { r: mean("r"), g: mean("g"), b: mean("b") };
}

/** `fill` and `stroke` of a new curve; `scale`: artboard units to a unit of the element. */
export function fallback(
  { artboard }: Drawing,
  sides: readonly SideValue<Rgb>[],
  scale: number,
): WrittenAttributes {
  const extent = Math.max(artboard[2] - artboard[0], artboard[3] - artboard[1]);
  const width = extent / 512 / (scale > 0 ? scale : 1);
  return [
    ["fill", "none"],
    ["stroke", colorText(meanColor(sides))],
    ["stroke-width", numberText(width, 10 ** (Math.floor(Math.log10(width)) - 1))],
  ];
}
