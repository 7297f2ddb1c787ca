// Files of another text than the drawing's, each in a worker of its own.
import { inOwnWorker } from "./own-worker.js";
import type { Link } from "./rpc.js";
import type { Host } from "./seat.js";
import type { Engine, GivenImage } from "./types.js";

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
