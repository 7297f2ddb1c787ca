// Pictures of the page as pixels, compared.
import { pathToFileURL } from "node:url";
import { check, packageOf } from "./harness.mjs";

const { decode } = await import(pathToFileURL(packageOf.resolve("fast-png")).href);

/** The largest difference of two PNGs in code values, where `counts(x, y)`; different sizes are an error. */
export function largestDifference(before, after, counts = () => true) {
  const [a, b] = [before, after].map((png) => decode(png));
  check(a.width === b.width && a.height === b.height, "the pictures differ in size");
  let most = 0;
  for (let k = 0; k < a.data.length; k += 1) {
    const pixel = Math.floor(k / a.channels);
    const difference = Math.abs(a.data[k] - b.data[k]);
    if (difference > most && counts(pixel % a.width, Math.floor(pixel / a.width))) most = difference;
  }
  return most;
}

/** The colour of a pixel, [r, g, b]. */
export function pixel(png, x, y) {
  const { data, width, channels } = decode(png);
  const at = (Math.round(y) * width + Math.round(x)) * channels;
  return [...data.subarray(at, at + 3)];
}
