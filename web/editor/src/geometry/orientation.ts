// The signed area that a closed path encloses.
import { isOpen, piecesOf, type CubicPath } from "./cubic.js";
import { cross, subtract } from "./vector.js";

/**
 * Returns the area inside a closed path, by Green's theorem: positive if the path runs clockwise on the
 * screen (y down). Loops that run the other way count negative.
 */
export function signedArea(path: CubicPath): number {
  const origin = path.points[0];
  let sum = 0;
  for (const piece of piecesOf(path)) {
    const [a, b, c, d] = piece.map((point) => subtract(point, origin));
    sum += 6 * (cross(a, b) + cross(c, d)) + 3 * (cross(a, c) + cross(b, c) + cross(b, d)) + cross(a, d);
  }
  return sum / 20;
}

/** An area that is smaller, as a share of the box around it, is rounding. */
const NO_AREA = 1e-9;

/**
 * Returns the side of closed paths that faces inside: -1 left, 1 right. Holes count with their outline if
 * they run the other way. Returns 0 if a path is open, or the paths enclose nothing.
 */
export function insideSign(paths: readonly CubicPath[]): -1 | 0 | 1 {
  if (paths.length === 0 || paths.some(isOpen)) return 0;
  const points = paths.flatMap((path) => path.points);
  const extent = [0, 1].map((k) => {
    const values = points.map((point) => point[k]);
    return values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
  });
  const area = paths.reduce((sum, path) => sum + signedArea(path), 0);
  if (!(Math.abs(area) > NO_AREA * extent[0] * extent[1])) return 0;
  return area > 0 ? 1 : -1;
}
