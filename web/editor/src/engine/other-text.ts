// Work on another text than the drawing's, each piece in a worker of its own.
import { inOwnWorker } from "./own-worker.js";
import type { Link } from "./rpc.js";
import type { Host } from "./seat.js";
import type { Engine, GivenImage, ImportedSvg } from "./types.js";

/** Work that takes long. */
export interface Watch {
  readonly signal: AbortSignal;
  /** Called with the share that is done, 0 to 1. */
  readonly onProgress: (share: number) => void;
}

/** The functions of the engine that export calls. */
export type Exporter = Pick<Engine, "raster" | "payload" | "write">;

/** Returns the same functions for another text. They throw the signal's reason, or an EngineError. */
export function exporterOf(
  host: Host,
  text: string,
  images: readonly GivenImage[],
  signal: AbortSignal,
): Exporter {
  const within = <Value>(work: (link: Link) => Promise<Value>) =>
    inOwnWorker(host, signal, async (link) => {
      await link.call("addImages", images);
      await link.call("read", text);
      return work(link);
    });
  return {
    raster: (wish) => within((link) => link.call("raster", wish)),
    payload: () => within((link) => link.call("payload")),
    write: (wish) => within((link) => link.call("write", wish)),
  };
}

/** Returns the shapes of an ordinary SVG as curves. @throws the signal's reason; EngineError */
export function importedSvg(
  host: Host,
  text: string,
  images: readonly GivenImage[],
  { signal, onProgress }: Watch,
): Promise<ImportedSvg> {
  return inOwnWorker(host, signal, async (link) => {
    link.onNote = onProgress;
    await link.call("addImages", images);
    return link.call("importSvg", text);
  });
}
