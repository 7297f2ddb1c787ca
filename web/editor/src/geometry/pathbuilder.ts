// Subpaths from the commands of a path, by the engine's rules (src/formats/svg/shapes/path.cpp): the same pieces,
// bit for bit except for the sine of an arc's rotation.
import type { Point } from "./affine.js";
import { arcPieces } from "./arc.js";
import type { CubicPath } from "./cubic.js";
import { distance, lerp } from "./vector.js";

/** Closing lines shorter than this share of the coordinates are what rounding left over. */
const CLOSING_SHARE = 1e-12;

/** Whether Z, from `current`, draws no line to `begin`. */
export function closesWithoutLine(current: Point, begin: Point): boolean {
  const extent = Math.max(...[...current, ...begin].map(Math.abs));
  return distance(current, begin) <= CLOSING_SHARE * extent;
}

export class PathBuilder {
  /** Subpaths that have a segment, in order. */
  readonly done: CubicPath[] = [];
  current: Point = [0, 0];
  /** The point to which close() draws. */
  begin: Point = [0, 0];
  #points: Point[] = [];
  #segments: number[] = [];
  #isMoved = false;

  /** Segments of the subpath that is being drawn. */
  get openSegments(): number {
    return this.#segments.length;
  }

  moveTo(point: Point): void {
    this.finish();
    this.current = this.begin = point;
    this.#isMoved = true;
  }

  lineTo(point: Point): void {
    const { current } = this;
    this.cubicTo(lerp(current, point, 1 / 3), lerp(point, current, 1 / 3), point);
  }

  quadraticTo(control: Point, point: Point): void {
    const { current } = this;
    this.cubicTo(lerp(current, control, 2 / 3), lerp(point, control, 2 / 3), point);
  }

  cubicTo(control1: Point, control2: Point, point: Point): void {
    this.#beginSegment();
    this.#add(control1, control2, point);
  }

  arcTo(radii: Point, degrees: number, large: boolean, sweep: boolean, point: Point): void {
    const pieces = arcPieces(this.current, radii, degrees, large, sweep, point);
    if (!pieces) return this.lineTo(point);
    this.#beginSegment();
    for (const [control1, control2, end] of pieces) this.#add(control1, control2, end);
  }

  /** @returns whether it drew a line */
  close(): boolean {
    let hasDrawn = this.#isMoved;
    if (this.#isMoved) this.lineTo(this.begin);
    const count = this.#points.length;
    if (count > 0) {
      if (closesWithoutLine(this.current, this.begin)) {
        this.#points[count - 1] = this.begin;
      } else {
        this.lineTo(this.begin);
        hasDrawn = true;
      }
    }
    this.finish(true);
    this.current = this.begin;
    return hasDrawn;
  }

  /** Ends the subpath; the next begins where this one ended. */
  finish(closed = false): void {
    if (this.#points.length === 0) return;
    const pieces = (this.#points.length - 1) / 3;
    const segments = [...this.#segments, pieces];
    const path = { points: this.#points, closed };
    this.done.push(segments.length === pieces + 1 ? path : { ...path, segments });
    this.#points = [];
    this.#segments = [];
  }

  #beginSegment(): void {
    this.#isMoved = false;
    if (this.#points.length === 0) this.#points.push(this.current);
    this.#segments.push((this.#points.length - 1) / 3);
  }

  #add(control1: Point, control2: Point, point: Point): void {
    this.#points.push(control1, control2, point);
    this.current = point;
  }
}
