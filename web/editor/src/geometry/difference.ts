// How far a drawing is from a photo, as a picture and as a number.
import type { Photo } from "./photo.js";

/** The difference that is shown as the last colour, of 255: smaller ones are made larger for the eye. */
export const MOST_DIFFERENCE = 64;
/** From none to MOST_DIFFERENCE; each is lighter than the one before, so that no hue needs to be recognized. */
const RAMP = [
  [0, 0, 4],
  [81, 18, 124],
  [183, 55, 121],
  [252, 137, 97],
  [252, 253, 191],
] as const;
/** Where the photo is less than this there is nothing to compare with. */
const SEEN = 128;

export interface DifferencePicture {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray<ArrayBuffer>;
  /** Decibels, of code values: infinite where both are the same; null: they are nowhere compared. */
  readonly psnr: number | null;
}

/** The ramp's colours, for a legend. */
export const differenceColors: readonly string[] = RAMP.map((color) => `rgb(${color.join(" ")})`);

/** A colour for each difference in code values. */
function table(): Uint8ClampedArray {
  const colors = new Uint8ClampedArray(4 * 256);
  for (let value = 0; value < 256; ++value) {
    const place = (Math.min(value / MOST_DIFFERENCE, 1) * (RAMP.length - 1));
    const step = Math.min(Math.floor(place), RAMP.length - 2);
    for (let k = 0; k < 3; ++k) {
      colors[4 * value + k] = RAMP[step][k] + (place - step) * (RAMP[step + 1][k] - RAMP[step][k]);
    }
    colors[4 * value + 3] = 255;
  }
  return colors;
}

/** @param drawing opaque, of the photo's size */
export function differenceOf(photo: Photo, drawing: Photo): DifferencePicture {
  const { width, height } = photo;
  const colors = table();
  const data = new Uint8ClampedArray(4 * width * height);
  let [squares, count] = [0, 0];
  for (let i = 0; i < data.length; i += 4) {
    if (photo.data[i + 3] < SEEN) continue;
    let most = 0;
    for (let k = i; k < i + 3; ++k) {
      const by = Math.abs(photo.data[k] - drawing.data[k]);
      squares += by * by;
      if (by > most) most = by;
    }
    count += 3;
    data.set(colors.subarray(4 * most, 4 * most + 4), i);
  }
  const psnr = count === 0 ? null : 10 * Math.log10((255 * 255 * count) / squares);
  return { width, height, data, psnr };
}
