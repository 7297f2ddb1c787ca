// The loupe while the Sample tool is held: follows the pointer, and waits for the photo's pixels.
import type { Rgb } from "../../geometry/color.js";
import type { Canvas } from "../canvas.js";
import type { CurveHit } from "../hit.js";
import { loupeOf } from "../loupe.js";
import { photoInSight, photoOf, photoToTrace, type PlacedPhoto } from "../photo.js";
import type { Press } from "./tool.js";

export class Lens {
  private latest = 0;

  constructor(private readonly canvas: Canvas) {}

  /**
   * @param hit whose sides are sampled. @param old the stop's former colour
   * @param still the picture that is sampled; absent: the last one drawn
   */
  look({ at, kind }: Press, hit: CurveHit | null, old: Rgb | null = null, still: OffscreenCanvas | null = null): void {
    this.latest += 1;
    const turn = this.latest;
    const show = (photo: PlacedPhoto | null) => {
      if (turn === this.latest)
        this.canvas.draw({ loupe: loupeOf(this.canvas, { at, kind, photo, hit, old, still }) });
    };
    const { editor } = this.canvas;
    const point = this.canvas.toArtboard(at);
    const reference = hit ? photoToTrace(editor.drawing, point) : photoInSight(editor, point);
    if (reference) void photoOf(reference).then(show);
    else show(null);
  }

  close(): void {
    this.latest += 1;
    this.canvas.draw({ loupe: null });
  }
}
