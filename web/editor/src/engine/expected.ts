// The next drag: the front worker prepares it while it has nothing else to do.
import { EngineError } from "./rpc.js";
import type { Seat } from "./seat.js";
import type { CurvePlace } from "./types.js";

const isSame = (a: CurvePlace | null, b: CurvePlace) => a?.layer === b.layer && a.curve === b.curve;

export class Expected {
  readonly #idle: () => Seat | null;
  readonly #lose: (seat: Seat) => void;
  #curve: CurvePlace | null = null;

  /**
   * @param idle the worker, with an exact picture of the text, or null while it is busy
   * @param lose called with a worker whose module can no longer be used
   */
  constructor(idle: () => Seat | null, lose: (seat: Seat) => void) {
    this.#idle = idle;
    this.#lose = lose;
  }

  set(curve: CurvePlace | null): void {
    this.#curve = curve;
    void this.prepare();
  }

  async prepare(): Promise<void> {
    const [seat, curve] = [this.#idle(), this.#curve];
    if (!seat || !curve || isSame(seat.expected, curve)) return;
    seat.expected = curve;
    try {
      await seat.link.call("expect", curve.layer, curve.curve);
    } catch (error) {
      // The drag itself reports errors of the text.
      if (!EngineError.of(error).isOfText) this.#lose(seat);
      return;
    }
    void this.prepare();
  }
}
