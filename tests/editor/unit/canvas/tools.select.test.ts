import { beforeEach, describe, expect, test, vi } from "vitest";
import type { Canvas } from "../../../../web/editor/src/canvas/canvas.js";
import { photosOf } from "../../../../web/editor/src/canvas/photo.js";
import { SelectTool } from "../../../../web/editor/src/canvas/tools/select.js";
import type { CurveItem, Item } from "../../../../web/editor/src/model/types.js";
import { curve, FakeDrawing, layer, line, reference } from "../support/drawing.js";
import { canvasOf, fakeEditor, type FakeEditor } from "../support/editor.js";
import { begun, click, dragThrough, press } from "../support/pointer.js";

vi.mock(
  "../../../../web/editor/src/model/commands/index.js",
  async () => (await import("../support/drawing.js")).fakeCommands,
);

let editor: FakeEditor;
let canvas: Canvas;
let tool: SelectTool;
let a: CurveItem;
let b: CurveItem;
let both: Item;

beforeEach(() => {
  a = curve("a", [line([100, 100], [200, 100])]);
  b = curve("b", [line([100, 200], [200, 200])]);
  both = layer("layer", [a, b]);
  editor = fakeEditor([both]);
  canvas = canvasOf(editor);
  tool = new SelectTool(canvas);
});

const names = () => editor.selection.value.map(({ handle }) => editor.drawing.item(handle)?.name);
const startOf = (item: CurveItem) =>
  (editor.drawing.item(item.handle) as CurveItem).paths[0].points[0];
const whole = (...items: Item[]) =>
  items.map(({ handle }) => ({ handle, part: { kind: "whole" } as const }));

describe("a click", () => {
  test("on_a_curve_selects_it_alone", () => {
    click(tool, [150, 103]);
    expect(names()).toEqual(["a"]);
    click(tool, [150, 200]);
    expect(names()).toEqual(["b"]);
    expect(editor.steps).toEqual([]);
  });

  test("with_shift_adds_and_takes_away", () => {
    click(tool, [150, 100]);
    click(tool, [150, 200], { shift: true });
    expect(names()).toEqual(["a", "b"]);
    click(tool, [150, 100], { shift: true });
    expect(names()).toEqual(["b"]);
  });

  test("on_one_of_several_leaves_it_alone", () => {
    editor.selection.value = whole(a, b);
    click(tool, [150, 100]);
    expect(names()).toEqual(["a"]);
  });

  test("between_curves_selects_the_layer_around_and_outside_nothing", () => {
    click(tool, [150, 150]);
    expect(names()).toEqual(["layer"]);
    click(tool, [350, 280]);
    expect(names()).toEqual([]);
  });

  test("twice_on_a_curve_goes_to_its_nodes", () => {
    click(tool, [150, 100]);
    click(tool, [150, 100], { clicks: 2 });
    expect(editor.tool.value).toBe("nodes");
    expect(names()).toEqual(["a"]);
  });

  test("that_trembles_by_two_pixels_moves_nothing", () => {
    dragThrough(tool, [
      [150, 100],
      [151, 101],
      [150, 102],
    ]);
    expect(editor.steps).toEqual([]);
    expect(startOf(a)).toEqual([100, 100]);
  });
});

describe("a drag", () => {
  test("moves_what_is_selected_in_one_step", () => {
    editor.selection.value = whole(a, b);
    dragThrough(tool, [
      [150, 100],
      [160, 110],
      [180, 130],
    ]);
    expect(startOf(a)).toEqual([130, 130]);
    expect(startOf(b)).toEqual([130, 230]);
    expect(editor.steps).toEqual(["move"]);
  });

  test("counts_artboard_units_where_the_view_is_zoomed", () => {
    editor.view.value = { x: 150, y: 100, zoom: 4 };
    click(tool, [200, 150]);
    expect(names()).toEqual(["a"]);
    dragThrough(tool, [
      [200, 150],
      [240, 170],
    ]);
    expect(startOf(a)).toEqual([110, 105]);
  });

  test("with_shift_goes_across_or_down_alone", () => {
    editor.selection.value = whole(a);
    // Shift at the press would add to the selection, so it comes during the drag.
    const drag = begun(tool, [
      [150, 100],
      [190, 110],
    ]);
    drag.move(press([190, 110], { shift: true }));
    drag.end(press([190, 110], { shift: true }));
    expect(startOf(a)).toEqual([140, 100]);
  });

  test("with_alt_leaves_a_copy", () => {
    editor.selection.value = whole(a);
    dragThrough(
      tool,
      [
        [150, 100],
        [150, 140],
      ],
      { alt: true },
    );
    expect(startOf(a)).toEqual([100, 100]);
    expect(names()).toEqual(["a copy"]);
    expect(editor.steps).toEqual(["copy"]);
  });

  test("that_is_cancelled_leaves_all_as_it_was", () => {
    editor.selection.value = whole(a);
    const drag = begun(tool, [
      [150, 100],
      [180, 130],
      [220, 160],
    ]);
    expect(startOf(a)).not.toEqual([100, 100]);
    drag.cancel();
    expect(startOf(a)).toEqual([100, 100]);
    expect(editor.steps).toEqual([]);
    expect(editor.dropped).toEqual(["move"]);
    expect(canvas.sketch.value.isFaded).toBe(false);
  });

  test("brings_an_end_to_the_end_of_another_curve", () => {
    editor.selection.value = whole(a);
    // The start of a comes within 8 px of the end of b at (200, 200).
    dragThrough(
      tool,
      [
        [150, 100],
        [252, 195],
      ],
      {},
    );
    expect(startOf(a)).toEqual([200, 200]);
  });

  test("with_ctrl_or_without_snapping_goes_where_the_hand_goes", () => {
    editor.selection.value = whole(a);
    dragThrough(
      tool,
      [
        [150, 100],
        [252, 195],
      ],
      { ctrl: true },
    );
    expect(startOf(a)).toEqual([202, 195]);
  });

  test("of_a_locked_thing_moves_nothing", () => {
    (a as { locked: boolean }).locked = true;
    editor.drawing.revision += 1;
    editor.selection.value = whole(a);
    dragThrough(tool, [
      [150, 100],
      [180, 130],
    ]);
    expect(startOf(a)).toEqual([100, 100]);
    expect(editor.steps).toEqual([]);
  });
});

describe("the rectangle", () => {
  test("takes_what_it_touches_and_what_is_within", () => {
    dragThrough(tool, [
      [20, 20],
      [120, 150],
    ]);
    expect(names()).toEqual(["a"]);
    dragThrough(tool, [
      [20, 20],
      [320, 250],
    ]);
    expect(names().sort()).toEqual(["a", "b"]);
  });

  test("with_shift_adds", () => {
    editor.selection.value = whole(b);
    dragThrough(
      tool,
      [
        [20, 20],
        [120, 150],
      ],
      { shift: true },
    );
    expect(names()).toEqual(["b", "a"]);
  });

  test("that_is_cancelled_selects_nothing_and_is_gone", () => {
    const drag = begun(tool, [
      [20, 20],
      [320, 250],
    ]);
    expect(canvas.sketch.value.marquee).not.toBeNull();
    drag.cancel();
    expect(canvas.sketch.value.marquee).toBeNull();
    expect(names()).toEqual([]);
  });
});

describe("the box", () => {
  const markOf = (label: string) => {
    const mark = canvas.marks.value.find((one) => one.label === label);
    if (!mark) throw new Error(`no ${label}`);
    return mark.at;
  };
  const ends = (item: CurveItem) => {
    const { points } = (editor.drawing.item(item.handle) as CurveItem).paths[0];
    return [points[0], points[3]].flat();
  };

  test("scales_from_the_corner_that_stays", () => {
    editor.selection.value = whole(a, b);
    const [x, y] = markOf("Scale, bottom right");
    dragThrough(tool, [
      [x, y],
      [x + 50, y + 100],
    ]);
    expect(ends(a)).toEqual([100, 100, 250, 100]);
    expect(ends(b)).toEqual([100, 300, 250, 300]);
    expect(editor.steps).toEqual(["scale"]);
  });

  test("keeps_its_shape_with_shift_and_its_middle_with_alt", () => {
    editor.selection.value = whole(a, b);
    const [x, y] = markOf("Scale, right");
    dragThrough(
      tool,
      [
        [x, y],
        [x + 50, y],
      ],
      { alt: true },
    );
    expect(ends(a)).toEqual([50, 100, 250, 100]);
    editor.selection.value = whole(a, b);
    const corner = markOf("Scale, bottom right");
    dragThrough(tool, [corner, [corner[0] + 100, corner[1]]], { shift: true });
    const [x0, y0, x1] = ends(a);
    expect([x0, y0]).toEqual([50, 100]);
    expect((ends(b)[1] - y0) / (x1 - x0)).toBeCloseTo(100 / 200, 9);
  });

  test("turns_about_its_middle_and_with_shift_by_fifteen_degrees", () => {
    editor.selection.value = whole(a, b);
    const [x, y] = markOf("Rotate");
    // The middle is at (150, 150): slightly less than a quarter turn.
    dragThrough(
      tool,
      [
        [x, y],
        [150 + (150 - y), 152],
      ],
      { shift: true },
    );
    ends(a).forEach((value, k) => expect(value).toBeCloseTo([200, 100, 200, 200][k], 9));
    expect(editor.steps).toEqual(["rotate"]);
  });

  test("never_becomes_nothing", () => {
    editor.selection.value = whole(a, b);
    const [x, y] = markOf("Scale, bottom right");
    dragThrough(tool, [
      [x, y],
      [x - 100, y - 100],
    ]);
    const [x0, , x1] = ends(a);
    expect(Math.abs(x1 - x0)).toBeGreaterThan(0);
  });

  test("of_a_straight_line_scales_along_it_alone", () => {
    editor.selection.value = whole(a);
    const [x, y] = markOf("Scale, bottom right");
    dragThrough(tool, [
      [x, y],
      [x + 50, y + 70],
    ]);
    ends(a).forEach((value, k) => expect(value).toBeCloseTo([100, 100, 250, 100][k], 9));
  });
});

describe("a photo to trace over", () => {
  const photo = (more = {}) => {
    const item = reference("photo", [10, 10, 390, 290], more);
    editor = fakeEditor([both, item]);
    canvas = canvasOf(editor);
    tool = new SelectTool(canvas);
    return item;
  };
  const matrixOf = (item: Item) => editor.drawing.item(item.handle)?.artboardFromItem;

  test("that is not locked is taken and moved where no curve is", () => {
    const item = photo();
    dragThrough(tool, [[300, 50], [310, 70]], { ctrl: true });
    expect(names()).toEqual(["photo"]);
    expect(matrixOf(item)).toEqual([1, 0, 0, 1, 10, 20]);
    expect(editor.steps).toEqual(["move"]);
    editor.selection.value = [];
    click(tool, [150, 100]);
    expect(names()).toEqual(["a"]);
  });

  test("is scaled by its box", () => {
    const item = photo();
    click(tool, [300, 50]);
    dragThrough(tool, [[398, 298], [208, 158]]);
    expect(matrixOf(item)?.map((value) => Math.round(value * 100) / 100)).toEqual([0.5, 0, 0, 0.5, 5, 5]);
  });

  test("that is locked, hidden or switched off is in nobody's way", () => {
    for (const more of [{ locked: true }, { hidden: true }]) {
      photo(more);
      click(tool, [300, 50]);
      expect(names()).toEqual([]);
    }
    photo();
    editor.showReference.value = false;
    click(tool, [300, 50]);
    expect(names()).toEqual([]);
  });

  test("is below the picture where it stands before all that is drawn", () => {
    const item = reference("photo", [0, 0, 10, 10]);
    expect(photosOf(new FakeDrawing([item, both]), true)).toEqual([item]);
    expect(photosOf(new FakeDrawing([both, item]), true)).toEqual([]);
    expect(photosOf(new FakeDrawing([both, item]), false)).toEqual([item]);
    expect(photosOf(new FakeDrawing([item]), false)).toEqual([item]);
  });
});

describe("a box that is moved", () => {
  test("is_aligned_with_the_edges_and_the_middle_of_others", () => {
    const low = curve("low", [line([100, 200], [180, 230])]);
    editor = fakeEditor([layer("layer", [a, low])]);
    canvas = canvasOf(editor);
    tool = new SelectTool(canvas);
    editor.selection.value = whole(low);
    // Its left edge comes to 205, beside the other one's right edge at 200.
    const drag = begun(tool, [[140, 215], [245, 215]]);
    expect(canvas.sketch.value.guides).toContainEqual({ from: [200, 100], to: [200, 230] });
    expect(startOf(low)[0]).toBeCloseTo(200, 6);
    // With Ctrl it goes where the pointer is.
    drag.move(press([245, 215], { ctrl: true }));
    expect(startOf(low)[0]).toBeCloseTo(205, 6);
  });
});
