// Stroke: a local curve, as wide as the pen presses.
import { fractionAtParameter, pathLength } from "../../geometry/length.js";
import { pressureStops, type Fit } from "../../geometry/fit.js";
import type { Gesture } from "../../app/types.js";
import * as en from "../../strings/en.js";
import type { Canvas } from "../canvas.js";
import type { CursorName } from "../cursors.js";
import { strokeOutcome } from "../drawn.js";
import { NO_SKETCH } from "../sketch.js";
import { Way } from "./freehand.js";
import type { Drag, Press, Tool } from "./tool.js";

/** How far pressure may be from what a stop says, of 1. */
const PRESSURE_TOLERANCE = 0.06;
/** The share of the full radius at zero pressure. */
const THINNEST = 0.15;

export class StrokeTool implements Tool {
  constructor(private readonly canvas: Canvas) {}

  hover(p: Press): CursorName {
    const { editor } = this.canvas;
    editor.hovered.value = null;
    const radius = editor.settings.strokeRadius.value * editor.view.peek().zoom;
    this.canvas.draw({ brush: { at: p.at, radius } });
    return "draw";
  }

  leave(): void {
    this.canvas.draw({ brush: null });
  }

  press(p: Press): Drag {
    return new StrokeDrag(this.canvas, p);
  }
}

class StrokeDrag implements Drag {
  readonly cursor = "draw";
  private readonly way: Way;
  private gesture: Gesture | null = null;

  constructor(
    private readonly canvas: Canvas,
    private readonly start: Press,
  ) {
    this.way = new Way(canvas, start);
  }

  move(p: Press): void {
    this.way.add(p);
    this.show();
  }

  /** The stroke itself, as it would be kept now. */
  private show(): void {
    const { editor } = this.canvas;
    const fit = this.way.isDot ? null : this.way.fit(false);
    if (!fit) return;
    this.gesture ??= editor.gesture(en.tools.undo.stroke);
    this.canvas.draw({ brush: null, isFaded: true });
    this.gesture.show((before) => strokeOutcome(editor, before, fit.path, this.radii(fit)));
  }

  /** A mouse and a finger always press alike. */
  private radii(fit: Fit): { offset: number; value: number }[] {
    const full = this.canvas.editor.settings.strokeRadius.peek();
    if (this.start.kind !== "pen" || !(pathLength(fit.path) > 0))
      return [{ offset: 0, value: full }];
    return pressureStops(fit, PRESSURE_TOLERANCE).map(([place, pressure]) => ({
      // As precise as a hand-drawn line: a thousandth of the way, three figures of the radius.
      offset: Number(fractionAtParameter(fit.path, place).toFixed(3)),
      value: Number((full * (THINNEST + (1 - THINNEST) * pressure)).toPrecision(3)),
    }));
  }

  end(p: Press): void {
    this.way.finish(p);
    this.show();
    this.gesture?.keep();
    this.canvas.sketch.value = NO_SKETCH;
  }

  cancel(): void {
    this.gesture?.drop();
    this.canvas.sketch.value = NO_SKETCH;
  }
}
