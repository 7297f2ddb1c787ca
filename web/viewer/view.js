// Which part of the picture is seen, and how large.

/** @import { Affine } from "./affine.js" */

/**
 * @typedef {object} ViewState
 * @property {number} x artboard point in the middle of the window, user units
 * @property {number} y
 * @property {number} zoom CSS pixels to a user unit
 */

/** Room around a picture that is fitted into the window, CSS pixels. */
const FIT_MARGIN = 12;
/** And below it, for the buttons. */
const FIT_TOOLS = 74;

/** Device pixels across the page at the closest: positions are 22 bits. */
const CLOSEST_PAGE = 2 ** 21;
/** CSS pixels across the page at the farthest, if it is not larger when fitted. */
const FARTHEST_PAGE = 16;

export class View {
  /**
   * @param {number[]} page the part of the artboard that is shown
   * @param {() => boolean} hasTools whether room is left for the buttons
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

  /** The longer side of the page; not 0. */
  get extent() {
    return Math.max(this.page[2] - this.page[0], this.page[3] - this.page[1]) || 1;
  }

  /** The state that shows all of the page. @returns {ViewState} */
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
   * The nearest state that is allowed: the page stays under the middle of the window. What is no
   * number stays as it is.
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
   * The state after zooming about a point of the window.
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
   * The state after the picture was moved by CSS pixels.
   * @param {ViewState} from
   * @param {number} dx
   * @param {number} dy
   */
  moved({ x, y, zoom }, dx, dy) {
    return this.limited({ x: x - dx / zoom, y: y - dy / zoom, zoom });
  }

  /** Where the page lies in the window: left, top, width, height, CSS pixels. */
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

/** How an address ends that has the viewer stand in a text: no buttons. */
export const EMBEDDED = /^#embed(,|$)/;

/**
 * "#x,y,zoom" or "#embed,x,y,zoom" as a state, or null where it is none.
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
