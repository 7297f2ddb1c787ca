// Attributes of curves: colours, opacities, blur, radii.
import type { Rgb } from "../../geometry/color.js";
import { attributeOf, setAttribute, sf, SFUMATO, valueOf } from "../../source/attributes.js";
import type { Edit } from "../../source/patch.js";
import { COLORS, RADII, readSide, SHARES, sideText } from "../../source/stops.js";
import type { Notation } from "../../source/stops.js";
import { ringed } from "../seams.js";
import type { CurveItem, Drawing, Handle, Outcome, Side, SideValue } from "../types.js";
import { finestStep } from "./mapping.js";
import { outcomeOf, together } from "./structure/together.js";

function curveOf(d: Drawing, handle: Handle): CurveItem | null {
  const item = d.item(handle);
  return item?.kind === "curve" || item?.kind === "stroke" ? item : null;
}

function otherSide(side: Side): Side {
  return side === "left" ? "right" : "left";
}

function rounded(value: number, unit: number): number {
  return Number((Math.round(value / unit) * unit).toFixed(5));
}

/** A pointer is less exact than numbers: new offsets get few decimals. */
function tidied<Value>(
  side: SideValue<Value>,
  before: SideValue<Value>,
  tidy: (value: Value) => Value,
  isSame: (a: Value, b: Value) => boolean,
): SideValue<Value> {
  if (side.kind !== "stops") return side;
  const known = before.kind === "stops" ? before.stops : [];
  const unit = side.space === "arc" ? 1e-5 : 1e-4;
  const stops = side.stops.map(({ offset, value }) => ({
    offset: known.some((stop) => stop.offset === offset) ? offset : rounded(offset, unit),
    value: known.some((stop) => isSame(stop.value, value)) ? value : tidy(value),
  }));
  return { ...side, stops };
}

function tidyNumber(value: number): number {
  return Number(value.toPrecision(6));
}

/** Writes a side into one attribute; open takes it away. No edit makes a seam in a closed curve. */
function write<Value extends Rgb | number>(
  d: Drawing,
  item: CurveItem,
  name: string,
  to: SideValue<Value>,
  before: SideValue<Value>,
  notation: Notation<Value>,
  tidy: (value: Value) => Value,
): Edit[] {
  const { element } = item;
  const side = tidied(ringed(item, before, to), before, tidy, notation.isSame);
  // Another attribute may have said it so far: its notation is kept.
  const [, own = ""] = /^(?:left|right)-(\w+)$/.exec(name) ?? [];
  const text = valueOf(element, sf(name)) ?? valueOf(element, sf(own));
  return setAttribute(d.text, element, sf(name), sideText(side, notation, text));
}

/** The colour of one side; the other one stays as it is seen. */
export function setColor(d: Drawing, h: Handle, side: Side, to: SideValue<Rgb>): Outcome | null {
  const item = curveOf(d, h);
  if (!item) return null;
  const before = item[side].color;
  const edits = write(d, item, side, to, before, COLORS, (color) => color);
  const other = otherSide(side);
  const shared = valueOf(item.element, sf(side));
  const isShared = shared !== undefined && !attributeOf(item.element, sf(other));
  // A local curve has one side that serves both.
  if (item.kind === "stroke" && isShared && to.kind !== "open" && edits.length > 0) {
    edits.push(...setAttribute(d.text, item.element, sf(other), shared));
  }
  return outcomeOf(edits);
}

const NOTATIONS = { opacity: SHARES, blur: RADII } as const;

/** Opacities or radii of blur of one side; the other one stays. A local curve has them for both. */
export function setNumbers(
  d: Drawing,
  h: Handle,
  side: Side,
  attribute: "opacity" | "blur",
  to: SideValue<number>,
): Outcome | null {
  const item = curveOf(d, h);
  if (!item) return null;
  if (item.kind === "stroke") return attribute === "blur" ? setBoth(d, h, attribute, to) : null;
  const own = `${side}-${attribute}`;
  const edits = write(d, item, own, to, item[side][attribute], NOTATIONS[attribute], tidyNumber);
  const shared = valueOf(item.element, sf(attribute));
  if (to.kind === "open" && shared !== undefined) {
    const other = `${otherSide(side)}-${attribute}`;
    edits.push(...setAttribute(d.text, item.element, sf(attribute), null));
    if (!attributeOf(item.element, sf(other))) {
      edits.push(...setAttribute(d.text, item.element, sf(other), shared));
    }
  }
  return outcomeOf(edits);
}

/**
 * Opacity of one side. Where the curve took no part in opacity the other side becomes opaque, as it
 * was: nothing would be seen there else.
 */
export function setSideOpacity(d: Drawing, h: Handle, side: Side, to: SideValue<number>): Outcome | null {
  const made = setNumbers(d, h, side, "opacity", to);
  const item = curveOf(d, h);
  const other = otherSide(side);
  const isFirst = item?.kind === "curve" && [side, other].every((one) => item[one].opacity.kind === "open");
  if (!made || !isFirst || to.kind === "open") return made;
  return together([made, outcomeOf(setAttribute(d.text, item.element, sf(`${other}-opacity`), "1"))]);
}

/** The same on both sides, by one attribute. */
export function setBoth(
  d: Drawing,
  h: Handle,
  attribute: "opacity" | "blur",
  to: SideValue<number>,
): Outcome | null {
  const item = curveOf(d, h);
  if (!item || (item.kind === "stroke" && attribute === "opacity")) return null;
  const before = item.left[attribute];
  const edits = write(d, item, attribute, to, before, NOTATIONS[attribute], tidyNumber);
  for (const side of ["left", "right"] as const) {
    edits.push(...setAttribute(d.text, item.element, sf(`${side}-${attribute}`), null));
  }
  return outcomeOf(edits);
}

/** Radii of influence of a local curve; it has some: with none the drawing could not be read. */
export function setRadius(d: Drawing, h: Handle, to: SideValue<number>): Outcome | null {
  const item = curveOf(d, h);
  if (item?.kind !== "stroke" || to.kind !== "stops") return null;
  const least = 100 * finestStep(d);
  const isSomewhere = to.stops.some(({ value }) => value >= least);
  const held = isSomewhere ? to : { ...to, stops: to.stops.map((stop) => ({ ...stop, value: least })) };
  return outcomeOf(write(d, item, "radius", held, item.radius, RADII, tidyNumber));
}

/** sf:alpha of local curves, sf:weight of diffusion curves; null takes it away. */
export function setNumber(
  d: Drawing,
  handles: readonly Handle[],
  name: "alpha" | "weight",
  to: number | null,
): Outcome | null {
  const kind = name === "alpha" ? "stroke" : "curve";
  const text = to === null ? null : SHARES.write(tidyNumber(to));
  const edits = handles.flatMap((handle) => {
    const item = curveOf(d, handle);
    return item?.kind === kind ? setAttribute(d.text, item.element, sf(name), text) : [];
  });
  return outcomeOf(edits);
}

/** Exchanges the names of the attributes: what they say keeps how it is written. */
export function swapSides(d: Drawing, handles: readonly Handle[]): Outcome | null {
  const edits: Edit[] = [];
  for (const handle of new Set(handles)) {
    for (const { name, local, namespace, range } of curveOf(d, handle)?.element.attributes ?? []) {
      const [, side] = /^(left|right)(?:-|$)/.exec(local) ?? [];
      if (namespace !== SFUMATO || side === undefined) continue;
      const at = range.start + name.length - local.length;
      edits.push({ at, removed: side, inserted: otherSide(side as Side) });
    }
  }
  return outcomeOf(edits);
}

/** Whether two colours are the same to the eye: their nearest bytes. */
function isSameColor(a: Rgb, b: Rgb): boolean {
  const byte = (channel: number) => Math.round(255 * channel);
  return byte(a.r) === byte(b.r) && byte(a.g) === byte(b.g) && byte(a.b) === byte(b.b);
}

/** Exchanges one colour for another everywhere in these curves. */
export function recolor(
  d: Drawing,
  handles: readonly Handle[],
  from: Rgb,
  to: Rgb,
): Outcome | null {
  const edits: Edit[] = [];
  for (const handle of new Set(handles)) {
    const item = curveOf(d, handle);
    for (const name of item ? ["left", "right"] : []) {
      const { element } = item as CurveItem;
      const text = valueOf(element, sf(name));
      const [segments] = (item as CurveItem).paths.map(({ points }) => (points.length - 1) / 3);
      const side = readSide(text, COLORS, segments ?? 1);
      if (side.kind !== "stops") continue;
      const stops = side.stops.map(({ offset, value }) => ({
        offset,
        value: isSameColor(value, from) ? to : value,
      }));
      if (stops.every(({ value }, i) => value === side.stops[i].value)) continue;
      const written = sideText({ ...side, stops }, COLORS, text);
      edits.push(...setAttribute(d.text, element, sf(name), written));
    }
  }
  return outcomeOf(edits);
}
