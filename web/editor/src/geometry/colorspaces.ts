// The spaces of CSS Color 4 beyond sRGB, and the mapping of their colours into sRGB. src/color/ is the
// same in C++; tests/color/colors.txt holds both to the same values.
import { clampedRgb, linearFromCode, rgbFromLinear, type Rgb } from "./color.js";

export type Triple = readonly [number, number, number];
type Matrix = readonly [Triple, Triple, Triple];
type Chromaticity = readonly [x: number, y: number];

const dot = (a: Triple, b: Triple) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const times = (m: Matrix, v: Triple): Triple => [dot(m[0], v), dot(m[1], v), dot(m[2], v)];
const each = (v: Triple, f: (x: number) => number): Triple => [f(v[0]), f(v[1]), f(v[2])];
const transposed = ([a, b, c]: Matrix): Matrix => [
  [a[0], b[0], c[0]],
  [a[1], b[1], c[1]],
  [a[2], b[2], c[2]],
];
const cross = (a: Triple, b: Triple): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const scaledRows = (m: Matrix, d: Triple): Matrix => [
  each(m[0], (x) => x * d[0]),
  each(m[1], (x) => x * d[1]),
  each(m[2], (x) => x * d[2]),
];

function product(a: Matrix, b: Matrix): Matrix {
  const columns = transposed(b);
  return [times(columns, a[0]), times(columns, a[1]), times(columns, a[2])];
}

function inverse([a, b, c]: Matrix): Matrix {
  const share = 1 / dot(a, cross(b, c));
  return transposed(scaledRows([cross(b, c), cross(c, a), cross(a, b)], [share, share, share]));
}

/** XYZ with Y = 1. */
const xyzOf = ([x, y]: Chromaticity): Triple => [x / y, 1, (1 - x - y) / y];

const D50: Chromaticity = [0.3457, 0.3585];
const D65: Chromaticity = [0.3127, 0.329];

/** XYZ under the white point, of the light of red, green and blue. */
function xyzFromLinear(
  red: Chromaticity,
  green: Chromaticity,
  blue: Chromaticity,
  white = D65,
): Matrix {
  const rows: Matrix = [xyzOf(red), xyzOf(green), xyzOf(blue)];
  return transposed(scaledRows(rows, times(inverse(transposed(rows)), xyzOf(white))));
}

const BRADFORD: Matrix = [
  [0.8951, 0.2664, -0.1614],
  [-0.7502, 1.7135, 0.0367],
  [0.0389, -0.0685, 1.0296],
];

/** Bradford's chromatic adaptation. */
function adaptation(from: Chromaticity, to: Chromaticity): Matrix {
  const [a, b] = [times(BRADFORD, xyzOf(from)), times(BRADFORD, xyzOf(to))];
  const scale: Triple = [b[0] / a[0], b[1] / a[1], b[2] / a[2]];
  return product(inverse(BRADFORD), scaledRows(BRADFORD, scale));
}

const D65_FROM_D50 = adaptation(D50, D65);
const XYZ_FROM_SRGB = xyzFromLinear([0.64, 0.33], [0.3, 0.6], [0.15, 0.06]);
const SRGB_FROM_XYZ = inverse(XYZ_FROM_SRGB);
const XYZ_FROM_P3 = xyzFromLinear([0.68, 0.32], [0.265, 0.69], [0.15, 0.06]);
const XYZ_FROM_A98 = xyzFromLinear([0.64, 0.33], [0.21, 0.71], [0.15, 0.06]);
const XYZ_FROM_REC2020 = xyzFromLinear([0.708, 0.292], [0.17, 0.797], [0.131, 0.046]);
const XYZ_FROM_PROPHOTO = product(
  D65_FROM_D50,
  xyzFromLinear([0.734699, 0.265301], [0.159597, 0.840403], [0.036598, 0.000105], D50),
);

// OKLab with the digits of CSS Color 4, section 10.
const LMS_FROM_XYZ: Matrix = [
  [0.819022437996703, 0.3619062600528904, -0.1288737815209879],
  [0.0329836539323885, 0.9292868615863434, 0.0361446663506424],
  [0.0481771893596242, 0.2642395317527308, 0.6335478284694309],
];
const OKLAB_FROM_LMS: Matrix = [
  [0.210454268309314, 0.7936177747023054, -0.0040720430116193],
  [1.9779985324311684, -2.42859224204858, 0.450593709617411],
  [0.0259040424655478, 0.7827717124575296, -0.8086757549230774],
];
const XYZ_FROM_LMS = inverse(LMS_FROM_XYZ);
const LMS_FROM_OKLAB = inverse(OKLAB_FROM_LMS);

const mirrored = (f: (x: number) => number) => (x: number) => Math.sign(x) * f(Math.abs(x));
const linearFromA98 = mirrored((x) => x ** (563 / 256));
const linearFromProphoto = mirrored((x) => (x <= 1 / 32 ? x / 16 : x ** 1.8));
const linearFromRec2020 = mirrored((x) => x ** 2.4);

/** XYZ under D65 of three components, by the names that color() has for spaces. */
export const XYZ_FROM: ReadonlyMap<string, (components: Triple) => Triple> = new Map([
  ["srgb", (c: Triple) => times(XYZ_FROM_SRGB, each(c, linearFromCode))],
  ["srgb-linear", (c: Triple) => times(XYZ_FROM_SRGB, c)],
  ["display-p3", (c: Triple) => times(XYZ_FROM_P3, each(c, linearFromCode))],
  ["display-p3-linear", (c: Triple) => times(XYZ_FROM_P3, c)],
  ["a98-rgb", (c: Triple) => times(XYZ_FROM_A98, each(c, linearFromA98))],
  ["prophoto-rgb", (c: Triple) => times(XYZ_FROM_PROPHOTO, each(c, linearFromProphoto))],
  ["rec2020", (c: Triple) => times(XYZ_FROM_REC2020, each(c, linearFromRec2020))],
  ["xyz", (c: Triple) => c],
  ["xyz-d50", (c: Triple) => times(D65_FROM_D50, c)],
  ["xyz-d65", (c: Triple) => c],
]);

/** Returns XYZ from CIE Lab under D50: L from 0 to 100. */
export function xyzFromLab([l, a, b]: Triple): Triple {
  const [kappa, epsilon] = [24389 / 27, 216 / 24389];
  const share = (f: number) => (f ** 3 > epsilon ? f ** 3 : (116 * f - 16) / kappa);
  const fy = (l + 16) / 116;
  const white = xyzOf(D50);
  return times(D65_FROM_D50, [
    white[0] * share(fy + a / 500),
    white[1] * share(fy),
    white[2] * share(fy - b / 200),
  ]);
}

/** Returns XYZ from OKLab: L from 0 to 1. */
export const xyzFromOklab = (lab: Triple): Triple =>
  times(XYZ_FROM_LMS, each(times(LMS_FROM_OKLAB, lab), (x) => x ** 3));

const oklabFromXyz = (xyz: Triple): Triple =>
  times(OKLAB_FROM_LMS, each(times(LMS_FROM_XYZ, xyz), Math.cbrt));

/** Lab of LCH, or OKLab of OKLCH. */
export function labFromLch(l: number, c: number, degrees: number): Triple {
  const angle = (degrees * Math.PI) / 180;
  return [l, c * Math.cos(angle), c * Math.sin(angle)];
}

/** The difference in OKLab that is just noticed. */
const JUST_NOTICEABLE = 0.02;
/** Where the search ends, in OKLab. */
const EPSILON = 1e-4;
/** Tolerance for rounding outside the range. */
const SLACK = 1e-9;

const isWithin = (light: Triple) => light.every((x) => x >= -SLACK && x <= 1 + SLACK);
const clipped = (light: Triple) => each(light, (x) => Math.min(Math.max(x, 0), 1));

/** How far clipping moves a colour in OKLab. */
function clipError(light: Triple, lab: Triple): number {
  const seen = oklabFromXyz(times(XYZ_FROM_SRGB, clipped(light)));
  return Math.hypot(seen[0] - lab[0], seen[1] - lab[1], seen[2] - lab[2]);
}

/** Light of sRGB from 0 to 1, by CSS Color 4, section 13: chroma is reduced in OKLCH. */
function mapped(light: Triple, lab: Triple): Triple {
  const [l, a, b] = lab;
  if (l >= 1) return [1, 1, 1];
  if (l <= 0) return [0, 0, 0];
  if (clipError(light, lab) < JUST_NOTICEABLE) return clipped(light);
  const lightOf = (scaled: Triple) => times(SRGB_FROM_XYZ, xyzFromOklab(scaled));
  const chroma = Math.hypot(a, b);
  let [low, high, lowIsWithin] = [0, 1, true];
  while ((high - low) * chroma > EPSILON) {
    const share = (low + high) / 2;
    const scaled: Triple = [l, a * share, b * share];
    const tried = lightOf(scaled);
    const error = lowIsWithin && isWithin(tried) ? 0 : clipError(tried, scaled);
    if (error >= JUST_NOTICEABLE) {
      high = share;
      continue;
    }
    if (JUST_NOTICEABLE - error < EPSILON) return clipped(tried);
    lowIsWithin &&= error === 0;
    low = share;
  }
  const share = (low + high) / 2;
  return clipped(lightOf([l, a * share, b * share]));
}

/** The colour of sRGB; what lies outside is mapped into it. */
export function rgbFromXyz(xyz: Triple): Rgb {
  const light = times(SRGB_FROM_XYZ, xyz);
  const [r, g, b] = isWithin(light) ? clipped(light) : mapped(light, oklabFromXyz(xyz));
  return clampedRgb(rgbFromLinear({ r, g, b }));
}
