// Deliberate corners of a drawn line.
import type { Sample } from "./sample.js";
import { dot, distance, subtract, unit } from "./vector.js";

/** A larger turn is a corner; a smaller one suffices where the pointer is slow. */
const SHARP = Math.cos((60 * Math.PI) / 180);
const SHARP_WHERE_SLOW = Math.cos((40 * Math.PI) / 180);
const SLOW = 1 / 3;
/**
 * Tremor turns less when measured over a longer reach: the factor of the reach, and the cosine of the least
 * turn.
 */
const FARTHER = 2.5;
const SHARP_FROM_FAR = Math.cos((30 * Math.PI) / 180);

/** Returns the first sample from i on, in steps of ±1, that is `reach` away; the last sample if there is none. */
function armOf(
  samples: readonly Sample[],
  i: number,
  step: number,
  reach: number,
  loop: boolean,
): number {
  const count = samples.length;
  let j = i;
  for (let steps = 1; steps < count; ++steps) {
    const next = loop ? (i + step * steps + steps * count) % count : i + step * steps;
    if (next < 0 || next >= count) break;
    j = next;
    if (distance(samples[i].point, samples[j].point) >= reach) break;
  }
  return j;
}

/** Per sample, the cosine of the turn there; 1 at the ends of an open stroke. */
function turnsOf(samples: readonly Sample[], reach: number, loop: boolean): number[] {
  return samples.map(({ point }, i) => {
    const back = armOf(samples, i, -1, reach, loop);
    const ahead = armOf(samples, i, 1, reach, loop);
    const into = unit(subtract(point, samples[back].point));
    const out = unit(subtract(samples[ahead].point, point));
    return into && out ? dot(into, out) : 1;
  });
}

/** Distance over time around each sample, as a share of the median; 1 where there are no times. */
function speedsOf(samples: readonly Sample[]): number[] {
  const last = samples.length - 1;
  const speeds = samples.map((_, i) => {
    const [a, b] = [samples[Math.max(i - 1, 0)], samples[Math.min(i + 1, last)]];
    return b.time > a.time ? distance(a.point, b.point) / (b.time - a.time) : Infinity;
  });
  const middle = [...speeds].sort((a, b) => a - b)[speeds.length >> 1];
  return speeds.map((speed) => (Number.isFinite(middle) && middle > 0 ? speed / middle : 1));
}

/**
 * Returns the indices of samples at which the stroke has a corner, ascending, without the ends of an open
 * one.
 * @param reach length over which directions are measured: smaller tremor is no corner
 * @param loop whether the last sample is followed by the first
 */
export function cornersOf(samples: readonly Sample[], reach: number, loop: boolean): number[] {
  const turns = turnsOf(samples, reach, loop);
  const farTurns = turnsOf(samples, FARTHER * reach, loop);
  const speeds = speedsOf(samples);
  const isSharp = (i: number) =>
    turns[i] <= (speeds[i] < SLOW ? SHARP_WHERE_SLOW : SHARP) && farTurns[i] <= SHARP_FROM_FAR;
  const corners: number[] = [];
  for (let i = loop ? 0 : 1; i < samples.length - (loop ? 0 : 1); ++i) {
    if (!isSharp(i)) continue;
    // Among samples of one corner the sharpest counts.
    const last = corners[corners.length - 1];
    const isNear = last !== undefined && distance(samples[last].point, samples[i].point) < reach;
    if (!isNear) corners.push(i);
    else if (turns[i] < turns[last]) corners[corners.length - 1] = i;
  }
  const [first, last] = [corners[0], corners[corners.length - 1]];
  const isSeam = loop && corners.length > 1 && distance(samples[first].point, samples[last].point) < reach;
  if (!isSeam) return corners;
  return turns[last] < turns[first] ? corners.slice(1) : corners.slice(0, -1);
}
