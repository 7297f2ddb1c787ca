// Curves that are drawn and on their way into the drawing, one after another: their colours take time.
import type { CubicPath } from "../../geometry/cubic.js";
import type { Canvas } from "../canvas.js";
import { addCurve } from "../drawn.js";
import { NO_SKETCH } from "../sketch.js";

export class Finished {
  private queue: Promise<void> = Promise.resolve();

  /** @param label of the step of undo */
  constructor(
    private readonly canvas: Canvas,
    private readonly label: string,
  ) {}

  /** Shows a path of the artboard until it is in the drawing. */
  add(path: CubicPath): void {
    const { canvas } = this;
    const draft = { path, rubber: null, closes: false, hasNodes: false };
    canvas.sketch.value = { ...NO_SKETCH, draft };
    this.queue = this.queue.then(async () => {
      await addCurve(canvas.editor, path, this.label);
      if (canvas.sketch.peek().draft === draft) canvas.sketch.value = NO_SKETCH;
    });
    canvas.editor.awaitEdit(this.queue);
  }

  /** Settles when all of them are in the drawing. */
  get isDone(): Promise<void> {
    return this.queue;
  }
}
