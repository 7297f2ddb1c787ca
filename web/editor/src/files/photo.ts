// Pixels of a photo as people see it: rotated as its camera says, with colours in sRGB.
import type { PhotoPixels } from "../engine/types.js";
import * as en from "../strings/en.js";

/**
 * The browser scales down larger photos, faster than the module could. The module reads a quarter of these
 * pixels.
 */
const MOST_PIXELS = 4e6;

/** The size that is read of a photo of that size. */
export function sizeRead(width: number, height: number): { readonly width: number; readonly height: number } {
  const scale = Math.min(1, Math.sqrt(MOST_PIXELS / (width * height)));
  const side = (length: number) => Math.max(1, Math.floor(length * scale));
  return { width: side(width), height: side(height) };
}

/** @throws Error where the browser cannot, in words */
export async function photoPixels(blob: Blob, name: string): Promise<PhotoPixels> {
  const picture = await createImageBitmap(blob).catch(() => null);
  if (!picture) throw new Error(en.files.undecodable(name));
  try {
    const { width, height } = sizeRead(picture.width, picture.height);
    const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
    if (!context) throw new Error(en.files.pictureTooLarge);
    context.imageSmoothingQuality = "high";
    context.drawImage(picture, 0, 0, width, height);
    return { width, height, data: context.getImageData(0, 0, width, height).data };
  } finally {
    picture.close();
  }
}
