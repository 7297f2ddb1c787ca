// Curves as path data in artboard units, and which of them are drawn how.
import type { Affine } from "../geometry/affine.js";
import { mappedPath, type CubicPath } from "../geometry/cubic.js";
import type { CurveItem, Handle, Item } from "../model/types.js";
import type { Place } from "./places.js";

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

export interface Outlines {
  /** Selected themselves, shown by what is selected, and under the pointer. */
  readonly selected: readonly Place[];
  readonly within: readonly Place[];
  readonly hovered: readonly Place[];
}

export function outlinesOf(
  places: readonly Place[],
  selected: ReadonlySet<Handle>,
  hovered: Handle | null,
): Outlines {
  const isWithin = (item: Item | null, is: (handle: Handle) => boolean): boolean =>
    item !== null && (is(item.handle) || isWithin(item.parent, is));
  const isSelected = ({ item, owner }: Place) =>
    selected.has(item.handle) || selected.has(owner.handle);
  return {
    selected:
      selected.size > 0
        ? places.filter((place) => isSelected(place) && place.owner.kind !== "use")
        : [],
    within:
      selected.size > 0
        ? places.filter(
            (place) =>
              !(isSelected(place) && place.owner.kind !== "use") &&
              (isWithin(place.owner, (handle) => selected.has(handle)) ||
                isWithin(place.item, (handle) => selected.has(handle))),
          )
        : [],
    hovered:
      hovered === null
        ? []
        : places.filter(({ owner }) => owner.handle === hovered && !selected.has(hovered)),
  };
}
