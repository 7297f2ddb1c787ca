// The sides of a curve by where they are: inside and outside of a closed curve, left and right of an open one.
import type { Rgb } from "../geometry/color.js";
import type { CubicPath } from "../geometry/cubic.js";
import { insideSign } from "../geometry/orientation.js";
import type { CurveItem, Side, SideValue } from "./types.js";

/** The words for sides: keys of the editor's strings. */
export type SideWord = Side | "inside" | "outside";

const known = new WeakMap<readonly CubicPath[], Side | null>();

/**
 * Returns the side that faces inside; null: the curve is open, or encloses no area. A transform that mirrors
 * swaps the sides of a curve, and its direction on the screen: the side is the same in every frame.
 */
export function insideOf({ paths }: Pick<CurveItem, "paths">): Side | null {
  let side = known.get(paths);
  if (side === undefined) {
    const sign = insideSign(paths);
    side = sign === 0 ? null : sign < 0 ? "left" : "right";
    known.set(paths, side);
  }
  return side;
}

/** Returns the word for a side of a curve: the only place that decides it. */
export function sideWord(item: Pick<CurveItem, "paths">, side: Side): SideWord {
  const inside = insideOf(item);
  if (inside === null) return side;
  return side === inside ? "inside" : "outside";
}

/** Returns both sides in the order of rows: the inside first, else left first. */
export function sidesInOrder(item: Pick<CurveItem, "paths">): readonly Side[] {
  return insideOf(item) === "right" ? ["right", "left"] : ["left", "right"];
}

/** Colours and opacities of both sides. */
export interface FilledSides extends Readonly<Record<Side, SideValue<Rgb>>> {
  readonly opacity: Readonly<Record<Side, number>>;
}

/** Returns the sides of a filled shape: a colour inside, transparent outside, where the colour passes through. */
export function filledSides(inside: Side, color: Rgb): FilledSides {
  const fill: SideValue<Rgb> = { kind: "stops", space: "arc", stops: [{ offset: 0, value: color }] };
  const open: SideValue<Rgb> = { kind: "open" };
  return inside === "left"
    ? { left: fill, right: open, opacity: { left: 1, right: 0 } }
    : { left: open, right: fill, opacity: { left: 0, right: 1 } };
}
