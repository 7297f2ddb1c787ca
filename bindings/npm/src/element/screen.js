// Observes for all elements of a page: sight, sizes, the pixel ratio, and printing.
import { clearPaper, preparePaper } from "./paper.js";

/**
 * @typedef {object} Observed
 * @property {(is: boolean) => void} see near the screen, or no longer near it
 * @property {(entry?: ResizeObserverEntry) => void} measure
 * @property {() => Promise<void> | null} loadForPrint null: there is nothing to load
 * @property {(end: Promise<unknown>) => void} pause
 * @property {() => void} print
 * @property {() => void} printed
 */

/** Elements in the document. @type {Set<HTMLElement & Observed>} */
const elements = new Set();

/** Test environments such as jsdom lay nothing out, so that there is nothing to draw. */
export const hasLayout = typeof ResizeObserver !== "undefined";
export const hasSight = typeof IntersectionObserver !== "undefined";

const sight = hasSight
  ? new IntersectionObserver((entries) => {
      for (const { target, isIntersecting } of entries) {
        /** @type {HTMLElement & Observed} */ (target).see(isIntersecting);
      }
    }, { rootMargin: "50%" })
  : null;

/** By the parts that are measured. @type {WeakMap<Element, HTMLElement & Observed>} */
const owners = new WeakMap();
const sizes = hasLayout
  ? new ResizeObserver((entries) => {
      for (const entry of entries) owners.get(entry.target)?.measure(entry);
    })
  : null;

let isListening = false;

/** How often the pixel ratio is read, milliseconds: emulated screens report no change. */
const RATIO_TIME = 1000;
let ratio = 0;
let ratioTimer = 0;

/** Another screen or the browser's zoom changes the ratio, and perhaps no size in CSS pixels. */
function readRatio() {
  if (ratio === devicePixelRatio) return;
  ratio = devicePixelRatio;
  globalThis.matchMedia?.(`(resolution: ${ratio}dppx)`).addEventListener("change", readRatio, { once: true });
  for (const element of elements) element.measure();
}

function listen() {
  if (isListening || !hasLayout) return;
  isListening = true;
  addEventListener("beforeprint", () => preparePaper(elements));
  addEventListener("afterprint", () => clearPaper(elements));
}

/**
 * @param {HTMLElement & Observed} element
 * @param {Element} measured the part whose size in pixels is wanted
 */
export function observe(element, measured) {
  listen();
  if (elements.size === 0 && hasLayout) {
    ratio = 0;
    readRatio();
    ratioTimer = window.setInterval(readRatio, RATIO_TIME);
  }
  elements.add(element);
  owners.set(measured, element);
  sight?.observe(element);
  try {
    sizes?.observe(measured, { box: "device-pixel-content-box" });
  } catch {
    sizes?.observe(measured);
  }
}

/**
 * @param {HTMLElement & Observed} element
 * @param {Element} measured
 */
export function unobserve(element, measured) {
  elements.delete(element);
  if (elements.size === 0) clearInterval(ratioTimer);
  sight?.unobserve(element);
  sizes?.unobserve(measured);
}
