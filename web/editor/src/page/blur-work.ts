// Radii of blur before and after they are fitted to a photo.
import type { PlacedPhoto } from "../canvas/photo.js";
import { sampledSides } from "../canvas/sampled.js";
import { composed, IDENTITY, inverted, lengthScale } from "../geometry/affine.js";
import { pieceCount } from "../geometry/cubic.js";
import { parameterAtSegment } from "../geometry/length.js";
import type { SideStops } from "../engine/types.js";
import type { Radii } from "../model/commands/index.js";
import type { CurveItem, Drawing, SideValue } from "../model/types.js";

const SIDES = ["left", "right"] as const;
/** Distance of samples, photo pixels. */
const SPACING = 2;
const DISTANCE = 3;
const TOLERANCE = 0.02;
/** Below this radius a curve is sharp, photo pixels, as in `sfumato trace`. */
const SHARP = 0.8;

/** The radii that a fit begins with, by where the element stands; null: the curve is sharp and stays it. */
export type Beginnings = ReadonlyMap<number, Radii | null>;

const isSomewhere = (value: SideValue<number>) =>
  value.kind === "stops" && value.stops.some((stop) => stop.value > 0);

/** Returns a curve's blur, or an estimate from the photo's transitions along it; null: they are sharp. */
export function beginningsOf(drawing: Drawing, item: CurveItem, photo: PlacedPhoto): Radii | null {
  const { left, right } = item;
  if (isSomewhere(left.blur) || isSomewhere(right.blur)) return { left: left.blur, right: right.blur };
  const back = inverted(photo.artboardFromPixel);
  const [path] = item.paths;
  if (!back || !path || pieceCount(path) === 0) return null;
  const layerFromItem = inverted(item.layerFromItem) ?? IDENTITY;
  const perUnit = lengthScale(composed(composed(back, item.artboardFromItem), layerFromItem));
  const wish = {
    range: [0, pieceCount(path)] as const,
    spacing: SPACING / perUnit,
    distance: DISTANCE,
    tolerance: TOLERANCE,
    blurs: true,
  };
  const { blur } = sampledSides(photo, item, 0, wish);
  return blur && drawing.item(item.handle) && isSomewhere(blur.left) ? blur : null;
}

/** As the engine takes them, of curves that have none themselves. */
export function rowsOf(item: CurveItem, begun: Radii | null): SideStops[] {
  if (!begun || begun.left === item.left.blur) return [];
  const scale = lengthScale(item.layerFromItem);
  return SIDES.flatMap((side, k): SideStops[] => {
    const value = begun[side];
    if (value.kind !== "stops") return [];
    const isArc = value.space === "arc";
    const offset = (of: number) => (isArc ? of : parameterAtSegment(item.paths[0], of));
    const rows = value.stops.map((stop) => [offset(stop.offset), scale * stop.value]);
    return [{ offset: item.element.range.start, side: k as 0 | 1, space: isArc ? 0 : 1, rows }];
  });
}

const digits = (value: number) => Number(value.toPrecision(3));

/**
 * Returns the radii after a fit. null: they are too small to differ from none.
 * @param perUnit photo pixels to a unit of the item
 */
export function fittedRadii(begun: Radii, factor: number, perUnit: number): Radii | null {
  const times = (value: SideValue<number>): SideValue<number> =>
    value.kind === "stops"
      ? { ...value, stops: value.stops.map((stop) => ({ ...stop, value: digits(factor * stop.value) })) }
      : value;
  const [left, right] = [times(begun.left), times(begun.right)];
  const all = [left, right].flatMap((value) => (value.kind === "stops" ? value.stops.map((stop) => stop.value) : []));
  return Math.max(0, ...all) * perUnit < SHARP ? null : { left, right };
}
