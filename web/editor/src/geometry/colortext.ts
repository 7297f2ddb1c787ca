// Colours as text: what people type and files say.
import { clampedRgb, inGamut, rgbFromHsl, rgbFromHwb, type Rgb } from "./color.js";
import { COLOR_NAMES } from "./colornames.js";

const byteOf = (channel: number) => Math.round(Math.min(Math.max(channel, 0), 1) * 255);

/** "#rrggbb", each channel rounded to a byte. */
export function hexOf({ r, g, b }: Rgb): string {
  return "#" + [r, g, b].map((channel) => byteOf(channel).toString(16).padStart(2, "0")).join("");
}

function fromHex(digits: string): Rgb | null {
  if (!/^(?:[0-9a-f]{3}|[0-9a-f]{6})$/.test(digits)) return null;
  const wide = digits.length === 3 ? digits.replace(/./g, "$&$&") : digits;
  const channel = (i: number) => parseInt(wide.slice(2 * i, 2 * i + 2), 16) / 255;
  return { r: channel(0), g: channel(1), b: channel(2) };
}

function fromName(name: string): Rgb | null {
  const bytes = COLOR_NAMES.get(name);
  return bytes === undefined ? null : fromHex(bytes.toString(16).padStart(6, "0"));
}

const NUMBER = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)(%|deg|grad|rad|turn)?$/;

/** A number and its unit; "none" is 0. */
function numberOf(text: string): { value: number; unit: string } | null {
  if (text === "none") return { value: 0, unit: "" };
  const [, value, unit] = NUMBER.exec(text) ?? [];
  return value !== undefined && Number.isFinite(Number(value))
    ? { value: Number(value), unit: unit ?? "" }
    : null;
}

/** A number, `whole` of which is 1, or a percentage of 1. */
function share(text: string, whole: number): number | null {
  const number = numberOf(text);
  if (!number || !["", "%"].includes(number.unit)) return null;
  return number.value / (number.unit === "%" ? 100 : whole);
}

function degrees(text: string): number | null {
  const number = numberOf(text);
  const factor = { "": 1, deg: 1, grad: 0.9, rad: 180 / Math.PI, turn: 360 }[number?.unit ?? "%"];
  return number && factor !== undefined ? number.value * factor : null;
}

const clamp = (value: number) => Math.min(Math.max(value, 0), 1);

type Arguments = readonly [string, string, string];

function fromRgb(texts: Arguments): Rgb | null {
  const [r, g, b] = texts.map((text) => share(text, 255));
  return r === null || g === null || b === null ? null : clampedRgb({ r, g, b });
}

function fromHsl([hue, saturation, lightness]: Arguments): Rgb | null {
  const [h, s, l] = [degrees(hue), share(saturation, 100), share(lightness, 100)];
  return h === null || s === null || l === null ? null : rgbFromHsl(h, clamp(s), clamp(l));
}

function fromHwb([hue, whiteness, blackness]: Arguments): Rgb | null {
  const [h, w, k] = [degrees(hue), share(whiteness, 100), share(blackness, 100)];
  if (h === null || w === null || k === null) return null;
  return rgbFromHwb(h, clamp(w), clamp(k));
}

/** Of CSS Color 4: a percentage of chroma is one of 0.4. */
function fromOklch([lightness, chroma, hue]: Arguments): Rgb | null {
  const [l, c, h] = [share(lightness, 1), numberOf(chroma), degrees(hue)];
  if (l === null || !c || !["", "%"].includes(c.unit) || h === null) return null;
  return inGamut({ l: clamp(l), c: Math.max(0, c.unit === "%" ? c.value * 0.004 : c.value), h });
}

const FUNCTIONS: Readonly<Record<string, (texts: Arguments) => Rgb | null>> = {
  rgb: fromRgb,
  rgba: fromRgb,
  hsl: fromHsl,
  hsla: fromHsl,
  hwb: fromHwb,
  oklch: fromOklch,
};

/** The three arguments of a function, with commas or blanks; an alpha of 1 may follow. */
function argumentsOf(text: string): Arguments | null {
  const [colors, alpha, ...more] = text.split("/").map((part) => part.trim());
  const texts = colors.split(/\s*,\s*|\s+/);
  const opacity = alpha ?? (texts.length === 4 && text.includes(",") ? texts.pop() : undefined);
  if (more.length > 0 || texts.length !== 3) return null;
  if (opacity !== undefined && share(opacity, 1) !== 1) return null;
  return [texts[0], texts[1], texts[2]];
}

/**
 * An opaque colour as CSS writes it: #rgb and #rrggbb, also without the #, names, rgb(), hsl(),
 * hwb(), oklch(), in any case. null: it is none, or it is not opaque.
 */
export function parseColor(text: string): Rgb | null {
  const trimmed = text.trim().toLowerCase();
  if (trimmed.startsWith("#")) return fromHex(trimmed.slice(1));
  const [, name, inner] = /^([a-z]+)\(\s*([^()]*?)\s*\)$/.exec(trimmed) ?? [];
  if (name === undefined) return fromName(trimmed) ?? fromHex(trimmed);
  const read = Object.hasOwn(FUNCTIONS, name) ? FUNCTIONS[name] : null;
  const texts = argumentsOf(inner);
  return read && texts ? read(texts) : null;
}
