// A worker, and what it has of the text.
import { Link } from "./rpc.js";
import type { ReadResult, SolveOptions } from "./session.js";
import type { EngineCurve, GivenImage, LayerCurves, QuickChange } from "./types.js";
import * as en from "../strings/en.js";

const words = en.engine;

/** Where workers and the module come from: a site, or one file. */
export interface Host {
  module(): Promise<WebAssembly.Module>;
  worker(): Worker;
}

/** null: the browser makes none for this page. */
export function workerOf(host: Host): Worker | null {
  try {
    return host.worker();
  } catch {
    return null;
  }
}

export async function moduleOf(host: Host): Promise<WebAssembly.Module> {
  if (!("WebAssembly" in globalThis)) throw new Error(words.noWebAssembly);
  try {
    return await host.module();
  } catch (error) {
    throw new Error(words.noModule(error instanceof Error ? error.message : String(error)));
  }
}

/**
 * Hands in the images that a worker has not got. More may be added to the list meanwhile.
 * @param count how many it has
 * @returns how many it has then
 */
export async function giveImages(link: Link, images: readonly GivenImage[], count: number): Promise<number> {
  const missing = images.slice(count);
  if (missing.length > 0) await link.call("addImages", missing);
  return count + missing.length;
}

export class Seat {
  readonly link: Link;
  /** Resolves when it can be called. */
  readonly ready: Promise<void>;
  isStarted = false;
  version = "";
  /** Number of the text that its document is of; -1: none. */
  serial = -1;
  /** Number of the text that it has read; -1: none. */
  readSerial = -1;
  /** Whether curves were changed since then. */
  isChanged = false;
  curves: readonly EngineCurve[] = [];
  /** The options that it has made an exact picture for; null: none. */
  exactFor: SolveOptions | null = null;
  /** Whether its last picture is exact. */
  isExact = false;
  /** The curves whose drag it has begun since. */
  expected: LayerCurves | null = null;
  #imageCount = 0;

  /** @param name distinguishes its stamps from others' */
  constructor(host: Host, name: string) {
    this.link = new Link(workerOf(host), words.noWorker);
    this.ready = this.#start(host, name);
    // A caller that waits gets the error; it is no error if none waits.
    this.ready.catch(() => {});
  }

  async #start(host: Host, name: string): Promise<void> {
    this.version = await this.link.call<string>("start", await moduleOf(host), name);
    this.isStarted = true;
  }

  /** Hands in the images that it has not got. */
  async give(images: readonly GivenImage[]): Promise<void> {
    this.#imageCount = await giveImages(this.link, images, this.#imageCount);
  }

  /**
   * Gives its document a text, by changes where these are known. After changes of curves alone, as in a drag,
   * the text has its curves in the same order. A curve without a length is missing there; the others keep
   * their numbers.
   * @throws EngineError; the document is as before then
   */
  async bring(
    text: string,
    serial: number,
    changes: readonly QuickChange[] | null,
    images: readonly GivenImage[],
    moving = false,
  ): Promise<void> {
    await this.give(images);
    if (changes) {
      if (changes.length > 0) await this.link.call("change", changes);
      this.isChanged ||= changes.length > 0;
    } else {
      this.expected = null;
      const { curves } = await this.link.call<ReadResult>("read", text);
      if (!moving || !this.isChanged || curves.length !== this.curves.length) {
        this.curves = curves;
        this.readSerial = serial;
      }
      this.isChanged = false;
    }
    this.serial = serial;
  }

  end(): void {
    this.link.end();
  }
}
