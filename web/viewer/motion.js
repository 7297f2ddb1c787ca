// Motion from one view to another: smooth, around the point that does not move.

/** @import { View, ViewState } from "./view.js" */

/** Time for half of the way, milliseconds. */
const HALF_TIME = 45;

/** Share of the way that counts as all of it. */
const ARRIVED = 0.999;

export class Motion {
  /** @param {View} view */
  constructor(view) {
    this.view = view;
    /** @type {ViewState} */
    this.from = view.state;
    /** @type {ViewState} */
    this.to = view.state;
    this.share = 1;
    this.time = 0;
    // Tests of the editor's view run without a window.
    this.still = globalThis.matchMedia?.("(prefers-reduced-motion: reduce)") ?? { matches: true };
  }

  get isMoving() {
    return this.share < 1;
  }

  /**
   * Goes to a state, smoothly or at once.
   * @param {ViewState} state
   * @param {boolean} smooth
   */
  go(state, smooth) {
    this.to = this.view.limited(state);
    if (!smooth || this.still.matches) {
      this.view.state = this.to;
      this.share = 1;
      return;
    }
    this.from = this.view.state;
    if (this.share === 1) this.time = performance.now();
    this.share = 0;
  }

  /** @param {number} now milliseconds */
  step(now) {
    if (!this.isMoving) return;
    const rest = (1 - this.share) * 2 ** (-Math.max(0, now - this.time) / HALF_TIME);
    this.time = now;
    this.share = 1 - rest > ARRIVED ? 1 : 1 - rest;
    this.view.state = this.share === 1 ? this.to : this.between();
  }

  /** @returns {ViewState} */
  between() {
    const { from, to, share } = this;
    const zoom = from.zoom * (to.zoom / from.zoom) ** share;
    // Where a point of the window stays over its point of the picture, the middle of the window moves linearly in
    // the size of a pixel.
    const isZoom = Math.abs(Math.log(to.zoom / from.zoom)) > 1e-9;
    const way = isZoom ? (1 / zoom - 1 / from.zoom) / (1 / to.zoom - 1 / from.zoom) : share;
    return { x: from.x + (to.x - from.x) * way, y: from.y + (to.y - from.y) * way, zoom };
  }
}
