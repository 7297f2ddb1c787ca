// The editor's state: previews of gestures, results of undo, and requests to the engine.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { DrawingEditor } from "../../../web/editor/src/app/editor.js";
import type { Engine, LayerCurves, QuickChange } from "../../../web/editor/src/engine/types.js";
import { addLayer, deleteItems, restack, setHidden } from "../../../web/editor/src/model/commands/index.js";
import type { Drawing, Outcome } from "../../../web/editor/src/model/types.js";
import { setAttribute, sf } from "../../../web/editor/src/source/attributes.js";

const text = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 200 150">
  <g id="layer" sf:diffuse="true">
    <path id="a" d="M0 0 L10 10" sf:left="red" sf:right="blue"/>
    <path id="b" d="M0 20 L10 30" sf:left="red" sf:right="blue"/>
  </g>
</svg>`;

/** Records its calls. */
class NotedEngine {
  shown: { text: string; moving: boolean; quick: readonly QuickChange[] | undefined }[] = [];
  index = { serial: -1, curves: [] as Engine["index"]["curves"] };
  onPicture = () => {};
  onStatus: Engine["onStatus"] = () => {};
  show(shown: string, moving: boolean, quick?: readonly QuickChange[]) {
    this.shown.push({ text: shown, moving, quick });
    return this.shown.length - 1;
  }
  look() {}
  expected: (string | null)[] = [];
  expect(curves: LayerCurves | null) {
    this.expected.push(curves && `${curves.layer} ${curves.curves}`);
  }
  colors = async () => new Float32Array();
  free() {}

  /** Returns the state as the worker has read the last text. */
  read() {
    const last = this.shown.at(-1)!.text;
    const offsets = [...last.matchAll(/<path/g)].map(({ index }) => index);
    const curves = offsets.map((offset, curve) => ({ layer: 0, curve, offset, subpath: 0 }));
    this.index = { serial: this.shown.length - 1, curves };
  }
}

let engine: NotedEngine;
let editor: DrawingEditor;
const handleOf = (id: string) => [...editor.drawing.all()].find(({ name }) => name === id)!.handle;

/** Returns an outcome that writes path data. */
const bent = (drawing: Drawing, id: string, d: string): Outcome => {
  const item = [...drawing.all()].find(({ name }) => name === id)!;
  return { patch: setAttribute(drawing.text, item.element, "d", d) };
};

beforeEach(() => {
  engine = new NotedEngine();
  editor = new DrawingEditor(engine as unknown as Engine, new Map(), text);
  editor.open(text, "test.svg");
  engine.read();
});

it("commands that are asked for before there are any are done in their order when they come", () => {
  const early = new DrawingEditor(engine as unknown as Engine, null, text);
  const done: string[] = [];
  early.command("a");
  early.command("b");
  early.command("nobody's");
  expect(done).toEqual([]);
  early.learn(new Map(["a", "b"].map((name) => [name, () => void done.push(name)])));
  expect(done).toEqual(["a", "b"]);
  early.command("a");
  expect(done).toEqual(["a", "b", "a"]);
});

describe("an isolated layer", () => {
  const two = text.replace("</svg>", `  <g id="top" sf:diffuse="true"><path id="c" d="M0 0 L9 9" sf:left="red" sf:right="blue"/></g>\n</svg>`);
  const isolated = () => editor.isolated.value !== null && editor.drawing.item(editor.isolated.value)?.name;
  beforeEach(() => {
    editor.open(two, "two.svg");
    editor.isolate(handleOf("layer"));
  });

  it("stays isolated when it moves in the stack, and when that is undone and done again", () => {
    expect(isolated()).toBe("layer");
    editor.run("move", restack(editor.drawing, [handleOf("layer")], 1));
    expect(editor.drawing.items.map(({ name }) => name)).toEqual(["top", "layer"]);
    expect(isolated()).toBe("layer");
    editor.undo();
    expect([editor.drawing.text, isolated()]).toEqual([two, "layer"]);
    editor.redo();
    expect(isolated()).toBe("layer");
    editor.run("bend", bent(editor.drawing, "a", "M1 1L5 5"));
    expect(isolated()).toBe("layer");
  });

  it("takes new curves, whatever is selected", () => {
    editor.selection.value = [{ handle: handleOf("top"), part: { kind: "whole" } }];
    expect(editor.activeLayer?.name).toBe("layer");
    editor.isolate(null);
    expect(editor.activeLayer?.name).toBe("top");
  });

  it("is no longer isolated when it is hidden, deleted, or another object is made", () => {
    editor.run("hide", setHidden(editor.drawing, [handleOf("layer")], true));
    expect(isolated()).toBe(false);
    editor.undo();
    expect(isolated()).toBe(false);
    editor.isolate(handleOf("layer"));
    editor.run("delete", deleteItems(editor.drawing, [handleOf("layer")]));
    expect(isolated()).toBe(false);
    editor.undo();
    editor.isolate(handleOf("layer"));
    editor.run("new", addLayer(editor.drawing, null, ""));
    expect(isolated()).toBe(false);
  });

  it("cannot be a hidden one, nor one that is not there", () => {
    editor.isolate(null);
    editor.run("hide", setHidden(editor.drawing, [handleOf("top")], true));
    editor.isolate(handleOf("top"));
    editor.run("show", setHidden(editor.drawing, [handleOf("top")], false));
    expect(isolated()).toBe(false);
    editor.isolate(123456);
    expect(isolated()).toBe(false);
  });
});

describe("the engine", () => {
  const exact = () => engine.onStatus({ kind: "exact", milliseconds: 0 });
  const rest = () => vi.advanceTimersByTime(200);
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it("hears which curve the hand points at, or what is selected, once it rests there", () => {
    exact();
    editor.hovered.value = handleOf("a");
    editor.hovered.value = handleOf("b");
    expect(engine.expected).toEqual([]);
    rest();
    editor.selection.value = [{ handle: handleOf("a"), part: { kind: "whole" } }];
    rest();
    editor.hovered.value = null;
    rest();
    editor.selection.value = [];
    rest();
    expect(engine.expected).toEqual(["0 1", "0 1", "0 0", null]);
  });

  it("hears of all curves that move together, where they are in one layer", () => {
    exact();
    const whole = ["b", "a"].map((id) => ({ handle: handleOf(id), part: { kind: "whole" } as const }));
    editor.selection.value = whole;
    rest();
    editor.hovered.value = handleOf("a");
    rest();
    editor.selection.value = [whole[0]];
    rest();
    expect(engine.expected).toEqual(["0 0,1", "0 0,1", "0 0"]);
  });

  it("hears of it anew with each exact picture, and not before", () => {
    editor.hovered.value = handleOf("a");
    rest();
    expect(engine.expected).toEqual([]);
    exact();
    rest();
    engine.onStatus({ kind: "refining", milliseconds: 0 });
    rest();
    exact();
    rest();
    expect(engine.expected).toEqual(["0 0", "0 0"]);
  });
});

describe("gestures", () => {
  it("show each look from the start, and are one step", () => {
    const gesture = editor.gesture("bend");
    for (const y of [20, 30, 40]) gesture.show((before) => bent(before, "a", `M0 0 L10 ${y}`));
    expect(editor.drawing.text).toContain('d="M0 0 L10 40"');
    gesture.keep();
    expect(editor.undoLabel.value).toBe("bend");
    editor.undo();
    expect(editor.drawing.text).toBe(text);
    editor.redo();
    expect(editor.drawing.text).toContain('d="M0 0 L10 40"');
  });

  it("that are dropped leave nothing", () => {
    const gesture = editor.gesture("bend");
    gesture.show((before) => bent(before, "a", "M0 0 L10 40"));
    gesture.drop();
    gesture.show((before) => bent(before, "a", "M0 0 L1 1"));
    gesture.keep();
    expect(editor.drawing.text).toBe(text);
    expect(editor.undoLabel.value).toBeNull();
    expect(engine.shown.at(-1)!.text).toBe(text);
  });

  it("that are open when something else is done are a step before it", () => {
    const gesture = editor.gesture("bend");
    gesture.show((before) => bent(before, "a", "M0 0 L10 40"));
    const shown = editor.drawing.text;
    editor.run("other", bent(editor.drawing, "b", "M0 20 L5 5"));
    expect(gesture.isOver).toBe(true);
    editor.undo();
    expect(editor.drawing.text).toBe(shown);
    editor.undo();
    expect(editor.drawing.text).toBe(text);
  });

  it("that are open are what undo takes back", () => {
    const gesture = editor.gesture("bend");
    gesture.show((before) => bent(before, "a", "M0 0 L10 40"));
    editor.undo();
    expect(editor.drawing.text).toBe(text);
    gesture.show((before) => bent(before, "a", "M0 0 L1 1"));
    expect(editor.drawing.text).toBe(text);
  });

  it("that show nothing at last leave nothing", () => {
    const gesture = editor.gesture("bend");
    gesture.show((before) => bent(before, "a", "M0 0 L10 40"));
    gesture.show(() => null);
    gesture.keep();
    expect(editor.drawing.text).toBe(text);
    expect(editor.undoLabel.value).toBeNull();
  });

  it("tell the engine numbers, where one curve moves", () => {
    const gesture = editor.gesture("bend");
    gesture.show((before) => bent(before, "b", "M0 20 L10 60"));
    const { moving, quick } = engine.shown.at(-1)!;
    expect(moving).toBe(true);
    expect(quick).toHaveLength(1);
    expect(quick![0]).toMatchObject({ kind: "points", layer: 0, curve: 1 });
    expect([...(quick![0] as { xy: Float64Array }).xy.slice(-2)]).toEqual([10, 60]);
    gesture.show((before) => ({
      patch: setAttribute(before.text, before.item(handleOf("a"))!.element, sf("left"), "lime, red 25%"),
    }));
    const changes = engine.shown.at(-1)!.quick!;
    expect(changes.map(({ kind, curve }) => [kind, curve])).toEqual([["points", 1], ["stops", 0]]);
    gesture.keep();
    expect(engine.shown.at(-1)).toMatchObject({ moving: false });
  });

  it("tell the engine the text, where structure changes", () => {
    const at = editor.drawing.text.indexOf("  </g>");
    editor.run("add", { patch: [{ at, removed: "", inserted: '<path id="c" d="M0 0 L1 1"/>' }] });
    expect(engine.shown.at(-1)!.quick).toBeUndefined();
  });
});

describe("selection", () => {
  it("of an outcome is by places, and comes back with undo and redo", () => {
    editor.selection.value = [{ handle: handleOf("b"), part: { kind: "node", path: 0, index: 1 } }];
    const { range } = editor.drawing.item(handleOf("b"))!.element;
    const removed = editor.drawing.text.slice(range.start, range.end);
    editor.run("delete", { patch: [{ at: range.start, removed, inserted: "" }] });
    expect(editor.selection.value).toEqual([]);
    editor.undo();
    expect(editor.selection.value).toEqual([
      { handle: handleOf("b"), part: { kind: "node", path: 0, index: 1 } },
    ]);
    editor.redo();
    expect(editor.selection.value).toEqual([]);
  });
});

describe("documents", () => {
  it("that cannot be read leave the one that is open", () => {
    expect(() => editor.open("<svg>", "broken.svg")).toThrow(/Line 1/);
    expect(editor.drawing.text).toBe(text);
    expect(editor.file.value.name).toBe("test.svg");
  });

  it("begin with their own undo", () => {
    editor.run("bend", bent(editor.drawing, "a", "M0 0 L5 5"));
    editor.open(text.replace("red", "lime"), "other.svg");
    editor.undo();
    expect(editor.drawing.text).toContain("lime");
    expect(editor.file.value).toMatchObject({ name: "other.svg", isChanged: false });
  });
});

describe("steps that follow each other quickly", () => {
  const choose = (id: string) => {
    editor.selection.value = [{ handle: handleOf(id), part: { kind: "whole" } }];
  };
  const nudge = (id: string, d: string) => editor.run("move", bent(editor.drawing, id, d), "nudge");

  it("are one step of undo where they are of one object", () => {
    choose("a");
    for (const y of [11, 12, 13]) nudge("a", `M0 0 L10 ${y}`);
    editor.undo();
    expect(editor.drawing.text).toBe(text);
  });

  it("are a step each where they are of different objects", () => {
    choose("a");
    nudge("a", "M0 0 L10 11");
    choose("b");
    nudge("b", "M0 20 L10 31");
    editor.undo();
    expect(editor.drawing.text).toBe(text.replace("L10 10", "L10 11"));
    editor.undo();
    expect(editor.drawing.text).toBe(text);
  });

  it("are a step each where another part of the object is chosen", () => {
    const stop = (index: number) => {
      const part = { kind: "stop", side: "left", attribute: "color", index } as const;
      editor.selection.value = [{ handle: handleOf("a"), part }];
    };
    stop(0);
    nudge("a", "M0 0 L10 11");
    stop(1);
    nudge("a", "M0 0 L10 12");
    editor.undo();
    expect(editor.drawing.text).toBe(text.replace("L10 10", "L10 11"));
  });
});

describe("a tool's draft", () => {
  const draft = (undoLabel: string | null, redoLabel: string | null) => ({
    undoLabel,
    redoLabel,
    undo: vi.fn(),
    redo: vi.fn(),
    finish: vi.fn(() => void (editor.draft.value = null)),
    drop: vi.fn(() => void (editor.draft.value = null)),
  });

  it("has undo and redo for itself, and their labels", () => {
    editor.run("bend", bent(editor.drawing, "a", "M0 0 L10 20"));
    const own = (editor.draft.value = draft("set node", null));
    expect([editor.undoLabel.value, editor.redoLabel.value]).toEqual(["set node", null]);
    editor.undo();
    editor.redo();
    expect(own.undo).toHaveBeenCalledTimes(1);
    expect(own.redo).not.toHaveBeenCalled();
    expect(editor.drawing.text).toContain("L10 20");
  });

  it("that is empty lets undo through, and ends", () => {
    editor.run("bend", bent(editor.drawing, "a", "M0 0 L10 20"));
    const own = (editor.draft.value = draft(null, "set node"));
    expect([editor.undoLabel.value, editor.redoLabel.value]).toEqual(["bend", "set node"]);
    editor.redo();
    expect(own.redo).toHaveBeenCalledTimes(1);
    editor.undo();
    expect(editor.drawing.text).toBe(text);
    expect(editor.redoLabel.value).toBe("bend");
  });

  it("is completed, with all edits on their way, before the text is taken", async () => {
    const own = (editor.draft.value = draft("set node", null));
    own.finish.mockImplementation(() => {
      const drawn = Promise.resolve().then(() => editor.run("draw", bent(editor.drawing, "b", "M0 20 L10 40")));
      editor.awaitEdit(drawn);
    });
    await editor.completeEdits(1000);
    expect(editor.drawing.text).toContain("M0 20 L10 40");
  });

  it("delays nobody for longer than is allowed", async () => {
    editor.awaitEdit(new Promise(() => undefined));
    await editor.completeEdits(1);
    expect(editor.drawing.text).toBe(text);
  });

  it("ends where another drawing is opened", () => {
    const own = (editor.draft.value = draft("set node", null));
    editor.open(text, "other.svg");
    expect(own.drop).toHaveBeenCalledTimes(1);
  });
});

it("undo waits for an edit that is on its way, and takes that back", async () => {
  editor.run("bend", bent(editor.drawing, "a", "M0 0 L10 20"));
  const coming = Promise.resolve().then(() => editor.run("draw", bent(editor.drawing, "b", "M0 20 L10 40")));
  editor.awaitEdit(coming);
  editor.undo();
  await coming;
  await Promise.resolve();
  await Promise.resolve();
  expect(editor.redoLabel.value).toBe("draw");
  expect(editor.drawing.text).toContain("L10 20");
  expect(editor.drawing.text).not.toContain("L10 40");
});

describe("hints", () => {
  const hint = { rule: "crossing", message: "they cross" };
  let answer: unknown[] | null = [];
  const lint = vi.fn(async () => answer);
  beforeEach(() => {
    vi.useFakeTimers();
    (engine as unknown as { lint: unknown }).lint = lint;
    answer = [];
  });
  afterEach(() => void vi.useRealTimers());
  const rest = async () => {
    engine.onStatus({ kind: "exact", milliseconds: 0 });
    await vi.advanceTimersByTimeAsync(1500);
  };

  it("are known where the drawing as it is was looked at", async () => {
    expect(editor.hintsKnown.value).toBe(false);
    await rest();
    expect(editor.hintsKnown.value).toBe(true);
    editor.run("bend", bent(editor.drawing, "a", "M0 0 L10 20"));
    expect(editor.hintsKnown.value).toBe(false);
    await rest();
    expect(editor.hintsKnown.value).toBe(true);
    editor.open(text, "other.svg");
    expect(editor.hintsKnown.value).toBe(false);
  });

  it("of a drawing that has changed since are not taken", async () => {
    answer = [hint];
    lint.mockImplementationOnce(async () => {
      editor.run("bend", bent(editor.drawing, "a", "M0 0 L10 20"));
      return answer;
    });
    await rest();
    expect([editor.hints.value, editor.hintsKnown.value]).toEqual([[], false]);
  });

  it("that nobody could look for are not known", async () => {
    answer = null;
    await rest();
    expect(editor.hintsKnown.value).toBe(false);
  });
});

describe("a drawing that is opened", () => {
  it("tells where its pictures begin", () => {
    const before = editor.opened.value;
    editor.run("bend", bent(editor.drawing, "a", "M0 0 L10 20"));
    expect(editor.opened.value).toBe(before);
    editor.open(text, "other.svg");
    expect(editor.opened.value).toBe(engine.shown.length - 1);
  });

  it("says so where it cannot be drawn, but not where only an edit cannot", () => {
    const unseen = vi.fn();
    editor.onUnseen = unseen;
    const problem = { kind: "problem", reason: "too many", line: 1, column: 1 } as const;
    engine.onStatus({ kind: "exact", milliseconds: 0 });
    engine.onStatus(problem);
    expect(unseen).not.toHaveBeenCalled();
    editor.open(text, "other.svg");
    engine.onStatus(problem);
    expect(unseen).toHaveBeenCalledTimes(1);
  });
});
