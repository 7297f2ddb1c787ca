import { signal } from "@preact/signals";
import { beforeEach, describe, expect, test, vi } from "vitest";
import { pressKey, releaseKey } from "../../../../web/editor/src/canvas/keyboard.js";
import { Pointers } from "../../../../web/editor/src/canvas/pointers.js";
import type { Drag, Press, Tool } from "../../../../web/editor/src/canvas/tools/tool.js";
import type { Canvas } from "../../../../web/editor/src/canvas/canvas.js";
import { curve, layer, line } from "../support/drawing.js";
import { canvasOf, fakeEditor, type FakeEditor } from "../support/editor.js";
import { Hand } from "../support/pointer.js";
import { randomFrom } from "../random.js";

vi.mock(
  "../../../../web/editor/src/model/commands/index.js",
  async () => (await import("../support/drawing.js")).fakeCommands,
);

/** A tool that records its events. */
class Recorder implements Tool {
  readonly heard: string[] = [];
  last: Press | null = null;
  open = 0;

  hover(): "default" {
    this.heard.push("hover");
    return "default";
  }

  press(p: Press): Drag {
    this.heard.push(p.clicks === 2 ? "double" : "press");
    this.open += 1;
    const note = (word: string, ends: boolean) => (now?: Press) => {
      this.heard.push(word);
      if (now) this.last = now;
      if (ends) this.open -= 1;
    };
    return {
      move: note("move", false),
      end: note("end", true),
      cancel: note("cancel", true),
      keys: note("keys", false),
    };
  }
}

let editor: FakeEditor;
let canvas: Canvas;
let tool: Recorder;
let pointers: Pointers;

beforeEach(() => {
  editor = fakeEditor([layer("layer", [curve("a", [line([10, 10], [200, 10])])])]);
  canvas = canvasOf(editor);
  tool = new Recorder();
  pointers = new Pointers(canvas, () => tool);
});

test("the hand is where a file may have something, and anywhere on the artboard", () => {
  const at = (x: number, y: number, zoom: number) => {
    editor.view.value = { x, y, zoom };
    return canvas.toArtboard([editor.stage.value.width / 2, editor.stage.value.height / 2]);
  };
  expect(at(120, -3e6, 1)).toEqual([120, -3e6]);
  expect(at(9e9, -9e9, 1e-6)).toEqual([5e6, -5e6]);
  // Metres on a map.
  editor.drawing.artboard = [500_000, 5_300_000, 500_100, 5_300_100];
  expect(at(500_050, 5_300_070, 4)).toEqual([500_050, 5_300_070]);
});

const key = (name: string, more = {}) => ({
  key: name,
  shift: false,
  alt: false,
  ctrl: false,
  ...more,
});

describe("a mouse", () => {
  test("presses_drags_and_lets_go", () => {
    const hand = new Hand(pointers);
    hand.move([5, 5]);
    expect(hand.down([5, 5])).toBe(true);
    hand.move([20, 20]);
    hand.up([20, 20]);
    expect(tool.heard).toEqual(["hover", "press", "move", "end", "hover"]);
  });

  test("clicks_twice_where_it_is_quick_and_in_one_place", () => {
    const hand = new Hand(pointers);
    const click = (x: number) => {
      hand.down([x, 5]);
      hand.up([x, 5]);
    };
    click(5);
    click(6);
    click(6);
    click(60);
    hand.wait(1000);
    click(60);
    expect(tool.heard.filter((word) => word === "press" || word === "double")).toEqual([
      "press",
      "double",
      "press",
      "press",
      "press",
    ]);
  });

  test("with_the_middle_button_moves_the_picture_whatever_the_tool", () => {
    const hand = new Hand(pointers);
    hand.down([100, 100], { button: 1 });
    hand.move([130, 110], { button: 1 });
    hand.up([130, 110], { button: 1 });
    expect(editor.view.value).toEqual({ x: 170, y: 140, zoom: 1 });
    expect(tool.heard).toEqual(["hover"]);
  });

  test("with_the_right_button_does_nothing_here", () => {
    expect(new Hand(pointers).down([1, 1], { button: 2 })).toBe(false);
    expect(tool.heard).toEqual([]);
  });

  test("tells_where_it_is_in_artboard_units", () => {
    editor.view.value = { x: 100, y: 50, zoom: 2 };
    new Hand(pointers).move([220, 150]);
    expect(editor.pointer.value).toEqual([110, 50]);
    pointers.leave();
    expect(editor.pointer.value).toBeNull();
  });

  test("drags_the_picture_while_space_is_down", () => {
    const hand = new Hand(pointers);
    pressKey(canvas, pointers, tool, key(" "));
    expect(pointers.cursor.value).toBe("grab");
    hand.down([100, 100]);
    hand.move([90, 100]);
    releaseKey(pointers, tool, key(" "));
    hand.up([90, 100]);
    hand.down([90, 100]);
    expect(editor.view.value.x).toBe(210);
    expect(tool.heard).toContain("press");
  });
});

describe("a drag", () => {
  test("is_dropped_by_escape_and_hears_nothing_more", () => {
    const hand = new Hand(pointers);
    hand.down([5, 5]);
    hand.move([30, 30]);
    expect(pressKey(canvas, pointers, tool, key("Escape"))).toBe(true);
    hand.move([50, 50]);
    hand.up([50, 50]);
    expect(tool.heard.filter((word) => word !== "hover" && word !== "keys")).toEqual([
      "press",
      "move",
      "cancel",
    ]);
  });

  test.each(["lost", "cancelled"])("is_dropped_when_the_pointer_is_%s", () => {
    const hand = new Hand(pointers);
    hand.down([5, 5]);
    hand.move([30, 30]);
    pointers.lost(1);
    pointers.lost(1);
    hand.up([30, 30]);
    expect(tool.heard.filter((word) => word === "cancel")).toHaveLength(1);
    expect(tool.heard).not.toContain("end");
  });

  test("ends_once_though_the_capture_is_lost_after_it", () => {
    const hand = new Hand(pointers);
    hand.down([5, 5]);
    hand.up([5, 5]);
    pointers.lost(1);
    expect(tool.heard.filter((word) => word === "end" || word === "cancel")).toEqual(["end"]);
  });

  test("hears_keys_that_are_pressed_meanwhile", () => {
    const hand = new Hand(pointers);
    hand.down([5, 5]);
    hand.move([30, 30]);
    pressKey(canvas, pointers, tool, key("Shift", { shift: true }));
    expect(tool.last?.shift).toBe(true);
    expect(tool.last?.at).toEqual([30, 30]);
    releaseKey(pointers, tool, key("Shift"));
    expect(tool.last?.shift).toBe(false);
  });

  test("is_not_disturbed_by_another_pointer", () => {
    const [mouse, pen] = [new Hand(pointers), new Hand(pointers, "pen", 2)];
    mouse.down([5, 5]);
    expect(pen.down([50, 50])).toBe(false);
    pen.move([60, 60]);
    pen.up([60, 60]);
    mouse.up([6, 6]);
    expect(tool.heard.filter((word) => word !== "hover")).toEqual(["press", "end"]);
  });
});

describe("fingers", () => {
  const two = () => [new Hand(pointers, "touch", 11), new Hand(pointers, "touch", 12)] as const;

  test("one_draws", () => {
    const [one] = two();
    one.down([50, 50]);
    one.move([80, 80]);
    one.up([80, 80]);
    expect(tool.heard).toEqual(["press", "move", "end"]);
  });

  test("a_second_drops_what_the_first_does_and_both_move_the_picture", () => {
    const [one, other] = two();
    one.down([100, 100]);
    one.move([120, 100]);
    other.down([200, 100]);
    expect(tool.heard).toEqual(["press", "move", "cancel"]);
    one.move([110, 120]);
    other.move([190, 120]);
    expect(tool.heard).toEqual(["press", "move", "cancel"]);
    // The fingers were 80 apart with the middle at (160, 100); now they are 80 apart at (150, 120).
    expect(editor.view.value.zoom).toBeCloseTo(1, 9);
    expect(editor.view.value.x).toBeCloseTo(210, 9);
    expect(editor.view.value.y).toBeCloseTo(130, 9);
  });

  test("spread_zoom_about_their_middle", () => {
    const [one, other] = two();
    one.down([180, 150]);
    other.down([220, 150]);
    one.move([160, 150]);
    other.move([240, 150]);
    expect(editor.view.value.zoom).toBeCloseTo(2, 9);
    expect(editor.view.value.x).toBeCloseTo(200, 9);
  });

  test("that_moved_the_picture_do_not_draw_until_all_are_lifted", () => {
    const [one, other] = two();
    one.down([100, 100]);
    other.down([200, 100]);
    other.up([200, 100]);
    one.move([150, 150]);
    one.up([150, 150]);
    expect(tool.heard).toEqual(["press", "cancel"]);
    one.down([20, 20]);
    expect(tool.heard.at(-1)).toBe("press");
  });

  test("that_lie_down_after_a_pen_are_not_heard", () => {
    const pen = new Hand(pointers, "pen", 3);
    pen.down([10, 10]);
    pen.move([20, 20]);
    pen.up([20, 20]);
    const [palm] = two();
    palm.time = pen.time;
    expect(palm.down([300, 200])).toBe(false);
    palm.up([300, 200]);
    palm.wait(600);
    expect(palm.down([300, 200])).toBe(true);
    expect(tool.heard.filter((word) => word === "press")).toHaveLength(1);
  });

  test("move_the_picture_once_a_pen_was_seen", () => {
    const [one, other] = two();
    new Hand(pointers, "pen", 3).move([10, 10]);
    one.wait(600);
    one.down([100, 100]);
    one.move([130, 90]);
    one.up([130, 90]);
    expect(tool.heard).toEqual(["hover"]);
    expect([editor.view.value.x, editor.view.value.y]).toEqual([170, 160]);
    // Two fingers zoom as before, and the pen draws.
    one.down([180, 150]);
    other.wait(800);
    other.down([220, 150]);
    other.move([260, 150]);
    expect(editor.view.value.zoom).toBeCloseTo(2, 9);
    one.up([180, 150]);
    other.up([260, 150]);
    new Hand(pointers, "pen", 3).down([10, 10]);
    expect(tool.heard.at(-1)).toBe("press");
  });
});

test("whatever_comes_in_whatever_order_each_press_ends_once", () => {
  const next = randomFrom(5);
  for (let round = 0; round < 60; round += 1) {
    tool = new Recorder();
    pointers = new Pointers(canvas, () => tool);
    const hands = [
      new Hand(pointers, "mouse", 1),
      new Hand(pointers, "pen", 2),
      new Hand(pointers, "touch", 3),
      new Hand(pointers, "touch", 4),
    ];
    for (let step = 0; step < 200; step += 1) {
      const hand = hands[Math.floor(next() * hands.length)];
      hand.wait(next() * 300);
      const at = [next() * 400, next() * 300] as const;
      const act = Math.floor(next() * 7);
      if (act === 0) hand.down(at, { button: next() < 0.2 ? 1 : 0 });
      else if (act === 1) hand.up(at);
      else if (act === 2) pointers.lost(hand.id);
      else if (act === 3) pressKey(canvas, pointers, tool, key("Escape"));
      else if (act === 4) pressKey(canvas, pointers, tool, key(" "));
      else if (act === 5) releaseKey(pointers, tool, key(" "));
      else hand.move(at);
      expect(tool.open).toBeGreaterThanOrEqual(0);
      expect(tool.open).toBeLessThanOrEqual(1);
    }
    for (const hand of hands) pointers.lost(hand.id);
    expect(tool.open).toBe(0);
    expect(pointers.isDragging).toBe(false);
  }
});

describe("a tap of several fingers", () => {
  const fingers = (count: number) => Array.from({ length: count }, (_, i) => new Hand(pointers, "touch", 21 + i));
  const history = { undo: vi.fn(), redo: vi.fn(), say: vi.fn() };
  const labels = { undoLabel: signal<string | null>(null), redoLabel: signal<string | null>(null) };
  const said = () => history.say.mock.calls.map(([text]) => text as string);
  const calls = () => [history.undo.mock.calls.length, history.redo.mock.calls.length];

  beforeEach(() => {
    vi.clearAllMocks();
    labels.undoLabel.value = labels.redoLabel.value = null;
    Object.assign(editor, history, labels);
  });

  function tapBy(count: number, between: (all: Hand[]) => void = () => {}) {
    labels.undoLabel.value = "draw curve";
    labels.redoLabel.value = "move";
    const all = fingers(count);
    all.forEach((finger, i) => finger.down([40 * i, 50]));
    between(all);
    all.forEach((finger, i) => finger.up([40 * i, 50]));
  }

  test.each([
    [1, [0, 0], []],
    [2, [1, 0], ["Undone: draw curve"]],
    [3, [0, 1], ["Redone: move"]],
    [4, [0, 0], []],
  ] as const)("%d: undoes or redoes", (count, wanted, words) => {
    tapBy(count);
    expect(calls()).toEqual(wanted);
    expect(said()).toEqual(words);
    expect(tool.open).toBe(0);
    if (count > 1) expect(tool.heard).not.toContain("end");
  });

  test("that shakes a little is one, and does not move the picture", () => {
    const view = editor.view.value;
    tapBy(2, ([a, b]) => (a.move([4, 53]), b.move([44, 47])));
    expect(calls()).toEqual([1, 0]);
    expect(editor.view.value).toEqual(view);
  });

  test("that moves the picture is none", () => {
    tapBy(2, ([a]) => a.move([30, 50]));
    expect(calls()).toEqual([0, 0]);
  });

  test("that lasts is none", () => {
    tapBy(2, (all) => all.forEach((finger) => (finger.time += 400)));
    expect(calls()).toEqual([0, 0]);
  });

  test("that the system takes away is none", () => {
    tapBy(2, ([a]) => pointers.lost(a.id));
    expect(calls()).toEqual([0, 0]);
  });

  test("after a line was drawn is none", () => {
    const [a, b] = fingers(2);
    a.down([0, 0]);
    a.move([60, 0]);
    b.down([90, 0]);
    a.up([60, 0]);
    b.up([90, 0]);
    expect(calls()).toEqual([0, 0]);
  });

  test("says nothing where there is nothing to undo", () => {
    const [a, b] = fingers(2);
    a.down([0, 0]);
    b.down([90, 0]);
    a.up([0, 0]);
    b.up([90, 0]);
    expect([calls(), said()]).toEqual([[0, 0], []]);
  });
});
