import { beforeEach, describe, expect, test, vi } from "vitest";
import type { Canvas } from "../../../../web/editor/src/canvas/canvas.js";
import { deleteParts, nudge } from "../../../../web/editor/src/canvas/edits.js";
import { NodesTool } from "../../../../web/editor/src/canvas/tools/nodes.js";
import type { Affine, Point } from "../../../../web/editor/src/geometry/affine.js";
import { mapped } from "../../../../web/editor/src/geometry/affine.js";
import type { CubicPath } from "../../../../web/editor/src/geometry/cubic.js";
import { pathPointAt } from "../../../../web/editor/src/geometry/length.js";
import { kindOf } from "../../../../web/editor/src/geometry/nodes.js";
import type { CurveItem, Part } from "../../../../web/editor/src/model/types.js";
import { curve, layer, line, NO_SIDES, stopsOf } from "../support/drawing.js";
import { canvasOf, fakeEditor, near, type FakeEditor } from "../support/editor.js";
import { begun, click, dragThrough, press } from "../support/pointer.js";

vi.mock(
  "../../../../web/editor/src/model/commands/index.js",
  async () => (await import("../support/drawing.js")).fakeCommands,
);

/** Two pieces, smooth in the middle at (150, 100). */
const WAVE: CubicPath = {
  points: [
    [50, 100],
    [80, 60],
    [120, 70],
    [150, 100],
    [180, 130],
    [220, 140],
    [250, 100],
  ],
  closed: false,
};
const RED = { r: 1, g: 0, b: 0 };
const BLUE = { r: 0, g: 0, b: 1 };

let editor: FakeEditor;
let canvas: Canvas;
let tool: NodesTool;
let item: CurveItem;

function open(path: CubicPath, more: Partial<CurveItem> = {}): void {
  item = curve("wave", [path], more);
  editor = fakeEditor([layer("layer", [item])]);
  editor.tool.value = "nodes";
  canvas = canvasOf(editor);
  tool = new NodesTool(canvas);
}

const now = () => editor.drawing.item(item.handle) as CurveItem;
const points = () => now().paths[0].points;
const select = (...parts: Part[]) => {
  editor.selection.value = parts.map((part) => ({ handle: item.handle, part }));
};
const node = (index: number): Part => ({ kind: "node", path: 0, index });

beforeEach(() => open(WAVE));

describe("delete at a handle", () => {
  test("takes_it_into_its_node_and_leaves_the_curve", () => {
    select({ kind: "handle", path: 0, index: 2 });
    expect(deleteParts(editor)).toBe(true);
    expect(points()[2]).toEqual(points()[3]);
    expect(points()[4]).toEqual(WAVE.points[4]);
    expect(editor.selection.value[0].part).toEqual(node(1));
  });
});

describe("a node", () => {
  test("moves_with_its_handles_in_one_step", () => {
    select({ kind: "whole" });
    dragThrough(tool, [
      [150, 100],
      [160, 110],
      [170, 90],
    ]);
    expect(points()[3]).toEqual([170, 90]);
    expect(points()[2]).toEqual([140, 60]);
    expect(points()[4]).toEqual([200, 120]);
    expect(points()[0]).toEqual([50, 100]);
    expect(editor.steps).toEqual(["move node"]);
  });

  test("is_moved_with_the_others_that_are_chosen", () => {
    select(node(0), node(1));
    dragThrough(tool, [
      [150, 100],
      [150, 120],
    ]);
    expect([points()[0], points()[3], points()[6]]).toEqual([
      [50, 120],
      [150, 120],
      [250, 100],
    ]);
    expect(editor.steps).toEqual(["move nodes"]);
  });

  test("goes_back_when_the_drag_is_cancelled", () => {
    select({ kind: "whole" });
    begun(tool, [
      [150, 100],
      [200, 200],
    ]).cancel();
    expect(now().paths[0]).toEqual(WAVE);
    expect(editor.steps).toEqual([]);
  });

  test("follows_the_pointer_where_the_curve_is_turned_and_scaled", () => {
    const map: Affine = [0, 2, -2, 0, 300, -100];
    open(WAVE, { artboardFromItem: map });
    select({ kind: "whole" });
    const [x, y] = mapped(map, WAVE.points[3]);
    dragThrough(tool, [
      [x, y],
      [x + 20, y + 30],
    ]);
    expect(near(mapped(map, points()[3]), [x + 20, y + 30])).toBe(true);
  });

  test("is_added_to_and_taken_from_the_chosen_with_shift", () => {
    select(node(0));
    click(tool, [150, 100], { shift: true });
    expect(editor.selection.value.map(({ part }) => part)).toEqual([node(0), node(1)]);
    click(tool, [150, 100], { shift: true });
    click(tool, [50, 100], { shift: true });
    expect(editor.selection.value.map(({ part }) => part)).toEqual([{ kind: "whole" }]);
  });

  test("at_the_seam_of_a_closed_curve_stays_one", () => {
    const ring: CubicPath = {
      points: [
        [100, 50],
        [130, 50],
        [150, 70],
        [150, 100],
        [150, 130],
        [80, 90],
        [100, 50],
      ],
      closed: true,
    };
    open(ring);
    select({ kind: "whole" });
    dragThrough(tool, [
      [100, 50],
      [90, 40],
    ]);
    expect(points()[0]).toEqual([90, 40]);
    expect(points()[6]).toEqual([90, 40]);
  });

  test("at_an_end_closes_its_curve_where_it_comes_to_the_other_end", () => {
    select({ kind: "whole" });
    dragThrough(tool, [
      [250, 100],
      [150, 150],
      [54, 96],
    ]);
    expect(points()[6]).toEqual(points()[0]);
    expect(now().paths[0].closed).toBe(true);
    expect(editor.steps).toEqual(["move node"]);
  });

  test("at_an_end_closes_nothing_that_it_goes_past_nor_with_ctrl", () => {
    select({ kind: "whole" });
    const drag = begun(tool, [
      [250, 100],
      [52, 98],
    ]);
    expect(now().paths[0].closed).toBe(true);
    drag.move(press([80, 60]));
    expect(now().paths[0].closed).toBe(false);
    drag.move(press([52, 98], { ctrl: true }));
    drag.end(press([52, 98], { ctrl: true }));
    expect(now().paths[0].closed).toBe(false);
    expect(points()[6]).toEqual([52, 98]);
  });

  test("of_one_subpath_takes_chosen_nodes_of_another_with_it", () => {
    open(WAVE, { paths: [line([50, 200], [250, 200]), WAVE] });
    select({ kind: "node", path: 0, index: 0 }, { kind: "node", path: 1, index: 1 });
    dragThrough(tool, [
      [150, 100],
      [160, 110],
    ]);
    expect(now().paths[1].points[3]).toEqual([160, 110]);
    expect(now().paths[0].points[0]).toEqual([60, 210]);
    expect(editor.steps).toEqual(["move nodes"]);
  });

  test("of_each_subpath_in_a_rectangle_is_chosen_and_goes_by_delete", () => {
    open(WAVE, { paths: [line([50, 200], [250, 200]), WAVE] });
    select({ kind: "whole" });
    dragThrough(tool, [
      [120, 60],
      [270, 230],
    ]);
    const parts = () => editor.selection.value.map(({ part }) => part);
    expect(parts()).toEqual([
      { kind: "node", path: 0, index: 1 },
      { kind: "node", path: 1, index: 1 },
      { kind: "node", path: 1, index: 2 },
    ]);
    expect(deleteParts(editor)).toBe(true);
    expect(editor.steps).toEqual(["delete nodes"]);
    expect(now().paths.map((path) => path.points.length)).toEqual([3, 3]);
    expect([...new Set(parts().map(({ kind }) => kind))]).toEqual(["whole"]);
  });

  test("is_drawn_to_the_end_of_another_curve_but_not_to_its_own", () => {
    const other = curve("other", [line([300, 50], [300, 150])]);
    editor = fakeEditor([layer("layer", [item, other])]);
    editor.tool.value = "nodes";
    canvas = canvasOf(editor);
    tool = new NodesTool(canvas);
    select({ kind: "whole" });
    const drag = begun(tool, [
      [250, 100],
      [296, 146],
    ]);
    expect(canvas.sketch.value.guides).toHaveLength(1);
    drag.end(press([296, 146]));
    expect(points()[6]).toEqual([300, 150]);
    dragThrough(tool, [
      [150, 100],
      [55, 103],
    ]);
    expect(points()[3]).toEqual([55, 103]);
  });
});

describe("a handle", () => {
  test("turns_the_other_where_the_node_is_symmetric", () => {
    select(node(1));
    dragThrough(tool, [
      [180, 130],
      [150, 150],
    ]);
    expect(points()[4]).toEqual([150, 150]);
    expect(near(points()[2], [150, 50])).toBe(true);
    expect(kindOf(now().paths[0], 1)).toBe("symmetric");
  });

  test("turns_the_other_and_leaves_its_length_where_the_node_is_smooth", () => {
    open({ ...WAVE, points: WAVE.points.map((point, k): Point => (k === 2 ? [135, 85] : point)) });
    select(node(1));
    dragThrough(tool, [
      [180, 130],
      [150, 150],
    ]);
    expect(near(points()[2], [150, 100 - Math.hypot(15, 15)])).toBe(true);
    expect(kindOf(now().paths[0], 1)).toBe("smooth");
  });

  test("leaves_the_other_with_alt", () => {
    select(node(1));
    dragThrough(
      tool,
      [
        [180, 130],
        [150, 150],
      ],
      { alt: true },
    );
    expect(points()[2]).toEqual([120, 70]);
  });

  test("keeps_to_fifteen_degrees_with_shift", () => {
    select(node(1));
    const drag = begun(tool, [
      [180, 130],
      [190, 134],
    ]);
    drag.move(press([190, 134], { shift: true }));
    drag.end(press([190, 134], { shift: true }));
    const angle = (Math.atan2(points()[4][1] - 100, points()[4][0] - 150) * 180) / Math.PI;
    expect(Math.abs(angle / 15 - Math.round(angle / 15))).toBeLessThan(1e-9);
  });

  test("is_pulled_out_of_a_node_with_alt_towards_the_piece_that_is_meant", () => {
    open(line([50, 100], [250, 100]));
    select({ kind: "whole" });
    dragThrough(
      tool,
      [
        [50, 100],
        [60, 60],
      ],
      { alt: true },
    );
    expect(points()[1]).toEqual([60, 60]);
    expect(points()[0]).toEqual([50, 100]);
  });
});

describe("the curve itself", () => {
  test.each([0.3, 0.5, 0.72, 1.4])("goes_through_the_pointer_at_%d", (at) => {
    select({ kind: "whole" });
    const from = pathPointAt(WAVE, at);
    const to: Point = [from[0] + 13, from[1] - 22];
    dragThrough(tool, [from, [from[0] + 5, from[1]], to]);
    expect(near(pathPointAt(now().paths[0], at), to, 0.5)).toBe(true);
    expect(points()[0]).toEqual(WAVE.points[0]);
    expect(points()[3]).toEqual(WAVE.points[3]);
    expect(editor.steps).toEqual(["bend curve"]);
  });

  test("stays_smooth_where_it_was_when_a_piece_is_bent", () => {
    select({ kind: "whole" });
    const from = pathPointAt(WAVE, 0.5);
    dragThrough(tool, [from, [from[0] + 20, from[1] + 30]]);
    expect(points()[2]).not.toEqual(WAVE.points[2]);
    expect(kindOf(now().paths[0], 1)).toBe("symmetric");
  });

  test("gets_a_node_where_it_is_clicked_twice_and_keeps_its_shape", () => {
    select({ kind: "whole" });
    const at = pathPointAt(WAVE, 1.5);
    click(tool, at, { clicks: 2 });
    expect(points()).toHaveLength(10);
    expect(editor.selection.value[0].part).toEqual(node(2));
    expect(near(points()[6], at, 0.6)).toBe(true);
  });
});

describe("stops", () => {
  beforeEach(() => {
    open(line([50, 100], [250, 100]), {
      left: { ...NO_SIDES, color: stopsOf([0, RED], [0.5, BLUE], [1, RED]) },
    });
    select({ kind: "whole" });
  });
  const list = () => {
    const { color } = now().left;
    if (color.kind !== "stops") throw new Error("no stops");
    return color.stops;
  };

  test("stand_on_their_side_eighteen_pixels_off", () => {
    const stops = canvas.marks.value.filter(({ kind }) => kind === "stop");
    expect(stops.map(({ at }) => at)).toEqual([
      [50, 82],
      [150, 82],
      [250, 82],
    ]);
  });

  test("stand_on_the_same_side_of_a_curve_that_is_mirrored", () => {
    open(line([50, 100], [250, 100]), {
      left: { ...NO_SIDES, color: stopsOf([0.5, RED]) },
      artboardFromItem: [1, 0, 0, -1, 0, 200],
    });
    select({ kind: "whole" });
    const [stop] = canvas.marks.value.filter(({ kind }) => kind === "stop");
    expect(stop.at).toEqual([150, 118]);
  });

  test("slide_along_the_curve_but_not_past_each_other", () => {
    dragThrough(tool, [
      [150, 82],
      [190, 70],
    ]);
    expect(list()[1].offset).toBeCloseTo(0.7, 6);
    expect(editor.steps).toEqual(["move stop"]);
    dragThrough(tool, [
      [190, 82],
      [400, 82],
    ]);
    expect(list()[1].offset).toBe(1);
  });

  test("open_the_picker_when_they_are_clicked_twice", () => {
    click(tool, [150, 82], { clicks: 2 });
    expect(editor.picker.value).toEqual({ handle: item.handle, side: "left", stops: [1] });
    expect(editor.steps).toEqual([]);
  });

  test("come_by_a_click_beside_the_curve_with_the_value_that_is_there", async () => {
    click(tool, [100, 82]);
    await vi.waitFor(() => expect(editor.steps).toEqual(["add stop"]));
    expect(list()).toHaveLength(4);
    expect(list()[1].offset).toBeCloseTo(0.25, 6);
    expect(list()[1].value.r).toBeCloseTo(0.5, 6);
    expect(list()[1].value.b).toBeCloseTo(0.5, 6);
    expect(editor.selection.value[0].part).toEqual({
      kind: "stop",
      side: "left",
      attribute: "color",
      index: 1,
    });
  });

  test("on_an_open_side_take_the_colour_of_the_picture", async () => {
    editor.layers = [{ layer: 3, offset: item.element.range.start }];
    editor.paint = (_, y) => (y > 100 ? [0.2, 0.4, 0.6, 1] : [1, 1, 1, 1]);
    click(tool, [100, 118]);
    await vi.waitFor(() => expect(editor.steps).toEqual(["add stop"]));
    expect(now().right.color).toEqual(stopsOf([0.25, { r: 0.2, g: 0.4, b: 0.6 }]));
  });

  test("go_with_delete_and_the_last_one_leaves_the_side_open", () => {
    select({ kind: "stop", side: "left", attribute: "color", index: 1 });
    expect(deleteParts(editor)).toBe(true);
    expect(list()).toHaveLength(2);
    for (let k = 0; k < 2; k += 1) {
      select({ kind: "stop", side: "left", attribute: "color", index: 0 });
      deleteParts(editor);
    }
    expect(now().left.color).toEqual({ kind: "open" });
  });

  test("move_by_the_arrows_by_pixels_of_the_screen", () => {
    select({ kind: "stop", side: "left", attribute: "color", index: 1 });
    nudge(editor, [10, 0]);
    expect(list()[1].offset).toBeCloseTo(0.55, 6);
  });
});

describe("the rectangle", () => {
  test("takes_the_nodes_within_and_a_click_lets_go_of_them", () => {
    select({ kind: "whole" });
    dragThrough(tool, [
      [20, 20],
      [200, 150],
    ]);
    expect(editor.selection.value.map(({ part }) => part)).toEqual([node(0), node(1)]);
    click(tool, [20, 20]);
    expect(editor.selection.value.map(({ part }) => part)).toEqual([{ kind: "whole" }]);
    click(tool, [20, 20]);
    expect(editor.selection.value).toEqual([]);
  });
});
