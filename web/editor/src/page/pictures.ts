// Pixels of the pictures that drawings name: decoded once, and handed to the engine before it reads.
import type { GivenImage } from "../engine/session.js";
import { decodeImage, hrefsOf, imagesOf, nothingBeside, type Beside } from "../files/images.js";

export interface PictureTaker {
  addImages(images: readonly GivenImage[]): void;
}

export class Pictures {
  #known = new Set<string>();
  #beside: Beside = nothingBeside;

  constructor(private readonly engine: PictureTaker) {}

  /** Another drawing is open, with files beside it. */
  begin(beside: Beside): void {
    this.#beside = beside;
  }

  /** Whether a text names pictures that the engine does not have. */
  hasNew(text: string): boolean {
    return text.includes("<image") && hrefsOf(text).some((href) => !this.#known.has(href));
  }

  /**
   * Hands in what a text names.
   * @returns names of files that are not there, or that no browser decodes
   */
  async take(text: string): Promise<readonly string[]> {
    if (!this.hasNew(text)) return [];
    const { found, missing } = await imagesOf(text, this.#beside);
    const lost = [...missing];
    for (const { href, bytes } of found) {
      if (this.#known.has(href)) continue;
      const pixels = await decodeImage(bytes);
      if (!pixels) {
        lost.push(href);
        continue;
      }
      this.#known.add(href);
      const { width, height, data } = pixels;
      const clamped = new Uint8ClampedArray(data.buffer, data.byteOffset, data.byteLength);
      this.engine.addImages([{ href, bytes, pixels: { width, height, data: clamped } }]);
    }
    return lost;
  }
}
