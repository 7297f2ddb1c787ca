// The drag that the hand is about to begin, which the front seat begins while it has nothing else to do.
import type { Seat } from "./seat.js";
import type { CurvePlace } from "./types.js";

const isSame = (a: CurvePlace | null, b: CurvePlace) => a?.layer === b.layer && a.curve === b.curve;

export class Expected {
  readonly #idle: () => Seat | null;
  #curve: CurvePlace | null = null;

  /** @param idle the seat, with an exact picture of the text, or null while it is to do something else */
  constructor(idle: () => Seat | null) {
    this.#idle = idle;
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
    } catch {
      // The drag itself says what is wrong.
      return;
    }
    void this.prepare();
  }
}
