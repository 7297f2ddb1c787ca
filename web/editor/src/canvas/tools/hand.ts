// Hand: the picture goes with the pointer.
import type { Canvas } from "../canvas.js";
import type { CursorName } from "../cursors.js";
import type { Drag, Press, Tool } from "./tool.js";

export class PanDrag implements Drag {
  readonly cursor: CursorName = "grabbing";
  private last: Press;

  constructor(
    private readonly canvas: Canvas,
    start: Press,
  ) {
    this.last = start;
  }

  move(p: Press): void {
    this.canvas.navigation.moveBy(p.at[0] - this.last.at[0], p.at[1] - this.last.at[1]);
    this.last = p;
  }

  end(): void {}

  cancel(): void {}
}

export class HandTool implements Tool {
  constructor(private readonly canvas: Canvas) {}

  hover(): CursorName {
    this.canvas.editor.hovered.value = null;
    return "grab";
  }

  press(p: Press): Drag {
    return new PanDrag(this.canvas, p);
  }
}
