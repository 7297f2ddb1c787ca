// A stop that is chosen on the canvas or in a panel, as a command.
import { setBoth, setColor, setGradientStops, setNumbers, setRadius, together } from "../model/commands/index.js";
import { gradientOf } from "../model/gradients.js";
import { shownStops } from "../model/seams.js";
import type { Rgb } from "../geometry/color.js";
import type { CurveItem, Drawing, Outcome, Part, Side, SideValue } from "../model/types.js";

type StopPart = Part & { kind: "stop" };

/** Returns a side without some of its stops. Without any that is shown, the side is open. */
export function withoutStops<Value extends Rgb | number>(
  curve: CurveItem,
  value: SideValue<Value>,
  indices: readonly number[],
): SideValue<Value> | null {
  const gone = new Set(indices);
  if (value.kind !== "stops" || indices.some((index) => index >= value.stops.length)) return null;
  if (gone.size >= shownStops(curve, value)) return { kind: "open" };
  return { ...value, stops: value.stops.filter((_, i) => !gone.has(i)) };
}

/** Deletes a stop of a gradient; a gradient keeps at least one. */
function withoutGradientStop(drawing: Drawing, href: string, index: number): Outcome | null {
  const stops = gradientOf(drawing, href)?.stops ?? [];
  if (index >= stops.length) return null;
  return setGradientStops(drawing, href, stops.filter((_, i) => i !== index));
}

/** Takes a stop away; the last one leaves its side open. */
export function deleteStop(drawing: Drawing, curve: CurveItem, part: StopPart): Outcome | null {
  const { handle } = curve;
  const { side, attribute, index } = part;
  if (attribute === "radius") {
    const radius = withoutStops(curve, curve.radius, [index]);
    return radius && radius.kind === "stops" ? setRadius(drawing, handle, radius) : null;
  }
  const now = curve[side][attribute];
  if (now.kind === "paint") return withoutGradientStop(drawing, now.href, index);
  if (attribute === "color") {
    const color = withoutStops(curve, curve[side].color, [index]);
    return color && setColor(drawing, handle, side, color);
  }
  const numbers = withoutStops(curve, curve[side][attribute], [index]);
  if (!numbers) return null;
  const isShared = JSON.stringify(curve.left[attribute]) === JSON.stringify(curve.right[attribute]);
  return isShared && attribute === "blur"
    ? setBoth(drawing, handle, attribute, numbers)
    : setNumbers(drawing, handle, side, attribute, numbers);
}

/** Returns the sides of a curve that have several colours, or only the side of the selected stop. */
function manyColored(curve: CurveItem, stop: StopPart | null): readonly Side[] {
  const sides: readonly Side[] = stop ? [stop.side] : ["left", "right"];
  return sides.filter((side) => {
    const { color } = curve[side];
    return color.kind === "stops" && color.stops.length > 1;
  });
}

/** Gives each side one colour: that of the selected stop, or of its first stop. Returns null if none has several. */
export function oneColor(
  drawing: Drawing,
  curves: readonly CurveItem[],
  stop: StopPart | null,
): Outcome | null {
  const outcomes = curves.flatMap((curve) =>
    manyColored(curve, stop).map((side) => {
      const { color } = curve[side];
      if (color.kind !== "stops") return null;
      const { value } = color.stops[stop?.index ?? 0] ?? color.stops[0];
      return setColor(drawing, curve.handle, side, { kind: "stops", space: "arc", stops: [{ offset: 0, value }] });
    }),
  );
  return together(outcomes);
}
