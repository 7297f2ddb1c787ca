// The drag that the hand is about to begin, which the front seat begins while it has nothing else to do.
import { EngineError } from "./rpc.js";
import type { Seat } from "./seat.js";
import type { CurvePlace } from "./types.js";

const isSame = (a: CurvePlace | null, b: CurvePlace) => a?.layer === b.layer && a.curve === b.curve;

export class Expected {
  readonly #idle: () => Seat | null;
  readonly #lose: (seat: Seat) => void;
  #curve: CurvePlace | null = null;

  /**
   * @param idle the seat, with an exact picture of the text, or null while it is to do something else
   * @param lose told of a seat whose module is of no more use
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
      // Of the text the drag itself says what is wrong.
      if (!EngineError.of(error).isOfText) this.#lose(seat);
      return;
    }
    void this.prepare();
  }
}
