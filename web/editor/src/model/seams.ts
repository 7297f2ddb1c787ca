// Keeps the values of closed curves free of seams: the stops of a side are a ring.
import type { Rgb } from "../geometry/color.js";
import { isOpen, segmentsOf } from "../geometry/cubic.js";
import type { CurveItem, SideValue, Stop, StopSpace } from "./types.js";

type Value = Rgb | number;
type Stops<V> = readonly Stop<V>[];

function isSame(a: Value, b: Value): boolean {
  if (typeof a === "number" || typeof b === "number") return a === b;
  return a.r === b.r && a.g === b.g && a.b === b.b;
}

const lastOf = <V>(stops: Stops<V>) => stops[stops.length - 1];

/** Returns whether the last value is the first one. */
export function meets<V extends Value>(stops: Stops<V>): boolean {
  return isSame(stops[0].value, lastOf(stops).value);
}

/** Returns whether all subpaths of a curve end where they begin. */
export function isRing({ paths }: CurveItem): boolean {
  return paths.length > 0 && !paths.some(isOpen);
}

/** Returns the offset of a curve's end. */
export function endOffset({ paths }: CurveItem, space: StopSpace): number {
  return space === "arc" ? 1 : Math.max(...paths.map((path) => segmentsOf(path).length - 1));
}

/** Returns whether the last stop only closes the ring: it stands at the end, with the first value. */
function isClosed<V extends Value>(stops: Stops<V>, end: number): boolean {
  return stops.length > 1 && lastOf(stops).offset >= end && meets(stops);
}

/** Returns how many stops of a side are shown, and edited: all but the one that closes a ring. */
export function shownStops<V extends Value>(
  curve: CurveItem,
  { space, stops }: { readonly space: StopSpace; readonly stops: Stops<V> },
): number {
  return isRing(curve) && isClosed(stops, endOffset(curve, space)) ? stops.length - 1 : stops.length;
}

/** Adds the first value at the end. Stops that are already there move halfway to the one before them. */
export function closedBy<V extends Value>(stops: Stops<V>, end: number): Stops<V> {
  const before = stops.filter(({ offset }) => offset < end);
  const middle = ((before.length > 0 ? lastOf(before).offset : 0) + end) / 2;
  const moved = stops.map((stop) => (stop.offset < end ? stop : { ...stop, offset: middle }));
  return [...moved, { offset: end, value: stops[0].value }];
}

/**
 * Returns a side's new values. On a closed curve they meet if they met before: the last value runs back to the first,
 * whose value a stop at the end has, too. It closes the ring, and goes with the first stop.
 */
export function ringed<V extends Value>(curve: CurveItem, before: SideValue<V>, after: SideValue<V>): SideValue<V> {
  if (after.kind !== "stops" || !isRing(curve) || meets(after.stops)) return after;
  const isClosedBefore = before.kind === "stops" && isClosed(before.stops, endOffset(curve, before.space));
  if (before.kind === "stops" && !meets(before.stops)) return after;
  const end = endOffset(curve, after.space);
  const stops = isClosedBefore
    ? closedAgain(before.stops, after.stops, end)
    : closed(after.stops, end, before.kind !== "stops");
  return { ...after, stops };
}

/** @param isNew whether the side had no stops: the value at the end is then about the first one */
function closed<V extends Value>(stops: Stops<V>, end: number, isNew: boolean): Stops<V> {
  if (meets(stops)) return stops;
  const others = isNew && lastOf(stops).offset >= end ? stops.slice(0, -1) : stops;
  return [...others, { offset: end, value: stops[0].value }];
}

/** The ring had a stop that closed it: it closes the ring again. */
function closedAgain<V extends Value>(before: Stops<V>, after: Stops<V>, end: number): Stops<V> {
  const last = lastOf(after);
  if (last.offset < end) return closed(after, end, false);
  const rest = after.slice(0, -1);
  // A stop that was added at the end stands before the one that closes the ring.
  if (isClosed(rest, end)) return [...rest.slice(0, -1), last, lastOf(rest)];
  if (!isSame(last.value, lastOf(before).value)) return [{ ...after[0], value: last.value }, ...after.slice(1)];
  return rest.length === 1 ? rest : [...rest, { ...last, value: after[0].value }];
}
