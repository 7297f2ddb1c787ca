// Lines through few points: as few of the given ones as keep within a tolerance of all (Douglas and Peucker's method),
// or a fixed number that is nearest to all.

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

/** Places of a knot that are tried first; then knots move in ever smaller steps. */
const COARSE = 16;
/** A share of the error: a smaller gain moves no knot, so that knots stay at the ends. And an error that is none. */
const NO_GAIN = 0.02;
const NO_ERROR = 1e-12;

interface Fit {
  readonly knots: readonly number[];
  /** The values at the knots. */
  readonly values: readonly number[][];
  /** The sum of the misses' fourth powers: one large miss counts more than many small ones. */
  readonly error: number;
}

/** Two of the values and the share of the second one: what the graph is at a row. */
type Between = readonly [before: number, after: number, share: number];

/** Returns where rows stand between knots. Beyond the first and the last knot the graph is constant. */
function betweens(rows: readonly Row[], knots: readonly number[], isRing: boolean): Between[] {
  const count = knots.length - (isRing ? 1 : 0);
  let next = 0;
  return rows.map(([at]) => {
    while (next < knots.length && rows[knots[next]][0] <= at) next += 1;
    const [before, after] = [Math.max(next - 1, 0), Math.min(next, knots.length - 1)];
    const [from, to] = [rows[knots[before]][0], rows[knots[after]][0]];
    return [before % count, after % count, to > from ? (at - from) / (to - from) : 0];
  });
}

/** Solves equations whose last columns are the right sides, one for each value. */
function solved(matrix: number[][], count: number): number[][] {
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < count; ++k) {
      const factor = k === i ? 0 : matrix[k][i] / matrix[i][i];
      for (let j = i; factor !== 0 && j < matrix[k].length; ++j) matrix[k][j] -= factor * matrix[i][j];
    }
  }
  return matrix.map((row, i) => row.slice(count).map((value) => value / row[i]));
}

/** Returns the values at knots by least squares. */
function valuesOf(rows: readonly Row[], places: readonly Between[], count: number): number[][] {
  const matrix = Array.from({ length: count }, () => new Array<number>(count + rows[0].length - 1).fill(0));
  rows.forEach((row, k) => {
    const [i, j, share] = places[k];
    for (const [knot, part] of [[i, 1 - share], [j, share]]) {
      matrix[knot][i] += part * (1 - share);
      matrix[knot][j] += part * share;
      for (let axis = 1; axis < row.length; ++axis) matrix[knot][count + axis - 1] += part * row[axis];
    }
  });
  return solved(matrix, count);
}

/** Fits the graph's values at some knots. @param isRing whether the last knot has the value of the first one */
function fitAt(rows: readonly Row[], knots: readonly number[], isRing: boolean): Fit {
  const places = betweens(rows, knots, isRing);
  const values = valuesOf(rows, places, knots.length - (isRing ? 1 : 0));
  let error = 0;
  rows.forEach((row, k) => {
    const [i, j, share] = places[k];
    let miss = 0;
    for (let axis = 1; axis < row.length; ++axis)
      miss += (values[i][axis - 1] * (1 - share) + values[j][axis - 1] * share - row[axis]) ** 2;
    error += miss * miss;
  });
  return { knots, values, error };
}

/** Every choice of ascending places among some. */
function* choices(places: readonly number[], count: number): Generator<readonly number[]> {
  if (count === 0) yield [];
  for (let k = 0; count > 0 && k < places.length; ++k) {
    for (const rest of choices(places.slice(k + 1), count - 1)) yield [places[k], ...rest];
  }
}

/** Each knot moves back, stays, or moves on. */
function movesOf(count: number, step: number): readonly (readonly number[])[] {
  if (count === 0) return [[]];
  return movesOf(count - 1, step).flatMap((rest) => [-step, 0, step].map((by) => [by, ...rest]));
}

const isBetter = (fit: Fit, than: Fit) => fit.error < than.error * (1 - NO_GAIN) - NO_ERROR;

/**
 * Returns the graph of straight lines between `count` knots that is nearest to a graph, rows of an ascending abscissa
 * and values. Knots stand at rows; fewer rows than knots are returned as they are.
 * @param isRing whether the graph ends as it begins: its first and last knot, which stand at its ends, count as one
 */
export function nearestGraph(rows: readonly Row[], count: number, isRing: boolean): readonly Row[] {
  const last = rows.length - 1;
  if (rows.length <= (isRing ? count + 1 : count)) return rows;
  const [low, high] = isRing ? [1, last - 1] : [0, last];
  const fit = (knots: readonly number[]) => fitAt(rows, isRing ? [0, ...knots, last] : knots, isRing);
  const stride = Math.ceil(rows.length / COARSE);
  const coarse = [...rows.keys()].filter((k) => k >= low && k <= high && (k % stride === 0 || k === last));
  const tried = [...choices(coarse, isRing ? count - 1 : count)].map(fit);
  let best = tried.reduce((a, b) => (isBetter(b, a) ? b : a));
  for (let step = stride; step >= 1;) {
    const now = isRing ? best.knots.slice(1, -1) : best.knots;
    const better = movesOf(now.length, step)
      .map((by) => now.map((knot, k) => knot + by[k]))
      .filter((knots) => knots.every((knot, k) => knot > (knots[k - 1] ?? low - 1) && knot <= high))
      .map(fit)
      .reduce((a, b) => (b.error < a.error ? b : a), best);
    if (isBetter(better, best)) best = better;
    else step >>= 1;
  }
  return best.knots.map((knot, k) => [rows[knot][0], ...best.values[k % best.values.length]]);
}
