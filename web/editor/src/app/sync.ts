// Describes changes for the engine: points and stops of single curves as numbers, all else as text.
import { determinant, lengthScale, mapped } from "../geometry/affine.js";
import { parameterAtSegment } from "../geometry/length.js";
import type { EngineCurve, QuickChange } from "../engine/types.js";
import type { Change, CurveItem, Drawing, Handle, Side, SideValue } from "../model/types.js";

/** Attributes that define the geometry of a shape. */
const SHAPE = new Set(["d", "x", "y", "width", "height", "rx", "ry", "cx", "cy", "r", "points", "x1", "y1", "x2", "y2"]);
/** Attributes that hold stops, with the sides and values that they set. */
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

/** Returns the engine's curves of an element, as in the last text that the engine has read. */
export type CurvesOf = (handle: Handle) => readonly EngineCurve[];

/** Returns the change as numbers, or undefined if the engine needs the text. */
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
  // Both lists are in the order of the text. Copies within the layer have their own transforms.
  const isPlain = known.length === item.paths.length && known.length > 0;
  // A transform that mirrors exchanges the sides.
  if (!isPlain || determinant(item.layerFromItem) <= 0) return null;
  const all: QuickChange[] = [];
  for (const name of names) {
    for (const [i, { layer, curve }] of known.entries()) {
      if (SHAPE.has(name)) {
        all.push({ kind: "points", layer, curve, xy: pointsOf(item, i) });
      } else if (name in STOPS) {
        for (const [side, attribute] of STOPS[name]) {
          const stops = stopsOf(item, side, attribute, { layer, curve, path: i });
          if (!stops) return null;
          all.push(stops);
        }
      } else if (name !== "stroke" && name !== "fill") {
        return null;
      }
    }
  }
  return all;
}

function pointsOf(item: CurveItem, path: number): Float64Array {
  return Float64Array.from(
    item.paths[path].points.flatMap((point) => mapped(item.layerFromItem, point)),
  );
}

function stopsOf(
  item: CurveItem,
  side: Side,
  attribute: "color" | "opacity" | "blur",
  { layer, curve, path }: { readonly layer: number; readonly curve: number; readonly path: number },
): QuickChange | null {
  const value: SideValue<unknown> = item[side][attribute];
  if (value.kind !== "stops") return null;
  const scale = attribute === "blur" ? lengthScale(item.layerFromItem) : 1;
  const isArc = value.space === "arc";
  const offset = (of: number) => (isArc ? of : parameterAtSegment(item.paths[path], of));
  return {
    kind: "stops",
    layer,
    curve,
    side: SIDES[side],
    attribute: ATTRIBUTES[attribute],
    space: isArc ? 0 : 1,
    rows: value.stops.map((stop) => [offset(stop.offset), ...numbersOf(stop.value, scale)]),
  };
}

function numbersOf(value: unknown, scale: number): number[] {
  if (typeof value === "number") return [scale * value];
  const { r, g, b } = value as { r: number; g: number; b: number };
  return [r, g, b];
}
