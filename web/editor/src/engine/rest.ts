// How long the pointer must rest before the exact picture is requested, milliseconds.

const REST = 120;
/** While a gesture is open: an open colour picker, or a drag that pauses. */
const HELD = 600;
/** The same where the exact picture would delay a drag that goes on. */
const LONG = 10_000;
/** A change after a pause of this length, in milliseconds, stands alone, and is made exact at once. */
const ALONE = 600;

export class Rest {
  #last = -Infinity;

  /**
   * Returns the wait after a change, in milliseconds. Opening a drawing or undo need not wait for a pointer
   * that goes on.
   */
  afterChange(moving: boolean, now = performance.now()): number {
    const isAlone = !moving && now - this.#last > ALONE;
    this.#last = now;
    return isAlone ? 0 : this.again(moving);
  }

  /** How much of a long rest is left. */
  left(now = performance.now()): number {
    return Math.max(0, this.#last + LONG - now);
  }

  /** After a picture that was not the last. */
  again(moving: boolean): number {
    return moving ? HELD : REST;
  }
}
