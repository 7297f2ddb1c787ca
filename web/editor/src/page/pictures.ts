// Pixels of the pictures that drawings name: decoded once, and handed to the engine before it reads.
import type { GivenImage } from "../engine/types.js";
import { decodeImage, hrefsOf, imagesOf, nothingBeside, type Beside, type DrawingImage } from "../files/images.js";

export interface PictureTaker {
  addImages(images: readonly GivenImage[]): void;
}

/** Pictures that a drawing names and the engine does not get. */
export interface Lost {
  /** Names of files that are not there. */
  readonly missing: readonly string[];
  /** Pictures that no browser decodes. */
  readonly broken: number;
}

const nothingLost: Lost = { missing: [], broken: 0 };
const isWithin = (href: string) => /^data:/i.test(href);

export class Pictures {
  /** Names of pictures that the engine has, or cannot get as things are. */
  #known = new Set<string>();
  #beside: Beside = nothingBeside;

  constructor(private readonly engine: PictureTaker) {}

  /**
   * Replaces the source of the files beside the drawing: names refer to other files now.
   * @returns the source before
   */
  begin(beside: Beside): Beside {
    const before = this.#beside;
    this.#beside = beside;
    this.#known = new Set([...this.#known].filter(isWithin));
    return before;
  }

  /** Whether a text names pictures that were not looked for. */
  hasNew(text: string): boolean {
    return text.includes("<image") && hrefsOf(text).some((href) => !this.#known.has(href));
  }

  /** Passes the pictures that a text names to the engine. Reports each lost one once. */
  async take(text: string): Promise<Lost> {
    if (!this.hasNew(text)) return nothingLost;
    const beside = this.#beside;
    const isNew = (href: string) => !this.#known.has(href);
    const { found, missing } = await imagesOf(text, beside, isNew);
    // Another drawing has come in the meantime.
    if (beside !== this.#beside) return nothingLost;
    for (const href of missing) this.#known.add(href);
    let broken = 0;
    for (const image of found) if (!(await this.#give(image))) broken += 1;
    return { missing, broken };
  }

  /** @returns false: no browser decodes it */
  async #give({ href, bytes }: DrawingImage): Promise<boolean> {
    this.#known.add(href);
    const pixels = await decodeImage(bytes);
    if (!pixels) return false;
    const { width, height, data } = pixels;
    const clamped = new Uint8ClampedArray(data.buffer, data.byteOffset, data.byteLength);
    this.engine.addImages([{ href, bytes, pixels: { width, height, data: clamped } }]);
    return true;
  }
}
