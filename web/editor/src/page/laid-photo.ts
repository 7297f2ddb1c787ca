// The photo that lies on a drawing, as pixels of its artboard.
import { photoOf, referenceAt } from "../canvas/photo.js";
import type { PhotoPixels } from "../engine/types.js";
import { composed, inverted, lengthScale, translation, type Affine } from "../geometry/affine.js";
import type { Drawing } from "../model/types.js";
import * as en from "../strings/en.js";

export interface LaidPhoto {
  /** As large as the artboard; clear where there is no photo. */
  readonly pixels: PhotoPixels;
  readonly pixelFromArtboard: Affine;
}

/** Pixels of the longer side at least: the border of a coarse photo is to lie where it does. */
const LEAST = 256;

/** Whether a photo that is not hidden lies anywhere. */
export const hasPhoto = (drawing: Drawing): boolean => referenceAt(drawing, null) !== null;

/**
 * The topmost photo as it lies on the artboard, no finer than it is itself unless that is coarse.
 * @param most pixels of the longer side
 * @returns null: there is none, or no browser decodes it
 */
export async function laidPhoto(drawing: Drawing, most: number): Promise<LaidPhoto | null> {
  const reference = referenceAt(drawing, null);
  const photo = reference && (await photoOf(reference));
  const back = photo && inverted(photo.artboardFromPixel);
  if (!photo || !back) return null;
  const [x0, y0, x1, y1] = drawing.artboard;
  const [w, h] = [x1 - x0, y1 - y0];
  const side = Math.min(most, Math.max(LEAST, lengthScale(back) * Math.max(w, h)));
  const scale = side / Math.max(w, h);
  const [width, height] = [w, h].map((length) => Math.max(1, Math.round(length * scale)));
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  const whole = new OffscreenCanvas(photo.width, photo.height);
  const own = whole.getContext("2d");
  if (!context || !own) throw new Error(en.files.pictureTooLarge);
  const data = new Uint8ClampedArray(photo.data.buffer as ArrayBuffer, photo.data.byteOffset, photo.data.length);
  own.putImageData(new ImageData(data, photo.width, photo.height), 0, 0);
  const pixelFromArtboard = composed([width / w, 0, 0, height / h, 0, 0], translation(-x0, -y0));
  const [a, b, c, d, e, f] = composed(pixelFromArtboard, photo.artboardFromPixel);
  context.setTransform(a, b, c, d, e, f);
  context.imageSmoothingQuality = "high";
  context.drawImage(whole, 0, 0);
  return { pixels: { width, height, data: context.getImageData(0, 0, width, height).data }, pixelFromArtboard };
}
