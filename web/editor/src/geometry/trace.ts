// Colours of a photo along both sides of a curve, as stops; and the blur that fits its edges.
import {
  determinant,
  lengthScale,
  mapped,
  mappedVector,
  type Affine,
  type Point,
} from "./affine.js";
import { rgbFromOklab, clampedRgb, type Oklab, type Rgb } from "./color.js";
import { Crossings } from "./crossings.js";
import { mappedPath, type CubicPath } from "./cubic.js";
import { pathDirectionAt, pathPointAt } from "./length.js";
import { flatten } from "./nearest.js";
import { colorAt, labDistance, median, medianLab, type Photo } from "./photo.js";
import { rampRadius, REACHES } from "./ramp.js";
import { simplifiedGraph } from "./simplify.js";
import { add, distance, leftOf, scaled, unit } from "./vector.js";

export interface TraceOptions {
  /** From the path's coordinates to photo pixels. */
  readonly photoFromPath: Affine;
  /** Between samples, in the path's coordinates: two pixels of the screen. */
  readonly spacing: number;
  /** From the curve, in photo pixels: 1 to 12. */
  readonly distance: number;
  /** In OKLab: how far the stops' colours may be from the photo's. */
  readonly tolerance: number;
  /** Whether the curve is to have the blur, too: colours are then taken from beyond its reach. */
  readonly blurs?: boolean;
  /** Curves that samples do not look across, in the path's coordinates. */
  readonly others?: readonly CubicPath[];
}

/** By arc length, 0 to 1, ascending. */
export interface TracedStop<Value> {
  readonly offset: number;
  readonly value: Value;
}

export interface Trace {
  /** Empty where nothing of the photo can be seen on that side. */
  readonly left: readonly TracedStop<Rgb>[];
  readonly right: readonly TracedStop<Rgb>[];
  /**
   * Radii for both sides, in the path's coordinates; empty: the edge is sharp, or there is none.
   */
  readonly blur: readonly TracedStop<number>[];
}

const MOST_SAMPLES = 2000;
const MOST_STOPS = 30;
/** Samples on each side of one that say what is usual there. */
const NEIGHBOURS = 4;
const OUTLIER = 2.5;
/** Below this nothing is an outlier: an 8-bit step or two. */
const NOISE = 0.01;
/** Tolerance of radii, photo pixels. */
const RADIUS_TOLERANCE = 0.75;
/** Where the look across begins: the curve itself does not stand in its own way. */
const CLEAR = 0.5;

interface Station {
  readonly offset: number;
  readonly point: Point;
  /** To the left of the path, of length 1, both in photo pixels. */
  readonly normal: Point;
}

/** Places at equal distances along the path. */
function stationsOf(path: CubicPath, { photoFromPath, spacing }: TraceOptions): Station[] {
  const { points, places } = flatten(path, spacing / 32);
  const lengths = [0];
  for (let i = 1; i < points.length; ++i)
    lengths.push(lengths[i - 1] + distance(points[i - 1], points[i]));
  const whole = lengths[lengths.length - 1];
  if (!(whole > 0)) return [];
  const count = Math.min(Math.max(Math.ceil(whole / spacing), 2), MOST_SAMPLES);
  const side = determinant(photoFromPath) < 0 ? -1 : 1;
  const stations: Station[] = [];
  let chord = 1;
  for (let i = 0; i <= count; ++i) {
    const wanted = (whole * i) / count;
    while (chord < lengths.length - 1 && lengths[chord] < wanted) ++chord;
    const width = lengths[chord] - lengths[chord - 1];
    const share = width > 0 ? (wanted - lengths[chord - 1]) / width : 0;
    const at = places[chord - 1] + share * (places[chord] - places[chord - 1]);
    const direction = pathDirectionAt(path, at);
    const along = direction && unit(mappedVector(photoFromPath, direction));
    if (!along) continue;
    const point = mapped(photoFromPath, pathPointAt(path, at));
    stations.push({ offset: i / count, point, normal: scaled(leftOf(along), side) });
  }
  return stations;
}

function crossingsOf(path: CubicPath, { photoFromPath, others = [] }: TraceOptions): Crossings {
  const crossings = new Crossings();
  for (const other of [path, ...others]) {
    crossings.add(flatten(mappedPath(photoFromPath, other), 0.05).points);
  }
  return crossings;
}

/** Looks from places of the curve into the photo. */
class Looker {
  readonly #crossings: Crossings;

  constructor(
    readonly photo: Photo,
    path: CubicPath,
    options: TraceOptions,
  ) {
    this.#crossings = crossingsOf(path, options);
  }

  /** The colour at a distance, to the left or, below 0, to the right; null: none can be seen. */
  color({ point, normal }: Station, reach: number): Oklab | null {
    const sign = Math.sign(reach);
    const target = add(point, scaled(normal, reach));
    // The pixels around the target are tested too.
    const behind = add(target, scaled(normal, sign));
    if (this.#crossings.isCrossed(add(point, scaled(normal, sign * CLEAR)), behind)) return null;
    return colorAt(this.photo, target);
  }

  /** As far as both sides can be seen. */
  radius(station: Station): number | null {
    const left: Oklab[] = [];
    const right: Oklab[] = [];
    for (const reach of REACHES) {
      const [a, b] = [this.color(station, reach), this.color(station, -reach)];
      if (!a || !b) break;
      left.push(a);
      right.push(b);
    }
    return rampRadius({ left, right });
  }
}

interface Found<Value> {
  readonly offset: number;
  readonly value: Value;
}

/** Without values that are far from the median of their neighbours, by median deviations. */
function usual<Value>(
  found: readonly Found<Value>[],
  closed: boolean,
  middle: (values: readonly Value[]) => Value,
  apart: (a: Value, b: Value) => number,
  noise: number,
): Found<Value>[] {
  const count = found.length;
  return found.filter(({ value }, i) => {
    const around: Value[] = [];
    for (let k = i - NEIGHBOURS; k <= i + NEIGHBOURS; ++k) {
      if (closed) around.push(found[(k + count) % count]?.value ?? value);
      else if (k >= 0 && k < count) around.push(found[k].value);
    }
    const center = middle(around);
    const deviation = median(around.map((other) => apart(other, center)));
    return apart(value, center) <= Math.max(OUTLIER * deviation, noise);
  });
}

/** Few rows near all, at most MOST_STOPS; one where they are all alike. */
function reduced(rows: readonly (readonly number[])[], tolerance: number): number[] {
  let kept = simplifiedGraph(rows, tolerance);
  for (let slack = tolerance; kept.length > MOST_STOPS;) {
    slack = Math.max(slack * 1.25, 1e-4);
    kept = simplifiedGraph(rows, slack);
  }
  const [first] = rows;
  const isFlat = rows.every(
    (row) => Math.hypot(...row.slice(1).map((v, i) => v - first[i + 1])) <= tolerance,
  );
  return isFlat ? kept.slice(0, 1) : kept;
}

/** The colour of one row: the mean of those beside it that are like it. */
function calm(found: readonly Found<Oklab>[], at: number, tolerance: number, all: boolean): Oklab {
  const { value } = found[at];
  const near = (all ? found : found.slice(Math.max(at - 2, 0), at + 3)).filter(
    (other) => labDistance(other.value, value) <= tolerance,
  );
  const mean = (channel: (color: Oklab) => number) =>
    near.reduce((sum, other) => sum + channel(other.value), 0) / near.length;
  return { l: mean((c) => c.l), a: mean((c) => c.a), b: mean((c) => c.b) };
}

/** A colour in bytes: what a file says in short. */
function inBytes(color: Oklab): Rgb {
  const { r, g, b } = clampedRgb(rgbFromOklab(color));
  const byte = (channel: number) => Math.round(channel * 255) / 255;
  return { r: byte(r), g: byte(g), b: byte(b) };
}

function colorStops(
  found: readonly Found<Oklab>[],
  closed: boolean,
  tolerance: number,
): TracedStop<Rgb>[] {
  const kept = usual(found, closed, medianLab, labDistance, NOISE);
  if (kept.length === 0) return [];
  const rows = kept.map(({ offset, value: { l, a, b } }) => [offset, l, a, b]);
  const stops = reduced(rows, tolerance);
  return stops.map((i) => ({
    offset: stops.length === 1 ? 0 : kept[i].offset,
    value: inBytes(calm(kept, i, tolerance, stops.length === 1)),
  }));
}

function blurStops(
  found: readonly Found<number>[],
  closed: boolean,
  scale: number,
): TracedStop<number>[] {
  const apart = (a: number, b: number) => Math.abs(a - b);
  const kept = usual(found, closed, median, apart, RADIUS_TOLERANCE);
  if (kept.length === 0 || median(kept.map(({ value }) => value)) === 0) return [];
  const rows = kept.map(({ offset, value }) => [offset, value]);
  const stops = reduced(rows, RADIUS_TOLERANCE);
  if (stops.length === 1)
    return [{ offset: 0, value: median(kept.map(({ value }) => value)) / scale }];
  return stops.map((i) => ({ offset: kept[i].offset, value: kept[i].value / scale }));
}

/**
 * Returns the photo's colours and blur beside a curve. Leaves out samples across other curves or outside the
 * photo.
 */
export function tracePhoto(photo: Photo, path: CubicPath, options: TraceOptions): Trace {
  const scale = lengthScale(options.photoFromPath);
  if (!(options.spacing > 0) || !(scale > 0)) return { left: [], right: [], blur: [] };
  const stations = stationsOf(path, options);
  const looker = new Looker(photo, path, options);
  const gather = <Value>(look: (station: Station) => Value | null): Found<Value>[] =>
    stations.flatMap((station) => {
      const value = look(station);
      return value === null ? [] : [{ offset: station.offset, value }];
    });
  const radii = new Map(stations.map((station) => [station, looker.radius(station)]));
  const side = (sign: 1 | -1) => {
    const near = sign * options.distance;
    const far = (station: Station) =>
      sign * Math.max(options.distance, options.blurs ? (radii.get(station) ?? 0) : 0);
    const look = (station: Station) =>
      looker.color(station, far(station)) ?? looker.color(station, near);
    return colorStops(gather(look), path.closed, options.tolerance);
  };
  return {
    left: side(1),
    right: side(-1),
    blur: blurStops(
      gather((station) => radii.get(station) ?? null),
      path.closed,
      scale,
    ),
  };
}
