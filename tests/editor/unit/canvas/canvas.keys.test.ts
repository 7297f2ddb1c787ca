import { beforeEach, describe, expect, test, vi } from "vitest";
import type { Canvas } from "../../../../web/editor/src/canvas/canvas.js";
import type { CurveItem } from "../../../../web/editor/src/model/types.js";
import { curve, line, NO_SIDES, stopsOf } from "../support/drawing.js";
import type { FakeEditor } from "../support/editor.js";
import { keyboardOn, type Keyboard } from "../support/keys.js";

vi.mock(
  "../../../../web/editor/src/model/commands/index.js",
  async () => (await import("../support/drawing.js")).fakeCommands,
);

let editor: FakeEditor;
let canvas: Canvas;
let press: Keyboard["press"];
let a: CurveItem;

beforeEach(() => {
  const red = { r: 1, g: 0, b: 0 };
  a = curve("a", [line([100, 100], [200, 100])], {
    left: { ...NO_SIDES, color: stopsOf([0, red]) },
  });
  ({ editor, canvas, press } = keyboardOn(a, curve("b", [line([100, 200], [200, 200])])));
});

const chosen = () => {
  const one = editor.selection.value.at(-1);
  return one && `${editor.drawing.item(one.handle)?.name} ${one.part.kind}`;
};

describe("Tab", () => {
  test("goes_from_curve_to_curve_and_then_on_to_the_page", () => {
    expect([press("Tab"), chosen()]).toEqual([true, "a whole"]);
    expect(editor.announcement.value).toBe("Curve “a”, 1 of 2");
    expect([press("Tab"), chosen()]).toEqual([true, "b whole"]);
    expect(press("Tab")).toBe(false);
    expect([press("Tab", { shift: true }), chosen()]).toEqual([true, "a whole"]);
    expect(press("Tab", { shift: true })).toBe(false);
  });

  test("goes_through_nodes_and_stops_within_a_curve", () => {
    press("Tab");
    press("Enter");
    const seen: (string | undefined)[] = [chosen()];
    while (press("Tab")) seen.push(canvas.marks.value.find(({ isChosen }) => isChosen)?.label);
    expect(seen).toContain("Node 2 of curve “a”");
    expect(seen).toContain("Left stop 1 of 1, #ff0000, at 0 %");
    expect(seen.length).toBeLessThan(10);
  });
});

test("enter_goes_in_and_escape_out_again", () => {
  editor.selection.value = [{ handle: editor.drawing.items[0].handle, part: { kind: "whole" } }];
  press("Enter");
  expect(chosen()).toBe("a whole");
  press("Enter");
  expect([chosen(), editor.tool.value]).toEqual(["a node", "nodes"]);
  press("Escape");
  expect(chosen()).toBe("a whole");
  press("Escape");
  expect(chosen()).toBe("layer whole");
  press("Escape");
  expect(chosen()).toBeUndefined();
  expect(press("Escape")).toBe(false);
});

test("enter_on_a_stop_asks_for_its_colour", () => {
  editor.selection.value = [
    { handle: a.handle, part: { kind: "stop", side: "left", attribute: "color", index: 0 } },
  ];
  expect(press("Enter")).toBe(true);
  expect(editor.picker.value).toEqual({ handle: a.handle, side: "left", stops: [0] });
});

test("arrows_move_by_pixels_of_the_screen_and_by_ten_with_shift", () => {
  editor.view.value = { x: 150, y: 100, zoom: 2 };
  press("Tab");
  press("ArrowRight");
  press("ArrowDown", { shift: true });
  expect((editor.drawing.item(a.handle) as CurveItem).paths[0].points[0]).toEqual([100.5, 105]);
  expect(editor.steps).toEqual(["move", "move"]);
});

test("keys_that_are_not_the_stages_go_on", () => {
  expect(press("ArrowRight")).toBe(false);
  expect(press("Delete")).toBe(false);
  expect(press("z", { ctrl: true })).toBe(false);
  expect(press("v")).toBe(false);
});
