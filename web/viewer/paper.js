// Prints the whole page of the picture, whatever part of it the window shows.

/** @import { Frame, Renderer } from "./renderer.js" */

/** Longer side of the page on paper, pixels. */
const PAPER_SIDE = 2400;

/**
 * Draws the whole page as fine as possible. The previous content of the canvas is lost.
 * @param {Renderer} renderer
 * @param {HTMLCanvasElement | OffscreenCanvas} canvas the renderer's canvas
 * @param {Frame} shown the frame in the window
 * @param {number} most the longer side, pixels
 */
export function drawPage(renderer, canvas, shown, most) {
  const [x0, y0, x1, y1] = renderer.picture.viewport;
  const side = Math.min(most, renderer.abilities.largestSide);
  const zoom = side / (Math.max(x1 - x0, y1 - y0) || 1);
  const size = [x1 - x0, y1 - y0].map((length) => Math.max(1, Math.round(length * zoom)));
  [canvas.width, canvas.height] = size;
  const pixelFromArtboard = [zoom, 0, 0, zoom, -x0 * zoom, -y0 * zoom];
  const frame = { ...shown, size, pixelFromArtboard, lineScale: 1 };
  renderer.draw(frame);
  while (renderer.canRefine) renderer.refine(frame);
}

/**
 * Draws the page and adds it beside the canvas as an image that only paper shows. The previous content of the
 * canvas is lost.
 * @param {Renderer} renderer
 * @param {HTMLCanvasElement} canvas the renderer's canvas
 * @param {Frame} shown the frame in the window
 */
export function layOnPaper(renderer, canvas, shown) {
  drawPage(renderer, canvas, { ...shown, desk: [1, 1, 1] }, PAPER_SIDE);
  // Chromium prints a canvas that is drawn in this event up to 6 % too small. An image with a data: address is
  // available at once.
  const paper = document.createElement("img");
  paper.id = "paper";
  paper.alt = canvas.getAttribute("aria-label") ?? "";
  paper.src = canvas.toDataURL();
  takeFromPaper();
  canvas.after(paper);
}

export function takeFromPaper() {
  document.getElementById("paper")?.remove();
}
