// Drawn points drawn to the edges of a photo.
import type { Point } from "./affine.js";
import { oklabFromRgb } from "./color.js";
import { median, type Photo } from "./photo.js";
import { add, leftOf, scaled, subtract, unit } from "./vector.js";

/** How strongly a photo's colours change at each pixel's centre: OKLab to a pixel. */
export interface EdgeMap {
  readonly width: number;
  readonly height: number;
  readonly strength: Float32Array;
}

/** Weaker changes are no edges. */
const LEAST = 0.02;
const STEP = 0.25;

/** The photo in OKLab, one plane behind the other. */
function planesOf({ width, height, data }: Photo): Float32Array[] {
  const count = width * height;
  const planes = [0, 1, 2].map(() => new Float32Array(count));
  for (let i = 0; i < count; ++i) {
    const [r, g, b] = [data[4 * i] / 255, data[4 * i + 1] / 255, data[4 * i + 2] / 255];
    const lab = oklabFromRgb({ r, g, b });
    [planes[0][i], planes[1][i], planes[2][i]] = [lab.l, lab.a, lab.b];
  }
  return planes;
}

/**
 * Sobel's operator on all three channels together. Work for a worker: a second for ten megapixels.
 */
export function edgeMap(photo: Photo): EdgeMap {
  const { width, height } = photo;
  const strength = new Float32Array(width * height);
  for (const plane of planesOf(photo)) {
    for (let y = 0; y < height; ++y) {
      const [up, down] = [Math.max(y - 1, 0) * width, Math.min(y + 1, height - 1) * width];
      for (let x = 0; x < width; ++x) {
        const [left, right] = [Math.max(x - 1, 0), Math.min(x + 1, width - 1)];
        const at = y * width;
        const dx =
          plane[up + right] -
          plane[up + left] +
          2 * (plane[at + right] - plane[at + left]) +
          plane[down + right] -
          plane[down + left];
        const dy =
          plane[down + left] -
          plane[up + left] +
          2 * (plane[down + x] - plane[up + x]) +
          plane[down + right] -
          plane[up + right];
        strength[at + x] += (dx * dx + dy * dy) / 64;
      }
    }
  }
  return { width, height, strength: strength.map(Math.sqrt) };
}

/** Between pixels' centres; 0 outside. */
function strengthAt({ width, height, strength }: EdgeMap, [px, py]: Point): number {
  const [x, y] = [px - 0.5, py - 0.5];
  const [i, j] = [Math.floor(x), Math.floor(y)];
  if (!(i >= 0 && i + 1 < width && j >= 0 && j + 1 < height)) return 0;
  const [u, v] = [x - i, y - j];
  const at = j * width + i;
  const upper = strength[at] * (1 - u) + strength[at + 1] * u;
  const lower = strength[at + width] * (1 - u) + strength[at + width + 1] * u;
  return upper * (1 - v) + lower * v;
}

/**
 * How far along the normal the strongest edge is; nearer ones are preferred. null: there is none.
 */
function edgeAlong(edges: EdgeMap, point: Point, normal: Point, reach: number): number | null {
  let [best, most] = [0, LEAST];
  for (let t = -reach; t <= reach; t += STEP) {
    const weight = 1 - 0.5 * (t / reach) ** 2;
    const found = strengthAt(edges, add(point, scaled(normal, t))) * weight;
    if (found > most) [best, most] = [t, found];
  }
  return most > LEAST ? best : null;
}

/**
 * Points of a stroke, in photo pixels, moved along its normal to the edges that it follows, by at
 * most `reach`. Where neighbours go elsewhere a point goes with them; where there is no edge it
 * stays, and is the same object.
 */
export function magnet(edges: EdgeMap, points: readonly Point[], reach = 6): Point[] {
  const last = points.length - 1;
  const normals = points.map((_, i) => {
    const along = unit(subtract(points[Math.min(i + 1, last)], points[Math.max(i - 1, 0)]));
    return along && leftOf(along);
  });
  const shifts = points.map((point, i) => {
    const normal = normals[i];
    return normal ? edgeAlong(edges, point, normal, reach) : null;
  });
  return points.map((point, i) => {
    const normal = normals[i];
    const around = shifts.slice(Math.max(i - 2, 0), i + 3).filter((shift) => shift !== null);
    if (!normal || shifts[i] === null || around.length === 0) return point;
    return add(point, scaled(normal, median(around)));
  });
}
