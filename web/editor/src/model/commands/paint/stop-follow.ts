// Stop lists of a curve whose nodes or direction change.
import { mixed, type Rgb } from "../../../geometry/color.js";
import { segmentsOf, type CubicPath } from "../../../geometry/cubic.js";
import { parameterAtSegment, segmentAtParameter } from "../../../geometry/length.js";
import type { Edited } from "../../../geometry/nodes.js";
import { setAttribute, sf, valueOf } from "../../../source/attributes.js";
import type { Edit } from "../../../source/patch.js";
import {
  COLORS,
  RADII,
  readSide,
  SHARES,
  sideText,
  type Notation,
  type SideValue,
  type Stop,
} from "../../../source/stops.js";
import type { ElementNode } from "../../../source/tree.js";
import type { Drawing } from "../../types.js";

/** Between two values. */
export type Mix<Value> = (a: Value, b: Value, t: number) => Value;

/** An attribute of Sfumato's that is a stop list. */
export interface ListAttribute<Value> {
  readonly name: string;
  readonly notation: Notation<Value>;
  readonly mix: Mix<Value>;
}

/** Edits a list: returns the stops afterwards, or null if it stays as it is. */
export type ListEdit = <Value>(
  side: Extract<SideValue<Value>, { kind: "stops" }>,
  mix: Mix<Value>,
) => Extract<SideValue<Value>, { kind: "stops" }> | null;

const between: Mix<number> = (a, b, t) => a + (b - a) * t;

function edited<Value>(
  { name, notation, mix }: ListAttribute<Value>,
  element: ElementNode,
  segments: number,
  edit: ListEdit,
): string | null {
  const text = valueOf(element, sf(name));
  const side = readSide(text, notation, segments);
  const changed = side.kind === "stops" ? edit(side, mix) : null;
  return changed && sideText(changed, notation, text);
}

/** The texts that an edit gives to lists of an element, by the attribute's name. */
export function editedLists(
  drawing: Drawing,
  element: ElementNode,
  segments: number,
  edit: ListEdit,
): Map<string, string> {
  const colors: Mix<Rgb> = (a, b, t) => mixed(a, b, t, drawing.interpolation);
  const texts = new Map<string, string>();
  const run = <Value>(names: readonly string[], notation: Notation<Value>, mix: Mix<Value>) => {
    for (const name of names) {
      const text = edited({ name, notation, mix }, element, segments, edit);
      if (text !== null) texts.set(name, text);
    }
  };
  run(["left", "right"], COLORS, colors);
  run(["left-opacity", "right-opacity", "opacity"], SHARES, between);
  run(["left-blur", "right-blur", "blur", "radius"], RADII, between);
  return texts;
}

export function segmentCount(path: CubicPath): number {
  return segmentsOf(path).length - 1;
}

/** Stops with one more where a list passes a place, strictly between two of different offsets. */
function withStopAt<Value>(
  stops: readonly Stop<Value>[],
  offset: number,
  mix: Mix<Value>,
): Stop<Value>[] {
  const behind = stops.findIndex((stop) => stop.offset > offset);
  const [a, b] = [stops[behind - 1], stops[behind]];
  if (!a || !b || a.offset >= offset || JSON.stringify(a.value) === JSON.stringify(b.value))
    return [...stops];
  const value = mix(a.value, b.value, (offset - a.offset) / (b.offset - a.offset));
  return [...stops.slice(0, behind), { offset, value }, ...stops.slice(behind)];
}

/** Returns a list by arc length whose stops are at other shares; null: one value has no place. */
function sharedList<Value, Side extends Extract<SideValue<Value>, { kind: "stops" }>>(
  side: Side,
  shares: (share: number) => number,
): Side | null {
  if (side.stops.length < 2) return null;
  return { ...side, stops: side.stops.map((stop) => ({ ...stop, offset: shares(stop.offset) })) };
}

/**
 * Edits that let lists with "@" follow their places onto another path, so that the same colours
 * stay at the same places. Lists by arc length stay as they are, unless the path became longer.
 * @param after the path as it reads back, with its segments
 */
export function followedLists(
  drawing: Drawing,
  element: ElementNode,
  before: CubicPath,
  after: CubicPath,
  { follow, bends, shares }: Pick<Edited, "follow" | "bends" | "shares">,
): Edit[] {
  const count = segmentCount(before);
  const texts = editedLists(drawing, element, count, (side, mix) => {
    if (side.space === "arc") return shares ? sharedList(side, shares) : null;
    const places = side.stops.map((stop) => ({
      ...stop,
      offset: parameterAtSegment(before, stop.offset),
    }));
    const full = bends.reduce((stops, bend) => withStopAt(stops, bend, mix), places);
    const stops = full.map((stop) => ({
      ...stop,
      offset: segmentAtParameter(after, follow(stop.offset)),
    }));
    const isSame =
      segmentCount(after) === count &&
      stops.length === side.stops.length &&
      stops.every(({ offset }, i) => Math.abs(offset - side.stops[i].offset) < 1e-9);
    return isSame ? null : { ...side, stops };
  });
  return [...texts].flatMap(([name, text]) => setAttribute(drawing.text, element, sf(name), text));
}
