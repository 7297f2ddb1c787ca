// Random user actions in any order: nothing throws, every text can be read, and undo restores the drawing.
import { effect } from "@preact/signals";
import { readFileSync } from "node:fs";
import { afterAll, expect, test } from "vitest";
import { copySelection, cutSelection, pasteText } from "../../../../web/editor/src/app/clipboard.js";
import { commandTable } from "../../../../web/editor/src/app/commands.js";
import { DrawingEditor } from "../../../../web/editor/src/app/editor.js";
import type { ToolName } from "../../../../web/editor/src/app/types.js";
import { Canvas } from "../../../../web/editor/src/canvas/canvas.js";
import { pressKey, releaseKey } from "../../../../web/editor/src/canvas/keyboard.js";
import { Pointers, type StagePointer } from "../../../../web/editor/src/canvas/pointers.js";
import { NO_SKETCH } from "../../../../web/editor/src/canvas/sketch.js";
import { makeTools } from "../../../../web/editor/src/canvas/tools/index.js";
import type { Engine } from "../../../../web/editor/src/engine/types.js";
import type { Point } from "../../../../web/editor/src/geometry/affine.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { Drawing } from "../../../../web/editor/src/model/types.js";
import { file, modulePath } from "../drawings.js";
import { Random } from "../random.js";

const open = (inner: string, more: string) =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" ${more}>${inner}</svg>`;
/** Returns curves of a drawing `s` times 100 units wide. */
const curves = (s: number) =>
  `<g id="l" sf:diffuse="true"><path id="a" d="M${10 * s} ${10 * s}C${30 * s} ${5 * s} ${60 * s} ${50 * s} ${90 * s} ${20 * s}" sf:left="#e33, #fd0" sf:right="#36c" sf:blur="${2 * s}"/>` +
  `<circle id="b" cx="${50 * s}" cy="${60 * s}" r="${15 * s}" sf:left="#fff" sf:right="#0a4"/></g>` +
  `<path id="st" d="M${5 * s} ${90 * s}L${80 * s} ${70 * s}" sf:radius="${4 * s}" sf:left="#f0f"/>`;

const DRAWINGS: Readonly<Record<string, string>> = {
  plain: open(curves(1), 'viewBox="0 0 100 100"'),
  empty: open("", 'viewBox="0 0 100 100"'),
  "one pixel": open(curves(0.01), 'width="1" height="1" viewBox="0 0 1 1"'),
  tiny: open(curves(1e-8), 'viewBox="0 0 1e-6 1e-6"'),
  large: open(curves(1e4), 'viewBox="0 0 1e6 1e6"'),
  "far away": open(`<g transform="translate(1000000 -2000000)">${curves(1)}</g>`, 'viewBox="1000000 -2000000 100 100"'),
  "of another system": `\ufeff<?xml version="1.0"?>\r\n${open(`\r\n\t<!-- x -->\r\n\t${curves(1)}\r\n`, 'viewBox="0 0 100 100"')}\r\n`,
  "of uses of uses": open(
    `<defs>${curves(0.5).replace(/id="(\w+)"/g, 'id="d$1"')}</defs><use id="u1" href="#dl" x="10"/>` +
      `<g id="gg" transform="rotate(20) scale(.7)"><use id="u2" href="#u1" y="60"/><use id="u3" href="#u2" transform="translate(60 0)"/></g>${curves(1)}`,
    'viewBox="0 0 100 100"',
  ),
  "of gradients": open(
    `<linearGradient id="gr" x1="0" x2="1"><stop offset="0" stop-color="red"/><stop offset="1" stop-color="blue" stop-opacity=".5"/></linearGradient>${curves(1).replace('"#fff"', '"url(#gr)"')}`,
    'viewBox="0 0 100 100"',
  ),
  "with styles": open(
    `<style>.k{opacity:.5;mix-blend-mode:multiply}</style><g class="k" transform="matrix(-1 0 .3 1 100 0)">${curves(1)}</g>`,
    'viewBox="0 0 100 100" style="background:#eee"',
  ),
  "of shapes": open(
    '<g id="l" sf:diffuse="true"><path id="s" d="M10 10h30v30h-30zM60 60l20 5 -5 20zM5 95a20 8 30 1 0 30-10" sf:left="red" sf:right="blue"/>' +
      '<ellipse cx="50%" cy="20" rx="8" ry="12" sf:left="#0ff" sf:right="#222"/><polygon points="70,10 90,10 80,30" sf:left="#0ff" sf:right="#222"/><line x1="2" y1="50" x2="98" y2="52" sf:left="#fa0"/></g>',
    'viewBox="0 0 100 100"',
  ),
};

/** Answers nothing: curves can be drawn even without colours and pictures. */
const deaf = {
  index: { serial: -1, curves: [] },
  show: () => 0,
  look: () => {},
  colors: () => Promise.reject(new Error("deaf")),
  lint: () => Promise.resolve(null),
};

const TOOLS: readonly ToolName[] = ["select", "nodes", "pen", "pencil", "stroke", "sample", "blur", "hand"];
const COMMANDS = [
  "undo", "undo", "redo", "duplicate", "delete", "select-all", "select-all", "deselect", "group", "ungroup", "bring-up", "send-down",
  "to-top", "to-bottom", "new-layer", "swap-sides", "reverse", "close-curve", "join", "make-instance", "make-unique", "corner",
  "smooth", "symmetric", "align-left", "align-middle", "flip-horizontal", "flip-vertical", "zoom-in", "zoom-out", "zoom-fit",
  "zoom-selection", "zoom-actual", "outlines", "grid", "snap", "show-color", "show-opacity", "show-blur", "hide-handles",
];
const KEYS = ["Tab", "Tab", "Enter", "Escape", "Delete", "ArrowLeft", "ArrowDown", "Backspace", " ", "a"];
const [WIDTH, HEIGHT] = [900, 700];

/** An editor with its stage, without a page, and random user actions on it. */
class Hand {
  readonly editor: DrawingEditor;
  private readonly canvas: Canvas;
  private readonly tools: ReturnType<typeof makeTools>;
  private readonly pointers: Pointers;
  private time = 0;
  private copied = "";
  readonly done: string[] = [];

  constructor(
    text: string,
    private readonly random: Random,
  ) {
    this.editor = new DrawingEditor(deaf as unknown as Engine, commandTable([]), text);
    const { editor } = this;
    editor.stage.value = { width: WIDTH, height: HEIGHT };
    editor.open(text, "any.svg");
    this.canvas = new Canvas(editor, editor.navigation);
    this.tools = makeTools(this.canvas);
    this.pointers = new Pointers(this.canvas, () => this.tools[editor.tool.peek()]);
    // The stage reads all marks.
    effect(() => void this.canvas.marks.value);
  }

  private place(): Point {
    const { random, canvas } = this;
    const marks = canvas.marks.peek();
    if (marks.length > 0 && random.chance(0.4)) return random.pick(marks).at;
    return random.chance(0.05) ? random.point(1e5) : [random.between(0, WIDTH), random.between(0, HEIGHT)];
  }

  private moment(at: Point, keys: Pick<StagePointer, "shift" | "alt" | "ctrl">, more: Partial<StagePointer> = {}): StagePointer {
    this.time += this.random.pick([5, 50, 900]);
    const pressure = this.random.next();
    return { id: 1, kind: "mouse", button: 0, at, pressure, time: this.time, trail: [{ at, time: this.time, pressure }], ...keys, ...more };
  }

  private keys() {
    const { random } = this;
    return { shift: random.chance(0.15), alt: random.chance(0.15), ctrl: random.chance(0.15) };
  }

  private stroke(moves: number) {
    const { random, pointers } = this;
    const keys = this.keys();
    const kind = random.pick(["mouse", "mouse", "pen", "touch"] as const);
    let at = this.place();
    pointers.down(this.moment(at, keys, { kind }));
    for (let k = 0; k < moves; k += 1) {
      at = random.chance(0.5) ? this.place() : [at[0] + random.between(-40, 40), at[1] + random.between(-40, 40)];
      pointers.move(this.moment(at, keys, { kind }));
      if (random.chance(0.04)) this.act();
    }
    if (random.chance(0.05)) pointers.lost(1);
    else pointers.up(this.moment(at, keys, { kind }));
  }

  private tool(name: ToolName) {
    const from = this.editor.tool.peek();
    this.editor.tool.value = name;
    if (name === from) return;
    this.pointers.cancel();
    this.tools[from].leave?.();
    this.canvas.sketch.value = NO_SKETCH;
  }

  private key(key: string) {
    const press = { key, ...this.keys() };
    const tool = this.tools[this.editor.tool.peek()];
    pressKey(this.canvas, this.pointers, tool, press);
    releaseKey(this.pointers, tool, press);
  }

  /** Does one random action and records it. */
  act() {
    const { random, editor, done } = this;
    const note = (...words: unknown[]) => void done.push(words.join(" "));
    const share = random.next();
    if (share < 0.4) {
      const moves = random.pick([0, 0, 1, 2, 5]);
      note("stroke", editor.tool.peek(), moves);
      this.stroke(moves);
    } else if (share < 0.55) {
      const key = random.pick(KEYS);
      note("key", key);
      this.key(key);
    } else if (share < 0.67) {
      const tool = random.pick(TOOLS);
      note("tool", tool);
      this.tool(tool);
    } else if (share < 0.92) {
      const command = random.pick(COMMANDS);
      note(command);
      editor.command(command);
    } else if (share < 0.95) {
      const factor = random.pick([1e-3, 0.5, 2, 1e3]);
      note("zoom", factor);
      editor.zoomBy(factor, this.place());
    } else {
      const what = random.pick(["copy", "cut", "paste", "paste"]);
      note(what);
      if (what === "paste") pasteText(editor, this.copied);
      else this.copied = what === "cut" ? cutSelection(editor) : copySelection(editor);
    }
  }

  /** Ends all actions in progress, and runs waiting work. */
  async rest() {
    this.tool("hand");
    this.tool("select");
    this.pointers.space(false);
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
}

const failures: unknown[] = [];
const fail = (reason: unknown) => void failures.push(reason);
process.on("unhandledRejection", fail);
afterAll(() => void process.off("unhandledRejection", fail));

/** Returns a function that gives the library's error for a text; "" if it can be drawn. */
async function reader() {
  const path = modulePath();
  if (!path) return () => "";
  const { loadSfumato } = await import(file("../../../web/wasm/sfumato.mjs"));
  const context = (await loadSfumato(readFileSync(path))).context();
  return (text: string) => {
    try {
      context.read(text).free();
      return "";
    } catch (error) {
      return String(error);
    }
  };
}

/** Returns all properties of a drawing, except handles. */
const said = (drawing: Drawing) =>
  [...drawing.all()].map((item) => {
    const { kind, name, artboardFromItem, element } = item;
    const sides = "paths" in item ? [item.paths, item.left, item.right] : [];
    return [kind, name, artboardFromItem, element.range, ...sides];
  });

test("the hand reaches no farther than a file may say", () => {
  const editor = new DrawingEditor(deaf as unknown as Engine, commandTable([]), DRAWINGS.plain);
  const canvas = new Canvas(editor, editor.navigation);
  editor.view.value = { x: 0, y: 0, zoom: 1e-4 };
  expect(canvas.toArtboard([1e6, -1e6])).toEqual([5e6, -5e6]);
});

/** SFUMATO_HOSTILE: how often each drawing is tried, for longer runs. */
const ROUNDS = Number(process.env.SFUMATO_HOSTILE ?? 6);
const STEPS = 60;

test.each(Object.keys(DRAWINGS))("a drawing %s survives any hand", async (name) => {
  const start = DRAWINGS[name];
  const read = await reader();
  let edits = 0;
  for (let round = 0; round < ROUNDS; round += 1) {
    const hand = new Hand(start, new Random(round * 101 + name.length));
    const { editor } = hand;
    const where = () => `${name}, round ${round}:\n${hand.done.join("\n")}\n${editor.drawing.text}`;
    try {
      for (let k = 0; k < STEPS; k += 1) hand.act();
      await hand.rest();
    } catch (error) {
      throw new Error(where(), { cause: error });
    }
    expect(failures, where()).toEqual([]);
    const end = editor.drawing.text;
    expect(/NaN|Infinity/.test(end), where()).toBe(false);
    expect(read(end), where()).toBe("");
    expect(said(openDrawing(end)), where()).toEqual(said(editor.drawing));
    let steps = 0;
    for (; editor.undoLabel.value !== null; steps += 1) editor.undo();
    expect(editor.drawing.text, where()).toBe(start);
    edits += steps;
    for (; steps > 0; steps -= 1) editor.redo();
    expect(editor.drawing.text, where()).toBe(end);
  }
  expect(edits).toBeGreaterThanOrEqual(3 * ROUNDS);
});
