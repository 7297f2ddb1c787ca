// What the elements of a page observe together: sight, sizes, the pixel ratio, and printing.

/**
 * @typedef {object} Observed
 * @property {(is: boolean) => void} see near the screen, or no longer near it
 * @property {(entry?: ResizeObserverEntry) => void} measure
 * @property {() => void} prepareForPrint
 * @property {() => void} print
 * @property {() => void} printed
 */

/** Longest time for which printing is held, milliseconds; browsers go on earlier. */
const MOST_HELD = 5000;

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

/** Another screen or the browser's zoom changes the ratio, and perhaps no size in CSS pixels. */
function watchRatio() {
  globalThis.matchMedia?.(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", () => {
    for (const element of elements) element.measure();
    watchRatio();
  }, { once: true });
}

function listen() {
  if (isListening || !hasLayout) return;
  isListening = true;
  watchRatio();
  addEventListener("beforeprint", () => {
    // Workers solve what is missing while this thread draws the others.
    elements.forEach((element) => element.prepareForPrint());
    elements.forEach((element) => element.print());
  });
  addEventListener("afterprint", () => {
    holding?.remove();
    holding = null;
    elements.forEach((element) => element.printed());
  });
}

/**
 * @param {HTMLElement & Observed} element
 * @param {Element} measured the part whose size in pixels is wanted
 */
export function observe(element, measured) {
  listen();
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
  sight?.unobserve(element);
  sizes?.unobserve(measured);
}

/** @type {HTMLImageElement | null} */
let holding = null;
/** @type {Set<Promise<unknown>>} */
const awaited = new Set();

/**
 * Holds printing until a promise settles, where browsers allow it: Chromium waits for lazy images, about two seconds
 * in all. An image that loads again and again counts as one.
 * @param {Node & ParentNode} place
 * @param {Promise<unknown>} promise
 * @returns {Promise<void>} resolves when the promise settles, or after the longest time
 */
export function holdPrint(place, promise) {
  awaited.add(promise);
  holding ??= repeatingImage(place);
  const longest = new Promise((resolve) => setTimeout(resolve, MOST_HELD));
  return Promise.race([promise, longest]).then(() => void awaited.delete(promise));
}

/** @param {Node & ParentNode} place */
function repeatingImage(place) {
  const image = document.createElement("img");
  image.loading = "lazy";
  image.alt = "";
  let count = 0;
  const load = () => void (image.src = `data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' id='_${++count}'/>`);
  image.addEventListener("load", () => {
    if (image === holding && awaited.size > 0) return load();
    image.remove();
    if (image === holding) holding = null;
  });
  load();
  place.append(image);
  return image;
}
