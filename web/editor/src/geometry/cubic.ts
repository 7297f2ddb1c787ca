// contract: curves as cubic Bézier pieces.
import type { Point } from "./affine.js";

/**
 * A piecewise cubic: 3 n + 1 control points, of which every third lies on the curve. Piece i has
 * control points 3 i to 3 i + 3, and is the i-th segment that stop offsets "@i" count.
 */
export interface CubicPath {
  readonly points: readonly Point[];
  /** Whether the path ends by Z; the last point then equals the first. */
  readonly closed: boolean;
}
