// The targets that a dragged point snaps to.
import type { Point } from "./affine.js";
import type { CubicPath } from "./cubic.js";
import { nearestOn } from "./nearest.js";
import { distance, dot, subtract } from "./vector.js";

/** The nearest of `targets` within a distance, the first of equals; null: there is none. */
export function nearestTarget<Target extends { readonly point: Point }>(
  point: Point,
  targets: Iterable<Target>,
  within: number,
): Target | null {
  let best: Target | null = null;
  let least = within;
  for (const target of targets) {
    const found = distance(point, target.point);
    if (found > least || (best && found === least)) continue;
    [best, least] = [target, found];
  }
  return best;
}

/** Ends of open paths, and the node where closed ones begin. */
export function endsOf(path: CubicPath): { readonly point: Point; readonly node: number }[] {
  const last = (path.points.length - 1) / 3;
  const first = { point: path.points[0], node: 0 };
  return path.closed ? [first] : [first, { point: path.points[3 * last], node: last }];
}

/**
 * The nearest end of paths within a distance, else the nearest point of them; null: there is none.
 */
export function weldTarget(
  point: Point,
  paths: readonly CubicPath[],
  within: number,
): { readonly point: Point; readonly path: number; readonly at: number } | null {
  const ends = paths.flatMap((path, i) =>
    endsOf(path).map((end) => ({ point: end.point, path: i, at: end.node })),
  );
  const feet = function* () {
    for (const [i, path] of paths.entries()) {
      const { at, point: foot } = nearestOn(path, point);
      yield { point: foot, path: i, at };
    }
  };
  return nearestTarget(point, ends, within) ?? nearestTarget(point, feet(), within);
}

/** The point nearest to `to` in a direction from `from` that is a multiple of an angle. */
export function atAngle(from: Point, to: Point, degrees = 15): Point {
  const way = subtract(to, from);
  const unitAngle = (degrees * Math.PI) / 180;
  const angle = Math.round(Math.atan2(way[1], way[0]) / unitAngle) * unitAngle;
  const direction: Point = [Math.cos(angle), Math.sin(angle)];
  const along = dot(way, direction);
  return [from[0] + direction[0] * along, from[1] + direction[1] * along];
}

/** The nearest point of a grid of squares. */
export function onGrid([x, y]: Point, spacing: number): Point {
  return [Math.round(x / spacing) * spacing, Math.round(y / spacing) * spacing];
}
