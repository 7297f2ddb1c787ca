// Places on a path, as they stand on the stage.
import { determinant, mapped, mappedVector, type Affine, type Point } from "../geometry/affine.js";
import { mappedPath, type CubicPath } from "../geometry/cubic.js";
import { pathDirectionAt, pathPointAt, placeOfOffset } from "../geometry/length.js";
import { nearestOn, type Nearest } from "../geometry/nearest.js";
import { leftOf, scaled, unit } from "../geometry/vector.js";
import type { CurveItem } from "../model/types.js";
import type { Stops } from "./sides.js";

/** Paths do not change: each is mapped once, so that it is measured once. */
const inLayers = new WeakMap<CubicPath, { readonly map: Affine; readonly inLayer: CubicPath }>();

/** Returns a path of an item in the frame of its layer, where arc lengths are measured. */
export function pathInLayer({ layerFromItem: map }: CurveItem, path: CubicPath): CubicPath {
  const known = inLayers.get(path);
  if (known && map.every((value, k) => value === known.map[k])) return known.inLayer;
  const inLayer = mappedPath(map, path);
  inLayers.set(path, { map, inLayer });
  return inLayer;
}

/** Places of stops, by path and by the list of stops on it. */
const stopPlaces = new WeakMap<CubicPath, WeakMap<Stops<unknown>, readonly number[]>>();

/** Where the stops of a list stand on a path, in the frame of its layer. */
export function placesOfStops(inLayer: CubicPath, list: Stops<unknown>): readonly number[] {
  const ofPath = stopPlaces.get(inLayer) ?? new WeakMap<Stops<unknown>, readonly number[]>();
  stopPlaces.set(inLayer, ofPath);
  const known = ofPath.get(list);
  if (known) return known;
  const places = list.stops.map(({ offset }) => placeOfOffset(inLayer, list.space, offset));
  ofPath.set(list, places);
  return places;
}

/** @param map from the path's coordinates to the point's, where distances are measured */
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
