// Colours of a photo beside a stretch of a curve, as stops of its two sides.
import { composed, determinant, inverted, lengthScale, mapped, type Point } from "../geometry/affine.js";
import { rgbFromOklab, type Rgb } from "../geometry/color.js";
import { pieceAt, pieceCount, subcurve, type CubicPath } from "../geometry/cubic.js";
import { fractionAtParameter, offsetOfPlace, parameterAtFraction } from "../geometry/length.js";
import { pathOf } from "../geometry/nodes.js";
import { colorAt } from "../geometry/photo.js";
import { tracePhoto, type TraceOptions, type TracedStop } from "../geometry/trace.js";
import type { CurveItem, Side, SideValue, Stop } from "../model/types.js";
import { add, scaled } from "../geometry/vector.js";
import { pathInLayer, standing } from "./along.js";
import type { PlacedPhoto } from "./photo.js";
import { stopsOf, type Stops } from "./sides.js";

/** The photo's colour at a point of the artboard; null: beside the photo, or where it is clear. */
export function photoColor(photo: PlacedPhoto, point: Point): Rgb | null {
  const back = inverted(photo.artboardFromPixel);
  const color = back && colorAt(photo, mapped(back, point));
  return color && rgbFromOklab(color);
}

/** The part of a path between two places, in pieces of its own. */
function stretchOf(path: CubicPath, [from, to]: readonly [number, number]): CubicPath {
  const pieces = (path.points.length - 1) / 3;
  if (from <= 0 && to >= pieces) return path;
  const cubics = [];
  for (let k = Math.min(pieces - 1, Math.floor(from)); k < to && k < pieces; k += 1) {
    const [t0, t1] = [Math.max(0, from - k), Math.min(1, to - k)];
    if (t1 > t0) cubics.push(subcurve(pieceAt(path, k), t0, t1));
  }
  return cubics.length > 0 ? pathOf(cubics, false) : { points: [], closed: false };
}

export interface SampleWish extends Omit<TraceOptions, "photoFromPath"> {
  /** The stretch of the subpath, piece + t. */
  readonly range: readonly [number, number];
}

export interface SampledSides extends Readonly<Record<Side, SideValue<Rgb> | null>> {
  /** null: the value stays, because it was not requested, or there is no transition. */
  readonly blur: Readonly<Record<Side, SideValue<number>>> | null;
}

/**
 * Returns the sides after a stretch of a subpath has taken the colours of a photo; stops beyond the stretch
 * stay. null: no pixel of the photo is visible on that side.
 * @param wish lengths are in the layer's coordinates
 */
export function sampledSides(
  photo: PlacedPhoto,
  item: CurveItem,
  path: number,
  wish: SampleWish,
): SampledSides {
  const back = inverted(photo.artboardFromPixel);
  const itemFromLayer = inverted(item.layerFromItem);
  const inLayer = pathInLayer(item, item.paths[path]);
  const stretch = stretchOf(inLayer, wish.range);
  if (!back || !itemFromLayer || stretch.points.length === 0) return { left: null, right: null, blur: null };
  const photoFromPath = composed(composed(back, item.artboardFromItem), itemFromLayer);
  const traced = tracePhoto(photo, stretch, { ...wish, photoFromPath });
  // A map that mirrors exchanges the sides of the curve.
  const isMirrored = determinant(item.layerFromItem) < 0;
  const side = (name: Side, stops: readonly TracedStop<Rgb>[]) =>
    merged(stopsOf(item, name, "color") as Stops<Rgb> | null, inLayer, wish.range, stops);
  return {
    left: side("left", isMirrored ? traced.right : traced.left),
    right: side("right", isMirrored ? traced.left : traced.right),
    blur: wish.blurs ? blurred(item, inLayer, wish.range, traced.blur) : null,
  };
}

/** The blur of both sides of a stretch; where there was none, there is none beyond it. */
function blurred(
  item: CurveItem,
  inLayer: CubicPath,
  range: readonly [number, number],
  traced: readonly TracedStop<number>[],
): SampledSides["blur"] {
  const scale = lengthScale(item.layerFromItem);
  const short = (value: number) => Number((value / scale).toPrecision(3));
  const radii = traced.map(({ offset, value }) => ({ offset, value: short(value) }));
  const isWhole = range[0] <= 0 && range[1] >= pieceCount(inLayer);
  const none: Stops<number> = {
    space: "arc",
    stops: [0, 1].map((offset) => ({ offset, value: 0 })),
  };
  const side = (name: Side) => {
    const list = (stopsOf(item, name, "blur") as Stops<number> | null) ?? (isWhole ? null : none);
    return merged(list, inLayer, range, stepped(radii, isWhole || list !== none));
  };
  const [left, right] = [side("left"), side("right")];
  return left && right ? { left, right } : null;
}

/** Radii between steps from and to none, unless they go on. */
function stepped(
  radii: readonly TracedStop<number>[],
  goesOn: boolean,
): readonly TracedStop<number>[] {
  if (goesOn || radii.length === 0) return radii;
  const [first, last] = [radii[0], radii[radii.length - 1]];
  return [
    { offset: 0, value: 0 },
    { offset: 0, value: first.value },
    ...radii.filter(({ offset }) => offset > 0 && offset < 1),
    { offset: 1, value: last.value },
    { offset: 1, value: 0 },
  ];
}

/**
 * Samples beside one place of a curve. Returns the colours, their places in the photo, and the direction to
 * the left. null: the curve has no direction there. @param at piece + t
 */
export function sampledAt(
  photo: PlacedPhoto,
  item: CurveItem,
  path: number,
  at: number,
  distance: number,
): {
  readonly left: Rgb | null;
  readonly right: Rgb | null;
  readonly spots: readonly [Point, Point];
  readonly normal: Point;
} | null {
  const back = inverted(photo.artboardFromPixel);
  if (!back || !item.paths[path]) return null;
  const { foot, normal } = standing(item.paths[path], composed(back, item.artboardFromItem), at, 1);
  const spots = [distance, -distance].map((reach) => add(foot, scaled(normal, reach))) as [Point, Point];
  const [left, right] = spots.map((spot) => {
    const color = colorAt(photo, spot);
    return color && rgbFromOklab(color);
  });
  return { left, right, spots, normal };
}

/** Returns the stops of a stretch between the stops beyond it. */
function merged<V>(
  list: Stops<V> | null,
  inLayer: CubicPath,
  range: readonly [number, number],
  traced: readonly TracedStop<V>[],
): SideValue<V> | null {
  if (traced.length === 0) return null;
  const space = list?.space ?? "arc";
  const [from, to] = range.map((at) => fractionAtParameter(inLayer, at));
  const offsetAt = (share: number) =>
    offsetOfPlace(inLayer, space, parameterAtFraction(inLayer, from + (to - from) * share));
  const fresh = traced.map(({ offset, value }): Stop<V> => ({ offset: offsetAt(offset), value }));
  // One value for all of the stretch is one at both of its ends where something is beyond.
  const ends = traced.length === 1 && to - from < 1;
  const inside = ends ? [0, 1].map((share) => ({ ...fresh[0], offset: offsetAt(share) })) : fresh;
  const kept = list?.stops ?? [];
  const [low, high] = [offsetAt(0), offsetAt(1)];
  const stops = [
    ...kept.filter(({ offset }) => offset < low),
    ...inside,
    ...kept.filter(({ offset }) => offset > high),
  ];
  return { kind: "stops", space, stops };
}
