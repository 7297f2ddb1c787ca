// Places on a path, as they stand on the stage.
import { determinant, mapped, mappedVector, type Affine, type Point } from "../geometry/affine.js";
import { mappedPath, type CubicPath } from "../geometry/cubic.js";
import { pathDirectionAt, pathPointAt } from "../geometry/length.js";
import { nearestOn, type Nearest } from "../geometry/nearest.js";
import { leftOf, scaled, unit } from "../geometry/vector.js";

/** @param map from the path's coordinates to the point's, in which distances are measured */
export function nearestAt(path: CubicPath, map: Affine, point: Point): Nearest {
  return nearestOn(mappedPath(map, path), point);
}

/**
 * Where a place of a path is on the stage, and the unit vector to a side of it there.
 * @param sign 1: what is left in the path's own coordinates, -1: right
 */
export function standing(
  path: CubicPath,
  map: Affine,
  at: number,
  sign: 1 | -1,
): { foot: Point; normal: Point } {
  const along = mappedVector(map, pathDirectionAt(path, at) ?? [1, 0]);
  // A map that mirrors turns left to right.
  const turned = determinant(map) < 0 ? -sign : sign;
  return {
    foot: mapped(map, pathPointAt(path, at)),
    normal: scaled(leftOf(unit(along) ?? [1, 0]), turned),
  };
}
