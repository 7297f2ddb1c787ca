// Workers for one piece of work: ending one takes no time, and nothing of it stays.
import * as en from "../strings/en.js";
import { Link } from "./rpc.js";
import { moduleOf, workerOf, type Host } from "./seat.js";

export async function started(host: Host): Promise<Link> {
  const link = new Link(workerOf(host), en.engine.noWorker);
  try {
    await link.call("start", await moduleOf(host), "trace");
  } catch (error) {
    link.end();
    throw error;
  }
  return link;
}

/**
 * Returns the answer of a worker that is started for it. The worker ends then, or when the signal aborts.
 * @throws the signal's reason; EngineError
 */
export async function inOwnWorker<Value>(
  host: Host,
  signal: AbortSignal,
  work: (link: Link) => Promise<Value>,
): Promise<Value> {
  signal.throwIfAborted();
  const link = await started(host);
  const stop = () => link.end();
  signal.addEventListener("abort", stop);
  try {
    signal.throwIfAborted();
    return await work(link);
  } catch (error) {
    signal.throwIfAborted();
    throw error;
  } finally {
    signal.removeEventListener("abort", stop);
    link.end();
  }
}
