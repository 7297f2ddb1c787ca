// The look of a curve, copied onto others.
import type { Rgb } from "../../geometry/color.js";
import { lengthScale } from "../../geometry/affine.js";
import { mappedPath } from "../../geometry/cubic.js";
import { fractionAtParameter, parameterAtSegment } from "../../geometry/length.js";
import { setAttribute, sf, valueOf } from "../../source/attributes.js";
import type { Edit } from "../../source/patch.js";
import { COLORS, RADII, SHARES, sideText, type Notation } from "../../source/stops.js";
import type { CurveItem, Drawing, Handle, Outcome, Side, SideValue, SideValues } from "../types.js";
import { curveOf } from "./curves/shape-edit.js";
import { outcomeOf } from "./structure/together.js";

/** Colours, opacities, blur and weight of a curve. Offsets count by arc length, radii in artboard units. */
export interface Style {
  readonly left: SideValues;
  readonly right: SideValues;
  readonly weight: string | null;
  /** The colours as the source writes them. */
  readonly words: string;
}

/** Returns a side with its stops by arc length, and its numbers times a factor. */
function byArc<Value>(
  item: CurveItem,
  side: SideValue<Value>,
  scaled = (value: Value) => value,
): SideValue<Value> {
  if (side.kind !== "stops") return side;
  const path = item.paths[0];
  const share = (offset: number) => {
    const at = parameterAtSegment(path, offset);
    return fractionAtParameter(mappedPath(item.layerFromItem, path), at);
  };
  const isArc = side.space === "arc" || !path;
  const stops = side.stops.map(({ offset, value }) => ({
    offset: isArc ? offset : share(offset),
    value: scaled(value),
  }));
  return { kind: "stops", space: "arc", stops };
}

/** Returns the look of a curve or a local stroke. null: the handle is none. */
export function styleOf(d: Drawing, h: Handle): Style | null {
  const item = curveOf(d, h);
  if (!item) return null;
  const scale = lengthScale(item.artboardFromItem);
  const values = ({ color, opacity, blur }: SideValues): SideValues => ({
    color: byArc(item, color),
    opacity: byArc(item, opacity),
    blur: byArc(item, blur, (radius) => radius * scale),
  });
  return {
    left: values(item.left),
    right: values(item.right),
    weight: valueOf(item.element, sf("weight")) ?? null,
    words: (["left", "right"] as const)
      .flatMap((side) => (item[side].color.kind === "stops" ? valueOf(item.element, sf(side))! : []))
      .join(", "),
  };
}

/** Returns a value without a paint that this drawing lacks. */
function known<Value>(d: Drawing, side: SideValue<Value>): SideValue<Value> {
  const isLost = side.kind === "paint" && !d.ids.has(side.href.replace(/^#/, ""));
  return isLost ? { kind: "open" } : side;
}

/** The edits that give an element one value for both sides, or one for each. */
function setSides(
  d: Drawing,
  { element }: CurveItem,
  name: "opacity" | "blur",
  notation: Notation<number>,
  values: Readonly<Record<Side, SideValue<number>>>,
): Edit[] {
  const [left, right] = (["left", "right"] as const).map((side) =>
    sideText(known(d, values[side]), notation),
  );
  const isOne = left === right;
  const set = (attribute: string, text: string | null) =>
    setAttribute(d.text, element, sf(attribute), text);
  return [
    ...set(name, isOne ? left : null),
    ...set(`left-${name}`, isOne ? null : left),
    ...set(`right-${name}`, isOne ? null : right),
  ];
}

function styled(d: Drawing, item: CurveItem, { left, right, weight, words }: Style): Edit[] {
  const { element } = item;
  const isStroke = item.kind === "stroke";
  const scale = 1 / lengthScale(item.artboardFromItem);
  const radii = ({ blur }: SideValues) =>
    byArc(item, blur, (radius) => Number((radius * scale).toPrecision(6)));
  const blur = { left: radii(left), right: radii(isStroke ? left : right) };
  const color = (side: Side, value: SideValue<Rgb>) =>
    setAttribute(d.text, element, sf(side), sideText(known(d, value), COLORS, words));
  const isBare = [left, right].every((side) => known(d, side.color).kind === "open");
  const edits = [...setSides(d, item, "blur", RADII, blur)];
  // A local stroke without a colour could not be read.
  if (!isStroke || !isBare) edits.push(...color("left", left.color), ...color("right", right.color));
  if (isStroke) return edits;
  const opacity = { left: left.opacity, right: right.opacity };
  return [
    ...edits,
    ...setSides(d, item, "opacity", SHARES, opacity),
    ...setAttribute(d.text, element, sf("weight"), weight),
  ];
}

/**
 * Gives curves the look of another one. Gradients and textures that this drawing lacks are left out;
 * a local stroke takes colours and the blur of the left side.
 */
export function pasteStyle(d: Drawing, handles: readonly Handle[], style: Style): Outcome | null {
  const items = [...new Set(handles)].flatMap((handle) => curveOf(d, handle) ?? []);
  return outcomeOf(items.flatMap((item) => styled(d, item, style)));
}
