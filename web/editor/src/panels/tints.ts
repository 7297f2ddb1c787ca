// The colour stops of a side: its own, or the stops of the gradient that it shows.
import { setGradientStops } from "../model/commands/index.js";
import { gradientOf, type Gradient, type Tint } from "../model/gradients.js";
import type { CurveItem, Drawing, PaintAttribute, Side } from "../model/types.js";
import { mixerOf } from "./color.js";
import { constant, mixNumbers, putColor, type Mix, type Put, type Stops } from "./stops.js";

export interface Tints {
  readonly list: Stops<Tint>;
  readonly put: Put<Tint>;
  readonly mix: Mix<Tint>;
  /** Whose stops they are; null: the side's own, which have no alpha. */
  readonly gradient: Gradient | null;
}

/** Mixes tints as gradients are drawn: in code values, alpha separately. */
const mixTints: Mix<Tint> = (a, b, t) => ({
  r: mixNumbers(a.r, b.r, t),
  g: mixNumbers(a.g, b.g, t),
  b: mixNumbers(a.b, b.b, t),
  alpha: mixNumbers(a.alpha, b.alpha, t),
});

export type GradientTints = Tints & { readonly gradient: Gradient };

function ofGradient(gradient: Gradient, href: string): GradientTints {
  return {
    list: { kind: "stops", space: "arc", stops: gradient.stops },
    put: (before, _, value) =>
      value.kind === "stops" ? setGradientStops(before, href, value.stops) : null,
    mix: mixTints,
    gradient,
  };
}

/** The stops of the gradient that a side shows as its colour or its opacity; null: it shows none. */
export function gradientTints(
  drawing: Drawing,
  item: CurveItem,
  side: Side,
  attribute: PaintAttribute,
): GradientTints | null {
  const value = item[side][attribute];
  const gradient = value.kind === "paint" ? gradientOf(drawing, value.href) : null;
  return gradient && ofGradient(gradient, `#${gradient.id}`);
}

/** null: the side is open, a barrier, or shows something else. */
export function tintsOf(drawing: Drawing, item: CurveItem, side: Side): Tints | null {
  const { color } = item[side];
  if (color.kind === "paint") return gradientTints(drawing, item, side, "color");
  if (color.kind !== "stops") return null;
  const mix = mixerOf(drawing.interpolation);
  const stops = color.stops.map(({ offset, value }) => ({ offset, value: { ...value, alpha: 1 } }));
  return {
    list: { ...color, stops },
    put: putColor(item.handle),
    mix: (a, b, t) => ({ ...mix(a, b, t), alpha: 1 }),
    gradient: null,
  };
}

/**
 * Returns a side's stops with another colour or alpha.
 * @param chosen indices of the stops that change; null: the whole side. Its own stops become a single one then; a
 *   gradient keeps its stops and their alpha.
 */
export function tinted(
  { list, gradient }: Tints,
  chosen: readonly number[] | null,
  change: Partial<Tint>,
): Stops<Tint> {
  if (!chosen && !gradient) return constant({ ...list.stops[0].value, ...change });
  const stops = list.stops.map((stop, k) =>
    !chosen || chosen.includes(k) ? { ...stop, value: { ...stop.value, ...change } } : stop,
  );
  return { ...list, stops };
}
