// Moves a canvas's last frame to another view, which takes no drawing, where a frame takes long.

import { composed, inverted } from "./affine.js";

/** @import { Affine } from "./affine.js" */

/** A frame that takes longer is moved, milliseconds. */
const SLOW = 30;

/** A view that has not changed for this long rests, milliseconds. */
const REST = 150;

/** While the view moves, drawing takes at most this share of the time. */
const SHARE = 0.2;

export class MovedFrame {
  /** @param {HTMLCanvasElement} canvas whose own transform this replaces */
  constructor(canvas) {
    this.canvas = canvas;
    canvas.style.transformOrigin = "0 0";
    /** The view of the last frame: artboard to CSS pixels. @type {Affine | null} */
    this.drawn = null;
    this.begunAt = 0;
    this.doneAt = 0;
    /** Duration of the last frame that was finished, with the GPU's work, milliseconds. */
    this.milliseconds = 0;
  }

  /**
   * Takes over a frame that is being drawn now.
   * @param {Affine} view artboard to CSS pixels
   */
  begin(view) {
    this.drawn = view;
    this.begunAt = performance.now();
    this.doneAt = 0;
    this.canvas.style.transform = "";
  }

  /** Measures the frame, when the GPU has finished it. */
  finish() {
    if (this.doneAt !== 0 || !this.drawn) return;
    this.doneAt = performance.now();
    this.milliseconds = this.doneAt - this.begunAt;
  }

  /**
   * Returns whether the last frame, moved, is to stand in for one of another view.
   * @param {number} changedAt when the view changed last, on the clock of performance.now()
   */
  standsIn(changedAt) {
    if (!this.drawn || this.milliseconds <= SLOW) return false;
    const now = performance.now();
    const pause = this.doneAt === 0 ? 0 : now - this.doneAt;
    return now - changedAt < REST && pause < this.milliseconds / SHARE;
  }

  /**
   * Shows the last frame as it lies in another view.
   * @param {Affine} view artboard to CSS pixels
   */
  move(view) {
    if (!this.drawn) return;
    this.canvas.style.transform = `matrix(${composed(view, inverted(this.drawn)).join(",")})`;
  }
}
