// Places that a dragged point is drawn to: ends of curves, curves, guides, the grid.
import type { Point } from "../geometry/affine.js";
import type { Lines } from "../geometry/box-snap.js";
import { nearestTarget, onGrid } from "../geometry/snap.js";
import { distance } from "../geometry/vector.js";
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
  /** Whether it is a point of a curve. */
  readonly isWelded: boolean;
}

export interface SnapWish {
  readonly snaps: boolean;
  readonly grid: boolean;
  /** The guides of the drawing, on the stage. */
  readonly lines: Lines;
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

/** Longer than any stage, CSS pixels. */
const LONG = 1e5;

/**
 * Where a point of the stage goes. Ends of curves go before all else, then the nearer of a curve and the guides,
 * then the grid.
 */
export function snapped(grid: CurveGrid, at: Point, wish: SnapWish): Snapped {
  const own = wish.also.map((point) => ({ point }));
  const ends = wish.snaps ? [...grid.endsNear(at, SNAP_REACH, wish.isWanted), ...own] : [];
  const end = nearestTarget(at, ends, SNAP_REACH);
  if (end) return welded(end.point);
  const curve = wish.snaps ? grid.near(at, SNAP_REACH, wish.isWanted)[0] : undefined;
  const lines = wish.snaps ? toLines(at, wish) : null;
  if (curve && !(lines && distance(at, lines.at) < distance(at, curve.point))) return welded(curve.point);
  return lines ?? { at: wish.grid ? toGrid(at, wish) : at, guides: [], isWelded: false };
}

const welded = (at: Point): Snapped => ({ at, guides: [{ from: at, to: at }], isWelded: true });

/** Each coordinate goes to the nearest guide; one without a guide goes to the grid. null: no guide is near. */
function toLines(at: Point, wish: SnapWish): Snapped | null {
  const [x, y] = wish.lines.map((places, axis) => nearestOf(places, at[axis]));
  if (x === null && y === null) return null;
  const [gx, gy] = wish.grid ? toGrid(at, wish) : at;
  const guides: Guide[] = [];
  if (x !== null) guides.push({ from: [x, -LONG], to: [x, LONG] });
  if (y !== null) guides.push({ from: [-LONG, y], to: [LONG, y] });
  return { at: [x ?? gx, y ?? gy], guides, isWelded: false };
}

function nearestOf(places: readonly number[], to: number): number | null {
  let best: number | null = null;
  for (const place of places) {
    const away = Math.abs(place - to);
    if (away <= SNAP_REACH && (best === null || away < Math.abs(best - to))) best = place;
  }
  return best;
}

/**
 * Returns the artboard units between lines of the grid, at least 8 pixels: a multiple of `unit` by 1, 2 or 5 times
 * a power of ten.
 * @param unit of the grid; 0: as fine as the zoom allows
 */
export function gridStep(zoom: number, unit = 0): number {
  const least = GRID_STEP_PX / zoom;
  if (unit > 0) return unit * (least <= unit ? 1 : gridStep(zoom * unit));
  return roundStep(least);
}

/** Returns the least number of 1, 2 or 5 times a power of ten that is not below another number. */
export function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return (
    [1, 2, 5, 10].map((k) => k * power).find((step) => step >= least * (1 - 1e-9)) ?? 10 * power
  );
}

function toGrid([x, y]: Point, { zoom, origin, unit }: SnapWish): Point {
  const [gx, gy] = onGrid([x - origin[0], y - origin[1]], gridStep(zoom, unit) * zoom);
  return [gx + origin[0], gy + origin[1]];
}
