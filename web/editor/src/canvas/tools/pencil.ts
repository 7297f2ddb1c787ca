// Pencil: draws a diffusion curve freely; it is smoothed when the hand lets go.
import { en } from "../../strings/en.js";
import type { Canvas } from "../canvas.js";
import type { CursorName } from "../cursors.js";
import { addCurve } from "../drawn.js";
import { NO_SKETCH } from "../sketch.js";
import { Way } from "./freehand.js";
import type { Drag, Press, Tool } from "./tool.js";

export class PencilTool implements Tool {
  private queue: Promise<void> = Promise.resolve();

  constructor(private readonly canvas: Canvas) {}

  hover(p: Press): CursorName {
    const { canvas } = this;
    canvas.editor.hovered.value = null;
    if (!p.ctrl) canvas.draw({ guides: canvas.snap(p.at, canvas.curves(), new Set()).guides });
    return "draw";
  }

  press(p: Press): Drag {
    const { canvas } = this;
    const way = new Way(canvas, p);
    const show = () => {
      const draft = { path: way.raw, rubber: null, closes: false, hasNodes: false };
      canvas.sketch.value = { ...NO_SKETCH, draft };
    };
    return {
      cursor: "draw",
      move: (now) => {
        way.add(now);
        show();
      },
      end: (now) => {
        way.finish(now);
        this.finish(way);
      },
      cancel: () => {
        canvas.sketch.value = NO_SKETCH;
      },
    };
  }

  /** Settles when what was drawn is in the document. */
  get isDone(): Promise<void> {
    return this.queue;
  }

  private finish(way: Way): void {
    const { canvas } = this;
    const fit = way.isDot ? null : way.fit(true);
    if (!fit) {
      canvas.sketch.value = NO_SKETCH;
      return;
    }
    const draft = { path: fit.path, rubber: null, closes: false, hasNodes: false };
    canvas.sketch.value = { ...NO_SKETCH, draft };
    this.queue = this.queue.then(async () => {
      await addCurve(canvas.editor, fit.path, en.tools.undo.pencil);
      if (canvas.sketch.peek().draft === draft) canvas.sketch.value = NO_SKETCH;
    });
  }
}
