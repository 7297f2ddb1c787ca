// Printing: pictures that were never near the screen are loaded, and all are drawn whole and fine.

/** @import { Observed } from "./screen.js" */

/** How long printing waits for pictures, milliseconds. Chromium itself waits two seconds at most. */
const MOST_WAIT = 1200;

/** Whether this browser waits for lazy images before it prints. Others print what is there at once. */
const waits = () => "userAgentData" in navigator;

let isPrinting = false;
/** @type {HTMLImageElement | null} */
let holding = null;

/** @param {Set<HTMLElement & Observed>} elements */
export function preparePaper(elements) {
  isPrinting = true;
  const loading = [...elements].flatMap((element) => element.loadForPrint() ?? []);
  const print = () => isPrinting && elements.forEach((element) => element.print());
  const [first] = elements;
  const all = Promise.all(loading);
  if (loading.length > 0 && waits()) {
    // Drawing blocks this thread, so it comes after loading; until then, workers solve.
    const held = Promise.race([all, new Promise((resolve) => setTimeout(resolve, MOST_WAIT))]).then(print);
    first.pause(held);
    hold(/** @type {ShadowRoot} */ (first.shadowRoot), held);
  } else {
    print();
  }
  // A dialog may still be open when the last one is loaded.
  if (loading.length > 0) void all.then(print);
}

/** @param {Set<HTMLElement & Observed>} elements */
export function clearPaper(elements) {
  isPrinting = false;
  holding?.remove();
  holding = null;
  elements.forEach((element) => element.printed());
}

/**
 * Holds printing until a promise settles: an image that loads again and again counts as one that is not there yet.
 * @param {ShadowRoot} place
 * @param {Promise<unknown>} promise
 */
function hold(place, promise) {
  const image = document.createElement("img");
  image.loading = "lazy";
  image.alt = "";
  let isOver = false;
  let count = 0;
  const load = () => void (image.src = `data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' id='_${++count}'/>`);
  image.addEventListener("load", () => (isOver ? image.remove() : load()));
  void promise.finally(() => (isOver = true));
  holding = image;
  load();
  place.append(image);
}
