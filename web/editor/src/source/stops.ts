// Stop lists, as the format writes them: `gold, orange 30%, white`.
import type { Rgb } from "../geometry/color.js";
import { colorText, parseOpaque } from "./colors.js";
import { behindComponent, keywordOf, tokensOf, urlOf } from "./css.js";
import { LARGEST, parseLength, parseNumber } from "./lengths.js";

// Where stops stand: shares of the arc length, 0 to 1, or segments and their parameter ("@2.5" is
// 2.5, an arc is one segment; geometry/length.ts leads to pieces).
export type StopSpace = "arc" | "parameter";

export interface Stop<Value> {
  readonly offset: number;
  readonly value: Value;
}

/** The value of a side: nothing ("open"), "none" ("barrier"), a paint, or stops by their offsets. */
export type SideValue<Value> =
  | { readonly kind: "open" }
  | { readonly kind: "barrier" }
  | { readonly kind: "paint"; readonly href: string }
  | { readonly kind: "stops"; readonly space: StopSpace; readonly stops: readonly Stop<Value>[] };

/** How values of a list are read, compared and written. */
export interface Notation<Value> {
  parse(text: string): Value | null;
  isSame(a: Value, b: Value): boolean;
  write(value: Value): string;
}

function shortest(value: number): string {
  for (let digits = 1; digits < 10; digits += 1) {
    const number = Number(value.toPrecision(digits));
    if (Math.fround(number) === Math.fround(value)) return plain(number);
  }
  return plain(value);
}

/** In decimals without an exponent, and without a 0 before the point. */
function plain(value: number): string {
  const text = String(value).includes("e")
    ? value.toFixed(20).replace(/\.?0+$/, "")
    : String(value);
  return text.replace(/^(-?)0\./, "$1.");
}

export const COLORS: Notation<Rgb> = {
  parse: parseOpaque,
  isSame: (a, b) => a.r === b.r && a.g === b.g && a.b === b.b,
  write: colorText,
};

const isSameNumber = (a: number, b: number) => a === b;

/** Numbers from 0 to 1. */
export const SHARES: Notation<number> = {
  parse(text) {
    const number = parseNumber(text);
    return number !== null && number >= 0 && number <= 1 ? number : null;
  },
  isSame: isSameNumber,
  write: shortest,
};

/** Lengths of 0 or more. */
export const RADII: Notation<number> = {
  parse(text) {
    const length = parseLength(text, NaN);
    return length !== null && length >= 0 ? length : null;
  },
  isSame: isSameNumber,
  write: shortest,
};

/** A stop as written. */
interface Written<Value> {
  readonly value: Value;
  readonly valueText: string;
  /** Place in its unit: 1 is 100% or a segment. null: not written. */
  readonly offset: number | null;
  readonly unit: "percent" | "segment" | null;
  readonly offsetText: string;
}

/** Usual lists: without comments, escapes, strings and brackets within brackets. */
const USUAL = /^(?:[^\\/"'()[\]{}]|\([^\\/"'()[\]{}]*\))*$/;

/** The parts of each stop, parted by blanks and comments. */
function itemsOf(text: string): string[][] {
  if (!USUAL.test(text)) return itemsOfTokens(text);
  const items: string[][] = [[]];
  for (const part of text.match(/(?:[^\s,()]|\([^()]*\))+|,/g) ?? []) {
    if (part === ",") items.push([]);
    else items[items.length - 1].push(part);
  }
  return items;
}

function itemsOfTokens(text: string): string[][] {
  const tokens = tokensOf(text);
  const items: string[][] = [[]];
  let last = -1;
  for (let i = 0; i < tokens.length;) {
    const { kind, start } = tokens[i];
    const next = behindComponent(tokens, i);
    if (kind === ",") {
      items.push([]);
    } else if (kind !== "blank" && kind !== "comment") {
      const item = items[items.length - 1];
      const part = text.slice(start, tokens[next - 1].end);
      if (item.length > 0 && last === start) item[item.length - 1] += part;
      else item.push(part);
      last = tokens[next - 1].end;
    }
    i = next;
  }
  return items;
}

type Offset = Pick<Written<unknown>, "offset" | "unit">;

function parseOffset(text: string): Offset | null {
  const isSegment = text.startsWith("@");
  if (!isSegment && !text.endsWith("%")) return null;
  const number = parseNumber(isSegment ? text.slice(1) : text.slice(0, -1));
  if (number === null || number < 0) return null;
  if (isSegment) return number <= LARGEST ? { offset: number, unit: "segment" } : null;
  return number <= 100 ? { offset: number / 100, unit: "percent" } : null;
}

function parseWritten<Value>(text: string, { parse }: Notation<Value>): Written<Value>[] | null {
  const stops: Written<Value>[] = [];
  for (const [valueText, offsetText, ...more] of itemsOf(text)) {
    const value = valueText === undefined ? null : parse(valueText);
    const offset =
      offsetText === undefined ? { offset: null, unit: null } : parseOffset(offsetText);
    if (value === null || !offset || more.length > 0) return null;
    stops.push({ value, valueText, offsetText: offsetText ?? "", ...offset });
  }
  return stops;
}

/** CSS Images 3, section 3.4.3, on offsets from 0 to `end`. */
function spread(offsets: (number | null)[], end: number): number[] {
  const full = [...offsets];
  full[0] ??= 0;
  full[full.length - 1] ??= end;
  let last = 0;
  let largest = 0;
  for (let i = 0; i < full.length; i += 1) {
    const offset = full[i];
    if (offset === null) continue;
    largest = Math.max(largest, offset);
    full[i] = largest;
    const begin = full[last] as number;
    const step = (largest - begin) / Math.max(i - last, 1);
    for (let j = last + 1; j < i; j += 1) full[j] = Math.min(begin + step * (j - last), largest);
    last = i;
  }
  return full as number[];
}

function placed<Value>(written: readonly Written<Value>[], segments: number): SideValue<Value> {
  const inSegments = written.some(({ unit }) => unit === "segment");
  const end = inSegments ? segments : 1;
  const offsets = spread(
    written.map(({ offset, unit }) => {
      if (offset === null) return null;
      return Math.min(unit === "percent" ? offset * end : offset, end);
    }),
    end,
  );
  const stops = written.map(({ value }, i) => ({ offset: offsets[i], value }));
  return { kind: "stops", space: inSegments ? "parameter" : "arc", stops };
}

/**
 * Returns the value of a side's attribute. Absent means open, and so does an unreadable one: the engine
 * reports the reason.
 * @param segments of the subpath: lists with "@" end there
 */
export function readSide<Value>(
  text: string | undefined,
  notation: Notation<Value>,
  segments: number,
): SideValue<Value> {
  if (text === undefined) return { kind: "open" };
  const trimmed = text.trim();
  if (/^[nNuU\\/]/.test(trimmed)) {
    if (keywordOf(trimmed) === "none") return { kind: "barrier" };
    const href = urlOf(trimmed);
    if (href !== null) return { kind: "paint", href };
  }
  const written = parseWritten(trimmed, notation);
  return written ? placed(written, segments) : { kind: "open" };
}

function offsetText(offset: number, space: StopSpace): string {
  if (space === "parameter") return `@${shortest(offset)}`;
  return `${shortest(100 * offset)}%`;
}

/** An address as url() holds it. */
function urlText(href: string): string {
  return /^[^"'()\\\s]*$/.test(href) ? `url(${href})` : `url("${href.replace(/["\\]/g, "\\$&")}")`;
}

/**
 * The text of a side; null where it bears nothing. Values and offsets that stand in `before`, the
 * text so far, keep how they are written.
 */
export function sideText<Value>(
  side: SideValue<Value>,
  notation: Notation<Value>,
  before = "",
): string | null {
  if (side.kind === "open") return null;
  if (side.kind === "barrier") return "none";
  if (side.kind === "paint") return urlText(side.href);
  const known = parseWritten(before.trim(), notation) ?? [];
  const { stops, space } = side;
  const last = stops.length - 1;
  return stops
    .map(({ offset, value }, i) => {
      const old = known.find((stop) => notation.isSame(stop.value, value));
      const valueText = old?.valueText ?? notation.write(value);
      const isEnd = (i === 0 && offset === 0) || (i === last && offset === 1);
      if (last === 0 || (space === "arc" && isEnd)) return valueText;
      const unit = space === "arc" ? "percent" : "segment";
      const same = known.find((stop) => stop.unit === unit && stop.offset === offset);
      return `${valueText} ${same?.offsetText ?? offsetText(offset, space)}`;
    })
    .join(", ");
}
