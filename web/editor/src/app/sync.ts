// Tells the engine what changed: points and stops of single curves by themselves, all else as text.
import { applied } from "../geometry/affine.js";
import type { EngineCurve, QuickChange } from "../engine/types.js";
import type { Change, CurveItem, Drawing, Handle, Side, SideValue } from "../model/types.js";

/** Attributes that say where a shape is. */
const SHAPE = new Set(["d", "x", "y", "width", "height", "rx", "ry", "cx", "cy", "r", "points", "x1", "y1", "x2", "y2"]);
/** Those of stops, with the engine's numbers of side and attribute. */
const STOPS: Readonly<Record<string, readonly (readonly [Side, "color" | "opacity" | "blur"])[]>> = {
  left: [["left", "color"]],
  right: [["right", "color"]],
  "left-opacity": [["left", "opacity"]],
  "right-opacity": [["right", "opacity"]],
  opacity: [["left", "opacity"], ["right", "opacity"]],
  "left-blur": [["left", "blur"]],
  "right-blur": [["right", "blur"]],
  blur: [["left", "blur"], ["right", "blur"]],
};
const SIDES = { left: 0, right: 1 } as const;
const ATTRIBUTES = { color: 0, opacity: 1, blur: 2 } as const;

/** The engine's curves of an element, as the last text it read had them. */
export type CurvesOf = (handle: Handle) => readonly EngineCurve[];

/** The change in numbers, or undefined where it takes the text. */
export function quickChanges(
  drawing: Drawing,
  change: Change,
  curvesOf: CurvesOf,
): QuickChange[] | undefined {
  if (change.isStructural) return undefined;
  const all: QuickChange[] = [];
  for (const [handle, names] of change.touched) {
    const item = drawing.item(handle);
    if (item?.kind !== "curve") return undefined;
    const quick = ofCurve(item, names, curvesOf(handle));
    if (!quick) return undefined;
    all.push(...quick);
  }
  return all;
}

function ofCurve(
  item: CurveItem,
  names: ReadonlySet<string>,
  known: readonly EngineCurve[],
): QuickChange[] | null {
  // Copies within its layer have transforms of their own.
  const isPlain = known.length === item.paths.length && known.length > 0;
  const isMirrored = item.layerFromItem[0] * item.layerFromItem[3] < item.layerFromItem[1] * item.layerFromItem[2];
  if (!isPlain || isMirrored) return null;
  const all: QuickChange[] = [];
  for (const name of names) {
    for (const { layer, curve, subpath } of known) {
      if (SHAPE.has(name)) {
        all.push({ kind: "points", layer, curve, xy: pointsOf(item, subpath) });
      } else if (name in STOPS) {
        const stops = STOPS[name].map(([side, attribute]) => stopsOf(item, side, attribute, layer, curve));
        if (stops.includes(null)) return null;
        all.push(...(stops as QuickChange[]));
      } else if (name !== "stroke" && name !== "fill") {
        return null;
      }
    }
  }
  return all;
}

function pointsOf(item: CurveItem, subpath: number): Float64Array {
  return Float64Array.from(
    item.paths[subpath].points.flatMap(([x, y]) => applied(item.layerFromItem, [x, y])),
  );
}

function stopsOf(
  item: CurveItem,
  side: Side,
  attribute: "color" | "opacity" | "blur",
  layer: number,
  curve: number,
): QuickChange | null {
  const value: SideValue<unknown> = item[side][attribute];
  if (value.kind !== "stops") return null;
  const [a, b, c, d] = item.layerFromItem;
  const scale = attribute === "blur" ? Math.sqrt(Math.abs(a * d - b * c)) : 1;
  return {
    kind: "stops",
    layer,
    curve,
    side: SIDES[side],
    attribute: ATTRIBUTES[attribute],
    space: value.space === "arc" ? 0 : 1,
    rows: value.stops.map((stop) => [stop.offset, ...numbersOf(stop.value, scale)]),
  };
}

function numbersOf(value: unknown, scale: number): number[] {
  if (typeof value === "number") return [scale * value];
  const { r, g, b } = value as { r: number; g: number; b: number };
  return [r, g, b];
}
