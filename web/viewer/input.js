// Pointers, wheel and keys.

/** Limits for two taps to be one double tap: milliseconds and CSS pixels. */
const DOUBLE_TAP_TIME = 350;
const DOUBLE_TAP_DISTANCE = 24;

export const KEY_ZOOM = 1.5;
const KEY_MOVE = 80;
const DOUBLE_TAP_ZOOM = 2;

/**
 * The commands that input gives.
 * @typedef {object} Commands
 * @property {(dx: number, dy: number, smooth: boolean) => void} move CSS pixels
 * @property {(factor: number, px: number, py: number, smooth: boolean) => void} zoom
 * @property {(factor: number) => void} zoomMiddle
 * @property {() => void} fit
 * @property {() => void} fullSize
 * @property {() => void} toggleMesh
 * @property {() => void} [toggleExact]
 * @property {() => void} toggleFull
 * @property {() => void} showHelp
 */

/**
 * Decides which input is for the picture and not for the page around it.
 * @typedef {object} Claims
 * @property {() => boolean} wheel a wheel event without Ctrl
 * @property {() => boolean} finger a single finger
 */

/** Handles drag, pinch and taps on the canvas. */
export class PointerInput {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Commands} commands
   * @param {Claims} claims
   */
  constructor(canvas, commands, claims) {
    this.canvas = canvas;
    this.commands = commands;
    this.claims = claims;
    /** @type {Map<number, number[]>} */
    this.down = new Map();
    this.travelled = 0;
    this.lastTap = { time: -Infinity, x: 0, y: 0 };
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.drag(event));
    canvas.addEventListener("pointerup", (event) => this.release(event, true));
    canvas.addEventListener("pointercancel", (event) => this.release(event, false));
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    // Prevent Safari's own pinch, which would zoom the page.
    canvas.addEventListener("gesturestart", (event) => event.preventDefault());
  }

  /** @param {MouseEvent} event */
  at(event) {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  /** @param {PointerEvent} event */
  press(event) {
    if (event.pointerType === "mouse" && event.button !== 0 && event.button !== 1) return;
    event.preventDefault();
    this.canvas.focus({ preventScroll: true });
    // A pointer that has already gone cannot be captured.
    if (event.isTrusted) this.canvas.setPointerCapture(event.pointerId);
    if (this.down.size === 0) this.travelled = 0;
    this.down.set(event.pointerId, this.at(event));
  }

  /** Returns middle and spread of the two pointers of a pinch. */
  pinch() {
    const [a, b] = [...this.down.values()];
    if (!b) return { x: a[0], y: a[1], spread: 0 };
    return {
      x: (a[0] + b[0]) / 2,
      y: (a[1] + b[1]) / 2,
      spread: Math.hypot(b[0] - a[0], b[1] - a[1]),
    };
  }

  /** @param {PointerEvent} event */
  drag(event) {
    if (!this.down.has(event.pointerId)) return;
    const before = this.pinch();
    this.down.set(event.pointerId, this.at(event));
    const after = this.pinch();
    const dx = after.x - before.x,
      dy = after.y - before.y;
    this.travelled += Math.hypot(dx, dy) + Math.abs(after.spread - before.spread);
    if (event.pointerType === "touch" && this.down.size < 2 && !this.claims.finger()) return;
    this.commands.move(dx, dy, false);
    if (before.spread > 0 && after.spread > 0) {
      this.commands.zoom(after.spread / before.spread, after.x, after.y, false);
    }
  }

  /**
   * @param {PointerEvent} event
   * @param {boolean} isUp released and not cancelled
   */
  release(event, isUp) {
    if (!this.down.delete(event.pointerId)) return;
    const isTap = isUp && this.down.size === 0 && this.travelled < DOUBLE_TAP_DISTANCE / 2;
    if (isTap) this.tap(event);
  }

  /** @param {PointerEvent} event */
  tap(event) {
    const [x, y] = this.at(event),
      last = this.lastTap;
    const isSecond =
      event.timeStamp - last.time < DOUBLE_TAP_TIME &&
      Math.hypot(x - last.x, y - last.y) < DOUBLE_TAP_DISTANCE;
    this.lastTap = { time: isSecond ? -Infinity : event.timeStamp, x, y };
    if (!isSecond) return;
    this.commands.zoom(event.shiftKey ? 1 / DOUBLE_TAP_ZOOM : DOUBLE_TAP_ZOOM, x, y, true);
  }

  /** @param {WheelEvent} event */
  wheel(event) {
    // An event that is not taken scrolls the page around the frame.
    if (!event.ctrlKey && !event.metaKey && !this.claims.wheel()) return;
    event.preventDefault();
    const unit = [1, 18, 400][event.deltaMode] ?? 1;
    const delta = (event.deltaY || event.deltaX) * unit;
    // A pinch on a touch pad arrives as a wheel with Ctrl, in small steps; steps of a wheel are large.
    const [speed, most] = event.ctrlKey ? [0.01, 25] : [0.002, 300];
    const factor = Math.exp(-Math.max(-most, Math.min(most, delta)) * speed);
    const [x, y] = this.at(event);
    this.commands.zoom(factor, x, y, !event.ctrlKey);
  }
}

/**
 * @param {KeyboardEvent} event
 * @param {Commands} commands
 * @returns {boolean} whether the key is one of ours
 */
export function obeyKey(event, commands) {
  switch (event.key) {
    case "ArrowLeft":
      commands.move(KEY_MOVE, 0, true);
      return true;
    case "ArrowRight":
      commands.move(-KEY_MOVE, 0, true);
      return true;
    case "ArrowUp":
      commands.move(0, KEY_MOVE, true);
      return true;
    case "ArrowDown":
      commands.move(0, -KEY_MOVE, true);
      return true;
    case "+":
    case "=":
      commands.zoomMiddle(KEY_ZOOM);
      return true;
    case "-":
    case "_":
      commands.zoomMiddle(1 / KEY_ZOOM);
      return true;
    case "0":
      commands.fit();
      return true;
    case "1":
      commands.fullSize();
      return true;
    case "m":
    case "M":
      commands.toggleMesh();
      return true;
    case "e":
    case "E":
      commands.toggleExact?.();
      return commands.toggleExact !== undefined;
    case "f":
    case "F":
      commands.toggleFull();
      return true;
    case "?":
      commands.showHelp();
      return true;
    default:
      return false;
  }
}

/** @param {Commands} commands */
export function listenToKeys(commands) {
  window.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    if (document.querySelector("dialog[open]")) return;
    if (obeyKey(event, commands)) event.preventDefault();
  });
}
