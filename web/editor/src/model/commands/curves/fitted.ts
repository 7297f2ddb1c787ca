// The attributes of curves that were fitted to a photo.
import type { Rgb } from "../../../geometry/color.js";
import { determinant } from "../../../geometry/affine.js";
import type { CurveItem, Drawing, Outcome, Side, SideValue } from "../../types.js";
import { setBoth, setColor, setNumbers } from "../attributes.js";
import { together } from "../structure/together.js";

const SIDES: readonly Side[] = ["left", "right"];

/** Rows of [offset, red, green, blue] of the left and of the right side, as they are in the layer. */
export type FittedColors = readonly [readonly (readonly number[])[], readonly (readonly number[])[]];

const byteOf = (channel: number) => Math.round(255 * channel);
const isSame = (a: Rgb, b: Rgb) =>
  byteOf(a.r) === byteOf(b.r) && byteOf(a.g) === byteOf(b.g) && byteOf(a.b) === byteOf(b.b);
const inBytes = (channel: number) => byteOf(channel) / 255;

/** Stops keep their places. null: the side has none, or others than were fitted. */
function colored(value: SideValue<Rgb>, rows: readonly (readonly number[])[]): SideValue<Rgb> | null {
  if (value.kind !== "stops" || value.stops.length !== rows.length) return null;
  const stops = value.stops.map((stop, i) => {
    const [, r, g, b] = rows[i];
    const to: Rgb = { ...stop.value, r: inBytes(r), g: inBytes(g), b: inBytes(b) };
    return { ...stop, value: isSame(stop.value, to) ? stop.value : to };
  });
  return stops.every(({ value: to }, i) => to === value.stops[i].value) ? null : { ...value, stops };
}

/** The stops of a curve in other colours; null: they have them. */
export function setFittedColors(d: Drawing, item: CurveItem, fitted: FittedColors): Outcome | null {
  // A transform that mirrors exchanges the sides.
  const isMirrored = determinant(item.layerFromItem) < 0;
  const made = SIDES.map((side, k) => {
    const value = colored(item[side].color, fitted[isMirrored ? 1 - k : k]);
    return value && setColor(d, item.handle, side, value);
  });
  return made.some((one) => one) ? together(made) : null;
}

export type Radii = Readonly<Record<Side, SideValue<number>>>;

/** The blur of a curve. @param radii null: none */
export function setFittedBlur(d: Drawing, item: CurveItem, radii: Radii | null): Outcome | null {
  const none: SideValue<number> = { kind: "open" };
  const [left, right] = radii ? [radii.left, radii.right] : [none, none];
  if (JSON.stringify([left, right]) === JSON.stringify([item.left.blur, item.right.blur])) return null;
  if (JSON.stringify(left) === JSON.stringify(right)) return setBoth(d, item.handle, "blur", left);
  return together([
    setNumbers(d, item.handle, "left", "blur", left),
    setNumbers(d, item.handle, "right", "blur", right),
  ]);
}
