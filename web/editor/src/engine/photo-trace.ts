// Photos traced, and drawings fitted to them, in workers of their own: the editor goes on meanwhile, and ending one takes no time.
// A second one draws what the first has reached, so that looking at it holds nothing up.
import * as en from "../strings/en.js";
import type { CubicPath } from "../geometry/cubic.js";
import { inOwnWorker, started } from "./own-worker.js";
import { EngineError, type Link } from "./rpc.js";
import { giveImages, type Host } from "./seat.js";
import type {
  FittedCurve,
  FitWish,
  GivenImage,
  PhotoPixels,
  RasterWish,
  SnapWish,
  TraceRound,
  TraceWish,
} from "./types.js";
import { Status } from "../../../wasm/library.mjs";

const words = en.engine;

/** The library's words, but where memory is out, which it says for programmers. */
function traceError(error: unknown): Error {
  const found = EngineError.of(error);
  return found.code === Status.outOfMemory ? new Error(words.traceTooLarge) : found;
}

/**
 * Returns a photo traced to SVG.
 * @param heard called after each round
 * @throws the signal's reason; EngineError; Error where it takes more memory than there is
 */
export async function tracePhoto(
  host: Host,
  wish: TraceWish,
  heard: (round: TraceRound) => void,
  signal: AbortSignal,
): Promise<string> {
  try {
    return await inOwnWorker(host, signal, (link) => {
      link.onNote = heard;
      return link.call<string>("trace", wish);
    });
  } catch (error) {
    signal.throwIfAborted();
    throw traceError(error);
  }
}

/**
 * The curves of a drawing with the colours, or the blur, of a photo.
 * @throws the signal's reason; EngineError; Error where it takes more memory than there is
 */
export async function fitToPhoto(
  host: Host,
  wish: FitWish,
  images: readonly GivenImage[],
  signal: AbortSignal,
): Promise<readonly FittedCurve[]> {
  try {
    return await inOwnWorker(host, signal, async (link) => {
      await link.call("addImages", images);
      return link.call<readonly FittedCurve[]>("fit", wish);
    });
  } catch (error) {
    signal.throwIfAborted();
    throw traceError(error);
  }
}

/** Curves moved to a photo's edges, null where there are none. @throws the signal's reason; EngineError */
export function snapToPhoto(
  host: Host,
  wish: SnapWish,
  signal: AbortSignal,
): Promise<readonly (CubicPath | null)[]> {
  return inOwnWorker(host, signal, (link) => link.call("snap", wish));
}

export interface PreviewWish {
  readonly text: string;
  readonly width: number;
  readonly height: number;
  /** Another one follows: it is to be there soon. */
  readonly isDraft: boolean;
  /** CSS colour; absent: the document's. */
  readonly background?: string;
  /** Pixels of images that the text names: all that there are, in one order. */
  readonly images?: readonly GivenImage[];
}

/** Draws texts. While it works, the latest request replaces earlier ones. */
export class TracePreviews {
  #link: Promise<Link> | null = null;
  #next: (() => Promise<void>) | null = null;
  #isAtWork = false;
  #isOver = false;
  #imageCount = 0;

  constructor(private readonly host: Host) {}

  /** @param show gets the pixels, unless another text replaced this one before its turn came */
  draw(
    { text, isDraft, width, height, background, images = [] }: PreviewWish,
    show: (pixels: PhotoPixels) => void,
  ): void {
    this.#next = async () => {
      const link = await (this.#link ??= started(this.host));
      this.#imageCount = await giveImages(link, images, this.#imageCount);
      await link.call("read", text);
      const wish: RasterWish = { width, height, viewport: null, background: background ?? null, depth: 8, isDraft };
      const data = await link.call<Uint8ClampedArray<ArrayBuffer>>("raster", wish);
      if (!this.#isOver) show({ width, height, data });
    };
    void this.#work();
  }

  async #work(): Promise<void> {
    if (this.#isAtWork) return;
    this.#isAtWork = true;
    for (let next = this.#next; next && !this.#isOver; next = this.#next) {
      this.#next = null;
      // A preview that fails is not there; the trace says what is wrong.
      await next().catch(() => undefined);
    }
    this.#isAtWork = false;
  }

  end(): void {
    this.#isOver = true;
    this.#link?.then((link) => link.end(), () => undefined);
  }
}
