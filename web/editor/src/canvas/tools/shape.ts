// Rectangle, ellipse and polygon: a drag makes a filled shape.
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
import { isBeyond, type Drag, type KeyPress, type Press, type Tool } from "./tool.js";

/** A shape has at least this width and height, CSS pixels. */
const LEAST = 1;

export class ShapeTool implements Tool {
  constructor(
    private readonly canvas: Canvas,
    private readonly kind: ShapeKind,
  ) {}

  hover(p: Press): CursorName {
    const { canvas } = this;
    canvas.editor.hovered.value = null;
    canvas.draw({ guides: p.ctrl ? [] : canvas.snap(p.at, canvas.curves(), new Set()).guides });
    return "draw";
  }

  press(p: Press): Drag {
    return new ShapeDrag(this.canvas, this.kind, p);
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
  private isOver = false;

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
    const [x0, y0, x1, y1] = shape.box;
    if (Math.min(x1 - x0, y1 - y0) * editor.view.peek().zoom < LEAST) {
      editor.say(en.tools.dragShape[this.kind]);
      return;
    }
    const layer = editor.activeLayer?.handle ?? null;
    const made = addShape(editor.drawing, layer, shape, currentColor(editor.settings), editor.step(null));
    const isMade = editor.run(en.tools.undo.shape[this.kind], made);
    if (isMade) editor.announcement.value = `${en.panels.tool[this.kind]}, ${sizeOf(shape)}`;
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
