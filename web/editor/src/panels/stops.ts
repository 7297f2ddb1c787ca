// Stop lists as the panels edit them: by their share of the curve's length.
import type { CubicPath } from "../geometry/cubic.js";
import {
  fractionAtParameter,
  offsetOfPlace,
  parameterAtFraction,
  placeOfOffset,
} from "../geometry/length.js";
import { setColor, setSideOpacity } from "../model/commands/index.js";
import type { Rgb } from "../geometry/color.js";
import { ringed, shownStops } from "../model/seams.js";
import type {
  CurveItem,
  Drawing,
  Outcome,
  Side,
  SideValue,
  Stop,
  StopSpace,
} from "../model/types.js";

/** A side's value where it has stops. */
export type Stops<Value> = Extract<SideValue<Value>, { kind: "stops" }>;

export type Mix<Value> = (a: Value, b: Value, t: number) => Value;

export const mixNumbers: Mix<number> = (a, b, t) => a + (b - a) * t;

/** The curve's offsets count in its first subpath, as they do for the engine; null: it has none. */
const pathOf = (item: CurveItem): CubicPath | null => item.paths[0] ?? null;

/** The share of the length at which a stop stands, 0 to 1. */
export function fractionOf(item: CurveItem, space: StopSpace, offset: number): number {
  const path = pathOf(item);
  if (space === "arc" || !path) return Math.min(Math.max(offset, 0), 1);
  return fractionAtParameter(path, placeOfOffset(path, space, offset));
}

/** Rounds a share of the length to the thousandth: finer than a pointer or an eye. */
export const rounded = (fraction: number) =>
  Math.round(Math.min(Math.max(fraction, 0), 1) * 1000) / 1000;

/** The offset of a stop at a share of the length, in the list's own space. */
export function offsetAt(item: CurveItem, space: StopSpace, fraction: number): number {
  const path = pathOf(item);
  const inside = Math.min(Math.max(fraction, 0), 1);
  if (space === "arc" || !path) return inside;
  return offsetOfPlace(path, space, parameterAtFraction(path, inside));
}

/** Linear between stops, constant beyond the ends; of a hard step, the side behind it. */
export function valueAt<Value>(
  stops: readonly Stop<Value>[],
  offset: number,
  mix: Mix<Value>,
): Value {
  const next = stops.findIndex((stop) => stop.offset > offset);
  if (next === 0) return stops[0].value;
  if (next < 0) return stops[stops.length - 1].value;
  const [a, b] = [stops[next - 1], stops[next]];
  return mix(a.value, b.value, (offset - a.offset) / (b.offset - a.offset));
}

export interface Placed<Value> {
  readonly value: Stops<Value>;
  /** Where the stop now is in the list. */
  readonly index: number;
}

const inserted = <Value>(stops: readonly Stop<Value>[], at: number, stop: Stop<Value>) => [
  ...stops.slice(0, at),
  stop,
  ...stops.slice(at),
];

/** With one more stop. Behind others at the same offset. */
export function withStop<Value>(list: Stops<Value>, stop: Stop<Value>): Placed<Value> {
  const later = list.stops.findIndex(({ offset }) => offset > stop.offset);
  const index = later < 0 ? list.stops.length : later;
  return { value: { ...list, stops: inserted(list.stops, index, stop) }, index };
}

export function withoutStop<Value>(list: Stops<Value>, index: number): Stops<Value> {
  return { ...list, stops: list.stops.filter((_, k) => k !== index) };
}

/** The stop at another offset; it goes over others that it passes. */
export function movedStop<Value>(list: Stops<Value>, index: number, offset: number): Placed<Value> {
  const stop = { ...list.stops[index], offset };
  const rest = withoutStop(list, index);
  // Onto another from behind: it stays behind; from before: it stays before.
  const place = rest.stops.findIndex((other, k) =>
    k < index ? other.offset > offset : other.offset >= offset,
  );
  const to = place < 0 ? rest.stops.length : place;
  return { value: { ...list, stops: inserted(rest.stops, to, stop) }, index: to };
}

/**
 * Returns a side's list as the drawing takes it: on a closed curve a stop may have to close the ring. A stop that only
 * closes it is the first one.
 */
export function settled<Value extends Rgb | number>(
  item: CurveItem,
  before: Stops<Value>,
  placed: Placed<Value>,
): Placed<Value> {
  const value = ringed(item, before, placed.value);
  if (value.kind !== "stops") return placed;
  const moved = value.stops.indexOf(placed.value.stops[placed.index]);
  const index = moved < 0 ? placed.index : moved;
  return { value, index: index < shownStops(item, value) ? index : 0 };
}

export function withValue<Value>(list: Stops<Value>, index: number, value: Value): Stops<Value> {
  return { ...list, stops: list.stops.map((stop, k) => (k === index ? { ...stop, value } : stop)) };
}

/** Returns stops at equal distances from the curve's start to its end; on a closed curve, around the ring. */
export function distributed<Value>(item: CurveItem, list: Stops<Value>): Stops<Value> {
  const last = Math.max(list.stops.length - 1, 1);
  const stops = list.stops.map((stop, k) => ({
    ...stop,
    offset: offsetAt(item, list.space, Number((k / last).toFixed(4))),
  }));
  return { ...list, stops };
}

/** Returns stops in the other order, at places that are counted from the other end. */
export function backwards<Value>(item: CurveItem, list: Stops<Value>): Stops<Value> {
  const stops = list.stops.map((stop) => ({
    ...stop,
    offset: offsetAt(item, list.space, Number((1 - fractionOf(item, list.space, stop.offset)).toFixed(5))),
  }));
  return { ...list, stops: stops.reverse() };
}

/** One value all along. */
export const constant = <Value>(value: Value): Stops<Value> => ({
  kind: "stops",
  space: "arc",
  stops: [{ offset: 0, value }],
});

/** Returns the curve of a handle in a drawing. */
export function curveOf(drawing: Drawing, handle: number): CurveItem | null {
  const item = drawing.item(handle);
  return item?.kind === "curve" || item?.kind === "stroke" ? item : null;
}

/** Writes a side's stops. */
export type Put<Value> = (before: Drawing, side: Side, value: SideValue<Value>) => Outcome | null;

export const putColor =
  (handle: number): Put<Rgb> =>
  (before, side, value) =>
    setColor(before, handle, side, value);

export const putOpacity =
  (handle: number): Put<number> =>
  (before, side, value) =>
    setSideOpacity(before, handle, side, value);
