// Small pictures of the drawing, as the command draws them.
import type { Exporter } from "../engine/other-text.js";
import type { Box } from "../geometry/affine.js";

/** The longer side, pixels. */
const SIDE = 640;

/** An address that its user revokes; null where the drawing cannot be drawn. */
export async function previewOf(engine: Exporter, viewport: Box, transparent: boolean): Promise<string | null> {
  const [x0, y0, x1, y1] = viewport;
  const scale = SIDE / (Math.max(x1 - x0, y1 - y0) || 1);
  const width = Math.max(1, Math.round((x1 - x0) * scale));
  const height = Math.max(1, Math.round((y1 - y0) * scale));
  const background = transparent ? "none" : null;
  try {
    const pixels = await engine.raster({ width, height, viewport, background, depth: 8 });
    const canvas = new OffscreenCanvas(width, height);
    canvas.getContext("2d")!.putImageData(new ImageData(pixels as Uint8ClampedArray<ArrayBuffer>, width, height), 0, 0);
    return URL.createObjectURL(await canvas.convertToBlob());
  } catch {
    return null;
  }
}
