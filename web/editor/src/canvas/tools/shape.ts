// Rectangle, ellipse and polygon: a drag makes a filled shape, and so do keys.
import { currentColor } from "../../app/colors.js";
import { FEWEST_SIDES, MOST_SIDES } from "../../app/settings.js";
import type { Point } from "../../geometry/affine.js";
import { hexOf } from "../../geometry/colortext.js";
import {
  boxOfDrag,
  outlineOf,
  regularRatio,
  type DrawnShape,
  type ShapeKind,
} from "../../geometry/drawn-shape.js";
import { add, subtract } from "../../geometry/vector.js";
import { addShape } from "../../model/commands/index.js";
import * as en from "../../strings/en.js";
import type { Canvas } from "../canvas.js";
import type { CursorName } from "../cursors.js";
import { shown } from "../format.js";
import type { CurveGrid } from "../hit.js";
import { NO_SKETCH } from "../sketch.js";
import { Caret } from "./caret.js";
import { isBeyond, type Drag, type KeyPress, type Modifiers, type Press, type Tool } from "./tool.js";

/** A shape has at least this width and height, CSS pixels. */
const LEAST = 1;

export class ShapeTool implements Tool {
  private readonly caret: Caret;
  /** The shape that was begun by keys last. */
  private begun: ShapeDrag | null = null;

  constructor(
    private readonly canvas: Canvas,
    private readonly kind: ShapeKind,
  ) {
    this.caret = new Caret(canvas, en.panels.tool[kind]);
  }

  /** The shape that keys are drawing, or null. */
  private get drawn(): ShapeDrag | null {
    return this.begun?.isOver === false ? this.begun : null;
  }

  hover(p: Press): CursorName {
    const { canvas } = this;
    if (this.drawn) return "draw";
    this.caret.hide();
    canvas.editor.hovered.value = null;
    canvas.draw({ guides: p.ctrl ? [] : canvas.snap(p.at, canvas.curves(), new Set()).guides });
    return "draw";
  }

  press(p: Press): Drag {
    this.leave();
    return new ShapeDrag(this.canvas, this.kind, p);
  }

  /** Arrows move a corner where nothing is selected; Enter or Space sets the first one, then the second. */
  key(pressed: KeyPress): boolean {
    const { key, shift, alt, ctrl } = pressed;
    const { caret, drawn, canvas } = this;
    const isFree = drawn ? !ctrl : !ctrl && !alt && canvas.editor.selection.peek().length === 0;
    if (isFree && caret.move(key, shift)) return this.follow(pressed);
    if (key === "Escape" && drawn) this.leave();
    else if ((key === "Enter" || key === " ") && caret.at) this.setCorner(pressed);
    else return false;
    return true;
  }

  modifiers(now: Modifiers): void {
    const { at } = this.caret;
    if (at) this.drawn?.keys(this.pressAt(at, now));
  }

  leave(): void {
    this.drawn?.cancel();
    this.caret.hide();
  }

  private follow(now: Modifiers): true {
    this.drawn?.move(this.pressAt(this.caret.at!, now));
    if (this.drawn) this.canvas.editor.announcement.value = this.drawn.name;
    return true;
  }

  private setCorner(now: Modifiers): void {
    const { canvas, drawn } = this;
    const at = this.pressAt(this.caret.at!, now);
    if (!drawn) {
      this.begun = new ShapeDrag(canvas, this.kind, at);
      canvas.editor.announcement.value = en.tools.firstCorner;
    } else if (drawn.isFlat) canvas.editor.say(en.tools.flatShape);
    else {
      drawn.end(at);
      this.caret.hide();
    }
  }

  /** The corner that keys move, as a pointer. It moves by whole steps: it does not snap. */
  private pressAt(point: Point, { shift, alt }: Modifiers): Press {
    const at = this.canvas.toStage(point);
    return { at, time: 0, trail: [], pressure: 0, kind: "mouse", shift, alt, ctrl: true, clicks: 1 };
  }
}

/** Shift: regular. Alt: from the middle. Space moves the shape. Arrows change the sides of a polygon. */
class ShapeDrag implements Drag {
  readonly cursor = "draw";
  private readonly grid: CurveGrid;
  /** Where the drag began, and where it is, artboard units. */
  private from: Point;
  private to: Point;
  private last: Press;
  private isSpace = false;
  isOver = false;

  constructor(
    private readonly canvas: Canvas,
    private readonly kind: ShapeKind,
    private readonly start: Press,
  ) {
    this.grid = canvas.curves();
    this.last = start;
    this.from = this.to = this.placeOf(start);
    const drop = () => this.cancel();
    canvas.editor.draft.value = {
      undoLabel: en.tools.undo.shape[kind],
      redoLabel: null,
      undo: drop,
      redo: () => undefined,
      // While the pointer is down, there is no shape yet.
      finish: drop,
      drop,
    };
  }

  /** Returns the place of the pointer, where it snaps. Shift decides one coordinate: then nothing snaps. */
  private placeOf(p: Press): Point {
    const { canvas } = this;
    const isFree = p.ctrl || (p.shift && p !== this.start);
    const { at, guides } = isFree ? { at: p.at, guides: [] } : canvas.snap(p.at, this.grid, new Set());
    canvas.draw({ guides });
    return canvas.toArtboard(at);
  }

  private shapeOf({ shift, alt }: Press): DrawnShape {
    const { kind } = this;
    const sides = this.canvas.editor.settings.polygonSides.peek();
    const ratio = shift ? regularRatio({ kind, sides }) : null;
    return { kind, sides, box: boxOfDrag(this.from, this.to, { ratio, isCentred: alt }) };
  }

  /** What a screen reader announces: the kind and the size. */
  get name(): string {
    return `${en.panels.tool[this.kind]}, ${sizeOf(this.shapeOf(this.last))}`;
  }

  /** Whether the shape has no width or no height. */
  get isFlat(): boolean {
    const [x0, y0, x1, y1] = this.shapeOf(this.last).box;
    return Math.min(x1 - x0, y1 - y0) * this.canvas.editor.view.peek().zoom < LEAST;
  }

  private get isClick(): boolean {
    return !isBeyond(this.start.at, this.last.at);
  }

  move(p: Press): void {
    if (this.isOver) return;
    if (this.isSpace) {
      const by = subtract(this.canvas.toArtboard(p.at), this.canvas.toArtboard(this.last.at));
      [this.from, this.to] = [add(this.from, by), add(this.to, by)];
    } else this.to = this.placeOf(p);
    this.last = p;
    this.show();
  }

  private show(): void {
    const { canvas } = this;
    if (this.isClick) return canvas.draw({ draft: null, tag: null });
    const shape = this.shapeOf(this.last);
    const path = outlineOf(shape);
    const fill = hexOf(currentColor(canvas.editor.settings));
    const draft = path && { path, rubber: null, closes: false, hasNodes: false, fill };
    canvas.draw({ draft, tag: { at: this.last.at, text: sizeOf(shape) } });
  }

  keys(p: Press): void {
    this.move({ ...p, at: this.last.at });
  }

  space(isDown: boolean): void {
    this.isSpace = isDown;
  }

  key({ key }: KeyPress): boolean {
    const by = { ArrowUp: 1, ArrowDown: -1 }[key];
    if (this.kind !== "polygon" || by === undefined) return false;
    const { polygonSides } = this.canvas.editor.settings;
    polygonSides.value = Math.min(Math.max(polygonSides.peek() + by, FEWEST_SIDES), MOST_SIDES);
    this.show();
    return true;
  }

  end(p: Press): void {
    if (this.isOver) return;
    const { editor } = this.canvas;
    this.last = { ...p, at: this.last.at };
    this.leave();
    const shape = this.shapeOf(this.last);
    if (this.isFlat) {
      editor.say(en.tools.dragShape[this.kind]);
      return;
    }
    const layer = editor.activeLayer?.handle ?? null;
    const made = addShape(editor.drawing, layer, shape, currentColor(editor.settings), editor.step(null));
    const isMade = editor.run(en.tools.undo.shape[this.kind], made);
    if (isMade) editor.announcement.value = this.name;
  }

  cancel(): void {
    if (!this.isOver) this.leave();
  }

  private leave(): void {
    this.isOver = true;
    this.canvas.editor.draft.value = null;
    this.canvas.sketch.value = NO_SKETCH;
  }
}

function sizeOf({ box: [x0, y0, x1, y1] }: DrawnShape): string {
  return en.canvas.size(shown(x1 - x0), shown(y1 - y0));
}
