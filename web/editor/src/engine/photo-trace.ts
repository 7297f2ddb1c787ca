// Photos traced in workers of their own: the editor goes on meanwhile, and ending one takes no time.
// A second one draws what the first has reached, so that looking at it holds nothing up.
import { en } from "../strings/en.js";
import { EngineError, Link } from "./rpc.js";
import { moduleOf, workerOf, type Host } from "./seat.js";
import type { PhotoPixels, RasterWish, TraceRound, TraceWish } from "./types.js";
import { Status } from "../../../wasm/library.mjs";

const words = en.engine;

async function started(host: Host): Promise<Link> {
  const link = new Link(workerOf(host), words.noWorker);
  try {
    await link.call("start", await moduleOf(host), "trace");
  } catch (error) {
    link.end();
    throw error;
  }
  return link;
}

/** The library's words, but where memory is out, which it says for programmers. */
function traceError(error: unknown): Error {
  const found = EngineError.of(error);
  return found.code === Status.outOfMemory ? new Error(words.traceTooLarge) : found;
}

/**
 * The drawing of a photo, as SVG.
 * @param heard told after each round
 * @throws the signal's reason; EngineError; Error where it takes more memory than there is
 */
export async function tracePhoto(
  host: Host,
  wish: TraceWish,
  heard: (round: TraceRound) => void,
  signal: AbortSignal,
): Promise<string> {
  signal.throwIfAborted();
  const link = await started(host);
  const stop = () => link.end();
  signal.addEventListener("abort", stop);
  link.onNote = heard;
  try {
    signal.throwIfAborted();
    return await link.call<string>("trace", wish);
  } catch (error) {
    signal.throwIfAborted();
    throw traceError(error);
  } finally {
    signal.removeEventListener("abort", stop);
    link.end();
  }
}

export interface PreviewWish {
  readonly text: string;
  readonly width: number;
  readonly height: number;
  /** Another one follows: it is to be there soon. */
  readonly isDraft: boolean;
}

/** Draws texts, the latest of those that are asked for while it works. */
export class TracePreviews {
  #link: Promise<Link> | null = null;
  #next: (() => Promise<void>) | null = null;
  #isAtWork = false;
  #isOver = false;

  constructor(private readonly host: Host) {}

  /** @param show gets the pixels, unless another text was asked for before its turn came */
  draw({ text, isDraft, width, height }: PreviewWish, show: (pixels: PhotoPixels) => void): void {
    this.#next = async () => {
      const link = await (this.#link ??= started(this.host));
      await link.call("read", text);
      const wish: RasterWish = { width, height, viewport: null, background: null, depth: 8, isDraft };
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
