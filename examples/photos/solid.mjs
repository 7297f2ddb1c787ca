// Solids of revolution: vases, bowls and fruit. A profile becomes a grid of signed distances,
// through which rays march.

const SPAN = 24;  // chords between two points
const STEPS = 300;  // of a ray that passes a solid

/** A cubic B-spline, which has no jumps of curvature; a point that stands thrice is a corner. */
function smooth(points) {
  const line = [points[0]];
  for (let i = -1; i < points.length; ++i) {
    const [a, b, c, d] = [i - 1, i, i + 1, i + 2]
      .map((k) => points[Math.min(points.length - 1, Math.max(0, k))]);
    for (let k = 0; k < SPAN; ++k) {
      const t = k / SPAN;
      const weight = [(1 - t) ** 3, 3 * t ** 3 - 6 * t * t + 4, -3 * t ** 3 + 3 * t * t + 3 * t + 1,
        t ** 3];
      line.push([0, 1].map((n) => (weight[0] * a[n] + weight[1] * b[n] + weight[2] * c[n] +
        weight[3] * d[n]) / 6));
    }
  }
  line.push(points.at(-1));
  return line.filter((p, i) => i === 0 || p[0] !== line[i - 1][0] || p[1] !== line[i - 1][1]);
}

/** The signed distance from (r, y) to the outline of a profile, below 0 inside. */
function distance(line, r, y) {
  let [nearest, inside] = [Infinity, false];
  for (let i = 0; i + 1 < line.length; ++i) {
    const [[ax, ay], [bx, by]] = [line[i], line[i + 1]];
    const [ex, ey, px, py] = [bx - ax, by - ay, r - ax, y - ay];
    const t = Math.min(1, Math.max(0, (px * ex + py * ey) / (ex * ex + ey * ey || 1)));
    nearest = Math.min(nearest, (px - t * ex) ** 2 + (py - t * ey) ** 2);
    if (ay > y !== by > y && r < ax + ((y - ay) / ey) * ex) inside = !inside;
  }
  return inside ? -Math.sqrt(nearest) : Math.sqrt(nearest);
}

/**
 * Returns the solid of a profile turned about the y axis: points [radius, y] from axis to axis.
 */
export function turned(points) {
  const line = smooth(points).map(([r, y]) => [Math.max(0, r), y]);
  const low = Math.min(...line.map((p) => p[1]));
  const high = Math.max(...line.map((p) => p[1]));
  const wide = Math.max(...line.map((p) => p[0]));
  const cell = Math.max(high - low, wide) / 220;
  const [columns, rows] = [Math.ceil(wide / cell) + 6, Math.ceil((high - low) / cell) + 10];
  const bottom = low - 5 * cell;
  const grid = new Float32Array(columns * rows);
  for (let j = 0; j < rows; ++j) {
    for (let i = 0; i < columns; ++i) {
      grid[j * columns + i] = distance(line, i * cell, bottom + j * cell);
    }
  }
  return { low, high, wide, cell, columns, rows, bottom, grid };
}

function distanceAt(shape, r, y) {
  const u = Math.min(r / shape.cell, shape.columns - 1.001);
  const v = Math.min(Math.max((y - shape.bottom) / shape.cell, 0), shape.rows - 1.001);
  const [i, j] = [u | 0, v | 0];
  const [s, t] = [u - i, v - j];
  const at = j * shape.columns + i;
  const g = shape.grid;
  const below = g[at] + (g[at + 1] - g[at]) * s;
  const above = g[at + shape.columns] +
    (g[at + shape.columns + 1] - g[at + shape.columns]) * s;
  return below + (above - below) * t;
}

/** The rotation whose y axis leans by `lean` towards the direction `heading` (radians, x to z). */
function leaning(lean, heading, spin) {
  const [c, s, ch, sh] = [Math.cos(lean), Math.sin(lean), Math.cos(heading), Math.sin(heading)];
  const axis = [s * ch, c, s * sh];
  const side = [c * ch, -s, c * sh];
  const third = [-sh, 0, ch];
  const [k, l] = [Math.cos(spin), Math.sin(spin)];
  return [side.map((v, i) => v * k + third[i] * l), axis, side.map((v, i) => third[i] * k - v * l)];
}

/**
 * A solid in the scene. `at`: where its origin lies; `size`: a factor, or one for each of its axes;
 * `lean`, `heading`, `spin`: radians.
 */
export function place(shape, material, at, { size = 1, lean = 0, heading = 0, spin = 0 } = {}) {
  const scale = Array.isArray(size) ? size : [size, size, size];
  const axes = leaning(lean, heading, spin);
  const middle = ((shape.low + shape.high) / 2) * scale[1];
  const reach = Math.hypot(shape.wide * Math.max(scale[0], scale[2]),
    ((shape.high - shape.low) / 2) * scale[1]);
  return { shape, material, at, scale, axes, least: Math.min(...scale), reach,
    center: at.map((v, i) => v + axes[1][i] * middle) };
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** A direction or a difference of points in the frame of the solid. */
function inFrame(solid, v) {
  return [0, 1, 2].map((i) => dot(solid.axes[i], v) / solid.scale[i]);
}

/** How far along a ray of unit direction the solid is hit before `most`, or -1. */
export function hitSolid(solid, origin, direction, most) {
  const [ox, oy, oz] = [origin[0] - solid.center[0], origin[1] - solid.center[1],
    origin[2] - solid.center[2]];
  const b = ox * direction[0] + oy * direction[1] + oz * direction[2];
  const root = b * b - (ox * ox + oy * oy + oz * oz) + solid.reach * solid.reach;
  if (root <= 0) return -1;
  const leave = Math.min(most, -b + Math.sqrt(root));
  let t = Math.max(0, -b - Math.sqrt(root));
  if (t >= leave) return -1;
  const o = inFrame(solid, [origin[0] - solid.at[0], origin[1] - solid.at[1],
    origin[2] - solid.at[2]]);
  const d = inFrame(solid, direction);
  const near = 0.05 * solid.shape.cell;  // well below OFFSET of light.mjs
  for (let step = 0; step < STEPS; ++step) {
    const gap = distanceAt(solid.shape, Math.hypot(o[0] + t * d[0], o[2] + t * d[2]),
      o[1] + t * d[1]);
    if (gap < near) return t;
    t += gap * solid.least;
    if (t >= leave) return -1;
  }
  return -1;
}

/** Where a point of the scene lies in the solid's frame, and the unit normal there. */
export function surface(solid, point) {
  const p = inFrame(solid, point.map((v, i) => v - solid.at[i]));
  const r = Math.hypot(p[0], p[2]);
  const h = 2.5 * solid.shape.cell;
  const across = distanceAt(solid.shape, r + h, p[1]) -
    distanceAt(solid.shape, Math.max(0, r - h), p[1]);
  const along = distanceAt(solid.shape, r, p[1] + h) - distanceAt(solid.shape, r, p[1] - h);
  const slope = [across * p[0] / (r || 1), along, across * p[2] / (r || 1)]
    .map((v, i) => v / solid.scale[i]);
  const n = [0, 1, 2].map((i) => solid.axes[0][i] * slope[0] + solid.axes[1][i] * slope[1] +
    solid.axes[2][i] * slope[2]);
  const length = Math.hypot(...n) || 1;
  return { p, n: n.map((v) => v / length) };
}
