// Places that a dragged point is drawn to: ends of curves, curves, the grid.
import type { Point } from "../geometry/affine.js";
import { nearestTarget, onGrid } from "../geometry/snap.js";
import type { CurveGrid } from "./hit.js";
import type { Place } from "./places.js";
import type { Guide } from "./sketch.js";

/** How near a point has to come, CSS pixels. */
export const SNAP_REACH = 8;
/** Points that are nearer are the same, CSS pixels. */
export const SAME_PX = 1e-6;
/** A snapped point is written with this many times finer steps, so that both points are identical. */
export const WELD_FINER = 1000;
/** Lines of the grid are at least so far apart, CSS pixels. */
const GRID_STEP_PX = 8;

export interface Snapped {
  /** On the stage. */
  readonly at: Point;
  readonly guides: readonly Guide[];
}

export interface SnapWish {
  readonly snaps: boolean;
  readonly grid: boolean;
  /** As gridStep() takes it. */
  readonly unit: number;
  /** CSS pixels in an artboard unit, and the artboard's origin on the stage. */
  readonly zoom: number;
  readonly origin: Point;
  /** Returns whether a curve counts; curves that are moved do not. */
  readonly isWanted: (place: Place) => boolean;
  /** Ends that count although their curve is moved: its own other end. */
  readonly also: readonly Point[];
}

/** Where a point of the stage goes. Ends of curves go before curves, these before the grid. */
export function snapped(grid: CurveGrid, at: Point, wish: SnapWish): Snapped {
  const own = wish.also.map((point) => ({ point }));
  const ends = wish.snaps ? [...grid.endsNear(at, SNAP_REACH, wish.isWanted), ...own] : [];
  const end = nearestTarget(at, ends, SNAP_REACH);
  if (end) return { at: end.point, guides: [{ from: end.point, to: end.point }] };
  const curve = wish.snaps ? grid.near(at, SNAP_REACH, wish.isWanted)[0] : undefined;
  if (curve) return { at: curve.point, guides: [{ from: curve.point, to: curve.point }] };
  return wish.grid ? toGrid(at, wish) : { at, guides: [] };
}

/**
 * Returns the artboard units between lines of the grid, at least 8 pixels: a multiple of `unit` by 1, 2 or 5 times
 * a power of ten.
 * @param unit of the grid; 0: as fine as the zoom allows
 */
export function gridStep(zoom: number, unit = 0): number {
  const least = GRID_STEP_PX / zoom;
  if (unit > 0) return unit * (least <= unit ? 1 : gridStep(zoom * unit));
  const power = 10 ** Math.floor(Math.log10(least));
  return (
    [1, 2, 5, 10].map((k) => k * power).find((step) => step >= least * (1 - 1e-9)) ?? 10 * power
  );
}

function toGrid([x, y]: Point, { zoom, origin, unit }: SnapWish): Snapped {
  const [gx, gy] = onGrid([x - origin[0], y - origin[1]], gridStep(zoom, unit) * zoom);
  return { at: [gx + origin[0], gy + origin[1]], guides: [] };
}
