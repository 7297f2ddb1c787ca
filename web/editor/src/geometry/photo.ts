// Colours of a picture to trace.
import type { Point } from "./affine.js";
import { oklabFromRgb, type Oklab } from "./color.js";

/** RGBA in the layout of ImageData. Pixel (i, j) covers [i, i + 1) × [j, j + 1). */
export interface Photo {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray | Uint8Array;
}

/** Pixels with less are nothing. */
const OPAQUE = 128;

export function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

export const labDistance = (p: Oklab, q: Oklab): number =>
  Math.hypot(p.l - q.l, p.a - q.a, p.b - q.b);

export const medianLab = (colors: readonly Oklab[]): Oklab => ({
  l: median(colors.map(({ l }) => l)),
  a: median(colors.map(({ a }) => a)),
  b: median(colors.map(({ b }) => b)),
});

/**
 * The median of the 3 × 3 pixels around a point, per channel; null outside and where it is clear.
 */
export function colorAt({ width, height, data }: Photo, [x, y]: Point): Oklab | null {
  const [i, j] = [Math.floor(x), Math.floor(y)];
  if (!(i >= 0 && i < width && j >= 0 && j < height)) return null;
  const channels: [number[], number[], number[]] = [[], [], []];
  for (let v = Math.max(j - 1, 0); v <= Math.min(j + 1, height - 1); ++v) {
    for (let u = Math.max(i - 1, 0); u <= Math.min(i + 1, width - 1); ++u) {
      const at = 4 * (v * width + u);
      if (data[at + 3] < OPAQUE) continue;
      channels.forEach((values, k) => values.push(data[at + k] / 255));
    }
  }
  if (channels[0].length === 0) return null;
  const [r, g, b] = channels.map(median);
  return oklabFromRgb({ r, g, b });
}

/** Whether there is a pixel that lets something through. */
export function isOpaque({ data }: Photo): boolean {
  for (let i = 3; i < data.length; i += 4) if (data[i] < 255) return false;
  return true;
}

/** A photo on what lies below it, of the same size: opaque. */
export function layered(
  { width, height, data }: Photo,
  { data: below }: Photo,
): Photo & { readonly data: Uint8ClampedArray<ArrayBuffer> } {
  const laid = new Uint8ClampedArray(data.length);
  const through = (color: number, share: number, under: number) => share * color + (1 - share) * under;
  for (let i = 0; i < data.length; i += 4) {
    const [share, own] = [data[i + 3] / 255, below[i + 3] / 255];
    for (let k = i; k < i + 3; ++k) laid[k] = through(data[k], share, through(below[k], own, 255));
    laid[i + 3] = 255;
  }
  return { width, height, data: laid };
}
