// Printing: pictures that were never near the screen are loaded, and all are drawn whole and fine.

/** @import { Observed } from "./screen.js" */

/** How long printing waits for pictures, milliseconds. Chromium itself waits two seconds at most. */
const MOST_WAIT = 1200;

/** Whether this browser waits for lazy images before it prints. Others print what is there at once. */
const waits = () => "userAgentData" in navigator;

/** Ends the waiting; null: nothing is printed. @type {(() => void) | null} */
let end = null;

/** @param {Set<HTMLElement & Observed>} elements */
export function preparePaper(elements) {
  const loading = [...elements].flatMap((element) => element.loadForPrint() ?? []);
  const print = () => elements.forEach((element) => element.print());
  const [first] = elements;
  if (loading.length === 0 || !waits()) return print();
  // Drawing blocks this thread, so it comes after loading; until then, workers solve.
  const stopped = new Promise((resolve) => {
    end = () => resolve(true);
    setTimeout(end, MOST_WAIT);
  });
  const held = Promise.race([Promise.all(loading), stopped]).then(() => end && print());
  first.pause(held);
  hold(/** @type {ShadowRoot} */ (first.shadowRoot), held);
}

/** @param {Set<HTMLElement & Observed>} elements */
export function clearPaper(elements) {
  end?.();
  end = null;
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
  load();
  place.append(image);
}
