// Keeps the colours of closed curves free of seams.
import type { Rgb } from "../geometry/color.js";
import { isOpen, segmentsOf } from "../geometry/cubic.js";
import type { CurveItem, SideValue, Stop, StopSpace } from "./types.js";

type Colors = readonly Stop<Rgb>[];

const isSame = (a: Rgb, b: Rgb) => a.r === b.r && a.g === b.g && a.b === b.b;
const lastOf = (stops: Colors) => stops[stops.length - 1];

/** Returns whether the last colour is the first one. */
export function meets(stops: Colors): boolean {
  return isSame(stops[0].value, lastOf(stops).value);
}

/** Returns the offset of a curve's end. */
export function endOffset({ paths }: CurveItem, space: StopSpace): number {
  return space === "arc" ? 1 : Math.max(...paths.map((path) => segmentsOf(path).length - 1));
}

/** Adds the first colour at the end. It replaces a stop that is already there. */
export function closedBy(stops: Colors, end: number): Colors {
  const others = lastOf(stops).offset < end ? stops : stops.slice(0, -1);
  return [...others, { offset: end, value: stops[0].value }];
}

/**
 * Returns a side's new colours. On a closed curve they meet if they met before: the stops at its start
 * and its end have one colour and are deleted together; without a stop at the end, the last colour runs
 * back to the first.
 */
export function ringed(curve: CurveItem, before: SideValue<Rgb>, after: SideValue<Rgb>): SideValue<Rgb> {
  if (before.kind !== "stops" || after.kind !== "stops") return after;
  if (curve.paths.length === 0 || curve.paths.some(isOpen)) return after;
  if (!meets(before.stops) || meets(after.stops)) return after;
  return { ...after, stops: joined(before.stops, after.stops, endOffset(curve, after.space)) };
}

const isPaired = (stops: Colors, end: number) => stops[0].offset <= 0 && lastOf(stops).offset >= end;

function joined(before: Colors, after: Colors, end: number): Colors {
  if (isPaired(after, end)) return recolored(before, after);
  const isDeleted = isPaired(before, end) && after.length < before.length;
  const left = isDeleted ? withoutPair(after, end) : after;
  // A stop at the end that never had a partner stays as it is.
  return meets(left) || lastOf(left).offset >= end ? left : closedBy(left, end);
}

/** The stop of the pair that got another colour gives it to the other one. */
function recolored(before: Colors, after: Colors): Colors {
  const [first, last] = [after[0].value, lastOf(after).value];
  const value = isSame(last, lastOf(before).value) ? first : last;
  return after.map((stop, k) => (k === 0 || k === after.length - 1 ? { ...stop, value } : stop));
}

function withoutPair(stops: Colors, end: number): Colors {
  if (lastOf(stops).offset >= end) return stops.slice(0, -1);
  return stops[0].offset <= 0 ? stops.slice(1) : stops;
}
