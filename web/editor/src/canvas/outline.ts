// Curves as path data in artboard units, and which of them are drawn how.
import type { Affine } from "../geometry/affine.js";
import { mappedPath, type CubicPath } from "../geometry/cubic.js";
import type { CurveItem, Handle, Item } from "../model/types.js";
import { editedAt, type Place } from "./places.js";

/** Decimals of artboard units: enough at any zoom. */
const DECIMALS = 6;

export function pathData({ points, closed }: CubicPath): string {
  const text = ([x, y]: readonly [number, number]) =>
    `${+x.toFixed(DECIMALS)} ${+y.toFixed(DECIMALS)}`;
  const pieces = Array.from(
    { length: (points.length - 1) / 3 },
    (_, k) => `C${text(points[3 * k + 1])} ${text(points[3 * k + 2])} ${text(points[3 * k + 3])}`,
  );
  return `M${text(points[0])}${pieces.join("")}${closed ? "Z" : ""}`;
}

const kept = new WeakMap<CurveItem, { map: Affine; data: string }>();

function placeData({ item, artboardFromItem }: Place): string {
  const known = kept.get(item);
  if (known && known.map.every((value, k) => value === artboardFromItem[k])) return known.data;
  const data = item.paths.map((path) => pathData(mappedPath(artboardFromItem, path))).join("");
  kept.set(item, { map: artboardFromItem, data });
  return data;
}

/** All of these curves as one path: few elements, however many curves. */
export function outlineOf(places: readonly Place[]): string {
  return places.map(placeData).join("");
}

/** Returns the places that are selected themselves, and those that a selected layer, group or <use> shows. */
export function selectedPlaces(
  places: readonly Place[],
  selected: ReadonlySet<Handle>,
): { readonly selected: readonly Place[]; readonly within: readonly Place[] } {
  if (selected.size === 0) return { selected: [], within: [] };
  const isWithin = (item: Item | null): boolean =>
    item !== null && (selected.has(item.handle) || isWithin(item.parent));
  const isOwn = (place: Place) => selected.has(place.item.handle) && editedAt(place) === place.item;
  return {
    selected: places.filter(isOwn),
    within: places.filter(
      (place) => !isOwn(place) && (isWithin(place.owner) || isWithin(place.item)),
    ),
  };
}
