// Colours as CSS Color 4 writes them; tests/color/colors.txt has what is read and what is not.
import {
  convertHslToRgb,
  convertHwbToRgb,
  convertLabToXyz50,
  convertLchToLab,
  convertOklabToLrgb,
} from "culori/fn";
import names from "../../../../src/formats/css/colors.json";
import { clampedRgb, type Oklab as Lab, type Rgb } from "../geometry/color.js";
import { LIGHT_FROM, lightFromXyz50, rgbFromLight, type Triple } from "../geometry/colorspaces.js";
import { solid, tokensOf, type Token } from "./css.js";

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

/** Components beyond this are clamped, as the engine does. */
const LARGEST = 1000;

const between = (value: number, least: number, most: number) =>
  Math.min(Math.max(value, least), most);
const clamped = (value: number) => between(value, 0, 1);

const COLOR_NAMES: ReadonlyMap<string, string> = new Map(Object.entries(names));

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
  const digits = COLOR_NAMES.get(name)?.slice(1);
  return digits === undefined ? null : fromHex(digits);
}

/** A number or that of a percentage; `none` is 0. NaN: neither, or too large. */
function amount({ kind, value }: Token): number {
  if (kind === "ident") return 0;
  const number = kind === "number" || kind === "percentage" ? Number(value) : NaN;
  return Number.isFinite(number) ? number : NaN;
}

/** Returns a number divided by `whole`, or a percentage, from 0 to 1. */
const share = (token: Token, whole: number) =>
  clamped(amount(token) / (token.kind === "percentage" ? 100 : whole));

/** A number or a percentage of `whole`, which may lie outside its range. */
const component = (token: Token, whole: number) =>
  between((token.kind === "percentage" ? whole / 100 : 1) * amount(token), -LARGEST, LARGEST);

const chroma = (token: Token, whole: number) => Math.max(component(token, whole), 0);

/** In degrees, 0 up to 360. */
function hue({ kind, value, unit }: Token): number {
  if (kind === "ident") return 0;
  const units = kind === "number" ? 360 : kind === "dimension" ? UNITS_OF_A_TURN[unit] : NaN;
  const fraction = (Number(value) / units) % 1;
  return 360 * (fraction < 0 ? fraction + 1 : fraction);
}

type Values = readonly [Token, Token, Token];

interface Arguments {
  readonly values: Values;
  readonly alpha: Token | null;
  /** The legacy syntax: no `none`, and one kind of numbers. */
  readonly hasCommas: boolean;
}

function argumentsOf(tokens: readonly Token[]): Arguments | null {
  const hasCommas = tokens[1]?.kind === ",";
  const step = hasCommas ? 2 : 1;
  const plain = 2 * step + 1;
  if (tokens.length !== plain && tokens.length !== plain + 2) return null;
  const values: Values = [tokens[0], tokens[step], tokens[2 * step]];
  const alpha = tokens[plain + 1] ?? null;
  const mark = tokens[plain]?.value ?? "";
  if (hasCommas && tokens[3].kind !== ",") return null;
  if (alpha && mark !== (hasCommas ? "," : "/")) return null;
  const isKeywordRight = (token: Token) =>
    token.kind !== "ident" || (!hasCommas && token.value.toLowerCase() === "none");
  if (![...values, ...(alpha ? [alpha] : [])].every(isKeywordRight)) return null;
  return { values, alpha, hasCommas };
}

interface ColorFunction {
  /** Returns the numbers in the units of `rgb`; NaN where a value is none. */
  readonly numbers: (values: Values) => Triple;
  readonly rgb: (numbers: Triple) => Rgb;
  /** The kinds of values that it takes with commas. */
  readonly legacy?: (kinds: readonly string[]) => boolean;
}

const fromLab = (lab: Lab) => rgbFromLight(lightFromXyz50(convertLabToXyz50(lab)));
const fromOklab = (lab: Lab) => rgbFromLight(convertOklabToLrgb(lab), lab);

const RGB: ColorFunction = {
  numbers: ([r, g, b]) => [share(r, 255), share(g, 255), share(b, 255)],
  rgb: ([r, g, b]) => ({ r, g, b }),
  legacy: ([r, g, b]) => r === g && r === b,
};
const HSL: ColorFunction = {
  numbers: ([h, s, l]) => [hue(h), share(s, 100), share(l, 100)],
  rgb: ([h, s, l]) => clampedRgb(convertHslToRgb({ h, s, l })),
  legacy: ([, s, l]) => s === "percentage" && l === "percentage",
};
const HWB: ColorFunction = {
  numbers: HSL.numbers,
  rgb: ([h, w, b]) => clampedRgb(convertHwbToRgb({ h, w, b })),
};
const LAB: ColorFunction = {
  numbers: ([l, a, b]) => [100 * share(l, 100), component(a, 125), component(b, 125)],
  rgb: ([l, a, b]) => fromLab({ l, a, b }),
};
const LCH: ColorFunction = {
  numbers: ([l, c, h]) => [100 * share(l, 100), chroma(c, 150), hue(h)],
  rgb: ([l, c, h]) => fromLab(convertLchToLab({ l, c, h })),
};
const OKLAB: ColorFunction = {
  numbers: ([l, a, b]) => [share(l, 1), component(a, 0.4), component(b, 0.4)],
  rgb: ([l, a, b]) => fromOklab({ l, a, b }),
};
const OKLCH: ColorFunction = {
  numbers: ([l, c, h]) => [share(l, 1), chroma(c, 0.4), hue(h)],
  rgb: ([l, c, h]) => fromOklab(convertLchToLab({ l, c, h })),
};
const FUNCTIONS: ReadonlyMap<string, ColorFunction> = new Map([
  ["rgb", RGB],
  ["rgba", RGB],
  ["hsl", HSL],
  ["hsla", HSL],
  ["hwb", HWB],
  ["lab", LAB],
  ["lch", LCH],
  ["oklab", OKLAB],
  ["oklch", OKLCH],
]);

/** color(), whose components follow the name of a space. */
function inSpace(name: string): ColorFunction | undefined {
  const lightFrom = LIGHT_FROM.get(name);
  if (!lightFrom) return undefined;
  return {
    numbers: ([a, b, c]) => [component(a, 1), component(b, 1), component(c, 1)],
    rgb: (numbers) => {
      const isPlain = name === "srgb" && numbers.every((x) => x >= 0 && x <= 1);
      return isPlain ? RGB.rgb(numbers) : rgbFromLight(lightFrom(numbers));
    },
  };
}

function fromFunction(name: string, tokens: readonly Token[]): Color | null {
  const closed = tokens.at(-1)?.kind === ")" ? tokens.slice(0, -1) : tokens;
  const isNamed = name === "color" && closed[0]?.kind === "ident";
  const color = isNamed ? inSpace(closed[0].value.toLowerCase()) : FUNCTIONS.get(name);
  const found = color && argumentsOf(isNamed ? closed.slice(1) : closed);
  if (!found) return null;
  const { values, alpha, hasCommas } = found;
  if (hasCommas && !color.legacy?.(values.map(({ kind }) => kind))) return null;
  const numbers = color.numbers(values);
  const opacity = alpha ? share(alpha, 1) : 1;
  return [...numbers, opacity].some(Number.isNaN) ? null : { rgb: color.rgb(numbers), alpha: opacity };
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

/** An opaque colour as someone types it into a field: hexadecimal digits also without their #. */
export function parseTyped(text: string): Rgb | null {
  const trimmed = text.trim();
  return parseOpaque(trimmed) ?? parseOpaque(`#${trimmed}`);
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
