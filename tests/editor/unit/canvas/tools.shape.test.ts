import { beforeEach, expect, test, vi } from "vitest";
import type { Canvas } from "../../../../web/editor/src/canvas/canvas.js";
import { ShapeTool } from "../../../../web/editor/src/canvas/tools/shape.js";
import type { DrawnShape, ShapeKind } from "../../../../web/editor/src/geometry/drawn-shape.js";
import { curve, layer, line } from "../support/drawing.js";
import { canvasOf, fakeEditor, type FakeEditor } from "../support/editor.js";
import { begun, click, dragThrough, press } from "../support/pointer.js";

const { added } = vi.hoisted(() => ({ added: [] as DrawnShape[] }));

vi.mock("../../../../web/editor/src/model/commands/index.js", async () => ({
  ...(await import("../support/drawing.js")).fakeCommands,
  addShape: ({ items }: { items: unknown }, _: number, shape: DrawnShape) => {
    added.push(shape);
    return { items, patch: [] };
  },
}));

let editor: FakeEditor;
let canvas: Canvas;
const said: string[] = [];
const plain = { shift: false, alt: false, ctrl: false };
const tool = (kind: ShapeKind) => new ShapeTool(canvas, kind);

beforeEach(() => {
  editor = fakeEditor([layer("home", [curve("horizon", [line([300, 20], [300, 280])])])]);
  editor.say = (text) => void said.push(text);
  canvas = canvasOf(editor);
  added.length = said.length = 0;
});

test("a_drag_is_one_step_and_leaves_no_sketch", () => {
  dragThrough(tool("rectangle"), [[20, 30], [60, 40], [120, 90]]);
  expect(added).toEqual([{ kind: "rectangle", sides: 6, box: [20, 30, 120, 90] }]);
  expect(editor.steps).toEqual(["draw rectangle"]);
  expect(editor.announcement.value).toBe("Rectangle, 100 × 60");
  expect(canvas.sketch.value).toMatchObject({ draft: null, tag: null, guides: [] });
  expect(editor.draft.value).toBeNull();
});

test("it_shows_the_filled_outline_and_the_size", () => {
  editor.settings.recent.value = [{ r: 0, g: 0, b: 1 }];
  begun(tool("ellipse"), [[20, 30], [120, 90]]);
  expect(canvas.sketch.value).toMatchObject({ draft: { fill: "#0000ff" }, tag: { text: "100 × 60" } });
});

test("shift_makes_it_regular_alt_draws_from_the_middle", () => {
  dragThrough(tool("ellipse"), [[50, 50], [90, 60]], { shift: true });
  dragThrough(tool("ellipse"), [[50, 50], [90, 60]], { alt: true });
  dragThrough(tool("ellipse"), [[50, 50], [90, 60]], { alt: true, shift: true });
  expect(added.map(({ box }) => box)).toEqual([[50, 50, 90, 90], [10, 40, 90, 60], [10, 10, 90, 90]]);
});

test("modifiers_count_while_the_pointer_rests_and_when_it_is_released", () => {
  const drag = begun(tool("rectangle"), [[50, 50], [90, 60]]);
  drag.keys?.(press([90, 60], { shift: true }));
  drag.end(press([90, 60], { shift: true }));
  expect(added[0].box).toEqual([50, 50, 90, 90]);
});

test("both_corners_snap_unless_ctrl_prevents_it", () => {
  dragThrough(tool("rectangle"), [[297, 22], [200, 100]]);
  dragThrough(tool("rectangle"), [[200, 100], [296, 150]]);
  dragThrough(tool("rectangle"), [[200, 100], [296, 150]], { ctrl: true });
  expect(added.map(({ box }) => box)).toEqual([[200, 20, 300, 100], [200, 100, 300, 150], [200, 100, 296, 150]]);
});

test("space_moves_the_shape_and_then_its_corner_goes_on", () => {
  const drag = begun(tool("rectangle"), [[20, 30], [60, 70]]);
  drag.space?.(true);
  drag.move(press([70, 75]));
  drag.space?.(false);
  drag.move(press([80, 85]));
  drag.end(press([80, 85]));
  expect(added[0].box).toEqual([30, 35, 80, 85]);
});

test("arrows_change_the_sides_of_a_polygon_from_three_to_twelve", () => {
  const drag = begun(tool("polygon"), [[20, 30], [60, 70]]);
  for (let k = 0; k < 9; k += 1) expect(drag.key?.({ ...plain, key: "ArrowUp" })).toBe(true);
  expect(editor.settings.polygonSides.value).toBe(12);
  for (let k = 0; k < 12; k += 1) drag.key?.({ ...plain, key: "ArrowDown" });
  drag.end(press([60, 70]));
  expect(added[0].sides).toBe(3);
  const other = begun(tool("rectangle"), [[20, 30], [60, 70]]);
  expect(other.key?.({ ...plain, key: "ArrowUp" })).toBe(false);
  expect(drag.key?.({ ...plain, key: "x" })).toBe(false);
});

test("a_click_and_a_drag_without_height_make_nothing_and_say_how", () => {
  click(tool("rectangle"), [20, 30]);
  dragThrough(tool("ellipse"), [[20, 30], [120, 30]]);
  expect(added).toEqual([]);
  expect(editor.steps).toEqual([]);
  expect(said).toEqual([
    "Drag from corner to corner to draw a rectangle.",
    "Drag from corner to corner to draw an ellipse.",
  ]);
});

test("undo_and_escape_drop_it", () => {
  const drag = begun(tool("rectangle"), [[20, 30], [120, 90]]);
  editor.draft.value?.undo();
  drag.move(press([130, 90]));
  drag.end(press([130, 90]));
  begun(tool("rectangle"), [[20, 30], [120, 90]]).cancel();
  expect(added).toEqual([]);
  expect(canvas.sketch.value.draft).toBeNull();
  expect(editor.draft.value).toBeNull();
});

/** The tool with a caret at the middle of the stage, after a step right and back. */
function caretOf(kind: ShapeKind) {
  const shape = tool(kind);
  const keys = (...names: string[]) => names.map((key) => shape.key({ ...plain, key }));
  keys("ArrowRight", "ArrowLeft");
  return { shape, keys };
}

test("keys_set_both_corners", () => {
  const { keys } = caretOf("rectangle");
  expect(canvas.sketch.value.brush?.at).toEqual([200, 150]);
  expect(keys("Enter", "ArrowRight", "ArrowRight", "ArrowDown")).toEqual([true, true, true, true]);
  expect(canvas.sketch.value).toMatchObject({ draft: { closes: false }, tag: { text: "20 × 10" } });
  expect(editor.announcement.value).toBe("Rectangle, 20 × 10");
  expect(keys("Enter")).toEqual([true]);
  expect(added).toEqual([{ kind: "rectangle", sides: 6, box: [200, 150, 220, 160] }]);
  expect(editor.steps).toEqual(["draw rectangle"]);
  expect(canvas.sketch.value).toMatchObject({ draft: null, tag: null, brush: null });
  expect(editor.draft.value).toBeNull();
});

test("space_sets_corners_too_and_shift_takes_large_steps", () => {
  const { shape, keys } = caretOf("polygon");
  keys(" ");
  shape.key({ ...plain, key: "ArrowRight", shift: true });
  shape.key({ ...plain, key: "ArrowDown", shift: true });
  shape.key({ ...plain, key: "ArrowDown" });
  keys(" ");
  expect(added[0].box).toEqual([200, 150, 250, 210]);
});

test("shift_and_alt_count_while_they_are_held", () => {
  const { shape, keys } = caretOf("ellipse");
  keys("Enter", "ArrowRight", "ArrowDown", "ArrowDown");
  const size = () => canvas.sketch.value.tag?.text;
  expect(size()).toBe("10 × 20");
  shape.modifiers({ ...plain, shift: true });
  expect(size()).toBe("20 × 20");
  shape.modifiers(plain);
  expect(size()).toBe("10 × 20");
  shape.key({ ...plain, key: "Enter", shift: true, alt: true });
  expect(added[0].box).toEqual([180, 130, 220, 170]);
});

test("escape_and_undo_drop_a_shape_of_keys_and_another_tool_does", () => {
  const { shape, keys } = caretOf("rectangle");
  const begin = () => keys("Enter", "ArrowRight", "ArrowDown");
  begin();
  expect(keys("Escape", "Escape")).toEqual([true, false]);
  keys("ArrowLeft");
  begin();
  editor.draft.value?.undo();
  expect(canvas.sketch.value.draft).toBeNull();
  begin();
  shape.leave();
  expect(editor.draft.value).toBeNull();
  expect([added, editor.steps]).toEqual([[], []]);
});

test("a_flat_shape_of_keys_waits_for_its_second_direction", () => {
  const { keys } = caretOf("rectangle");
  keys("Enter", "Enter", "ArrowRight", "Enter");
  expect([added.length, said.length]).toEqual([0, 2]);
  keys("ArrowUp", "Enter");
  expect(added[0].box).toEqual([200, 140, 210, 150]);
});

test("keys_are_the_selections_while_there_is_one", () => {
  editor.selection.value = [{ handle: editor.drawing.items[0].handle, part: { kind: "whole" } }];
  const { keys } = caretOf("rectangle");
  expect(keys("ArrowRight", "Enter", " ")).toEqual([false, false, false]);
});

test("a_pointer_takes_the_place_of_keys", () => {
  const { shape, keys } = caretOf("rectangle");
  keys("Enter", "ArrowRight", "ArrowDown");
  shape.hover(press([10, 10]));
  expect(canvas.sketch.value.draft).not.toBeNull();
  dragThrough(shape, [[20, 30], [60, 40], [120, 90]]);
  expect(added.map(({ box }) => box)).toEqual([[20, 30, 120, 90]]);
});
