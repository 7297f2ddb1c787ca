// From a stop to the colour it takes.
import type { Gesture, ViewState } from "../../app/types.js";
import type { Rgb } from "../../geometry/color.js";
import { rgbFromHex } from "../../geometry/colortext.js";
import type { Drawing, Outcome } from "../../model/types.js";
import * as en from "../../strings/en.js";
import type { Canvas } from "../canvas.js";
import { setSide } from "../edits.js";
import type { StopMark } from "../marks.js";
import { photoInSight, photoOf } from "../photo.js";
import { isCurve } from "../places.js";
import { photoColor } from "../sampled.js";
import { stopsOf, withValue, type Value } from "../sides.js";
import { NO_SKETCH } from "../sketch.js";
import { heldStill, pixelsOf, rgbOf, stillOf } from "../still.js";
import { colorAt } from "../taken.js";
import type { Lens } from "./lens.js";
import { isBeyond, type Drag, type Press } from "./tool.js";

/** The system's eyedropper, where there is one. */
interface EyeDropper {
  open(): Promise<{ readonly sRGBHex: string }>;
}

/**
 * Takes the photo's colour, else that of the picture as it was before, which the stop's new colours do
 * not change; a click asks the system.
 */
export class PickDrag implements Drag {
  readonly cursor = "sample";
  private gesture: Gesture | null = null;
  private latest = 0;
  private asked: Promise<void> = Promise.resolve();
  private readonly held: OffscreenCanvas | null;
  private readonly view: ViewState;

  constructor(
    private readonly canvas: Canvas,
    private readonly mark: StopMark,
    private readonly start: Press,
    private readonly lens: Lens,
  ) {
    this.held = heldStill(canvas.editor);
    this.view = canvas.editor.view.peek();
    this.look(start);
  }

  private look(p: Press): void {
    this.lens.look(p, null, this.mark.value as Rgb, this.still());
  }

  /** When the view has moved, the picture from before is of other places. */
  private still(): OffscreenCanvas | null {
    const { editor } = this.canvas;
    return editor.view.peek() === this.view ? this.held : stillOf(editor);
  }

  move(p: Press): void {
    const { canvas } = this;
    this.look(p);
    if (!this.gesture) {
      if (!isBeyond(this.start.at, p.at)) return;
      this.gesture = canvas.editor.gesture(en.tools.undo.pick);
      canvas.draw({ isFaded: true, dragged: { handle: this.mark.handle, part: this.mark.part } });
    }
    this.latest += 1;
    const turn = this.latest;
    this.asked = this.pick(p).then((color) => {
      // The latest wins: answers may come in any order.
      if (color && turn === this.latest) this.show(color);
    });
  }

  private async pick(p: Press): Promise<Rgb | null> {
    const { editor } = this.canvas;
    const point = this.canvas.toArtboard(p.at);
    const still = this.still();
    const pixels = still && pixelsOf(still, p.at, 0);
    const reference = photoInSight(editor, point);
    const photo = reference && (await photoOf(reference));
    const traced = photo && photoColor(photo, point);
    if (traced || pixels) return traced ?? rgbOf(pixels!);
    const item = editor.drawing.item(this.mark.handle);
    return item ? colorAt(editor, item, point) : null;
  }

  private show(color: Rgb): void {
    if (!this.gesture || this.gesture.isOver) return;
    this.gesture.show((before) => this.colored(before, color));
  }

  private colored(drawing: Drawing, color: Rgb): Outcome | null {
    const { handle, side, index } = this.mark;
    const item = drawing.item(handle);
    const list = isCurve(item) ? stopsOf(item, side, "color") : null;
    if (!isCurve(item) || !list?.stops[index]) return null;
    return setSide(drawing, item, side, "color", withValue<Value>(list, index, color));
  }

  end(): void {
    this.lens.close();
    const { gesture } = this;
    if (!gesture) {
      void this.askSystem();
      return;
    }
    void this.asked.then(() => {
      if (!gesture.isOver) gesture.keep();
      this.canvas.sketch.value = NO_SKETCH;
    });
  }

  private async askSystem(): Promise<void> {
    const { EyeDropper } = globalThis as { EyeDropper?: new () => EyeDropper };
    if (!EyeDropper) return;
    try {
      const color = rgbFromHex((await new EyeDropper().open()).sRGBHex);
      const { editor } = this.canvas;
      if (color) editor.run(en.tools.undo.pick, this.colored(editor.drawing, color));
    } catch {
      // It was left by Escape.
    }
  }

  cancel(): void {
    this.lens.close();
    this.latest += 1;
    if (this.gesture && !this.gesture.isOver) this.gesture.drop();
    this.canvas.sketch.value = NO_SKETCH;
  }
}
