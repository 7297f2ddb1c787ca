// Colours of a photo beside a curve, as stops of its two sides.
import {
  composed,
  inverted,
  lengthScale,
  mapped,
  type Affine,
  type Point,
} from "../geometry/affine.js";
import { clampedRgb, oklabFromRgb, rgbFromOklab, type Rgb } from "../geometry/color.js";
import { mappedPath, type CubicPath } from "../geometry/cubic.js";
import { offsetOfPlace } from "../geometry/length.js";
import { simplifiedGraph } from "../geometry/simplify.js";
import type { CurveItem, Side, SideValue, Stop } from "../model/types.js";
import { standing } from "./along.js";
import type { Photo } from "./photo.js";
import { stopsOf } from "./sides.js";

/** Places looked at along the whole of a curve, at least and at most. */
const FEWEST = 16;
const MOST = 400;
/** One for so many pixels of the photo. */
const APART = 2;
/** A sample is compared with so many to each side, and dropped where it is so many deviations off. */
const NEIGHBOURS = 4;
const OUTLYING = 2.5;
/** Below it samples are alike, whatever their deviation; OKLab. */
const ALIKE = 0.02;

type Lab = readonly [number, number, number];

/** A pixel of the photo by its place on the artboard; null: beside the photo, or where it is clear. */
export function photoColor(photo: Photo, point: Point): Rgb | null {
  const back = inverted(photo.artboardFromPixel);
  return back && pixelAt(photo, mapped(back, point));
}

function pixelAt({ width, height, data }: Photo, [x, y]: Point): Rgb | null {
  const [column, row] = [Math.floor(x), Math.floor(y)];
  if (!(column >= 0 && row >= 0 && column < width && row < height)) return null;
  const at = 4 * (row * width + column);
  return data[at + 3] === 0
    ? null
    : { r: data[at] / 255, g: data[at + 1] / 255, b: data[at + 2] / 255 };
}

function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const half = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

function medianLab(labs: readonly Lab[]): Lab {
  const channel = (k: number) => median(labs.map((lab) => lab[k]));
  return [channel(0), channel(1), channel(2)];
}

function labOf(color: Rgb): Lab {
  const { l, a, b } = oklabFromRgb(color);
  return [l, a, b];
}

/** The median of the nine pixels around a place: noise does not count. */
function calmColor(photo: Photo, [x, y]: Point): Lab | null {
  const around = [-1, 0, 1].flatMap((dy) =>
    [-1, 0, 1].map((dx) => pixelAt(photo, [x + dx, y + dy])),
  );
  const seen = around.filter((color) => color !== null);
  return seen.length > 0 ? medianLab(seen.map(labOf)) : null;
}

interface Sample {
  /** Piece + t. */
  readonly at: number;
  readonly lab: Lab;
}

/** Without samples that are unlike their neighbours: a hair, a highlight. */
function withoutOutliers(samples: readonly Sample[]): Sample[] {
  return samples.filter((sample, k) => {
    const around = samples
      .slice(Math.max(0, k - NEIGHBOURS), k + NEIGHBOURS + 1)
      .map(({ lab }) => lab);
    const middle = medianLab(around);
    const off = (lab: Lab) =>
      Math.hypot(lab[0] - middle[0], lab[1] - middle[1], lab[2] - middle[2]);
    return off(sample.lab) <= Math.max(ALIKE, OUTLYING * median(around.map(off)));
  });
}

function samplesAlong(
  photo: Photo,
  path: CubicPath,
  pixelFromItem: Affine,
  sign: 1 | -1,
  distance: number,
  range: readonly [number, number],
): Sample[] {
  const pieces = (path.points.length - 1) / 3;
  const seen = mappedPath(pixelFromItem, path);
  const length = seen.points.reduce((sum, [x, y], k) => {
    const [px, py] = seen.points[Math.max(0, k - 1)];
    return sum + Math.hypot(x - px, y - py);
  }, 0);
  const count = Math.min(MOST, Math.max(FEWEST, Math.ceil(length / APART)));
  const samples: Sample[] = [];
  for (let k = 0; k <= count; k += 1) {
    const at = range[0] + ((range[1] - range[0]) * k) / count;
    const { foot, normal } = standing(path, pixelFromItem, Math.min(pieces, at), sign);
    const lab = calmColor(photo, [foot[0] + normal[0] * distance, foot[1] + normal[1] * distance]);
    if (lab) samples.push({ at, lab });
  }
  return withoutOutliers(samples);
}

export interface SampleWish {
  /** From the curve, photo pixels. */
  readonly distance: number;
  /** How far stops may be from what they stand for, OKLab. */
  readonly tolerance: number;
  /** The stretch of the subpath, piece + t. */
  readonly range: readonly [number, number];
}

/**
 * What a side becomes when a stretch of a subpath takes the colours of a photo; stops beyond the
 * stretch stay. null: no pixel of the photo lies there.
 */
export function sampledSide(
  photo: Photo,
  item: CurveItem,
  path: number,
  side: Side,
  wish: SampleWish,
): SideValue<Rgb> | null {
  const back = inverted(photo.artboardFromPixel);
  if (!back || !(lengthScale(item.artboardFromItem) > 0)) return null;
  const pixelFromItem = composed(back, item.artboardFromItem);
  const samples = samplesAlong(
    photo,
    item.paths[path],
    pixelFromItem,
    side === "left" ? 1 : -1,
    wish.distance,
    wish.range,
  );
  if (samples.length === 0) return null;
  const list = stopsOf(item, side, "color");
  const space = list?.space ?? "arc";
  const inLayer = mappedPath(item.layerFromItem, item.paths[path]);
  const offset = (at: number) => offsetOfPlace(inLayer, space, at);
  const rows = samples.map(({ at, lab }) => [offset(at), ...lab]);
  const fresh = simplifiedGraph(rows, wish.tolerance).map((k): Stop<Rgb> => {
    const [l, a, b] = samples[k].lab;
    return { offset: rows[k][0], value: clampedRgb(rgbFromOklab({ l, a, b })) };
  });
  const [from, to] = [offset(wish.range[0]), offset(wish.range[1])];
  const kept = (list?.stops ?? []) as readonly Stop<Rgb>[];
  const stops = [
    ...kept.filter((stop) => stop.offset < from),
    ...fresh,
    ...kept.filter((stop) => stop.offset > to),
  ];
  return { kind: "stops", space, stops };
}
