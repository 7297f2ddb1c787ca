// Pencil: draws a diffusion curve freely; the curve is smoothed when the pointer is released.
import * as en from "../../strings/en.js";
import type { Canvas } from "../canvas.js";
import type { CursorName } from "../cursors.js";
import { NO_SKETCH } from "../sketch.js";
import { Finished } from "./finished.js";
import { Way } from "./freehand.js";
import type { Drag, Press, Tool } from "./tool.js";

export class PencilTool implements Tool {
  private readonly finished: Finished;

  constructor(private readonly canvas: Canvas) {
    this.finished = new Finished(canvas, en.tools.undo.pencil);
  }

  hover(p: Press): CursorName {
    const { canvas } = this;
    canvas.editor.hovered.value = null;
    if (!p.ctrl) canvas.draw({ guides: canvas.snap(p.at, canvas.curves(), new Set()).guides });
    return "draw";
  }

  press(p: Press): Drag {
    return new PencilDrag(this.canvas, this.finished, p);
  }

  /** Settles when what was drawn is in the document. */
  get isDone(): Promise<void> {
    return this.finished.isDone;
  }
}

/** Undo takes the line back that is being drawn. */
class PencilDrag implements Drag {
  readonly cursor = "draw";
  private readonly way: Way;
  private isOver = false;

  constructor(
    private readonly canvas: Canvas,
    private readonly finished: Finished,
    start: Press,
  ) {
    this.way = new Way(canvas, start);
    const drop = () => this.cancel();
    canvas.editor.draft.value = {
      undoLabel: en.tools.undo.pencil,
      redoLabel: null,
      undo: drop,
      redo: () => undefined,
      // While the pointer is down, the line is no curve yet.
      finish: drop,
      drop,
    };
  }

  move(now: Press): void {
    if (this.isOver) return;
    this.way.add(now);
    const draft = { path: this.way.path, rubber: null, closes: false, hasNodes: false };
    this.canvas.sketch.value = { ...NO_SKETCH, draft };
  }

  end(now: Press): void {
    if (this.isOver) return;
    this.leave();
    this.way.finish(now);
    const fit = this.way.isDot ? null : this.way.fit(true);
    if (fit) this.finished.add(fit.path);
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
