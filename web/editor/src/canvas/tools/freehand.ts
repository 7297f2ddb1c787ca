// Shared by pencil and stroke: the path of the pointer, and the curve that is fitted to it.
import type { Point } from "../../geometry/affine.js";
import { lineBetween, type CubicPath } from "../../geometry/cubic.js";
import { fitStroke, type Fit } from "../../geometry/fit.js";
import type { Sample } from "../../geometry/sample.js";
import { withEnds } from "../../geometry/ends.js";
import type { Canvas } from "../canvas.js";
import type { CurveGrid } from "../hit.js";
import type { Press, TrailPoint } from "./tool.js";

/** A way that comes back so near to its beginning is closed, CSS pixels; and how long it has to be. */
const CLOSING = 8;
const LEAST_LOOP = 40;

/** From where an end snaps to, this much of the way bends towards it, CSS pixels. */
const BEND = 20;

/** Collects points of a pointer, in artboard units; the first and the last snap. */
export class Way {
  /** The points of the pointer's path. */
  private readonly raw: Sample[] = [];
  private readonly grid: CurveGrid;
  private length = 0;
  private last: Point;
  /** Where the ends snap to, artboard units; null: the end stays. */
  private begin: Point | null;
  private end: Point | null = null;

  constructor(
    private readonly canvas: Canvas,
    start: Press,
  ) {
    this.grid = canvas.curves();
    this.last = start.at;
    this.raw.push(this.sample(start));
    this.begin = this.snapped(start);
  }

  private snapped(p: Press): Point | null {
    if (p.ctrl) return null;
    const { at } = this.canvas.snap(p.at, this.grid, new Set());
    return at === p.at ? null : this.canvas.toArtboard(at);
  }

  private sample({ at, time, pressure }: TrailPoint): Sample {
    return { point: this.canvas.toArtboard(at), time, pressure };
  }

  add(p: Press): void {
    for (const moment of p.trail) {
      const { at } = moment;
      this.length += Math.hypot(at[0] - this.last[0], at[1] - this.last[1]);
      this.last = at;
      this.raw.push(this.sample(moment));
    }
  }

  /** The end comes to where it snaps. */
  finish(p: Press): void {
    this.end = this.snapped(p);
  }

  /** Whether it is too short to be anything. */
  get isDot(): boolean {
    return this.length < CLOSING / 2;
  }

  private get isLoop(): boolean {
    const [x, y] = this.canvas.toStage(this.begin ?? this.raw[0].point);
    return this.length > LEAST_LOOP && Math.hypot(this.last[0] - x, this.last[1] - y) < CLOSING;
  }

  /** The samples with their ends where these snap to, of a loop at one place. */
  private samples(isLoop: boolean): readonly Sample[] {
    const begin = this.begin ?? this.raw[0].point;
    const end = isLoop ? begin : this.end;
    const points = this.raw.map(({ point }) => point);
    const bent = withEnds(points, this.begin, end, BEND / this.canvas.editor.view.peek().zoom);
    return this.raw.map((sample, k) => ({ ...sample, point: bent[k] }));
  }

  /** The curve through it, within the smoothing that is set; null: it is a point. */
  fit(mayClose: boolean): Fit | null {
    const { settings, view } = this.canvas.editor;
    const isLoop = mayClose && this.isLoop;
    return fitStroke(this.samples(isLoop), settings.smoothing.peek() / view.peek().zoom, isLoop);
  }

  /** Returns the pointer's path itself: straight from point to point. */
  get path(): CubicPath {
    const [first, ...rest] = this.samples(false).map(({ point }) => point);
    const points: Point[] = [first];
    for (const point of rest) points.push(...lineBetween(points[points.length - 1], point).slice(1));
    return { points, closed: false };
  }
}
