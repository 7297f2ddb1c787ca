import { describe, expect, test } from "vitest";
import type { Lines } from "../../../../web/editor/src/geometry/box-snap.js";
import type { Point } from "../../../../web/editor/src/geometry/affine.js";
import { CurveGrid } from "../../../../web/editor/src/canvas/hit.js";
import { gridStep, snapped } from "../../../../web/editor/src/canvas/snap.js";
import { curve, FakeDrawing, line } from "../support/drawing.js";
import { placesIn } from "../support/editor.js";

const a = curve("a", [line([100, 100], [200, 100])]);
const b = curve("b", [line([204, 60], [204, 160])]);
const grid = new CurveGrid(placesIn(new FakeDrawing([a, b])), [1, 0, 0, 1, 0, 0], 400, 300);
const none: Lines = [[], []];
const wish = { snaps: true, grid: false, lines: none, unit: 0, zoom: 1, origin: [0, 0] as Point, isWanted: () => true, also: [] };

describe("a point", () => {
  test("goes_to_an_end_before_a_curve_that_is_nearer", () => {
    expect(snapped(grid, [203, 104], wish).at).toEqual([200, 100]);
  });

  test("goes_to_the_nearest_point_of_a_curve_where_no_end_is_near", () => {
    const { at, guides } = snapped(grid, [150, 105], wish);
    expect(at[0]).toBeCloseTo(150, 6);
    expect(at[1]).toBeCloseTo(100, 6);
    expect(guides).toHaveLength(1);
  });

  test("stays_where_nothing_is_within_eight_pixels", () => {
    expect(snapped(grid, [150, 108.1], wish)).toEqual({ at: [150, 108.1], guides: [], isWelded: false });
  });

  test("does_not_hear_what_is_moved_nor_anything_where_snapping_is_off", () => {
    const isWanted = ({ item }: { item: { name: string } }) => item.name !== "a";
    expect(snapped(grid, [150, 101], { ...wish, isWanted }).at).toEqual([150, 101]);
    expect(snapped(grid, [150, 101], { ...wish, snaps: false }).at).toEqual([150, 101]);
  });

  test("goes_to_the_grid_where_it_is_on_and_nothing_else_is_near", () => {
    // At zoom 1, lines are 10 units apart.
    const at = snapped(grid, [31, 248], { ...wish, grid: true, origin: [2, 3] }).at;
    expect(at).toEqual([32, 253]);
  });
});

describe("guides", () => {
  const lines: Lines = [[120, 303], [106, 250]];

  test("take each coordinate that is near one, and lines show it", () => {
    const { at, guides, isWelded } = snapped(grid, [300, 204], { ...wish, lines });
    expect([at, isWelded]).toEqual([[303, 204], false]);
    expect(guides.map(({ from, to }) => [from[0], to[0]])).toEqual([[303, 303]]);
    expect(snapped(grid, [300, 255], { ...wish, lines }).at).toEqual([303, 250]);
    expect(snapped(grid, [300, 255], { ...wish, lines }).guides).toHaveLength(2);
    expect(snapped(grid, [320, 230], { ...wish, lines })).toEqual({ at: [320, 230], guides: [], isWelded: false });
  });

  test("come after ends, and before curves that are farther away", () => {
    expect(snapped(grid, [198, 105], { ...wish, lines }).at).toEqual([200, 100]);
    expect(snapped(grid, [150, 105], { ...wish, lines }).at).toEqual([150, 106]);
    const { at, isWelded } = snapped(grid, [150, 101], { ...wish, lines });
    expect([Math.round(at[1]), isWelded]).toEqual([100, true]);
  });

  test("leave the other coordinate to the grid, and count only where points snap", () => {
    expect(snapped(grid, [300, 204], { ...wish, lines, grid: true }).at).toEqual([303, 200]);
    expect(snapped(grid, [300, 204], { ...wish, lines, snaps: false }).at).toEqual([300, 204]);
  });
});

test("lines_of_the_grid_are_one_two_or_five_units_and_at_least_eight_pixels_apart", () => {
  for (let exponent = -3; exponent <= 4; exponent += 0.01) {
    const zoom = 10 ** exponent;
    const step = gridStep(zoom);
    expect(step * zoom).toBeGreaterThanOrEqual(8 - 1e-6);
    expect(step * zoom).toBeLessThan(20 + 1e-6);
    const mantissa = step / 10 ** Math.floor(Math.log10(step) + 1e-9);
    expect([1, 2, 5].some((k) => Math.abs(mantissa - k) < 1e-6)).toBe(true);
  }
});

describe("a grid with a unit of its own", () => {
  test("has lines at each unit, or at multiples that are eight pixels apart", () => {
    expect(gridStep(1, 20)).toBe(20);
    expect(gridStep(100, 20)).toBe(20);
    expect(gridStep(0.1, 20)).toBe(100);
    expect(gridStep(0.01, 20)).toBe(1000);
    expect(gridStep(1, 7)).toBe(14);
  });

  test("is what a point snaps to", () => {
    const empty = new CurveGrid([], [1, 0, 0, 1, 0, 0], 400, 300);
    const { at } = snapped(empty, [33, 47], { ...wish, grid: true, unit: 25, origin: [5, 5] });
    expect(at).toEqual([30, 55]);
  });
});
