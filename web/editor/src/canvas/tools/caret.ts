// The point that arrows move: a pointer for those who have none.
import type { Point } from "../../geometry/affine.js";
import * as en from "../../strings/en.js";
import type { Canvas } from "../canvas.js";
import { shown } from "../format.js";

/** CSS pixels of an arrow, and with Shift; of the ring that shows it. */
const STEP = 10;
const LARGE_STEP = 50;
const RING = 5;

const WAYS: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

export class Caret {
  /** Artboard units; null: it is not there. */
  at: Point | null = null;

  /** @param name of the tool, for screen readers */
  constructor(
    private readonly canvas: Canvas,
    private readonly name: string,
  ) {}

  /** It begins in the middle of the stage. @returns whether the key is an arrow */
  move(key: string, isLarge: boolean): boolean {
    const way = WAYS[key];
    if (!way) return false;
    const { canvas } = this;
    const { width, height } = canvas.editor.stage.peek();
    const [x, y] = this.at ? canvas.toStage(this.at) : [width / 2, height / 2];
    const step = isLarge ? LARGE_STEP : STEP;
    const within = (value: number, most: number) => Math.min(Math.max(value, 0), most);
    const to: Point = [within(x + way[0] * step, width), within(y + way[1] * step, height)];
    this.at = canvas.toArtboard(to);
    canvas.draw({ brush: { at: to, radius: RING } });
    const [px, py] = this.at;
    canvas.editor.announcement.value = en.canvas.at(this.name, shown(px), shown(py));
    return true;
  }

  hide(): void {
    if (!this.at) return;
    this.at = null;
    this.canvas.draw({ brush: null });
  }
}
