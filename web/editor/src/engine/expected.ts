// The next drag: the front worker prepares it while it has nothing else to do.
import { EngineError } from "./rpc.js";
import type { Seat } from "./seat.js";
import type { LayerCurves } from "./types.js";

const isSame = (a: LayerCurves | null, b: LayerCurves) =>
  a?.layer === b.layer && a.curves.join() === b.curves.join();

export class Expected {
  readonly #idle: () => Seat | null;
  readonly #lose: (seat: Seat) => void;
  #curves: LayerCurves | null = null;

  /**
   * @param idle the worker, with an exact picture of the text, or null while it is busy
   * @param lose called with a worker whose module can no longer be used
   */
  constructor(idle: () => Seat | null, lose: (seat: Seat) => void) {
    this.#idle = idle;
    this.#lose = lose;
  }

  set(curves: LayerCurves | null): void {
    this.#curves = curves;
    void this.prepare();
  }

  async prepare(): Promise<void> {
    const [seat, curves] = [this.#idle(), this.#curves];
    if (!seat || !curves || isSame(seat.expected, curves)) return;
    seat.expected = curves;
    try {
      await seat.link.call("expect", curves);
    } catch (error) {
      // The drag itself reports errors of the text.
      if (!EngineError.of(error).isOfText) this.#lose(seat);
      return;
    }
    void this.prepare();
  }
}
