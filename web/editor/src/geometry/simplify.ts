// Douglas and Peucker's method: as few of the points as keep within a tolerance of all.

type Row = readonly number[];

/**
 * The squared distance of a point from the line between two others, in any number of dimensions.
 */
function squaredDistance(row: Row, from: Row, to: Row): number {
  let along = 0;
  let length = 0;
  row.forEach((value, i) => {
    const step = to[i] - from[i];
    along += (value - from[i]) * step;
    length += step * step;
  });
  const share = length > 0 ? Math.min(Math.max(along / length, 0), 1) : 0;
  return row.reduce((sum, value, i) => sum + (value - from[i] - share * (to[i] - from[i])) ** 2, 0);
}

/** The same of values over an abscissa, the first number: how wrong the line's value is there. */
function squaredMiss(row: Row, from: Row, to: Row): number {
  const width = to[0] - from[0];
  const share = width > 0 ? (row[0] - from[0]) / width : 0;
  let sum = 0;
  for (let i = 1; i < row.length; ++i) {
    sum += (row[i] - from[i] - share * (to[i] - from[i])) ** 2;
  }
  return sum;
}

function kept(rows: readonly Row[], tolerance: number, measure: typeof squaredMiss): number[] {
  if (rows.length < 2) return rows.map((_, i) => i);
  const keep = new Set([0, rows.length - 1]);
  const spans: [number, number][] = [[0, rows.length - 1]];
  for (let span = spans.pop(); span; span = spans.pop()) {
    const [from, to] = span;
    let farthest = from;
    let most = tolerance * tolerance;
    for (let i = from + 1; i < to; ++i) {
      const miss = measure(rows[i], rows[from], rows[to]);
      if (miss > most) [farthest, most] = [i, miss];
    }
    if (farthest === from) continue;
    keep.add(farthest);
    spans.push([from, farthest], [farthest, to]);
  }
  return [...keep].sort((a, b) => a - b);
}

/**
 * Indices of the points to keep: no point is farther than `tolerance` from the line through these.
 */
export function simplified(points: readonly Row[], tolerance: number): number[] {
  return kept(points, tolerance, squaredDistance);
}

/**
 * The same of a graph, rows of an ascending abscissa and values: at the abscissa of each row the
 * values between those kept are within `tolerance` of its own.
 */
export function simplifiedGraph(rows: readonly Row[], tolerance: number): number[] {
  return kept(rows, tolerance, squaredMiss);
}
