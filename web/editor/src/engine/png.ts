// PNG files of pixels, made in a worker.
import { createPngWorker } from "./host.js";

export interface PngPixels {
  readonly width: number;
  readonly height: number;
  /** RGBA, rows from the top, alpha not premultiplied. They are handed over: the array is empty afterwards. */
  readonly data: Uint8ClampedArray<ArrayBuffer> | Uint16Array<ArrayBuffer>;
}

export type PngAnswer = { readonly png: Uint8Array<ArrayBuffer> } | { readonly error: string };

/** A PNG of 8 or 16 bits, as the array has; without alpha where all is opaque. @throws Error; the signal's reason */
export function encodePng(pixels: PngPixels, signal?: AbortSignal): Promise<Uint8Array<ArrayBuffer>> {
  signal?.throwIfAborted();
  const worker = createPngWorker();
  return new Promise<Uint8Array<ArrayBuffer>>((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<PngAnswer>) =>
      "png" in data ? resolve(data.png) : reject(new Error(data.error));
    worker.onerror = (event) => reject(new Error(event.message));
    signal?.addEventListener("abort", () => reject(signal.reason));
    worker.postMessage(pixels, [pixels.data.buffer]);
  }).finally(() => worker.terminate());
}
