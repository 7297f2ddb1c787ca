// Compares screenshots as pixels.
import { pathToFileURL } from "node:url";
import { check, packageOf } from "./harness.mjs";

export const { decode } = await import(pathToFileURL(packageOf.resolve("fast-png")).href);

/**
 * Returns the largest difference of two PNGs in code values, where `counts(x, y)`. Different sizes are an error. An
 * alpha channel of only one PNG is ignored.
 */
export function largestDifference(before, after, counts = () => true) {
  const [a, b] = [before, after].map((png) => decode(png));
  check(a.width === b.width && a.height === b.height, "the pictures differ in size");
  const channels = Math.min(a.channels, b.channels);
  let most = 0;
  for (let k = 0; k < a.width * a.height * channels; k += 1) {
    const pixel = Math.floor(k / channels);
    const difference = Math.abs(a.data[k + pixel * (a.channels - channels)] - b.data[k + pixel * (b.channels - channels)]);
    if (difference > most && counts(pixel % a.width, Math.floor(pixel / a.width))) most = difference;
  }
  return most;
}

/** Returns how many colours a PNG has. */
export function countColors(png) {
  const { data, channels } = decode(png);
  const colors = new Set();
  for (let k = 0; k < data.length; k += channels) colors.add((data[k] << 16) | (data[k + 1] << 8) | data[k + 2]);
  return colors.size;
}
