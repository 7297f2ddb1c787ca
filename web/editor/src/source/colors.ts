// Colours as CSS Color 4 writes them.
import type { Rgb } from "../geometry/color.js";
import { rgbFromHsl, rgbFromHwb } from "../geometry/color.js";
import { COLOR_NAMES } from "../geometry/colornames.js";
import { solid, tokensOf } from "./css.js";
import type { Token } from "./css.js";

export interface Color {
  readonly rgb: Rgb;
  readonly alpha: number;
}

const UNITS_OF_A_TURN: Readonly<Record<string, number>> = {
  deg: 360,
  grad: 400,
  rad: 2 * Math.PI,
  turn: 1,
};

function clamped(value: number): number {
  return Math.min(Math.max(value, 0), 1);
}

function fromBytes(rgb: number): Rgb {
  return { r: (rgb >> 16) / 255, g: ((rgb >> 8) & 255) / 255, b: (rgb & 255) / 255 };
}

function fromHex(digits: string): Color | null {
  if (!/^(?:[0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})$/i.test(digits)) return null;
  const each = digits.length < 6 ? 1 : 2;
  const channel = (i: number) => {
    const written = digits.slice(i * each, (i + 1) * each);
    return written === "" ? 1 : parseInt(each === 1 ? written + written : written, 16) / 255;
  };
  return { rgb: { r: channel(0), g: channel(1), b: channel(2) }, alpha: channel(3) };
}

function fromName(name: string): Color | null {
  if (name === "transparent") return { rgb: { r: 0, g: 0, b: 0 }, alpha: 0 };
  const bytes = COLOR_NAMES.get(name);
  return bytes === undefined ? null : { rgb: fromBytes(bytes), alpha: 1 };
}

/** A number, `whole` of which is 1, a percentage, or none. */
function share({ kind, value }: Token, whole: number): number {
  if (kind === "ident") return 0;
  if (kind === "number") return clamped(Number(value) / whole);
  return kind === "percentage" ? clamped(Number(value) / 100) : NaN;
}

/** In degrees, 0 up to 360. */
function hue({ kind, value, unit }: Token): number {
  if (kind === "ident") return 0;
  const units = kind === "number" ? 360 : kind === "dimension" ? UNITS_OF_A_TURN[unit] : NaN;
  const fraction = (Number(value) / units) % 1;
  return 360 * (fraction < 0 ? fraction + 1 : fraction);
}

interface Arguments {
  readonly values: readonly Token[];
  readonly alpha: Token | null;
  /** As CSS had it first: no `none`, and one kind of numbers. */
  readonly hasCommas: boolean;
}

function argumentsOf(tokens: readonly Token[]): Arguments | null {
  const hasCommas = tokens[1]?.kind === ",";
  const step = hasCommas ? 2 : 1;
  const plain = 2 * step + 1;
  if (tokens.length !== plain && tokens.length !== plain + 2) return null;
  const values = [0, 1, 2].map((i) => tokens[i * step]);
  const alpha = tokens[plain + 1] ?? null;
  const mark = tokens[plain]?.value ?? "";
  if (hasCommas && tokens[3].kind !== ",") return null;
  if (alpha && mark !== (hasCommas ? "," : "/")) return null;
  const isKeywordRight = (token: Token) =>
    token.kind !== "ident" || (!hasCommas && token.value.toLowerCase() === "none");
  if (![...values, ...(alpha ? [alpha] : [])].every(isKeywordRight)) return null;
  return { values, alpha, hasCommas };
}

function components(name: string, { values, hasCommas }: Arguments): Rgb | null {
  const [first, second, third] = values;
  if (name === "rgb" || name === "rgba") {
    if (hasCommas && values.some(({ kind }) => kind !== first.kind)) return null;
    return { r: share(first, 255), g: share(second, 255), b: share(third, 255) };
  }
  const arePercentages = second.kind === "percentage" && third.kind === "percentage";
  if (hasCommas && !arePercentages) return null;
  const numbers = [hue(first), share(second, 100), share(third, 100)] as const;
  if (name === "hsl" || name === "hsla") return rgbFromHsl(...numbers);
  return name === "hwb" && !hasCommas ? rgbFromHwb(...numbers) : null;
}

function fromFunction(name: string, tokens: readonly Token[]): Color | null {
  const closed = tokens.at(-1)?.kind === ")" ? tokens.slice(0, -1) : tokens;
  const found = argumentsOf(closed);
  const rgb = found && components(name, found);
  if (!rgb || Number.isNaN(rgb.r + rgb.g + rgb.b)) return null;
  const alpha = found.alpha ? share(found.alpha, 1) : 1;
  return Number.isNaN(alpha) ? null : { rgb, alpha };
}

/** null where the text is no colour; currentColor is none. */
export function parseColor(text: string): Color | null {
  if (text.startsWith("#")) {
    const color = fromHex(text.slice(1));
    if (color) return color;
  }
  const [first, ...rest] = solid(tokensOf(text));
  if (first?.kind === "function") return fromFunction(first.value.toLowerCase(), rest);
  if (!first || rest.length > 0) return null;
  if (first.kind === "hash") return fromHex(first.value);
  return first.kind === "ident" ? fromName(first.value.toLowerCase()) : null;
}

/** An opaque colour, or null. */
export function parseOpaque(text: string): Rgb | null {
  const color = parseColor(text);
  return color && color.alpha >= 1 ? color.rgb : null;
}

/** The fewest decimals of a percentage that a single-precision reader takes for the same. */
function percentage(value: number): string {
  for (let decimals = 0; decimals < 10; decimals += 1) {
    const text = (100 * value).toFixed(decimals);
    if (Math.fround(Number(text) / 100) === Math.fround(value)) {
      return `${text.includes(".") ? text.replace(/\.?0+$/, "") : text}%`;
    }
  }
  return `${100 * value}%`;
}

/** #rgb or #rrggbb where that is the colour, else rgb() in percentages. */
export function colorText({ r, g, b }: Rgb): string {
  const channels = [r, g, b].map(clamped);
  const bytes = channels.map((channel) => Math.round(255 * channel));
  const isExact = channels.every((c, i) => Math.fround(c) === Math.fround(bytes[i] / 255));
  if (!isExact) return `rgb(${channels.map(percentage).join(" ")})`;
  const pairs = bytes.map((byte) => byte.toString(16).padStart(2, "0"));
  const isShort = pairs.every(([high, low]) => high === low);
  return `#${pairs.map((pair) => (isShort ? pair[0] : pair)).join("")}`;
}
