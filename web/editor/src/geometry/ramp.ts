// How wide the transition across a curve is in a photo.
import type { Oklab } from "./color.js";
import { labDistance } from "./photo.js";

/** Distances from the curve at which both sides are sampled, photo pixels. */
export const REACHES = [1, 2, 4, 8] as const;

/** A step of less in OKLab says nothing about its width. */
const LEAST_STEP = 0.05;
/** A transition this narrow, in pixels to each side, is the camera's. */
const SHARP = 1.5;

/** The colours on both sides of a place, at REACHES, as far as they can be seen. */
export interface Profile {
  readonly left: readonly Oklab[];
  readonly right: readonly Oklab[];
}

/** The share of the step that lies between -s and s. */
function sharesOf({ left, right }: Profile): number[] | null {
  const count = Math.min(left.length, right.length);
  if (count < 2) return null;
  const [from, to] = [left[count - 1], right[count - 1]];
  const step = labDistance(from, to);
  if (step < LEAST_STEP) return null;
  const along = (color: Oklab) =>
    ((color.l - from.l) * (to.l - from.l) +
      (color.a - from.a) * (to.a - from.a) +
      (color.b - from.b) * (to.b - from.b)) /
    (step * step);
  return Array.from({ length: count }, (_, i) => along(right[i]) - along(left[i]));
}

/**
 * How much of a step the engine's blur leaves within s of the curve, y = s / R: 2 β - 1 of eq. 8.
 */
function blurredShare(y: number): number {
  return y < 1 ? (3 * y - y ** 3) / 2 : 1;
}

/**
 * The blur radius whose transition is nearest to the one between both sides, in pixels: 0 for a
 * step, at most a little beyond the last reach. null: there is no step to speak of, or it cannot be
 * seen.
 */
export function rampRadius(profile: Profile): number | null {
  const shares = sharesOf(profile);
  if (!shares) return null;
  const miss = (radius: number) =>
    shares.reduce((sum, share, i) => sum + (share - blurredShare(REACHES[i] / radius)) ** 2, 0);
  const last = 1.4 * REACHES[shares.length - 1];
  let [best, least] = [0.5, Infinity];
  for (let radius = 0.5; radius <= last; radius *= 1.02) {
    const found = miss(radius);
    if (found < least - 1e-12) [best, least] = [radius, found];
  }
  return best <= SHARP ? 0 : best;
}
