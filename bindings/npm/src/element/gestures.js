// Gestures on a picture. They match the viewer's, but a gesture that could be meant for the page stays the page's.
import { obeyKey, PointerInput } from "../../../../web/viewer/input.js";

/** @import { Commands } from "../../../../web/viewer/input.js" */
/** @import { Motion } from "../../../../web/viewer/motion.js" */
/** @import { ViewState } from "../../../../web/viewer/view.js" */

/** The keys of the viewer that also work here. */
const keys = /^(Arrow(Left|Right|Up|Down)|[-+=_01])$/;

/**
 * @param {Motion} motion
 * @param {() => void} changed
 * @param {() => void} fit
 * @returns {Commands}
 */
function commandsOf(motion, changed, fit) {
  const { view } = motion;
  const target = () => (motion.isMoving ? motion.to : view.state);
  const go = (/** @type {ViewState} */ state, /** @type {boolean} */ smooth) => {
    motion.go(state, smooth);
    changed();
  };
  /** @type {Commands["zoom"]} */
  const zoom = (factor, x, y, smooth) =>
    go(view.zoomed(smooth ? target() : view.state, factor, x, y), smooth);
  return {
    move: (dx, dy, smooth) => go(view.moved(smooth ? target() : view.state, dx, dy), smooth),
    zoom,
    zoomMiddle: (factor) => zoom(factor, view.width / 2, view.height / 2, true),
    fit,
    fullSize: () => go({ ...target(), zoom: 1 }, true),
    toggleMesh: () => {},
    toggleFull: () => {},
    showHelp: () => {},
  };
}

/** Handles pointers on a picture, until free(). */
export class Gestures {
  /**
   * @param {Motion} motion
   * @param {{changed: () => void, fit: () => void, takesWheel: () => boolean, hint: (words: "wheel" | "touch") => void}} ask
   */
  constructor(motion, { changed, fit, takesWheel, hint }) {
    this.commands = commandsOf(motion, changed, fit);
    // Removing this area also removes the listeners.
    this.area = document.createElement("div");
    this.area.id = "input";
    new PointerInput(/** @type {HTMLCanvasElement} */ (/** @type {unknown} */ (this.area)), this.commands, {
      wheel: () => {
        const takes = takesWheel();
        if (!takes) hint("wheel");
        return takes;
      },
      finger: () => {
        hint("touch");
        return false;
      },
    });
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    if (keys.test(event.key) && obeyKey(event, this.commands)) event.preventDefault();
  }

  free() {
    this.area.remove();
  }
}

