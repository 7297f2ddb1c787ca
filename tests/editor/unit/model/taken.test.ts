import { expect, test } from "vitest";
import type { Editor } from "../../../../web/editor/src/app/types.js";
import { takenSides } from "../../../../web/editor/src/canvas/taken.js";
import type { Affine } from "../../../../web/editor/src/geometry/affine.js";
import type { CubicPath } from "../../../../web/editor/src/geometry/cubic.js";
import type { Item } from "../../../../web/editor/src/model/types.js";
import { line } from "../support/drawing.js";

/** Returns an engine with a layer within 100 by 100 of its own units, blue above 50 and red below. */
function editorOf(size: number): Editor {
  const colors = async (_: number, xy: Float64Array) => {
    const out: number[] = [];
    for (let k = 0; k < xy.length; k += 2) {
      const [x, y] = [xy[k], xy[k + 1]];
      if (!(x >= 0 && x <= 100 && y >= 0 && y <= 100)) throw new Error("a point outside");
      out.push(y < 50 ? 0 : 1, 0, y < 50 ? 1 : 0, 1);
    }
    return Float32Array.from(out);
  };
  const view = { peek: () => ({ zoom: 1 }) };
  const drawing = { artboard: [0, 0, size, size] };
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
