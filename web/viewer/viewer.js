// The viewer: draws after a change, then refines the frame, then rests.

import { exactPixels, isSoftware } from "./exact.js";
import { makeTexels } from "./paints.js";
import { Renderer } from "./renderer.js";
import { View } from "./view.js";
import { Motion } from "./motion.js";
import { layOnPaper, takeFromPaper } from "./paper.js";

/** @import { Picture } from "./payload.js" */
/** @import { Frame } from "./renderer.js" */
/** @import { ViewState } from "./view.js" */
/** @import { Controls } from "./controls.js" */

/** Time until a lost context is reported, milliseconds. */
const PATIENCE = 1000;

/** Limit for the time of a frame, milliseconds. If frames take longer, the still picture is shown. */
const SLOWEST_FRAME = 1000;

/** The message if exact pixels leave out pixels that a curve cuts. */
const BUT_CUTS = "exact but where a curve cuts a pixel";
const CUTS_TOO = "exact; where a curve cuts a pixel, at 16 points";

/** Slow frames in a row until the still picture is shown; the first frame compiles shaders. */
const SLOW_FRAMES = 2;

export class Viewer {
  /**
   * @param {Picture} picture
   * @param {Controls} controls
   */
  constructor(picture, controls) {
    this.picture = picture;
    this.controls = controls;
    this.canvas = controls.canvas;
    this.view = new View(picture.viewport, () => !controls.isEmbedded);
    this.motion = new Motion(this.view);
    this.mesh = false;
    /** Whether pixels are made exact when nothing moves. */
    this.exact = false;
    /** Number of frames shown, and how many of them were refined. */
    this.frames = 0;
    this.size = [1, 1];
    this.isDirty = true;
    this.isScheduled = false;
    /** Whether frames are drawn however long they take. */
    this.isLive = controls.fallback === null;
    /** Whether the still picture is shown because frames took too long. */
    this.isStill = false;
    this.slowFrames = 0;
    /** When the GPU last received work; null: the work is done. @type {number | null} */
    this.workSince = null;
    /** Whether the whole page stays in the window when the window's size changes. */
    this.isFitted = true;
    /** @type {Renderer | null} */
    this.renderer = null;
    /** Callers that wait for the next frame, and for the last. @type {(() => void)[]} */
    this.waitingForFrame = [];
    /** @type {(() => void)[]} */
    this.waiting = [];
    /** @type {Uint16Array | null} */
    this.texels = null;
    /** @type {(state: ViewState) => void} */
    this.onSettled = () => {};
    /** @type {(error: unknown) => void} */
    this.onError = () => {};
  }

  /** Opens the GPU; throws if that is not possible. */
  async start() {
    const gl = this.canvas.getContext("webgl2", {
      alpha: false,
      antialias: false,
      depth: false,
      stencil: false,
      powerPreference: "high-performance",
    });
    if (!gl) throw new Error("This browser shows a still picture only: it has no WebGL 2.");
    this.gl = gl;
    this.texels = await makeTexels(gl, this.picture.paints);
    // Software needs a minute for the work that a GPU does in a second.
    this.exact = !isSoftware(gl);
    this.build();
    this.canvas.addEventListener("webglcontextlost", (event) => this.lose(event));
    this.canvas.addEventListener("webglcontextrestored", () => this.attempt(() => this.restore()));
    this.controls.openCanvas();
    this.watchSize();
    window
      .matchMedia("(prefers-color-scheme: dark)")
      .addEventListener("change", () => this.change());
    // A frame that waited while the page was hidden was not slow.
    document.addEventListener("visibilitychange", () => (this.workSince = null));
    window.addEventListener("beforeprint", () => this.attempt(() => this.print()));
    window.addEventListener("afterprint", takeFromPaper);
  }

  build() {
    const { gl, texels } = this;
    if (!gl || !texels || gl.isContextLost()) return;
    this.renderer = new Renderer(gl, this.picture, texels);
    this.change();
  }

  /** @param {Event} event */
  lose(event) {
    event.preventDefault();
    this.renderer = null;
    setTimeout(() => {
      if (!this.renderer)
        this.controls.say("The browser has taken the graphics away. They may come back.");
    }, PATIENCE);
  }

  restore() {
    this.workSince = null;
    this.controls.openCanvas();
    this.build();
  }

  /** @param {() => void} act */
  attempt(act) {
    try {
      act();
    } catch (error) {
      this.renderer = null;
      this.onError(error);
    }
  }

  watchSize() {
    const observer = new ResizeObserver((entries) => this.resize(entries[0]));
    try {
      observer.observe(this.canvas, { box: "device-pixel-content-box" });
    } catch {
      observer.observe(this.canvas);
      // On another screen the pixel ratio may change without the size.
      window.addEventListener("resize", () => this.resize(null));
    }
    this.resize(null);
  }

  /** @param {ResizeObserverEntry | null} entry */
  resize(entry) {
    const { clientWidth, clientHeight } = this.canvas;
    const ratio = window.devicePixelRatio || 1;
    const exact = entry?.devicePixelContentBoxSize?.[0];
    let size = [Math.round(clientWidth * ratio), Math.round(clientHeight * ratio)];
    // An emulated ratio does not affect the exact box.
    if (exact && Math.abs(exact.inlineSize - size[0]) <= 1)
      size = [exact.inlineSize, exact.blockSize];
    const most = this.renderer?.abilities.largestSide ?? Infinity;
    const shrink = Math.min(1, most / Math.max(...size));
    size = size.map((length) => Math.max(1, Math.floor(length * shrink)));
    this.view.width = Math.max(1, clientWidth);
    this.view.height = Math.max(1, clientHeight);
    this.view.ratio = size[0] / this.view.width;
    this.size = size;
    if (this.isFitted) this.motion.go(this.view.fitted(), false);
    this.change();
  }

  /**
   * @param {ViewState} state
   * @param {boolean} smooth
   */
  show(state, smooth) {
    this.isFitted = false;
    this.motion.go(state, smooth);
    this.change();
  }

  /** @param {boolean} smooth */
  fit(smooth) {
    this.motion.go(this.view.fitted(), smooth);
    this.isFitted = true;
    this.change();
  }

  /** @param {boolean} isShown */
  setMesh(isShown) {
    this.mesh = isShown;
    this.controls.showMesh(isShown);
    this.change();
  }

  /** @param {boolean} isWanted */
  setExact(isWanted) {
    this.exact = Boolean(isWanted);
    // Removes exact pixels at once when they are turned off.
    if (!this.exact) this.renderer?.setExact(null);
    this.change();
    this.showExact();
  }

  /** The state of exact pixels, in words. */
  get exactState() {
    const { exact } = this.renderer ?? {};
    const isPossible = !exact?.reason || exact.isTooLarge;
    const isOn = this.exact && isPossible;
    if (exact?.reason)
      return { isOn, isPossible, word: "None", sentence: `not here: ${exact.reason}` };
    if (!isOn) return { isOn, isPossible, word: "Off", sentence: "off" };
    const share = exact && this.renderer?.isGathering ? exact.progress : 0;
    if (share === 1 && !this.renderer?.canRefine)
      return { isOn, isPossible, word: "Exact", sentence: exact?.hasCuts ? CUTS_TOO : BUT_CUTS };
    const percent = `${Math.floor(99 * share)} %`;
    return { isOn, isPossible, word: percent, sentence: `gathered ${percent}` };
  }

  showExact() {
    this.controls.showExact(this.exactState);
  }

  /** Requests a frame after a visible change. */
  change() {
    this.isDirty = true;
    this.schedule();
  }

  schedule() {
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame((now) => {
      this.isScheduled = false;
      this.attempt(() => this.tick(now));
    });
  }

  /** @returns {Frame} */
  frame() {
    return {
      size: this.size,
      pixelFromArtboard: this.view.pixelFromArtboard(this.size),
      desk: this.controls.deskColor(),
      mesh: this.mesh,
      lineScale: this.view.ratio,
    };
  }

  /** @param {number} now milliseconds */
  tick(now) {
    const { renderer, motion } = this;
    if (!renderer) return;
    if (motion.isMoving) {
      motion.step(now);
      this.isDirty = true;
    }
    if (this.controls.isStill) this.controls.placeStill(this.view.pageBox());
    // Do not queue more work on a busy GPU.
    if (renderer.isBusy) return this.schedule();
    this.measure(now);
    if (this.isStill) {
      this.controls.showZoom(this.view.state.zoom);
    } else if (this.isDirty) {
      this.drawFrame(renderer);
    } else if (renderer.canRefine) {
      this.workSince = performance.now();
      renderer.refine(this.frame());
      if (!renderer.canRefine) this.frames += 1;
    } else if (!motion.isMoving && this.exact) {
      this.gather(renderer);
    }
    this.showExact();
    if (motion.isMoving || this.workSince !== null || this.isGathering) this.schedule();
    else this.settle();
  }

  /** Whether more exact pixels of the view are to come. */
  get isGathering() {
    const { renderer } = this;
    if (!this.exact || !renderer || this.isStill) return false;
    return !renderer.exact || renderer.canGather || renderer.hasUnshown || renderer.canRefine;
  }

  /**
   * Gathers exact pixels after nothing moves and the last frame is as fine as patches get.
   * @param {Renderer} renderer
   */
  gather(renderer) {
    if (!renderer.exact) renderer.setExact(exactPixels());
    renderer.gatherMore(this.frame());
    renderer.showGathered();
  }

  /**
   * Called when the GPU is done: shows the frame, or the still picture if the frame took too long.
   * @param {number} now milliseconds
   */
  measure(now) {
    if (this.workSince === null) return;
    const isSlow = now - this.workSince > SLOWEST_FRAME;
    this.workSince = null;
    this.slowFrames = isSlow ? this.slowFrames + 1 : 0;
    this.isStill = !this.isLive && this.slowFrames >= SLOW_FRAMES;
    if (this.isStill) this.controls.keepStill(() => this.goLive());
    else if (this.controls.isStill) this.controls.setStill(false);
  }

  /** Draws from now on, however slowly. */
  goLive() {
    this.isLive = true;
    if (this.isStill) this.controls.setStill(true);
    this.isStill = false;
    this.change();
  }

  /** Prints the page as fine as possible, or the still picture if drawing takes too long. */
  print() {
    if (!this.renderer || this.isStill) return;
    layOnPaper(this.renderer, this.canvas, this.frame());
    this.change();
  }

  /** @param {Renderer} renderer */
  drawFrame(renderer) {
    this.isDirty = false;
    const [width, height] = this.size;
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    this.workSince = performance.now();
    renderer.draw(this.frame());
    this.frames += 1;
    this.controls.showZoom(this.view.state.zoom);
    for (const resolve of this.waitingForFrame.splice(0)) resolve();
  }

  settle() {
    this.onSettled(this.view.state);
    for (const resolve of this.waiting.splice(0)) resolve();
  }

  /** Resolves at the next frame. @returns {Promise<void>} */
  drawn() {
    return new Promise((resolve) => {
      this.waitingForFrame.push(resolve);
      this.change();
    });
  }

  /** Resolves when everything is drawn as fine as possible. @returns {Promise<void>} */
  settled() {
    return new Promise((resolve) => {
      this.waiting.push(resolve);
      this.schedule();
    });
  }
}
