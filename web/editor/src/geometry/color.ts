// Colours: sRGB code values, linear light, OKLab, OKLCH and HSV. The matrices of OKLab, in which documents
// mix, equal those of the engine (src/base/color_space.cpp); culori has the later digits of CSS Color 4.
import {
  convertHsvToRgb,
  convertLchToLab,
  convertLrgbToRgb,
  convertRgbToHsv,
  convertRgbToLrgb,
} from "culori/fn";

/** contract: sRGB code values, each 0 to 1. */
export interface Rgb {
  readonly r: number;
  readonly g: number;
  readonly b: number;
}

/** L 0 to 1, a and b about ±0.4. */
export interface Oklab {
  readonly l: number;
  readonly a: number;
  readonly b: number;
}

/** L 0 to 1, chroma 0 to about 0.32, hue in degrees from 0 up to 360; 0 for a gray. */
export interface Oklch {
  readonly l: number;
  readonly c: number;
  readonly h: number;
}

/** Hue in degrees from 0 up to 360, saturation and value 0 to 1. */
export interface Hsv {
  readonly h: number;
  readonly s: number;
  readonly v: number;
}

/** Chroma below this is a gray, whose hue says nothing. */
const GRAY = 4e-6;

const clamped = (value: number) => Math.min(Math.max(value, 0), 1);
const turned = (degrees: number) => ((degrees % 360) + 360) % 360;
const mapRgb = (color: Rgb, f: (channel: number) => number): Rgb => ({
  r: f(color.r),
  g: f(color.g),
  b: f(color.b),
});

/**
 * Light, each channel 0 to 1. It is odd about 0, so colours outside of sRGB keep their place.
 */
export const linearFromRgb = (color: Rgb): Rgb => convertRgbToLrgb(color);
export const rgbFromLinear = (light: Rgb): Rgb => convertLrgbToRgb(light);

export function oklabFromRgb(color: Rgb): Oklab {
  const { r, g, b } = linearFromRgb(color);
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {
    l: 0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    a: 1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    b: 0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  };
}

/**
 * Outside of sRGB where the colour is. By the inverses of the matrices above, to the last digit.
 */
export function rgbFromOklab({ l: lightness, a, b }: Oklab): Rgb {
  const l =
    (0.9999999984505198 * lightness + 0.39633779217376786 * a + 0.2158037580607588 * b) ** 3;
  const m =
    (1.0000000088817609 * lightness - 0.10556134232365635 * a - 0.06385417477170591 * b) ** 3;
  const s =
    (1.0000000546724108 * lightness - 0.08948418209496575 * a - 1.2914855378640917 * b) ** 3;
  return rgbFromLinear({
    r: 4.076741661347994 * l - 3.3077115904081933 * m + 0.2309699287294279 * s,
    g: -1.268438004092176 * l + 2.6097574006633715 * m - 0.3413193963102196 * s,
    b: -0.004196086541837109 * l - 0.7034186144594496 * m + 1.7076147009309448 * s,
  });
}

export function oklchFromOklab({ l, a, b }: Oklab): Oklch {
  const c = Math.hypot(a, b);
  return { l, c, h: c < GRAY ? 0 : turned((Math.atan2(b, a) * 180) / Math.PI) };
}

export const oklabFromOklch = (color: Oklch): Oklab => convertLchToLab(color);

export const oklchFromRgb = (color: Rgb): Oklch => oklchFromOklab(oklabFromRgb(color));
/** The result may be outside of sRGB; inGamut() moves it inside. */
export const rgbFromOklch = (color: Oklch): Rgb => rgbFromOklab(oklabFromOklch(color));

/** The colour's distance from another in OKLab: 0.02 is just seen. */
export function deltaE(a: Rgb, b: Rgb): number {
  const [p, q] = [oklabFromRgb(a), oklabFromRgb(b)];
  return Math.hypot(p.l - q.l, p.a - q.a, p.b - q.b);
}

/** Returns whether all channels are from 0 to 1, with a tolerance for rounding. */
export function isInGamut({ r, g, b }: Rgb): boolean {
  return [r, g, b].every((channel) => channel >= -1e-4 && channel <= 1 + 1e-4);
}

export const clampedRgb = (color: Rgb): Rgb => mapRgb(color, clamped);

/** The largest chroma in sRGB of a lightness and a hue. */
export function largestChroma(l: number, h: number): number {
  if (!(l > 0 && l < 1)) return 0;
  let [inside, outside] = [0, 0.5];
  for (let i = 0; i < 30; ++i) {
    const c = (inside + outside) / 2;
    if (isInGamut(rgbFromOklch({ l, c, h }))) inside = c;
    else outside = c;
  }
  return inside;
}

/** The colour of sRGB with the same lightness and hue and as much of the chroma as there is. */
export function inGamut(color: Oklch): Rgb {
  const l = clamped(color.l);
  const rgb = rgbFromOklch({ ...color, l });
  if (isInGamut(rgb)) return clampedRgb(rgb);
  return clampedRgb(rgbFromOklch({ l, c: largestChroma(l, color.h), h: color.h }));
}

/** The difference in lightness between a colour and its partner. */
const PARTNER_STEP = 0.3;
const MIDDLE_LIGHTNESS = 0.62;

/** Returns a colour of the same hue for the other end of a gradient: darker than a light one, else lighter. */
export function partnerOf(color: Rgb): Rgb {
  const { l, c, h } = oklchFromRgb(color);
  const by = l > MIDDLE_LIGHTNESS ? -PARTNER_STEP : PARTNER_STEP;
  const { r, g, b } = inGamut({ l: l + by, c, h });
  const byte = (channel: number) => Math.round(255 * channel) / 255;
  return { r: byte(r), g: byte(g), b: byte(b) };
}

/** Returns HSV. A grey has hue 0, black has saturation 0. */
export function hsvFromRgb(color: Rgb): Hsv {
  const { h = 0, s, v } = convertRgbToHsv(color);
  return { h, s, v };
}

export const rgbFromHsv = (color: Hsv): Rgb => clampedRgb(convertHsvToRgb(color));

/** A colour space in which a document can interpolate between colours. */
export type MixSpace = "srgb" | "linear" | "oklab";

/** Returns a colour's three coordinates in a space. */
export function axesOf(color: Rgb, space: MixSpace): readonly number[] {
  if (space === "oklab") {
    const { l, a, b } = oklabFromRgb(color);
    return [l, a, b];
  }
  const { r, g, b } = space === "linear" ? linearFromRgb(color) : color;
  return [r, g, b];
}

/** The colour of coordinates in a space. It may be outside of sRGB. */
export function colorOfAxes([x, y, z]: readonly number[], space: MixSpace): Rgb {
  if (space === "oklab") return rgbFromOklab({ l: x, a: y, b: z });
  const color = { r: x, g: y, b: z };
  return space === "linear" ? rgbFromLinear(color) : color;
}

/** Between two colours, where the document mixes them. */
export function mixed(a: Rgb, b: Rgb, t: number, space: MixSpace): Rgb {
  const [p, q] = [axesOf(a, space), axesOf(b, space)];
  const mix = colorOfAxes(p.map((from, axis) => from + (q[axis] - from) * t), space);
  return space === "srgb" ? mix : clampedRgb(mix);
}
