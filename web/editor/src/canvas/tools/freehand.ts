// What pencil and stroke have in common: the hand's way, and the curve that is fitted to it.
import type { Point } from "../../geometry/affine.js";
import { lineBetween, type CubicPath } from "../../geometry/cubic.js";
import { fitStroke, type Fit, type Sample } from "../../geometry/fit.js";
import type { Canvas } from "../canvas.js";
import type { CurveGrid } from "../hit.js";
import type { Press } from "./tool.js";

/** A way that comes back so near to its beginning is closed, CSS pixels; and how long it has to be. */
const CLOSING = 8;
const LEAST_LOOP = 40;

/** Collects points of a pointer, in artboard units; the first and the last snap. */
export class Way {
  private readonly samples: Sample[] = [];
  private readonly grid: CurveGrid;
  private length = 0;
  private last: Point;

  constructor(
    private readonly canvas: Canvas,
    start: Press,
  ) {
    this.grid = canvas.curves();
    this.last = start.at;
    this.samples.push(this.sample(this.snapped(start), start.pressure));
  }

  private snapped(p: Press): Point {
    return p.ctrl ? p.at : this.canvas.snap(p.at, this.grid, new Set()).at;
  }

  private sample(at: Point, pressure: number): Sample {
    return { point: this.canvas.toArtboard(at), pressure, time: performance.now() };
  }

  add(p: Press): void {
    for (const { at, pressure } of p.trail) {
      this.length += Math.hypot(at[0] - this.last[0], at[1] - this.last[1]);
      this.last = at;
      this.samples.push(this.sample(at, pressure));
    }
  }

  /** The end comes to where it snaps. */
  finish(p: Press): void {
    const end = this.snapped(p);
    if (end !== p.at)
      this.samples.push(this.sample(end, this.samples[this.samples.length - 1].pressure));
  }

  /** Whether it is too short to be anything. */
  get isDot(): boolean {
    return this.length < CLOSING / 2;
  }

  private get isLoop(): boolean {
    const [x, y] = this.canvas.toStage(this.samples[0].point);
    return this.length > LEAST_LOOP && Math.hypot(this.last[0] - x, this.last[1] - y) < CLOSING;
  }

  /** The curve through it, within the smoothing that is set; null: it is a point. */
  fit(mayClose: boolean): Fit | null {
    const { settings, view } = this.canvas.editor;
    return fitStroke(
      this.samples,
      settings.smoothing.peek() / view.peek().zoom,
      mayClose && this.isLoop,
    );
  }

  /** The way itself: straight from point to point, as the hand went. */
  get raw(): CubicPath {
    const points: Point[] = [this.samples[0].point];
    for (let k = 1; k < this.samples.length; k += 1) {
      const [a, b] = [this.samples[k - 1].point, this.samples[k].point];
      points.push(...lineBetween(a, b).slice(1));
    }
    return { points, closed: false };
  }
}
