import { expect, test } from "vitest";
import type { Editor } from "../../../../web/editor/src/app/types.js";
import { takenSides } from "../../../../web/editor/src/canvas/taken.js";
import { mixer, valueAt } from "../../../../web/editor/src/canvas/sides.js";
import type { Affine } from "../../../../web/editor/src/geometry/affine.js";
import { mixed, type Rgb } from "../../../../web/editor/src/geometry/color.js";
import type { CubicPath } from "../../../../web/editor/src/geometry/cubic.js";
import { parameterAtFraction, pathPointAt } from "../../../../web/editor/src/geometry/length.js";
import type { Item } from "../../../../web/editor/src/model/types.js";
import { line } from "../support/drawing.js";

type Color = readonly [number, number, number, number];

/** Blue above 50 and red below. */
const halves = (_: number, y: number): Color => (y < 50 ? [0, 0, 1, 1] : [1, 0, 0, 1]);

/** Returns an engine with a layer within 100 by 100 of its own units. */
function editorOf(size: number, color = halves, interpolation = "srgb"): Editor {
  const colors = async (_: number, xy: Float64Array) => {
    const out: number[] = [];
    for (let k = 0; k < xy.length; k += 2) {
      const [x, y] = [xy[k], xy[k + 1]];
      if (!(x >= 0 && x <= 100 && y >= 0 && y <= 100)) throw new Error("a point outside");
      out.push(...color(x, y));
    }
    return Float32Array.from(out);
  };
  const view = { peek: () => ({ zoom: 1 }) };
  const drawing = { artboard: [0, 0, size, size], interpolation };
  return { engineLayer: () => 0, engine: { colors }, view, drawing } as unknown as Editor;
}

const layerAt = (artboardFromItem: Affine) => ({ artboardFromItem }) as unknown as Item;

async function firstColors(path: CubicPath, layer: Item, size: number) {
  const sides = await takenSides(editorOf(size), layer, path);
  return [sides?.left, sides?.right].map((side) =>
    side?.kind === "stops" ? side.stops.map(({ value }) => [value.r, value.b]) : null,
  );
}

test("a_curve_that_runs_beyond_the_artboard_takes_the_colours_within", async () => {
  const [left, right] = await firstColors(line([-40, 50], [140, 50]), layerAt([1, 0, 0, 1, 0, 0]), 100);
  expect([left, right]).toEqual([[[0, 1]], [[1, 0]]]);
});

test("a_curve_beside_the_artboard_takes_the_colours_of_its_edge", async () => {
  const [left, right] = await firstColors(line([-40, -30], [140, -30]), layerAt([1, 0, 0, 1, 0, 0]), 100);
  expect([left, right]).toEqual([[[0, 1]], [[0, 1]]]);
});

test("the_edge_is_that_of_the_artboard_in_a_layer_that_is_scaled", async () => {
  const [left, right] = await firstColors(line([-9, 120], [109, 120]), layerAt([2, 0, 0, 2, 0, 0]), 200);
  expect([left, right]).toEqual([[[1, 0]], [[1, 0]]]);
});

const PAGE = layerAt([1, 0, 0, 1, 0, 0]);
const CIRCLE: CubicPath = {
  closed: true,
  points: [[50, 20], [66.57, 20], [80, 33.43], [80, 50], [80, 66.57], [66.57, 80], [50, 80], [33.43, 80], [20, 66.57],
    [20, 50], [20, 33.43], [33.43, 20], [50, 20]],
};

/** Returns the stops of the left side of a path on a ground. */
async function stopsOn(color: typeof halves, path: CubicPath, space?: string) {
  const side = (await takenSides(editorOf(100, color, space), PAGE, path))!.left;
  return side.kind === "stops" ? side.stops : [];
}

/** The largest channel by which stops differ from a ground along a path, code values. */
function missOf(stops: Awaited<ReturnType<typeof stopsOn>>, color: typeof halves, path: CubicPath): number {
  return Math.max(
    ...Array.from({ length: 101 }, (_, k) => {
      const [x, y] = pathPointAt(path, parameterAtFraction(path, k / 100));
      const { r, g, b } = valueAt({ space: "arc", stops }, k / 100, mixer("srgb")) as Rgb;
      return 255 * Math.max(...[r, g, b].map((channel, axis) => Math.abs(channel - color(x, y)[axis])));
    }),
  );
}

const shaded = (_: number, y: number): Color => [0.2 + 0.005 * y, 0.5, 0.9 - 0.003 * y, 1];

test("a_line_across_an_even_shade_has_a_stop_at_each_end", async () => {
  const stops = await stopsOn((x) => [x / 100, 0.5, 0.5, 1], line([0, 50], [100, 50]));
  expect(stops.map(({ offset }) => offset)).toEqual([0, 1]);
  expect(stops.map(({ value }) => value.r)).toEqual([0, 1]);
});

test("a_line_across_an_edge_has_a_stop_on_both_sides_of_it", async () => {
  const stops = await stopsOn((x) => [x < 41 ? 0 : 1, 0, 0, 1], line([0, 50], [100, 50]));
  expect(stops.map(({ value }) => value.r)).toEqual([0, 1]);
  expect(stops[0].offset).toBeGreaterThan(0.35);
  expect(stops[1].offset).toBeLessThan(0.46);
});

test("a_line_with_many_colours_has_three_stops_near_all_of_them", async () => {
  const wave = (x: number): Color => [0.5 + 0.3 * Math.sin(x / 16), 0.5, 0.5, 1];
  const path = line([0, 50], [100, 50]);
  const stops = await stopsOn(wave, path);
  expect(stops.length).toBe(3);
  // Stops at the ends and in the middle would miss it by 76.
  expect(missOf(stops, wave, path)).toBeLessThan(50);
});

test("a_circle_on_a_shade_has_three_stops_and_ends_with_its_first_colour", async () => {
  const stops = await stopsOn(shaded, CIRCLE);
  expect(stops.length).toBeLessThanOrEqual(4);
  expect(stops[0].offset).toBe(0);
  expect(stops[stops.length - 1]).toEqual({ offset: 1, value: stops[0].value });
  // The ground varies by 76 code values along it.
  expect(missOf(stops, shaded, CIRCLE)).toBeLessThan(12);
});

test.each(["linear", "oklab"])("stops_are_found_in_the_space_that_they_mix_in: %s", async (space) => {
  const [from, to] = [{ r: 0, g: 0.2, b: 1 }, { r: 1, g: 0.9, b: 0 }];
  const ground = (x: number): Color => {
    const { r, g, b } = mixed(from, to, x / 100, space as "oklab");
    return [r, g, b, 1];
  };
  expect(await stopsOn(ground, line([0, 50], [100, 50]), space)).toHaveLength(2);
});

test("sides_with_about_the_same_colours_have_stops_at_the_same_places", async () => {
  const sides = await takenSides(editorOf(100, shaded), PAGE, CIRCLE);
  const places = [sides!.left, sides!.right].map((side) => (side.kind === "stops" ? side.stops.map(({ offset }) => offset) : []));
  expect(places[0].length).toBe(4);
  expect(places[1]).toEqual(places[0]);
});

test("a_side_without_colours_stays_open_and_gaps_are_left_out", async () => {
  const sides = await takenSides(editorOf(100, (x) => (x < 60 ? [0, 0, 0, 0] : [1, 1, 0, 1])), PAGE, CIRCLE);
  expect(sides!.left).toEqual({ kind: "stops", space: "arc", stops: [{ offset: 0, value: { r: 1, g: 1, b: 0 } }] });
  expect(await takenSides(editorOf(100, () => [0, 0, 0, 0]), PAGE, CIRCLE)).toBeNull();
});
