import { beforeEach, describe, expect, test, vi } from "vitest";
import type { Canvas } from "../../../../web/editor/src/canvas/canvas.js";
import type { SelectTool } from "../../../../web/editor/src/canvas/tools/select.js";
import type { CurveItem } from "../../../../web/editor/src/model/types.js";
import { curve, line } from "../support/drawing.js";
import type { FakeEditor } from "../support/editor.js";
import { keyboardOn, type Keyboard } from "../support/keys.js";
import { click, dragThrough } from "../support/pointer.js";

vi.mock(
  "../../../../web/editor/src/model/commands/index.js",
  async () => (await import("../support/drawing.js")).fakeCommands,
);

let editor: FakeEditor;
let canvas: Canvas;
let tool: SelectTool;
let press: Keyboard["press"];
let a: CurveItem;

/** A box of 100 by 60 around its middle at 150, 130. */
beforeEach(() => {
  a = curve("a", [line([100, 100], [200, 160])]);
  ({ editor, canvas, tool, press } = keyboardOn(a, curve("b", [line([20, 20], [30, 40])])));
  editor.selection.value = [{ handle: a.handle, part: { kind: "whole" } }];
});

const label = () => canvas.marks.value.find(({ isChosen }) => isChosen)?.label;
/** Returns the ends of the curve, rounded. */
const ends = () => {
  const { points } = (editor.drawing.item(a.handle) as CurveItem).paths[0];
  return [points[0], points[3]].flat().map((value) => Math.round(value * 1e6) / 1e6);
};
const goTo = (name: string) => {
  press("Enter", { shift: true });
  while (label() !== name) if (!press("Tab")) throw new Error(`there is no ${name}`);
};

describe("the handles of the box", () => {
  test("are_gone_through_by_tab_and_left_by_escape", () => {
    expect([press("Enter", { shift: true }), label()]).toEqual([true, "Scale, top left"]);
    const seen = [label()];
    while (press("Tab")) seen.push(label());
    expect(seen).toHaveLength(9);
    expect(new Set(seen).size).toBe(9);
    expect(seen.at(-1)).toBe("Rotate");
    expect([press("Tab", { shift: true }), label()]).toEqual([true, seen.at(-2)]);
    expect([press("Escape"), label()]).toEqual([true, undefined]);
    expect(editor.selection.value).toHaveLength(1);
  });

  test("are_none_where_nothing_is_selected", () => {
    editor.selection.value = [];
    expect(press("Enter", { shift: true })).toBe(false);
  });

  test("take_the_keys_by_a_click_and_a_press_elsewhere_takes_them_back", () => {
    click(tool, [208, 168]);
    expect(label()).toBe("Scale, bottom right");
    click(tool, [150, 130]);
    expect(label()).toBeUndefined();
  });

  test("keep_the_keys_after_a_drag_and_after_undo_leaves_the_same_thing_selected", () => {
    dragThrough(tool, [[208, 168], [228, 168]]);
    expect(label()).toBe("Scale, bottom right");
    editor.selection.value = [...editor.selection.value];
    expect(label()).toBe("Scale, bottom right");
    editor.selection.value = [{ handle: editor.drawing.items[0].children[1].handle, part: { kind: "whole" } }];
    expect(label()).toBeUndefined();
  });

  test("are_chosen_by_the_focus_that_a_screen_reader_sets", () => {
    canvas.grips.focused("scale-1-1");
    expect(label()).toBe("Scale, bottom right");
    canvas.grips.focused("no such mark");
    expect(label()).toBe("Scale, bottom right");
  });

  test("are_let_go_when_another_tool_is_taken_up", () => {
    goTo("Rotate");
    tool.leave();
    expect(label()).toBeUndefined();
  });
});

describe("arrows on a handle that scales", () => {
  test("bring_it_by_a_pixel_and_by_ten_with_shift_and_the_other_side_stays", () => {
    goTo("Scale, right");
    press("ArrowRight");
    expect(ends()).toEqual([100, 100, 201, 160]);
    press("ArrowRight", { shift: true });
    expect(ends()).toEqual([100, 100, 211, 160]);
    expect(press("ArrowDown")).toBe(true);
    expect(ends()).toEqual([100, 100, 211, 160]);
    expect(editor.announcement.value).toBe("111 × 60");
  });

  test("count_pixels_of_the_screen", () => {
    editor.view.value = { x: 150, y: 130, zoom: 2 };
    goTo("Scale, bottom");
    press("ArrowDown");
    expect(ends()).toEqual([100, 100, 200, 160.5]);
  });

  test("scale_from_the_middle_with_alt_and_in_proportion_with_ctrl", () => {
    goTo("Scale, right");
    press("ArrowRight", { alt: true });
    expect(ends()).toEqual([99, 100, 201, 160]);
    press("Escape");
    goTo("Scale, bottom right");
    press("ArrowRight", { ctrl: true, shift: true });
    const [x0, y0, x1, y1] = ends();
    expect((x1 - x0) / (y1 - y0)).toBeCloseTo(102 / 60, 6);
    expect(x1 - x0).toBeCloseTo(112, 6);
  });

  test("keep_the_handle_in_a_box_that_has_become_too_narrow_for_it", () => {
    goTo("Scale, right");
    for (let k = 0; k < 7; k += 1) press("ArrowLeft", { shift: true });
    expect(label()).toBe("Scale, right");
    expect(ends()).toEqual([100, 100, 130, 160]);
  });

  test("never_flatten_what_they_scale", () => {
    goTo("Scale, right");
    for (let k = 0; k < 10; k += 1) press("ArrowLeft", { shift: true });
    const [x0, , x1] = ends();
    expect(x1 - x0).toBeGreaterThan(0);
  });
});

describe("arrows on the handle that turns", () => {
  test("turn_by_a_degree_and_by_fifteen_with_shift_clockwise_to_the_right", () => {
    goTo("Rotate");
    press("ArrowRight");
    const turned = (by: number) => {
      const [c, s] = [Math.cos((by * Math.PI) / 180), Math.sin((by * Math.PI) / 180)];
      return [150 - 50 * c + 30 * s, 130 - 50 * s - 30 * c].map((value) => Math.round(value * 1e6) / 1e6);
    };
    expect(ends().slice(0, 2)).toEqual(turned(1));
    press("ArrowDown", { shift: true });
    expect(ends().slice(0, 2)).toEqual(turned(16));
    expect(editor.announcement.value).toBe("16°");
    press("ArrowLeft");
    expect(ends().slice(0, 2)).toEqual(turned(15));
  });

  test("come_back_to_where_they_began_after_a_whole_turn", () => {
    goTo("Rotate");
    for (let k = 0; k < 24; k += 1) press("ArrowUp", { shift: true });
    expect(ends()).toEqual([100, 100, 200, 160]);
  });
});

test("a_run_of_steps_by_one_handle_is_one_step_of_undo", () => {
  goTo("Scale, right");
  press("ArrowRight");
  press("ArrowRight", { shift: true });
  expect(editor.merges[0]).not.toBe("");
  expect(editor.merges[1]).toBe(editor.merges[0]);
  goTo("Rotate");
  press("ArrowRight");
  expect(editor.merges[2]).not.toBe(editor.merges[0]);
  expect(editor.steps).toEqual(["scale", "scale", "rotate"]);
});

test("what_is_locked_has_no_handles_to_go_to", () => {
  Object.assign(a, { locked: true });
  expect(press("Enter", { shift: true })).toBe(false);
});
