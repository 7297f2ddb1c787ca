// The buttons, the messages and the other parts of the page around the picture.

import { EMBEDDED } from "./view.js";
import { KEY_ZOOM } from "./input.js";

/** @import { Commands } from "./input.js" */

/**
 * Returns an element of the page, which must be of a class.
 * @template {Element} T
 * @param {string} id
 * @param {new () => T} type
 * @returns {T}
 */
function element(id, type) {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`The page has no ${id}.`);
  return found;
}

/** Above this percentage, the zoom is shown as a factor. */
const MOST_PERCENT = 10000;

export class Controls {
  constructor() {
    this.canvas = element("canvas", HTMLCanvasElement);
    this.tools = element("tools", HTMLDivElement);
    this.message = element("message", HTMLParagraphElement);
    this.percent = element("percent", HTMLOutputElement);
    this.mesh = element("mesh", HTMLButtonElement);
    this.exact = element("exact", HTMLButtonElement);
    this.exactState = element("exact-state", HTMLElement);
    this.exactWords = element("exact-words", HTMLParagraphElement);
    this.full = element("full", HTMLButtonElement);
    this.dialog = element("keys-dialog", HTMLDialogElement);
    this.fallback = document.getElementById("fallback");
    this.note = element("still", HTMLParagraphElement);
    this.live = element("live", HTMLButtonElement);
    /** Whether the picture is embedded in a text and has no tools of its own. */
    this.isEmbedded = false;
    this.followAddress();
    /** Whether the page is in the frame of another page, which scrolls. */
    this.isFramed = window.parent !== window;
    document.documentElement.classList.toggle("framed", this.isFramed);
    /** Whether the still picture covers the canvas. */
    this.isStill = false;
    this.full.hidden = !document.fullscreenEnabled;
    this.message.hidden = false;
    this.message.textContent = "Unpacking the picture …";
  }

  /** @param {Commands} commands */
  connect(commands) {
    const on = (/** @type {string} */ id, /** @type {() => void} */ act) =>
      element(id, HTMLButtonElement).addEventListener("click", act);
    on("zoom-in", () => commands.zoomMiddle(KEY_ZOOM));
    on("zoom-out", () => commands.zoomMiddle(1 / KEY_ZOOM));
    on("zoom", () => commands.fullSize());
    on("fit", () => commands.fit());
    on("mesh", () => commands.toggleMesh());
    on("exact", () => commands.toggleExact?.());
    on("full", () => commands.toggleFull());
    on("help", () => commands.showHelp());
    document.addEventListener("fullscreenchange", () => {
      this.full.setAttribute("aria-pressed", String(document.fullscreenElement !== null));
    });
  }

  /** Hides the buttons for "#embed" in the address. @returns {boolean} whether that has changed */
  followAddress() {
    const before = this.isEmbedded;
    this.isEmbedded = EMBEDDED.test(location.hash);
    document.documentElement.classList.toggle("embedded", this.isEmbedded);
    return before !== this.isEmbedded;
  }

  /** Shows the canvas, ready for drawing; the still picture, if any, covers it until a frame is done. */
  openCanvas() {
    this.canvas.hidden = false;
    this.tools.hidden = false;
    this.message.hidden = true;
    this.setStill(true);
  }

  /**
   * Shows the still picture over the canvas, which still receives pointers and keys, or only the canvas.
   * @param {boolean} isStill
   */
  setStill(isStill) {
    this.isStill = isStill && this.fallback !== null;
    document.documentElement.classList.toggle("still", this.isStill);
    this.note.hidden = true;
    if (this.fallback) this.fallback.hidden = !this.isStill;
  }

  /**
   * Places the still picture: left, top, width, height.
   * @param {number[]} box CSS pixels of the window
   */
  placeStill(box) {
    if (!this.fallback) return;
    const [left, top, width, height] = box.map((length) => `${length}px`);
    Object.assign(this.fallback.style, { left, top, width, height });
  }

  /**
   * Keeps the still picture; a button starts drawing again.
   * @param {() => void} goOn
   */
  keepStill(goOn) {
    this.setStill(true);
    this.note.hidden = false;
    this.live.onclick = goOn;
  }

  /**
   * Shows a message instead of drawing, with the still picture if there is one.
   * @param {string} text
   */
  say(text) {
    this.canvas.hidden = true;
    this.tools.hidden = true;
    this.message.hidden = false;
    this.message.textContent = text;
    this.message.classList.toggle("alone", this.fallback === null);
    this.setStill(false);
    if (!this.fallback) return;
    this.fallback.hidden = false;
    this.fallback.removeAttribute("style");
  }

  /** @param {number} zoom */
  showZoom(zoom) {
    const percent = 100 * zoom;
    const digits = percent >= 10 ? 0 : 1;
    this.percent.textContent =
      zoom < MOST_PERCENT / 100 ? `${percent.toFixed(digits)} %` : `${zoom.toFixed(0)} ×`;
  }

  /** @param {boolean} isShown */
  showMesh(isShown) {
    this.mesh.setAttribute("aria-pressed", String(isShown));
  }

  /**
   * Shows the state of exact pixels: a word for the button, and a sentence.
   * @param {{isOn: boolean, isPossible: boolean, word: string, sentence: string}} state
   */
  showExact({ isOn, isPossible, word, sentence }) {
    const { exact, exactState } = this;
    if (exactState.textContent === word && exact.title.endsWith(sentence)) return;
    exact.setAttribute("aria-pressed", String(isOn));
    exact.setAttribute("aria-disabled", String(!isPossible));
    exact.title = `Exact pixels (E): ${sentence}`;
    exactState.textContent = word;
    // Screen readers announce only the result, not every step.
    if (!word.includes("%")) this.exactWords.textContent = `Exact pixels: ${sentence}`;
  }

  toggleFull() {
    // A frame may lack the permission; the error is harmless.
    const ignore = () => {};
    if (document.fullscreenElement) document.exitFullscreen().catch(ignore);
    else document.documentElement.requestFullscreen().catch(ignore);
  }

  /** Returns red, green and blue of the area around the page, from 0 to 1. */
  deskColor() {
    const text = getComputedStyle(document.body).backgroundColor;
    return (text.match(/[\d.]+/g) ?? []).slice(0, 3).map((value) => Number(value) / 255);
  }
}
