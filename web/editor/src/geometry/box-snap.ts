// Boxes that snap to the edges and middles of other boxes while they are moved.
import type { Box, Point } from "./affine.js";

/** A line between boxes that are aligned; it spans both. */
export interface AlignedLine {
  readonly from: Point;
  readonly to: Point;
}

export interface BoxSnap {
  /** The movement that aligns the box. */
  readonly by: Point;
  readonly lines: readonly AlignedLine[];
}

/** Edges and middle of a box along an axis. */
const marksOf = (box: Box, axis: 0 | 1): readonly number[] => [
  box[axis],
  (box[axis] + box[axis + 2]) / 2,
  box[axis + 2],
];

/** Places of lines across x, and across y: they have no ends. */
export type Lines = readonly [readonly number[], readonly number[]];

interface Fit {
  readonly by: number;
  readonly at: number;
  /** null: it is a line. */
  readonly other: Box | null;
}

/** Returns the nearest mark of other boxes, or line, to a mark of a box; null: none is within reach. */
function nearest(box: Box, others: readonly Box[], lines: Lines, axis: 0 | 1, reach: number): Fit | null {
  let best: Fit | null = null;
  let least = reach;
  const compare = (at: number, other: Box | null) => {
    for (const own of marksOf(box, axis)) {
      const by = at - own;
      if (Math.abs(by) > least || (best && Math.abs(by) === least)) continue;
      [best, least] = [{ by, at, other }, Math.abs(by)];
    }
  };
  for (const other of others) for (const at of marksOf(other, axis)) compare(at, other);
  for (const at of lines[axis]) compare(at, null);
  return best;
}

/**
 * Aligns a box with others and with lines: its edges and its middle with theirs, in each direction with the
 * nearest one.
 * @param reach the largest distance over which it snaps
 */
export function snappedBox(box: Box, others: readonly Box[], reach: number, to: Lines = [[], []]): BoxSnap {
  const [x, y] = [nearest(box, others, to, 0, reach), nearest(box, others, to, 1, reach)];
  const by: Point = [x?.by ?? 0, y?.by ?? 0];
  const [x0, y0, x1, y1] = [box[0] + by[0], box[1] + by[1], box[2] + by[0], box[3] + by[1]];
  const lines: AlignedLine[] = [];
  if (x) {
    const [low, high] = [Math.min(y0, x.other?.[1] ?? y0), Math.max(y1, x.other?.[3] ?? y1)];
    lines.push({ from: [x.at, low], to: [x.at, high] });
  }
  if (y) {
    const [low, high] = [Math.min(x0, y.other?.[0] ?? x0), Math.max(x1, y.other?.[2] ?? x1)];
    lines.push({ from: [low, y.at], to: [high, y.at] });
  }
  return { by, lines };
}
