// The attributes of a curve that was joined from two.
import { segmentsOf, type CubicPath } from "../../../geometry/cubic.js";
import { fractionAtParameter, parameterAtSegment } from "../../../geometry/length.js";
import { setAttribute, sf, SFUMATO, valueOf } from "../../../source/attributes.js";
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
import type { CurveItem, Side } from "../../types.js";

/** A curve as a part of the joined one. */
export interface Half {
  readonly element: ElementNode;
  /** As its stops count it. */
  readonly own: CubicPath;
  /** In the joined curve's coordinates. */
  readonly length: number;
  readonly isReversed: boolean;
  /** Whether what it calls left is right in the joined curve. */
  readonly isSwapped: boolean;
  /** Factor of radii. */
  readonly scale: number;
}

/** First and last, in the direction of the joined curve. */
export type Halves = readonly [Half, Half];

const other = (side: Side): Side => (side === "left" ? "right" : "left");

/** Returns the value of a half's first attribute among these. */
function borne<Value>(
  half: Half,
  notation: Notation<Value>,
  names: readonly string[],
): SideValue<Value> {
  const text = names.map((name) => valueOf(half.element, sf(name))).find((it) => it !== undefined);
  return readSide(text, notation, segmentsOf(half.own).length - 1);
}

/** Stops by arc length of the half, 0 to 1, walked as the joined curve is. */
function stopsOf<Value>({ own, isReversed }: Half, side: SideValue<Value>): Stop<Value>[] | null {
  if (side.kind !== "stops") return null;
  const stops = side.stops.map(({ offset, value }) => {
    const share =
      side.space === "arc" ? offset : fractionAtParameter(own, parameterAtSegment(own, offset));
    return { offset: isReversed ? 1 - share : share, value };
  });
  return isReversed ? stops.reverse() : stops;
}

/** The stops of a half where it lies, constant up to its ends where these are not the curve's. */
function laid<Value>(stops: readonly Stop<Value>[], from: number, to: number): Stop<Value>[] {
  const list = stops.map(({ offset, value }) => ({ offset: from + (to - from) * offset, value }));
  if (from > 0 && stops[0].offset > 0) list.unshift({ offset: from, value: stops[0].value });
  const last = stops[stops.length - 1];
  if (to < 1 && last.offset < 1) list.push({ offset: to, value: last.value });
  return list;
}

/**
 * Returns the values of both halves, one after the other. If a value cannot apply to a part of a curve, the
 * first half's value counts, if it has one.
 * @param absent the value of a half without any
 */
function together<Value>(
  [first, last]: Halves,
  bridge: number,
  bear: (half: Half) => SideValue<Value>,
  absent?: Value,
): SideValue<Value> {
  const none: SideValue<Value> = { kind: "open" };
  const zero: SideValue<Value> =
    absent === undefined
      ? none
      : { kind: "stops", space: "arc", stops: [{ offset: 0, value: absent }] };
  const [borneByFirst, borneByLast] = [bear(first), bear(last)];
  const isBare = borneByFirst.kind === "open" && borneByLast.kind === "open";
  const [a, b] = [borneByFirst, borneByLast].map((side) =>
    side.kind === "open" && !isBare ? zero : side,
  );
  const [before, behind] = [stopsOf(first, a), stopsOf(last, b)];
  if (!before || !behind) return a.kind === "open" ? b : a;
  const whole = first.length + bridge + last.length;
  const isSame = (p: Stop<Value>, q: Stop<Value>) =>
    JSON.stringify(p.value) === JSON.stringify(q.value);
  const stops = [
    ...laid(before, 0, first.length / whole),
    ...laid(behind, (first.length + bridge) / whole, 1),
  ].filter(
    (stop, i, all) => i === 0 || stop.offset !== all[i - 1].offset || !isSame(stop, all[i - 1]),
  );
  const isOne = stops.every((stop) => isSame(stop, stops[0]));
  return { kind: "stops", space: "arc", stops: isOne ? stops.slice(0, 1) : stops };
}

const scaledBy = (side: SideValue<number>, scale: number): SideValue<number> =>
  side.kind === "stops" && scale !== 1
    ? { ...side, stops: side.stops.map((stop) => ({ ...stop, value: stop.value * scale })) }
    : side;

/**
 * The edits that let `element` bear what both halves bore. @param bridge length of a line between
 * them
 */
export function joinedAttributes(
  text: string,
  element: ElementNode,
  kind: CurveItem["kind"],
  halves: Halves,
  bridge: number,
): Edit[] {
  const isStroke = kind === "stroke";
  const own = (half: Half, side: Side): Side => (half.isSwapped ? other(side) : side);
  const set = (name: string, value: string | null) => setAttribute(text, element, sf(name), value);
  // Values that either half names keep their words.
  const known = halves.flatMap((half) =>
    half.element.attributes.filter(({ namespace }) => namespace === SFUMATO),
  );
  const written = <Value>(
    side: SideValue<Value>,
    notation: Notation<Value>,
    ...names: string[]
  ) => {
    const texts = known.filter(({ local }) => names.includes(local)).map(({ value }) => value);
    return sideText(side, notation, texts.join(", "));
  };
  const color = (side: Side): string | null => {
    const names = (half: Half) =>
      isStroke ? [own(half, side), other(own(half, side))] : [own(half, side)];
    return written(
      together(halves, bridge, (half) => borne(half, COLORS, names(half))),
      COLORS,
      "left",
      "right",
    );
  };
  const numbers = (name: "opacity" | "blur", notation: Notation<number>): Edit[] => {
    const [left, right] = (["left", "right"] as const).map((side) => {
      const bear = (half: Half) =>
        scaledBy(
          borne(half, notation, [`${own(half, side)}-${name}`, name]),
          name === "blur" ? half.scale : 1,
        );
      const value = together(halves, bridge, bear, name === "blur" ? 0 : undefined);
      return written(value, notation, `left-${name}`, `right-${name}`, name);
    });
    const isOne = left === right;
    return [
      ...set(`left-${name}`, isOne ? null : left),
      ...set(`right-${name}`, isOne ? null : right),
      ...set(name, isOne ? left : null),
    ];
  };
  const radius = together(halves, bridge, (half) =>
    scaledBy(borne(half, RADII, ["radius"]), half.scale),
  );
  const [left, right] = [color("left"), color("right")];
  const needsBoth = !isStroke || left !== right;
  return [
    ...set("left", left),
    ...set("right", needsBoth ? right : null),
    ...numbers("opacity", SHARES),
    ...numbers("blur", RADII),
    ...set("radius", written(radius, RADII, "radius")),
  ];
}
