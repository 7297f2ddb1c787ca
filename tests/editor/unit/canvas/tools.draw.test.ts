import { beforeEach, describe, expect, test, vi } from "vitest";
import type { Canvas } from "../../../../web/editor/src/canvas/canvas.js";
import { BlurTool } from "../../../../web/editor/src/canvas/tools/blur.js";
import { PencilTool } from "../../../../web/editor/src/canvas/tools/pencil.js";
import { PenTool } from "../../../../web/editor/src/canvas/tools/pen.js";
import { StrokeTool } from "../../../../web/editor/src/canvas/tools/stroke.js";
import type { Point } from "../../../../web/editor/src/geometry/affine.js";
import { nearestOn } from "../../../../web/editor/src/geometry/nearest.js";
import type { CurveItem, Item } from "../../../../web/editor/src/model/types.js";
import { curve, layer, line, NO_SIDES, stopsOf } from "../support/drawing.js";
import { canvasOf, fakeEditor, type FakeEditor } from "../support/editor.js";
import { begun, click, dragThrough, press } from "../support/pointer.js";

vi.mock(
  "../../../../web/editor/src/model/commands/index.js",
  async () => (await import("../support/drawing.js")).fakeCommands,
);

let editor: FakeEditor;
let canvas: Canvas;
let home: Item;
let horizon: CurveItem;

beforeEach(() => {
  horizon = curve("horizon", [line([300, 20], [300, 280])], {
    left: { ...NO_SIDES, blur: stopsOf([0, 5], [1, 5]) },
  });
  home = layer("home", [horizon]);
  editor = fakeEditor([home]);
  editor.layers = [{ layer: 0, offset: horizon.element.range.start }];
  canvas = canvasOf(editor);
});

const plain = { key: "", shift: false, alt: false, ctrl: false };
const made = () => {
  const [layerNow] = editor.drawing.items;
  const item = layerNow.children.at(-1) as CurveItem;
  expect(item.name).toBe("new");
  return item;
};
const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1]];
const nodes = (item: CurveItem) => item.paths[0].points.filter((_, k) => k % 3 === 0);

describe("the pen", () => {
  let pen: PenTool;
  beforeEach(() => {
    pen = new PenTool(canvas);
  });

  test("sets_corners_by_clicks_and_ends_by_enter_in_one_step", async () => {
    for (const at of [
      [20, 20],
      [80, 20],
      [80, 90],
    ] as Point[])
      click(pen, at);
    expect(editor.steps).toEqual([]);
    expect(pen.key({ ...plain, key: "Enter" })).toBe(true);
    await pen.isDone;
    expect(nodes(made())).toEqual([
      [20, 20],
      [80, 20],
      [80, 90],
    ]);
    expect(made().paths[0].closed).toBe(false);
    expect(editor.steps).toEqual(["draw curve"]);
    expect(canvas.sketch.value.draft).toBeNull();
  });

  test("pulls_both_handles_out_of_a_node_that_is_dragged", async () => {
    click(pen, [20, 100]);
    dragThrough(pen, [
      [100, 100],
      [110, 100],
      [130, 80],
    ]);
    click(pen, [180, 100]);
    pen.key({ ...plain, key: "Enter" });
    await pen.isDone;
    const { points } = made().paths[0];
    expect(points[4]).toEqual([130, 80]);
    expect(points[2]).toEqual([70, 120]);
  });

  test("closes_at_its_first_node", async () => {
    for (const at of [
      [20, 20],
      [80, 20],
      [80, 90],
      [24, 23],
    ] as Point[])
      click(pen, at);
    await pen.isDone;
    expect(made().paths[0].closed).toBe(true);
    expect(nodes(made())).toEqual([
      [20, 20],
      [80, 20],
      [80, 90],
      [20, 20],
    ]);
  });

  test("moves_the_node_that_is_set_while_space_is_down", async () => {
    click(pen, [20, 100]);
    const drag = begun(pen, [
      [100, 100],
      [130, 80],
    ]);
    drag.space?.(true);
    drag.move(press([140, 90]));
    drag.space?.(false);
    drag.end(press([140, 90]));
    pen.key({ ...plain, key: "Enter" });
    await pen.isDone;
    expect(nodes(made())[1]).toEqual([110, 110]);
  });

  test("forgets_a_node_whose_drag_is_cancelled_and_the_last_by_backspace", async () => {
    click(pen, [20, 20]);
    click(pen, [80, 20]);
    begun(pen, [
      [80, 90],
      [120, 120],
    ]).cancel();
    click(pen, [50, 150]);
    pen.key({ ...plain, key: "Backspace" });
    pen.key({ ...plain, key: "Escape" });
    await pen.isDone;
    expect(nodes(made())).toEqual([
      [20, 20],
      [80, 20],
    ]);
  });

  test("makes_nothing_of_a_single_node", async () => {
    click(pen, [20, 20]);
    pen.leave();
    await pen.isDone;
    expect(editor.steps).toEqual([]);
    expect(canvas.sketch.value.draft).toBeNull();
    expect(pen.key({ ...plain, key: "Enter" })).toBe(false);
  });

  test("finishes_when_another_tool_is_taken_up", async () => {
    click(pen, [20, 20]);
    click(pen, [80, 20]);
    pen.leave();
    await pen.isDone;
    expect(editor.steps).toEqual(["draw curve"]);
  });

  test("keeps_to_fifteen_degrees_with_shift", async () => {
    click(pen, [20, 20]);
    click(pen, [120, 24], { shift: true });
    pen.leave();
    await pen.isDone;
    expect(nodes(made())[1][1]).toBeCloseTo(20, 9);
  });

  test("begins_at_a_curve_that_is_near", async () => {
    click(pen, [296, 150]);
    click(pen, [200, 150]);
    pen.leave();
    await pen.isDone;
    expect(nodes(made())[0][0]).toBeCloseTo(300, 6);
  });
});

describe("undo and redo while the pen draws", () => {
  let pen: PenTool;
  const draft = () => editor.draft.value!;
  beforeEach(() => {
    pen = new PenTool(canvas);
    for (const x of [20, 80, 140]) click(pen, [x, 40]);
  });
  const ended = async () => {
    pen.key({ ...plain, key: "Enter" });
    await pen.isDone;
    return nodes(made());
  };

  test("take_nodes_back_and_give_them_again", async () => {
    expect([draft().undoLabel, draft().redoLabel]).toEqual(["set node", null]);
    draft().undo();
    draft().undo();
    expect(draft().redoLabel).toBe("set node");
    draft().redo();
    expect(await ended()).toEqual([[20, 40], [80, 40]]);
    expect(editor.draft.value).toBeNull();
  });

  test("forget_what_was_taken_back_with_the_next_node", async () => {
    draft().undo();
    click(pen, [80, 120]);
    expect(draft().redoLabel).toBeNull();
    expect(await ended()).toEqual([[20, 40], [80, 40], [80, 120]]);
  });

  test("let_undo_through_where_no_node_is_left_and_keep_redo", () => {
    for (let k = 0; k < 3; k += 1) draft().undo();
    expect([draft().undoLabel, draft().redoLabel]).toEqual([null, "set node"]);
    expect(canvas.sketch.value.draft).toBeNull();
    draft().redo();
    expect(draft().undoLabel).toBe("set node");
  });

  test("take_back_the_node_that_is_being_set_alone", async () => {
    const drag = begun(pen, [[200, 40], [220, 80]]);
    draft().undo();
    drag.move(press([240, 90]));
    drag.end(press([240, 90]));
    expect(await ended()).toHaveLength(3);
  });

  test("are_over_when_the_draft_is_finished_and_its_nodes_are_a_curve", async () => {
    draft().finish();
    await pen.isDone;
    expect(nodes(made())).toEqual([[20, 40], [80, 40], [140, 40]]);
    expect(editor.draft.value).toBeNull();
  });

  test("end_with_the_tool_and_with_the_drawing", () => {
    draft().drop();
    expect([editor.draft.value, canvas.sketch.value.draft]).toEqual([null, null]);
    click(pen, [20, 40]);
    draft().undo();
    pen.leave();
    expect(editor.draft.value).toBeNull();
  });
});

describe("colours of a new curve", () => {
  test("are_those_that_the_picture_has_on_its_sides", async () => {
    // The left of a curve that runs to the right is above it.
    editor.paint = (x, y) => (y < 100 ? [x / 400, 0, 0, 1] : [0, 0, 0.6, 1]);
    const pen = new PenTool(canvas);
    click(pen, [100, 100]);
    click(pen, [200, 100]);
    pen.leave();
    await pen.isDone;
    const { left, right } = made();
    expect(right.color).toEqual(stopsOf([0, { r: 0, g: 0, b: 0.6 }]));
    if (left.color.kind !== "stops") throw new Error("no stops");
    const { stops } = left.color;
    expect(stops.length).toBeLessThan(6);
    expect(stops[0].value.r).toBeCloseTo(0.25, 2);
    expect(stops.at(-1)?.value.r).toBeCloseTo(0.5, 2);
  });

  test("leave_a_side_open_beside_which_nothing_is", async () => {
    editor.paint = (_, y) => (y < 100 ? [1, 1, 1, 1] : [0, 0, 0, 0]);
    const pen = new PenTool(canvas);
    click(pen, [100, 100]);
    click(pen, [200, 100]);
    pen.leave();
    await pen.isDone;
    expect(made().left.color.kind).toBe("stops");
    expect(made().right.color).toEqual({ kind: "open" });
  });

  const drawnInto = async (items: Item[]) => {
    editor = fakeEditor(items);
    editor.layers = [];
    const pen = new PenTool(canvasOf(editor));
    click(pen, [100, 100]);
    click(pen, [200, 100]);
    pen.leave();
    await pen.isDone;
    return made();
  };

  test("are_two_that_can_be_told_apart_in_an_empty_drawing", async () => {
    const { left, right } = await drawnInto([layer("empty", [])]);
    expect([left.color.kind, right.color.kind]).toEqual(["stops", "stops"]);
    expect(left.color).not.toEqual(right.color);
  });

  test("are_none_in_an_empty_layer_above_a_picture", async () => {
    const { left, right } = await drawnInto([layer("empty", []), layer("picture", [horizon])]);
    expect([left.color.kind, right.color.kind]).toEqual(["open", "open"]);
  });

  test("do_not_hinder_drawing_where_the_engine_fails", async () => {
    editor.paint = () => {
      throw new Error("gone");
    };
    const pen = new PenTool(canvas);
    click(pen, [100, 100]);
    click(pen, [200, 100]);
    pen.leave();
    await pen.isDone;
    expect(editor.steps).toEqual(["draw curve"]);
  });
});

describe("the pencil", () => {
  const wave = Array.from({ length: 60 }, (_, k): Point => [
    20 + 4 * k,
    150 + 40 * Math.sin(k / 10),
  ]);

  test("draws_a_smooth_curve_near_the_hand_in_one_step", async () => {
    const pencil = new PencilTool(canvas);
    dragThrough(pencil, wave, { ctrl: true });
    await pencil.isDone;
    const [path] = made().paths;
    for (const at of wave) expect(nearestOn(path, at).distance).toBeLessThan(2.5);
    expect(path.points.length).toBeLessThan(wave.length);
    expect(editor.steps).toEqual(["draw curve"]);
  });

  test("closes_a_way_that_comes_back", async () => {
    const ring = Array.from({ length: 41 }, (_, k): Point => [
      150 + 60 * Math.cos(k * 0.157),
      150 + 60 * Math.sin(k * 0.157),
    ]);
    const pencil = new PencilTool(canvas);
    dragThrough(pencil, ring, { ctrl: true });
    await pencil.isDone;
    expect(made().paths[0].closed).toBe(true);
  });

  test("makes_nothing_of_a_dot_or_of_what_is_cancelled", async () => {
    const pencil = new PencilTool(canvas);
    dragThrough(pencil, [
      [50, 50],
      [51, 50],
    ]);
    begun(pencil, wave).cancel();
    await pencil.isDone;
    expect(editor.steps).toEqual([]);
    expect(canvas.sketch.value.draft).toBeNull();
  });

  test("ends_where_it_snaps_without_a_spike", async () => {
    const pencil = new PencilTool(canvas);
    for (const [from, to] of [[200, 294], [200, 306], [306, 200], [294, 200]]) {
      const steps = Array.from({ length: 30 }, (_, k): Point => [from + ((to - from) * k) / 29, 150]);
      dragThrough(pencil, steps);
      await pencil.isDone;
      const { points } = made().paths[0];
      const [first, last] = [points[0][0], points[points.length - 1][0]];
      expect(Math.abs(first - 300) < 1e-6 || Math.abs(last - 300) < 1e-6).toBe(true);
      const ways = points.slice(1).map(([x], k) => Math.sign(x - points[k][0]));
      expect(new Set(ways).size).toBe(1);
      expect(points).toHaveLength(4);
    }
  });

  test("closes_without_a_tooth_where_the_hand_falls_short_or_goes_too_far", async () => {
    const pencil = new PencilTool(canvas);
    for (const [turn, radius] of [[6.18, 60], [6.28, 60], [6.38, 60], [6.28, 66], [6.28, 54]]) {
      const ring = Array.from({ length: 80 }, (_, k): Point => {
        const [angle, r] = [(turn * k) / 79, 60 + ((radius - 60) * k) / 79];
        return [150 + r * Math.cos(angle), 150 + r * Math.sin(angle)];
      });
      dragThrough(pencil, ring, { ctrl: true });
      await pencil.isDone;
      const { points, closed } = made().paths[0];
      expect(closed).toBe(true);
      // Each piece leaves a node nearly in the direction in which the previous one arrived.
      for (let k = 0; k < points.length - 1; k += 3) {
        const before = points[k === 0 ? points.length - 2 : k - 1];
        const [a, b] = [minus(points[k], before), minus(points[k + 1], points[k])];
        const cosine = (a[0] * b[0] + a[1] * b[1]) / (Math.hypot(...a) * Math.hypot(...b));
        expect(cosine).toBeGreaterThan(0.8);
      }
    }
  });

  test("is_taken_back_by_undo_while_it_is_drawn", async () => {
    const pencil = new PencilTool(canvas);
    const drag = begun(pencil, wave.slice(0, 30));
    editor.draft.value!.undo();
    drag.move(press(wave[31]));
    drag.end(press(wave[31]));
    await pencil.isDone;
    expect([editor.steps, editor.draft.value, canvas.sketch.value.draft]).toEqual([[], null, null]);
  });

  test("uses_all_moments_between_two_events", async () => {
    const pencil = new PencilTool(canvas);
    const trail = wave.map((at, k) => ({ at, time: 8 * k, pressure: 0.5 }));
    const drag = begun(pencil, [wave[0]], { ctrl: true });
    drag.move(press(wave[wave.length - 1], { trail, ctrl: true }));
    drag.end(press(wave[wave.length - 1], { ctrl: true }));
    await pencil.isDone;
    expect(nearestOn(made().paths[0], wave[15]).distance).toBeLessThan(2.5);
  });

  test("has_a_corner_where_the_pointer_is_slow_also_within_one_event", async () => {
    const bend = (50 * Math.PI) / 180;
    const turning = Array.from({ length: 41 }, (_, k): Point => {
      const [before, after] = [Math.min(k, 20), Math.max(k - 20, 0)];
      return [20 + 5 * before + 5 * after * Math.cos(bend), 20 + 5 * after * Math.sin(bend)];
    });
    const hasCorner = async (pause: number) => {
      const pencil = new PencilTool(canvas);
      const timeOf = (k: number) => 8 * k + (k >= 20 ? pause : 0) + (k > 20 ? pause : 0);
      const trail = turning.map((at, k) => ({ at, time: timeOf(k), pressure: 0.5 }));
      const drag = begun(pencil, [turning[0]], { ctrl: true });
      drag.move(press(turning[40], { trail, ctrl: true }));
      drag.end(press(turning[40], { ctrl: true }));
      await pencil.isDone;
      const { points } = made().paths[0];
      return points.some(([x, y], k) => {
        if (k % 3 !== 0 || Math.hypot(x - 120, y - 20) > 5) return false;
        const [before, after] = [points[k - 1], points[k + 1]];
        return Math.abs((x - before[0]) * (after[1] - y) - (y - before[1]) * (after[0] - x)) > 1;
      });
    };
    expect(await hasCorner(200)).toBe(true);
    expect(await hasCorner(0)).toBe(false);
  });
});

describe("the stroke", () => {
  const way = Array.from({ length: 30 }, (_, k): Point => [40 + 5 * k, 60]);
  const stroke = () => editor.drawing.items.at(-1) as CurveItem;

  test("is_a_local_curve_that_is_there_while_it_is_drawn", () => {
    const tool = new StrokeTool(canvas);
    const drag = begun(tool, way, { ctrl: true });
    expect(stroke().kind).toBe("stroke");
    expect(stroke().radius).toEqual(stopsOf([0, 6]));
    drag.end(press(way[29], { ctrl: true }));
    expect(editor.steps).toEqual(["draw stroke"]);
  });

  test("goes_when_it_is_cancelled", () => {
    begun(new StrokeTool(canvas), way).cancel();
    expect(editor.drawing.items).toHaveLength(1);
    expect(editor.steps).toEqual([]);
  });

  test("is_as_wide_as_the_pen_presses", () => {
    const tool = new StrokeTool(canvas);
    const drag = tool.press(press(way[0], { kind: "pen", pressure: 0, ctrl: true }));
    way
      .slice(1)
      .forEach((at, k) =>
        drag.move(press(at, { kind: "pen", pressure: (k + 1) / 29, ctrl: true })),
      );
    drag.end(press(way[29], { kind: "pen", pressure: 1, ctrl: true }));
    const { radius } = stroke();
    if (radius.kind !== "stops") throw new Error("no stops");
    expect(radius.stops[0].value).toBeLessThan(2);
    expect(radius.stops.at(-1)?.value).toBeCloseTo(6, 6);
    expect(radius.stops.length).toBeLessThan(8);
  });
});

describe("the blur tool", () => {
  let blur: BlurTool;
  const side = (name: "left" | "right") => {
    const value = (editor.drawing.item(horizon.handle) as CurveItem)[name].blur;
    return value.kind === "stops"
      ? value.stops.map(({ offset, value: radius }) => [offset, radius])
      : [];
  };
  beforeEach(() => {
    blur = new BlurTool(canvas);
    editor.tool.value = "blur";
    editor.selection.value = [{ handle: horizon.handle, part: { kind: "whole" } }];
  });

  test("sets_the_radius_where_it_is_pulled_on_the_side_that_is_pulled", () => {
    // Down the screen, left is to the right.
    dragThrough(blur, [
      [300, 150],
      [310, 150],
      [340, 150],
    ]);
    expect(side("left")).toEqual([
      [0, 5],
      [0.5, 40],
      [1, 5],
    ]);
    expect(side("right")).toEqual([]);
    expect(editor.steps).toEqual(["change blur"]);
  });

  test("sets_both_sides_with_shift", () => {
    const drag = begun(blur, [
      [300, 150],
      [280, 150],
    ]);
    drag.move(press([280, 150], { shift: true }));
    drag.end(press([280, 150], { shift: true }));
    expect(side("left")).toEqual(side("right"));
    expect(side("left")).toEqual([[0, 20]]);
  });

  test("gives_all_of_a_side_the_radius_where_it_had_none", () => {
    dragThrough(blur, [
      [300, 150],
      [260, 150],
    ]);
    expect(side("right")).toEqual([[0, 40]]);
  });

  test("changes_a_stop_that_is_near_rather_than_making_one", () => {
    dragThrough(blur, [
      [300, 24],
      [330, 24],
    ]);
    expect(side("left")).toEqual([
      [0, 30],
      [1, 5],
    ]);
  });

  test("is_sharp_again_at_the_curve_and_never_below", () => {
    dragThrough(blur, [
      [300, 150],
      [340, 150],
      [301, 150],
    ]);
    expect(side("left")[1]).toEqual([0.5, 0]);
    dragThrough(blur, [
      [320, 150],
      [330, 150],
      [200, 150],
    ]);
    expect(side("left")[1]).toEqual([0.5, 0]);
    expect(side("right")).toEqual([]);
  });

  test("pulls_a_bracket_to_another_radius", () => {
    const bracket = canvas.marks.value.find(({ kind }) => kind === "bracket");
    if (!bracket) throw new Error("no bracket");
    const [x, y] = bracket.at;
    expect(x).toBeCloseTo(309, 6);
    dragThrough(blur, [
      [x, y],
      [x + 10, y],
      [350, y],
    ]);
    expect(side("left")).toEqual([
      [0, 50],
      [1, 5],
    ]);
  });

  test("puts_back_what_was_when_it_is_cancelled", () => {
    begun(blur, [
      [300, 150],
      [340, 150],
    ]).cancel();
    expect(side("left")).toEqual([
      [0, 5],
      [1, 5],
    ]);
    expect(canvas.sketch.value.tag).toBeNull();
  });
});
