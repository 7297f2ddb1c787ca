// How wide the transition across a curve is in a photo.
import type { Oklab } from "./color.js";
import { labDistance } from "./photo.js";

/** Distances from the curve at which both sides are looked at, photo pixels. */
export const REACHES = [1, 2, 4, 8] as const;

/** A step of less in OKLab says nothing about its width. */
const LEAST_STEP = 0.05;
/** A transition this narrow, in pixels to each side, is the camera's. */
const SHARP = 1.3;

/** The colours on both sides of a place, as far as they can be seen: at the first of REACHES, … */
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
 * Half the width of the ramp between both sides, in pixels: 0 for a step, at most the last reach.
 * null: there is no step to speak of, or it cannot be seen.
 */
export function rampHalfWidth(profile: Profile): number | null {
  const shares = sharesOf(profile);
  if (!shares) return null;
  const last = REACHES[shares.length - 1];
  // The last is 1 by construction. A ramp has min(1, s / w) within s.
  const miss = (width: number) =>
    shares.slice(0, -1).reduce((sum, share, i) => sum + (share - Math.min(1, REACHES[i] / width)) ** 2, 0);
  let [best, least] = [0.5, Infinity];
  for (let width = 0.5; width <= last * 1.001; width *= 1.02) {
    const found = miss(width);
    if (found < least - 1e-12) [best, least] = [width, found];
  }
  return best <= SHARP ? 0 : Math.min(best, last);
}
