// Samples of a drawn line.
import type { Point } from "./affine.js";

/** A point of a stroke, as in a pointer event. */
export interface Sample {
  readonly point: Point;
  /** Milliseconds. */
  readonly time: number;
  /** 0 to 1. */
  readonly pressure: number;
}
