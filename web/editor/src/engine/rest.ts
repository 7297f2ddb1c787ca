// How long a hand must rest before the exact picture is asked for, milliseconds.

const REST = 120;
/** While a gesture is not over: a colour picker that is open, a hand that holds still. */
const HELD = 600;
/** The same where the exact picture would hold up a hand that goes on. */
const LONG = 10_000;
/** What comes after so long is a change by itself, and is made exact at once. */
const ALONE = 600;

export class Rest {
  #last = -Infinity;

  /** After a change. What opens a drawing, or is undone, need not wait for a hand that goes on. */
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
