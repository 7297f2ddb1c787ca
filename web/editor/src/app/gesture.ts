// One movement of the pointer: each step starts from the drawing at the beginning.
import { inverse, type Patch } from "../source/patch.js";
import type { Change, Drawing, Outcome } from "../model/types.js";
import type { Gesture } from "./types.js";

/** The functions of the editor that a gesture uses. */
export interface GestureHost {
  readonly drawing: Drawing;
  apply(patch: Patch): Change;
  /** Shows the changes since the last step, and whether the pointer still moves. */
  changed(changes: readonly Change[], moving: boolean): void;
  /** Keeps the patch, which made this change, as one step of undo. */
  keep(outcome: Outcome, change: Change): void;
}

export class LiveGesture implements Gesture {
  #host: GestureHost;
  #shown: { readonly outcome: Outcome; readonly change: Change } | null = null;
  isOver = false;

  constructor(host: GestureHost) {
    this.#host = host;
  }

  show(make: (before: Drawing) => Outcome | null): void {
    if (this.isOver) return;
    const changes = this.#takeBack();
    const outcome = make(this.#host.drawing);
    if (outcome && outcome.patch.length > 0) {
      const change = this.#host.apply(outcome.patch);
      changes.push(change);
      this.#shown = { outcome, change };
    }
    this.#host.changed(changes, true);
  }

  keep(): void {
    if (this.isOver) return;
    this.isOver = true;
    if (this.#shown) this.#host.keep(this.#shown.outcome, this.#shown.change);
    else this.#host.changed([], false);
  }

  drop(): void {
    if (this.isOver) return;
    this.isOver = true;
    this.#host.changed(this.#takeBack(), false);
  }

  #takeBack(): Change[] {
    if (!this.#shown) return [];
    const change = this.#host.apply(inverse(this.#shown.outcome.patch));
    this.#shown = null;
    return [change];
  }
}
