// Curves through a drawn line: Schneider's method, with corners.
import type { Point } from "./affine.js";
import { cornersOf } from "./corners.js";
import { lineBetween, type Cubic, type CubicPath } from "./cubic.js";
import { fitted, straight } from "./fitcubic.js";
import type { Sample } from "./sample.js";
import { simplifiedGraph } from "./simplify.js";
import { distance, isSame, scaled, subtract, unit } from "./vector.js";

export interface Fit {
  readonly path: CubicPath;
  /** The samples that the path follows, and their places on it (piece + t). */
  readonly samples: readonly Sample[];
  readonly places: readonly number[];
}

/** As far as the format's coordinates go. */
const LARGEST = 1e7;

const inRange = (value: number) => Math.min(Math.max(value, -LARGEST), LARGEST);

/** Returns the samples that are finite and in range, without repeated points. */
function cleaned(samples: readonly Sample[]): Sample[] {
  const clean: Sample[] = [];
  for (const { point, time, pressure } of samples) {
    if (!point.every((value) => !Number.isNaN(value))) continue;
    const at: Point = [inRange(point[0]), inRange(point[1])];
    if (clean.length > 0 && isSame(clean[clean.length - 1].point, at)) continue;
    clean.push({
      point: at,
      time: Number.isFinite(time) ? time : 0,
      pressure: Math.min(Math.max(Number.isNaN(pressure) ? 0.5 : pressure, 0), 1),
    });
  }
  return clean;
}

/** Returns the direction in which points leave the first of them, measured over a few tolerances. */
function leaving(points: readonly Point[], reach: number): Point | null {
  const [from] = points;
  const far = points.find((p) => distance(p, from) >= reach) ?? points[points.length - 1];
  const near = points.find((p) => !isSame(p, from)) ?? from;
  return unit(subtract(far, from)) ?? unit(subtract(near, from));
}

/** A closed stroke from its sharpest corner on, which then needs no common tangent at its ends. */
function rotated(samples: readonly Sample[], corners: readonly number[]): Sample[] {
  const [first] = corners;
  const turned = [...samples.slice(first ?? 0), ...samples.slice(0, first ?? 0)];
  return [...turned, turned[0]];
}

/**
 * Returns a curve within `tolerance` of each sample, smooth except at corners. null: the samples are one
 * point.
 * @param closed whether the end runs to the beginning
 */
export function fitStroke(
  samples: readonly Sample[],
  tolerance: number,
  closed = false,
): Fit | null {
  let clean = cleaned(samples);
  if (clean.length > 2 && closed && isSame(clean[0].point, clean[clean.length - 1].point))
    clean.pop();
  if (clean.length < 2) return null;
  const isLoop = closed && clean.length > 2;
  const slack = tolerance > 0 ? tolerance : 0;
  const reach = 2 * slack;
  let corners = cornersOf(clean, reach, isLoop);
  const smoothSeam = isLoop && corners.length === 0;
  if (isLoop) {
    clean = rotated(clean, corners);
    corners = corners.map((i) => i - corners[0]).filter((i) => i > 0);
  }
  const points = clean.map((sample) => sample.point);
  const seam = smoothSeam ? seamDirection(points, reach) : null;
  const ends = [0, ...corners, points.length - 1];
  const cubics: Cubic[] = [];
  const places: number[] = [0];
  for (let i = 0; i + 1 < ends.length; ++i) {
    const run = points.slice(ends[i], ends[i + 1] + 1);
    const out = (i === 0 && seam) || leaving(run, reach);
    const backwards = leaving([...run].reverse(), reach);
    const into = i + 2 === ends.length && seam ? scaled(seam, -1) : backwards;
    for (const piece of piecesThrough(run, out, into, slack)) {
      piece.parameters.slice(1).forEach((t) => places.push(cubics.length + t));
      cubics.push(piece.cubic);
    }
  }
  const control = [cubics[0][0], ...cubics.flatMap((cubic) => cubic.slice(1))];
  return { path: { points: control, closed: isLoop }, samples: clean, places };
}

function piecesThrough(
  run: readonly Point[],
  out: Point | null,
  into: Point | null,
  slack: number,
) {
  const line = straight(run, slack);
  if (line) return [line];
  if (run.length > 2 && out && into) return fitted(run, out, into, slack);
  return run.slice(1).map((to, i) => ({ cubic: lineBetween(run[i], to), parameters: [0, 1] }));
}

/** The direction of a smooth loop where it begins and ends. */
function seamDirection(points: readonly Point[], reach: number): Point | null {
  const out = leaving(points, reach);
  const back = leaving([...points].reverse(), reach);
  return out && back ? (unit(subtract(out, back)) ?? out) : out;
}

/**
 * Pressures along a fitted stroke as few stops: [place, pressure], within `tolerance` of each.
 * Places ascend.
 */
export function pressureStops(fit: Fit, tolerance: number): (readonly [number, number])[] {
  const rows = fit.samples.map((sample, i) => [fit.places[i], sample.pressure] as const);
  return simplifiedGraph(rows, tolerance).map((i) => rows[i]);
}
