// Colours compared with known values, and converted there and back.
import { describe, expect, test } from "vitest";
import {
  clampedRgb,
  deltaE,
  hsvFromRgb,
  inGamut,
  isInGamut,
  largestChroma,
  linearFromRgb,
  mixed,
  oklabFromRgb,
  oklchFromRgb,
  rgbFromHsv,
  rgbFromLinear,
  rgbFromOklab,
  rgbFromOklch,
  type Rgb,
} from "../../../../web/editor/src/geometry/color.js";
import { hexOf, rgbFromHex } from "../../../../web/editor/src/geometry/colortext.js";
import { Random } from "../random.js";

const rgb = (r: number, g: number, b: number): Rgb => ({ r, g, b });
const miss = (p: Rgb, q: Rgb) =>
  Math.max(...(["r", "g", "b"] as const).map((k) => Math.abs(p[k] - q[k])));
const randomColor = (random: Random) => rgb(random.next(), random.next(), random.next());

describe("colour spaces", () => {
  test("lead there and back to 1e-6", () => {
    const random = new Random(3);
    for (let i = 0; i < 20000; ++i) {
      const color = i < 8 ? rgb(i & 1, (i >> 1) & 1, i >> 2) : randomColor(random);
      expect(miss(rgbFromLinear(linearFromRgb(color)), color)).toBeLessThan(1e-12);
      expect(miss(rgbFromOklab(oklabFromRgb(color)), color)).toBeLessThan(1e-6);
      // A gray has no hue to convert back.
      const lch = oklchFromRgb(color);
      if (lch.c > 0)
        expect(miss(rgbFromOklch(lch), color)).toBeLessThan(lch.c < 1e-5 ? 1e-4 : 1e-6);
      expect(miss(rgbFromHsv(hsvFromRgb(color)), color)).toBeLessThan(1e-12);
    }
  });

  test("have the values of CSS Color 4", () => {
    const green = oklchFromRgb(rgb(0, 128 / 255, 0));
    expect(green.l).toBeCloseTo(0.51975, 4);
    expect(green.c).toBeCloseTo(0.17686, 4);
    expect(green.h).toBeCloseTo(142.495, 2);
    const lab = oklabFromRgb(rgb(0, 128 / 255, 0));
    expect(lab.a).toBeCloseTo(-0.1403, 4);
    expect(lab.b).toBeCloseTo(0.10768, 4);
    expect(
      miss(rgbFromOklch({ l: 0.5, c: 0.2, h: 0 }), rgb(0.70492, 0.02351, 0.37073)),
    ).toBeLessThan(2e-4);
    expect(
      miss(rgbFromOklch({ l: 0.5, c: 0.2, h: 270 }), rgb(0.23056, 0.3173, 0.82628)),
    ).toBeLessThan(2e-4);
    expect(oklabFromRgb(rgb(1, 1, 1)).l).toBeCloseTo(1, 6);
    expect(oklchFromRgb(rgb(0.5, 0.5, 0.5)).h).toBe(0);
  });

  test("HSV has the corners of its cone", () => {
    expect(hsvFromRgb(rgb(1, 0, 0))).toEqual({ h: 0, s: 1, v: 1 });
    expect(hsvFromRgb(rgb(0, 0, 1))).toEqual({ h: 240, s: 1, v: 1 });
    expect(hsvFromRgb(rgb(1, 0, 0.5)).h).toBeCloseTo(330, 9);
    expect(hsvFromRgb(rgb(0, 0, 0))).toEqual({ h: 0, s: 0, v: 0 });
    expect(miss(rgbFromHsv({ h: -60, s: 1, v: 1 }), rgb(1, 0, 1))).toBeLessThan(1e-12);
  });

  test("a colour outside of sRGB keeps lightness and hue, and as much chroma as there is", () => {
    const random = new Random(7);
    for (let i = 0; i < 2000; ++i) {
      const wish = { l: random.next(), c: random.between(0, 0.5), h: random.between(-100, 500) };
      const color = inGamut(wish);
      expect(Math.min(color.r, color.g, color.b)).toBeGreaterThanOrEqual(0);
      expect(Math.max(color.r, color.g, color.b)).toBeLessThanOrEqual(1);
      const found = oklchFromRgb(color);
      // Only clamping changes it, by rounding errors beyond the cube's faces.
      const most = Math.min(wish.c, largestChroma(wish.l, wish.h));
      expect(deltaE(color, clampedRgb(rgbFromOklch({ ...wish, c: most })))).toBeLessThan(1e-3);
      if (wish.l > 0.1) expect(Math.abs(found.l - wish.l)).toBeLessThan(4e-3);
      if (wish.l > 0.1 && isInGamut(rgbFromOklch(wish))) expect(found.c).toBeCloseTo(wish.c, 2);
    }
    expect(miss(inGamut({ l: 1.5, c: 0.3, h: 20 }), rgb(1, 1, 1))).toBeLessThan(1e-6);
  });

  test("two colours mix where the document says", () => {
    const [black, white] = [rgb(0, 0, 0), rgb(1, 1, 1)];
    expect(mixed(black, white, 0.5, "srgb").r).toBe(0.5);
    expect(mixed(black, white, 0.5, "linear").r).toBeCloseTo(0.735357, 5);
    expect(mixed(black, white, 0.5, "oklab").r).toBeCloseTo(0.388573, 4);
    for (const space of ["srgb", "linear", "oklab"] as const) {
      const [a, b] = [rgb(0.1, 0.9, 0.4), rgb(0.7, 0.2, 0.3)];
      expect(miss(mixed(a, b, 0, space), a)).toBeLessThan(1e-6);
      expect(miss(mixed(a, b, 1, space), b)).toBeLessThan(1e-6);
    }
  });
});

describe("colours as text", () => {
  test("hex leads back to the same bytes", () => {
    const random = new Random(11);
    for (let i = 0; i < 500; ++i) {
      const hex =
        "#" +
        random
          .below(1 << 24)
          .toString(16)
          .padStart(6, "0");
      expect(hexOf(rgbFromHex(hex)!)).toBe(hex);
    }
  });
});
