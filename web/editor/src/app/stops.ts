// A stop that is chosen on the canvas or in a panel, as a command.
import { setBoth, setColor, setGradientStops, setNumbers, setRadius } from "../model/commands/index.js";
import { gradientOf } from "../model/gradients.js";
import type { CurveItem, Drawing, Outcome, Part, SideValue } from "../model/types.js";

type StopPart = Part & { kind: "stop" };

function without<Value>(value: SideValue<Value>, index: number): SideValue<Value> | null {
  if (value.kind !== "stops" || index >= value.stops.length) return null;
  const stops = value.stops.filter((_, i) => i !== index);
  return stops.length > 0 ? { ...value, stops } : { kind: "open" };
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
    const radius = without(curve.radius, index);
    return radius && radius.kind === "stops" ? setRadius(drawing, handle, radius) : null;
  }
  const now = curve[side][attribute];
  if (now.kind === "paint") return withoutGradientStop(drawing, now.href, index);
  if (attribute === "color") {
    const color = without(curve[side].color, index);
    return color && setColor(drawing, handle, side, color);
  }
  const numbers = without(curve[side][attribute], index);
  if (!numbers) return null;
  const isShared = JSON.stringify(curve.left[attribute]) === JSON.stringify(curve.right[attribute]);
  return isShared && attribute === "blur"
    ? setBoth(drawing, handle, attribute, numbers)
    : setNumbers(drawing, handle, side, attribute, numbers);
}
