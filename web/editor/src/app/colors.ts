// The colours that were chosen last: the first of them is the colour of what is drawn next.
import type { Rgb } from "../geometry/color.js";
import { hexOf } from "../geometry/colortext.js";
import type { Settings } from "./types.js";

const RECENT = 8;

/** The colour before any was chosen: a warm red, which shows on white and on black. */
const FIRST: Rgb = { r: 224 / 255, g: 110 / 255, b: 78 / 255 };

/** Puts a colour in front of the recent ones. */
export function remember({ recent }: Settings, color: Rgb): void {
  const others = recent.peek().filter((other) => hexOf(other) !== hexOf(color));
  recent.value = [color, ...others].slice(0, RECENT);
}

/**
 * Returns the current colour: of new shapes and strokes, and of new curves on request. Within components and effects,
 * reading it subscribes to its changes.
 */
export function currentColor({ recent }: Settings): Rgb {
  return recent.value[0] ?? FIRST;
}
