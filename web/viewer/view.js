// The visible part of the picture, and its scale.

/** @import { Affine } from "./affine.js" */

/**
 * @typedef {object} ViewState
 * @property {number} x artboard point in the middle of the window, user units
 * @property {number} y
 * @property {number} zoom CSS pixels per user unit
 */

/** Margin around a fitted picture, CSS pixels. */
const FIT_MARGIN = 12;
/** Room below it for the buttons. */
const FIT_TOOLS = 74;

/** Device pixels across the page at the largest zoom: positions have 22 bits. */
const CLOSEST_PAGE = 2 ** 21;
/** CSS pixels across the page at the smallest zoom, unless the fitted page is even smaller. */
const FARTHEST_PAGE = 16;

export class View {
  /**
   * @param {number[]} page the visible part of the artboard
   * @param {() => boolean} hasTools whether to leave room for the buttons
   */
  constructor(page, hasTools) {
    this.page = page;
    this.hasTools = hasTools;
    this.width = 1;
    this.height = 1;
    this.ratio = 1;
    /** @type {ViewState} */
    this.state = { x: (page[0] + page[2]) / 2, y: (page[1] + page[3]) / 2, zoom: 1 };
  }

  /** The longer side of the page; never 0. */
  get extent() {
    return Math.max(this.page[2] - this.page[0], this.page[3] - this.page[1]) || 1;
  }

  /** Returns the state that shows the whole page. @returns {ViewState} */
  fitted() {
    const [x0, y0, x1, y1] = this.page;
    const small = !this.hasTools() || this.width < 240 || this.height < 240;
    const margin = small ? 0 : FIT_MARGIN,
      tools = small ? 0 : FIT_TOOLS;
    const width = Math.max(1, this.width - 2 * margin);
    const height = Math.max(1, this.height - margin - tools);
    const zoom = Math.min(width / (x1 - x0 || 1), height / (y1 - y0 || 1));
    return { x: (x0 + x1) / 2, y: (y0 + y1) / 2 + (tools - (small ? 0 : margin)) / 2 / zoom, zoom };
  }

  /**
   * Returns the nearest allowed state: the page stays under the middle of the window. A value that is not a number
   * is ignored.
   * @param {ViewState} state
   * @returns {ViewState}
   */
  limited(state) {
    const kept = (/** @type {keyof ViewState} */ name) =>
      Number.isFinite(state[name]) ? state[name] : this.state[name];
    const [x, y, zoom] = [kept("x"), kept("y"), kept("zoom")];
    const fitted = this.fitted();
    const least = Math.min(fitted.zoom, FARTHEST_PAGE / this.extent);
    const most = Math.max(fitted.zoom, CLOSEST_PAGE / this.extent / this.ratio);
    const [x0, y0, x1, y1] = this.page;
    const slack = Math.abs(fitted.y - (y0 + y1) / 2);
    return {
      x: Math.min(x1, Math.max(x0, x)),
      y: Math.min(y1 + slack, Math.max(y0 - slack, y)),
      zoom: Math.min(most, Math.max(least, zoom)),
    };
  }

  /**
   * Returns the state after zooming around a point of the window.
   * @param {ViewState} from
   * @param {number} factor
   * @param {number} px CSS pixels
   * @param {number} py
   */
  zoomed(from, factor, px, py) {
    const { zoom } = this.limited({ ...from, zoom: from.zoom * factor });
    const dx = px - this.width / 2,
      dy = py - this.height / 2;
    return this.limited({
      x: from.x + dx / from.zoom - dx / zoom,
      y: from.y + dy / from.zoom - dy / zoom,
      zoom,
    });
  }

  /**
   * Returns the state after moving the picture by CSS pixels.
   * @param {ViewState} from
   * @param {number} dx
   * @param {number} dy
   */
  moved({ x, y, zoom }, dx, dy) {
    return this.limited({ x: x - dx / zoom, y: y - dy / zoom, zoom });
  }

  /** Returns the page's place in the window: left, top, width, height, CSS pixels. */
  pageBox() {
    const [x0, y0, x1, y1] = this.page;
    const { x, y, zoom } = this.state;
    return [
      this.width / 2 + (x0 - x) * zoom,
      this.height / 2 + (y0 - y) * zoom,
      (x1 - x0) * zoom,
      (y1 - y0) * zoom,
    ];
  }

  /**
   * @param {number[]} size of the canvas, device pixels
   * @returns {Affine}
   */
  pixelFromArtboard(size) {
    const scale = this.state.zoom * this.ratio;
    return [
      scale,
      0,
      0,
      scale,
      size[0] / 2 - this.state.x * scale,
      size[1] / 2 - this.state.y * scale,
    ];
  }
}

/** The end of an address that embeds the viewer in a text, without buttons. */
export const EMBEDDED = /^#embed(,|$)/;

/**
 * Returns the state of "#x,y,zoom" or "#embed,x,y,zoom", or null for another text.
 * @param {string} hash
 * @returns {ViewState | null}
 */
export function stateOfHash(hash) {
  const numbers = hash.replace(EMBEDDED, "").replace(/^#/, "").split(",").map(Number);
  const isState = numbers.length === 3 && numbers.every(Number.isFinite) && numbers[2] > 0;
  return isState ? { x: numbers[0], y: numbers[1], zoom: numbers[2] } : null;
}

/**
 * @param {ViewState} state
 */
export function hashOfState({ x, y, zoom }) {
  return `#${[x, y, zoom].map((value) => Number(value.toPrecision(9))).join(",")}`;
}
