import { describe, expect, test } from "vitest";
import type { PlacedPhoto } from "../../../../web/editor/src/canvas/photo.js";
import { photoColor, sampledSides } from "../../../../web/editor/src/canvas/sampled.js";
import type { Rgb } from "../../../../web/editor/src/geometry/color.js";
import type { SideValue, Stop } from "../../../../web/editor/src/model/types.js";
import { curve, line, NO_SIDES, stopsOf } from "../support/drawing.js";
import { randomFrom } from "../random.js";

/** Returns a photo of 200 by 100 pixels, two pixels per artboard unit. */
function photoOf(
  paint: (x: number, y: number) => readonly [number, number, number, number?],
): PlacedPhoto {
  const data = new Uint8ClampedArray(200 * 100 * 4);
  for (let y = 0; y < 100; y += 1) {
    for (let x = 0; x < 200; x += 1) {
      const [r, g, b, a = 255] = paint(x, y);
      data.set([r, g, b, a], 4 * (y * 200 + x));
    }
  }
  return { width: 200, height: 100, data, artboardFromPixel: [0.5, 0, 0, 0.5, 0, 0] };
}

const across = curve("across", [line([10, 25], [90, 25])]);
const wish = { distance: 3, tolerance: 0.02, spacing: 0.5, range: [0, 1] as const };

function stops(value: SideValue<Rgb> | null): readonly Stop<Rgb>[] {
  if (value?.kind !== "stops") throw new Error("no stops");
  return value.stops;
}

describe("colours of a photo beside a curve", () => {
  test("are_those_of_each_side", () => {
    const photo = photoOf((_, y) => (y < 50 ? [255, 0, 0] : [0, 0, 255]));
    const [above, below] = (["left", "right"] as const).map((side) =>
      stops(sampledSides(photo, across, 0, wish)[side]),
    );
    for (const { value } of above)
      expect([value.r, value.b]).toEqual([expect.closeTo(1, 4), expect.closeTo(0, 4)]);
    for (const { value } of below)
      expect([value.r, value.b]).toEqual([expect.closeTo(0, 4), expect.closeTo(1, 4)]);
  });

  test("of_a_ramp_need_few_stops_and_are_near_it", () => {
    const photo = photoOf((x) => [x, 128, 255 - x]);
    const made = stops(sampledSides(photo, across, 0, wish).left);
    expect(made.length).toBeLessThan(12);
    for (const { offset, value } of made) expect(value.r * 255).toBeCloseTo(20 + offset * 160, -1);
  });

  test("do_not_hear_a_hair_or_noise", () => {
    const next = randomFrom(8);
    const photo = photoOf((x) => (x > 95 && x < 98 ? [0, 0, 0] : [200 + 6 * next(), 100, 50]));
    for (const { value } of stops(sampledSides(photo, across, 0, wish).left))
      expect(value.r).toBeGreaterThan(0.7);
  });

  test("leave_stops_beyond_the_stretch_where_they_were", () => {
    const black = { r: 0, g: 0, b: 0 };
    const item = curve("c", across.paths, {
      left: { ...NO_SIDES, color: stopsOf([0, black], [0.5, black], [0.9, black]) },
    });
    const photo = photoOf(() => [255, 255, 255]);
    const made = stops(sampledSides(photo, item, 0, { ...wish, range: [0.3, 0.7] }).left);
    expect(made[0]).toEqual({ offset: 0, value: black });
    expect(made.at(-1)).toEqual({ offset: 0.9, value: black });
    const inside = made.slice(1, -1);
    expect(inside.every(({ offset }) => offset >= 0.3 - 1e-9 && offset <= 0.7 + 1e-9)).toBe(true);
    expect(inside.every(({ value }) => value.r > 0.99)).toBe(true);
  });

  test("are_none_where_the_photo_is_not", () => {
    const photo = photoOf(() => [255, 255, 255, 0]);
    expect(sampledSides(photo, across, 0, wish).left).toBeNull();
    const away = curve("away", [line([500, 500], [600, 500])]);
    expect(
      sampledSides(
        photoOf(() => [1, 2, 3]),
        away,
        0,
        wish,
      ).left,
    ).toBeNull();
  });
});

test("a_pixel_of_the_photo_is_found_by_its_place_on_the_artboard", () => {
  const photo = photoOf((x, y) => [x, y, 0]);
  const color = photoColor(photo, [50.2, 20.2]);
  expect(color?.r).toBeCloseTo(100 / 255, 9);
  expect(color?.g).toBeCloseTo(40 / 255, 9);
  expect(photoColor(photo, [-0.1, 20])).toBeNull();
  expect(photoColor(photo, [100, 20])).toBeNull();
});

describe("the blur of a photo beside a curve", () => {
  const smoothstep = (t: number) => Math.min(Math.max(t, 0), 1) ** 2 * (3 - 2 * Math.min(Math.max(t, 0), 1));
  /** A transition of 6 photo pixels on each side of the curve, which is 3 of its units. */
  const soft = photoOf((_, y) => {
    const t = smoothstep(((y + 0.5 - 50) / 6 + 1) / 2);
    return [255 * (1 - t), 40, 255 * t];
  });
  const radii = (value: SideValue<number> | undefined) => {
    if (value?.kind !== "stops") throw new Error("no stops");
    return value.stops;
  };

  test("is_that_of_both_sides_and_colours_are_from_beyond_it", () => {
    const made = sampledSides(soft, across, 0, { ...wish, blurs: true });
    for (const side of ["left", "right"] as const) {
      for (const { value } of radii(made.blur?.[side])) expect(Math.abs(value - 3)).toBeLessThan(0.6);
    }
    expect(stops(made.left)[0].value.r).toBeGreaterThan(0.93);
    expect(stops(sampledSides(soft, across, 0, wish).left)[0].value.r).toBeLessThan(0.9);
  });

  test("is_not_touched_where_it_is_not_asked_for_or_the_edge_is_sharp", () => {
    expect(sampledSides(soft, across, 0, wish).blur).toBeNull();
    const sharp = photoOf((_, y) => (y < 50 ? [255, 0, 0] : [0, 0, 255]));
    expect(sampledSides(sharp, across, 0, { ...wish, blurs: true }).blur).toBeNull();
  });

  test("of_a_stretch_leaves_no_blur_beyond_it", () => {
    const part = { ...wish, blurs: true, range: [0.25, 0.75] as const };
    const list = radii(sampledSides(soft, across, 0, part).blur?.left);
    const at = (offset: number) => list.filter((stop) => Math.abs(stop.offset - offset) < 0.01).map(({ value }) => value);
    expect(at(0)).toEqual([0]);
    expect(at(1)).toEqual([0]);
    expect(at(0.25)[0]).toBe(0);
    expect(at(0.25).at(-1)).toBeGreaterThan(2.4);
    expect(at(0.75).at(-1)).toBe(0);
  });

  test("of_a_stretch_keeps_what_stands_beyond_it_on_each_side", () => {
    const item = curve("c", across.paths, {
      left: { ...NO_SIDES, blur: stopsOf([0, 1], [1, 1]) },
      right: { ...NO_SIDES, blur: stopsOf([0, 2], [1, 2]) },
    });
    const made = sampledSides(soft, item, 0, { ...wish, blurs: true, range: [0.25, 0.75] });
    expect(radii(made.blur?.left)[0].value).toBe(1);
    expect(radii(made.blur?.right).at(-1)?.value).toBe(2);
  });
});
