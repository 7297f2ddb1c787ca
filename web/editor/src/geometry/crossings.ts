// Whether short lines cross curves, looked up in a grid.
import type { Point } from "./affine.js";
import { cross, subtract } from "./vector.js";

const CELL = 16;
/** A line that covers more cells than this is tested against every other line. */
const MOST_CELLS = 4096;

/** Whether two lines have a point in common. */
export function doCross(a: Point, b: Point, c: Point, d: Point): boolean {
  const [ab, cd] = [subtract(b, a), subtract(d, c)];
  const turn = cross(ab, cd);
  if (turn === 0) return false;
  const ac = subtract(c, a);
  const [s, t] = [cross(ac, cd) / turn, cross(ac, ab) / turn];
  return s >= 0 && s <= 1 && t >= 0 && t <= 1;
}

/** Polylines in photo pixels. */
export class Crossings {
  readonly #cells = new Map<string, (readonly [Point, Point])[]>();
  readonly #long: (readonly [Point, Point])[] = [];

  add(points: readonly Point[]): void {
    for (let i = 0; i + 1 < points.length; ++i) {
      const line = [points[i], points[i + 1]] as const;
      const cells = cellsOf(...line);
      if (!cells) this.#long.push(line);
      for (const key of cells ?? []) {
        const lines = this.#cells.get(key);
        if (lines) lines.push(line);
        else this.#cells.set(key, [line]);
      }
    }
  }

  isCrossed(from: Point, to: Point): boolean {
    const crosses = ([c, d]: readonly [Point, Point]) => doCross(from, to, c, d);
    if (this.#long.some(crosses)) return true;
    for (const key of cellsOf(from, to) ?? []) if (this.#cells.get(key)?.some(crosses)) return true;
    return false;
  }
}

/** The cells of a line's box; null: too many. */
function cellsOf(a: Point, b: Point): string[] | null {
  const cell = (value: number) => Math.floor(value / CELL);
  const [i0, i1] = [cell(Math.min(a[0], b[0])), cell(Math.max(a[0], b[0]))];
  const [j0, j1] = [cell(Math.min(a[1], b[1])), cell(Math.max(a[1], b[1]))];
  if (!((i1 - i0 + 1) * (j1 - j0 + 1) <= MOST_CELLS)) return null;
  const keys: string[] = [];
  for (let j = j0; j <= j1; ++j) for (let i = i0; i <= i1; ++i) keys.push(`${i} ${j}`);
  return keys;
}
