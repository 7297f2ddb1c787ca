// The spaces of CSS Color 4 beyond sRGB, and the mapping of their colours into sRGB. src/color/ is the
// same in C++; tests/color/colors.txt holds both to the same values. The mapping of culori has others.
import {
  convertA98ToXyz65,
  convertLrgbToOklab,
  convertLrgbToRgb,
  convertOklabToLrgb,
  convertP3ToXyz65,
  convertProphotoToXyz50,
  convertRgbToLrgb,
  convertXyz65ToRgb,
} from "culori/fn";
import { clampedRgb, rgbFromLinear, type Oklab, type Rgb } from "./color.js";

export type Triple = readonly [number, number, number];
type Xyz = { readonly x: number; readonly y: number; readonly z: number };

const rgbOf = ([r, g, b]: Triple): Rgb => ({ r, g, b });
const xyzOf = ([x, y, z]: Triple): Xyz => ({ x, y, z });
const lightFromXyz = (xyz: Xyz): Rgb => convertRgbToLrgb(convertXyz65ToRgb(xyz));

/** Returns light of sRGB from XYZ under D50, with the digits of CSS Color 4; culori has older ones. */
export function lightFromXyz50({ x, y, z }: Xyz): Rgb {
  return lightFromXyz({
    x: 0.955473421488075 * x - 0.02309845494876471 * y + 0.06325924320057072 * z,
    y: -0.0283697093338637 * x + 1.0099953980813041 * y + 0.021041441191917323 * z,
    z: 0.012314014864481998 * x - 0.020507649298898964 * y + 1.330365926242124 * z,
  });
}

/** Rec. 2020 with the power of 2.4 that CSS Color 4 has; culori has the curve of cameras. */
function lightFromRec2020(c: Triple): Rgb {
  const [r, g, b] = c.map((x) => Math.sign(x) * Math.abs(x) ** 2.4);
  return lightFromXyz({
    x: 0.6369580483012914 * r + 0.14461690358620832 * g + 0.1688809751641721 * b,
    y: 0.2627002120112671 * r + 0.6779980715188708 * g + 0.05930171646986196 * b,
    z: 0.028072693049087428 * g + 1.060985057710791 * b,
  });
}

/** Light of sRGB of three components, by the names that color() has for spaces. */
export const LIGHT_FROM: ReadonlyMap<string, (components: Triple) => Rgb> = new Map([
  ["srgb", (c: Triple) => convertRgbToLrgb(rgbOf(c))],
  ["srgb-linear", rgbOf],
  ["display-p3", (c: Triple) => lightFromXyz(convertP3ToXyz65(rgbOf(c)))],
  ["display-p3-linear", (c: Triple) => lightFromXyz(convertP3ToXyz65(convertLrgbToRgb(rgbOf(c))))],
  ["a98-rgb", (c: Triple) => lightFromXyz(convertA98ToXyz65(rgbOf(c)))],
  ["prophoto-rgb", (c: Triple) => lightFromXyz50(convertProphotoToXyz50(rgbOf(c)))],
  ["rec2020", lightFromRec2020],
  ["xyz", (c: Triple) => lightFromXyz(xyzOf(c))],
  ["xyz-d50", (c: Triple) => lightFromXyz50(xyzOf(c))],
  ["xyz-d65", (c: Triple) => lightFromXyz(xyzOf(c))],
]);

/** The difference in OKLab that is just noticed. */
const JUST_NOTICEABLE = 0.02;
/** Where the search ends, in OKLab. */
const EPSILON = 1e-4;
/** Tolerance for rounding outside the range. */
const SLACK = 1e-9;

const isWithin = ({ r, g, b }: Rgb) => [r, g, b].every((x) => x >= -SLACK && x <= 1 + SLACK);

/** How far clipping moves a colour in OKLab. */
function clipError(light: Rgb, lab: Oklab): number {
  const seen = convertLrgbToOklab(clampedRgb(light));
  return Math.hypot(seen.l - lab.l, seen.a - lab.a, seen.b - lab.b);
}

/** Light of sRGB from 0 to 1, by CSS Color 4, section 13: chroma is reduced in OKLCH. */
function mapped(light: Rgb, lab: Oklab): Rgb {
  const { l, a, b } = lab;
  if (l >= 1) return { r: 1, g: 1, b: 1 };
  if (l <= 0) return { r: 0, g: 0, b: 0 };
  if (clipError(light, lab) < JUST_NOTICEABLE) return light;
  const chroma = Math.hypot(a, b);
  let [low, high, lowIsWithin] = [0, 1, true];
  while ((high - low) * chroma > EPSILON) {
    const share = (low + high) / 2;
    const scaled = { l, a: a * share, b: b * share };
    const tried = convertOklabToLrgb(scaled);
    const error = lowIsWithin && isWithin(tried) ? 0 : clipError(tried, scaled);
    if (error >= JUST_NOTICEABLE) {
      high = share;
      continue;
    }
    if (JUST_NOTICEABLE - error < EPSILON) return tried;
    lowIsWithin &&= error === 0;
    low = share;
  }
  const share = (low + high) / 2;
  return convertOklabToLrgb({ l, a: a * share, b: b * share });
}

/** The colour of sRGB; what lies outside is mapped into it. `lab` is the same colour. */
export function rgbFromLight(light: Rgb, lab: Oklab = convertLrgbToOklab(light)): Rgb {
  const found = isWithin(light) ? light : mapped(light, lab);
  return rgbFromLinear(clampedRgb(found));
}
