// Stops on the two sides of a curve: where they stand, and lists with one of them changed.
import { mixed, type Rgb } from "../geometry/color.js";
import type {
  Attribute,
  CurveItem,
  Drawing,
  Side,
  SideValue,
  Stop,
  StopSpace,
} from "../model/types.js";

export type StopKind = Attribute | "radius";
export type Value = Rgb | number;

export interface Stops<V> {
  readonly space: StopSpace;
  readonly stops: readonly Stop<V>[];
}

export const SIDES: readonly Side[] = ["left", "right"];

/** Returns the kind of stops shown on the curve for an attribute: a local curve shows radii instead of blur. */
export function kindOn(item: CurveItem, attribute: Attribute): StopKind | null {
  if (item.kind === "curve") return attribute;
  return attribute === "blur" ? "radius" : attribute === "color" ? "color" : null;
}

export function sideValue(item: CurveItem, side: Side, kind: StopKind): SideValue<Value> {
  if (kind === "radius") return item.radius;
  return item[side][kind];
}

/** The stops of a side, or null where it has none. */
export function stopsOf(item: CurveItem, side: Side, kind: StopKind): Stops<Value> | null {
  const value = sideValue(item, side, kind);
  return value.kind === "stops" && value.stops.length > 0 ? value : null;
}

/**
 * A list with a stop elsewhere, between its neighbours: stops never pass each other.
 * @param end the offset of a closed curve's end: beyond it the curve goes on at its start, where the stop waits
 */
export function withOffset<V>(list: Stops<V>, index: number, offset: number, end: number | null): SideValue<V> {
  const low = list.stops[index - 1]?.offset ?? 0;
  const high = list.stops[index + 1]?.offset ?? end ?? Infinity;
  const held = (to: number) => Math.min(high, Math.max(low, to));
  const ways = end === null ? [offset] : [offset, offset - end, offset + end];
  const way = ways.reduce((a, b) => (Math.abs(b - held(b)) < Math.abs(a - held(a)) ? b : a));
  const stops = list.stops.map((stop, k) => (k === index ? { ...stop, offset: held(way) } : stop));
  return { kind: "stops", space: list.space, stops };
}

export function withValue<V>(list: Stops<V>, index: number, value: V): SideValue<V> {
  const stops = list.stops.map((stop, k) => (k === index ? { ...stop, value } : stop));
  return { kind: "stops", space: list.space, stops };
}

/** A list with a stop more, and which it is. */
export function withStop<V>(
  list: Stops<V>,
  offset: number,
  value: V,
): { value: SideValue<V>; index: number } {
  const after = list.stops.findIndex((stop) => stop.offset > offset);
  const index = after < 0 ? list.stops.length : after;
  const stops = [...list.stops.slice(0, index), { offset, value }, ...list.stops.slice(index)];
  return { value: { kind: "stops", space: list.space, stops }, index };
}

/** The value at an offset: linear between stops, constant beyond the ends. */
export function valueAt<V>(
  { stops }: Stops<V>,
  offset: number,
  mix: (a: V, b: V, share: number) => V,
): V {
  const after = stops.findIndex((stop) => stop.offset > offset);
  if (after < 0) return stops[stops.length - 1].value;
  if (after === 0) return stops[0].value;
  const [a, b] = [stops[after - 1], stops[after]];
  return mix(a.value, b.value, (offset - a.offset) / (b.offset - a.offset));
}

/** Mixes two values of one kind as the document does. */
export function mixer(
  space: Drawing["interpolation"],
): (a: Value, b: Value, share: number) => Value {
  return (a, b, share) =>
    typeof a === "number" || typeof b === "number"
      ? Number(a) + (Number(b) - Number(a)) * share
      : mixed(a, b, share, space);
}
