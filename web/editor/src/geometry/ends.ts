// A line of points whose ends are moved: what is near an end follows it, so that no spike comes of it.
import type { Point } from "./affine.js";
import { distance } from "./vector.js";

/** How far along the line each point is from its beginning. */
function lengthsTo(points: readonly Point[]): number[] {
  const lengths = [0];
  for (let k = 1; k < points.length; k += 1)
    lengths.push(lengths[k - 1] + distance(points[k - 1], points[k]));
  return lengths;
}

/**
 * The points with the first at `begin` and the last at `end`. Points within `reach` of an end along
 * the line move with it, the less the farther they are.
 * @param begin null: the first point stays; `end` likewise
 * @param reach should be more than the ends are moved by: the line would turn back otherwise
 */
export function withEnds(
  points: readonly Point[],
  begin: Point | null,
  end: Point | null,
  reach: number,
): Point[] {
  const last = points.length - 1;
  const lengths = lengthsTo(points);
  const total = lengths[last];
  const most = Math.min(reach, total);
  const share = (length: number) => (most > 0 ? Math.max(1 - length / most, 0) : 0);
  return points.map(([x, y], k) => {
    if (k === last && end) return end;
    if (k === 0 && begin) return begin;
    const atBegin = begin ? share(lengths[k]) : 0;
    const atEnd = end ? share(total - lengths[k]) : 0;
    const by = (axis: 0 | 1) =>
      (begin ? atBegin * (begin[axis] - points[0][axis]) : 0) +
      (end ? atEnd * (end[axis] - points[last][axis]) : 0);
    return [x + by(0), y + by(1)];
  });
}
