/*! Sfumato's viewer, MIT licence. */
// Starts the viewer, and gives the page its interface: window.sfumatoViewer (docs/viewer.md).

import { PayloadError } from "./bytes.js";
import { readPicture } from "./payload.js";
import { hashOfState, stateOfHash } from "./view.js";
import { listenToKeys, PointerInput } from "./input.js";
import { Controls } from "./controls.js";
import { Viewer } from "./viewer.js";

/** @import { Commands } from "./input.js" */

/**
 * @param {unknown} error
 */
function inWords(error) {
  if (error instanceof PayloadError)
    return `The picture in this file is damaged: ${error.message}.`;
  return error instanceof Error ? error.message : String(error);
}

/**
 * @param {Viewer} viewer
 * @param {Controls} controls
 * @returns {Commands}
 */
function commandsOf(viewer, controls) {
  const { view, motion } = viewer;
  const target = () => (motion.isMoving ? motion.to : view.state);
  const zoom = (
    /** @type {number} */ factor,
    /** @type {number} */ x,
    /** @type {number} */ y,
    /** @type {boolean} */ smooth,
  ) => viewer.show(view.zoomed(smooth ? target() : view.state, factor, x, y), smooth);
  return {
    move: (dx, dy, smooth) =>
      viewer.show(view.moved(smooth ? target() : view.state, dx, dy), smooth),
    zoom,
    zoomMiddle: (factor) => zoom(factor, view.width / 2, view.height / 2, true),
    fit: () => viewer.fit(true),
    fullSize: () => viewer.show({ ...target(), zoom: 1 }, true),
    toggleMesh: () => viewer.setMesh(!viewer.mesh),
    toggleExact: () => viewer.setExact(!viewer.exact),
    toggleFull: () => controls.toggleFull(),
    showHelp: () => controls.dialog.showModal(),
  };
}

/**
 * Keeps the view in the address, so that a link or a reload shows it again.
 * @param {Viewer} viewer
 */
function followAddress(viewer) {
  const obey = () => {
    const state = stateOfHash(location.hash);
    const isOther = viewer.controls.followAddress();
    if (state) viewer.show(state, false);
    else if (isOther && viewer.isFitted) viewer.fit(false);
  };
  obey();
  window.addEventListener("hashchange", obey);
  viewer.onSettled = (state) => {
    const view = viewer.isFitted ? "" : hashOfState(state);
    const hash = viewer.controls.isEmbedded ? `#embed${view.replace("#", ",")}` : view;
    if (hash === location.hash) return;
    // A page in a frame without an address of its own may not change it.
    try {
      history.replaceState(null, "", hash || location.pathname + location.search);
    } catch {
      viewer.onSettled = () => {};
    }
  };
}

/** @param {Controls} controls */
async function openViewer(controls) {
  const payload = document.getElementById("payload")?.textContent ?? "";
  const picture = await readPicture(payload);
  const viewer = new Viewer(picture, controls);
  viewer.onError = (error) => controls.say(inWords(error));
  await viewer.start();
  const commands = commandsOf(viewer, controls);
  new PointerInput(controls.canvas, commands, {
    // In a frame a wheel belongs to the page until somebody works with the picture.
    wheel: () => !controls.isEmbedded && (!controls.isFramed || document.hasFocus()),
    finger: () => !controls.isEmbedded,
  });
  listenToKeys(commands);
  controls.connect(commands);
  followAddress(viewer);
  await viewer.drawn();
  return viewer;
}

function main() {
  const controls = new Controls();
  /** @type {Viewer | null} */
  let viewer = null;
  const ready = openViewer(controls).then((opened) => {
    viewer = opened;
  });
  ready.catch((error) => controls.say(inWords(error)));
  const api = {
    /** Resolves when the picture is drawn; rejects if that is not possible. */
    ready,
    /** The artboard point in the middle of the window, and CSS pixels per user unit. */
    get view() {
      return viewer ? { ...viewer.view.state } : null;
    },
    set view(state) {
      if (viewer && state) viewer.show({ ...viewer.view.state, ...state }, false);
    },
    /** Whether the triangulation is shown. */
    get mesh() {
      return viewer?.mesh ?? false;
    },
    set mesh(isShown) {
      viewer?.setMesh(isShown);
    },
    /** Whether pixels are made exact when nothing moves. */
    get exact() {
      return viewer?.exact ?? false;
    },
    set exact(isWanted) {
      viewer?.setExact(isWanted);
    },
    /** The state of exact pixels, in words. */
    get exactState() {
      return viewer?.exactState.sentence ?? "";
    },
    /** The rectangle of the artboard that is the page: minimum x, y, maximum x, y. */
    get page() {
      return viewer ? [...viewer.picture.viewport] : null;
    },
    /** Whether the still picture is shown because frames took too long. */
    get still() {
      return viewer?.isStill ?? false;
    },
    /** Draws frames from now on, however long they take. */
    goLive: () => viewer?.goLive(),
    /** Number of frames drawn so far. */
    get frames() {
      return viewer?.frames ?? 0;
    },
    /** Shows the whole page. */
    fit: () => viewer?.fit(false),
    /** Resolves when nothing moves and the last frame is as fine as possible. */
    settled: () => ready.then(() => viewer?.settled()),
  };
  Object.defineProperty(window, "sfumatoViewer", { value: Object.freeze(api) });
}

main();
