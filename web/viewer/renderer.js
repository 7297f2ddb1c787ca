// Draws a frame: the picture on its page, the mesh on top, and, when nothing moves, finer edges.

import { mappedBox } from "./affine.js";
import { abilitiesOf, Programs } from "./gl.js";
import { LayerDrawer } from "./layers.js";
import { StrokeDrawer } from "./strokes.js";
import { intersected, isEmptyRect, Target, Targets } from "./targets.js";
import { Painter } from "./painter.js";

/** @import { Affine } from "./affine.js" */
/** @import { ExactPixels } from "./exact.js" */
/** @import { LayerDelta } from "./layer_tables.js" */
/** @import { Layer, Picture } from "./payload.js" */

/**
 * Shifts of edges in the images that are averaged to a finer one, pixels. The four samples of a pixel usually lie
 * an eighth, and three eighths, to both sides of its centre, in x and in y. With these shifts all sixteen are
 * evenly spread over the pixel and stay inside it.
 */
const SHIFTS = [
  [-3, -1],
  [-1, 3],
  [1, -3],
  [3, 1],
].map((shift) => shift.map((v) => v / 32));

/** Interval between updates of the gathered pixels on the screen, milliseconds. */
const SHOWN_EVERY = 400;

/**
 * The content of a frame.
 * @typedef {object} Frame
 * @property {number[]} size device pixels
 * @property {Affine} pixelFromArtboard
 * @property {number[]} desk colour around the page
 * @property {boolean} mesh
 * @property {number} lineScale device pixels per unit of line width
 * @property {boolean} [isClear] without a background, so that the page below the canvas shows
 */

export class Renderer {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {Picture} picture
   * @param {Uint16Array} texels texels of the paints
   * @param {Programs | null} shared programs of this context, owned by the caller
   */
  constructor(gl, picture, texels, shared = null) {
    this.gl = gl;
    this.picture = picture;
    this.abilities = abilitiesOf(gl);
    this.hasOwnPrograms = shared === null;
    this.programs = shared ?? new Programs(gl);
    this.targets = new Targets(gl, this.abilities);
    this.layers = new LayerDrawer(gl, this.programs, picture, texels);
    this.strokes = new StrokeDrawer(gl, this.programs, picture);
    this.painter = new Painter(gl, this.programs, this.targets, picture, this.layers, this.strokes);
    this.noInk = new Target(gl, gl.RG8, [1, 1], 0);
    this.noInk.clear([0, 0, 1, 1], [0, 0, 0, 0]);
    this.vertices = gl.createVertexArray();
    gl.bindVertexArray(this.vertices);
    gl.disable(gl.CULL_FACE);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.DITHER);
    /** @type {ExactPixels | null} */
    this.exact = null;
    /** @type {((renderer: Renderer) => ExactPixels) | null} */
    this.makeExact = null;
    /** Number of images summed so far; the full number if no frame of the present view was drawn. */
    this.added = SHIFTS.length;
    /** Whether gathering exact pixels of the last frame has begun. */
    this.isGathering = false;
    /** Whether some gathered pixels are not shown yet. */
    this.hasUnshown = false;
    /** When gathered pixels were last shown, on the clock of performance.now(). */
    this.shownAt = 0;
    /** @type {WebGLSync | null} */
    this.fence = null;
  }

  /**
   * Switches to another picture: makes tables for new layers and frees the tables of layers that it does not have.
   * Layers in both pictures, as the same objects, keep their tables. Throws if a layer is too large for the GPU;
   * the renderer then still draws the previous picture.
   * @param {Picture} picture
   * @param {Uint16Array} texels texels of the paints; the same array if they have not changed
   */
  setPicture(picture, texels) {
    const makeExact = this.makeExact;
    this.setExact(null);
    this.layers.setPicture(picture, texels);
    this.picture = picture;
    this.strokes.setPicture(picture);
    this.painter.setPicture(picture);
    this.setExact(makeExact);
    this.added = SHIFTS.length;
  }

  /**
   * Updates a layer of the picture after its tables have changed.
   * @param {Layer} layer
   * @param {LayerDelta | null} delta null: everything may have changed
   */
  updateLayer(layer, delta) {
    this.layers.update(layer, delta);
    this.added = SHIFTS.length;
  }

  /**
   * Turns exact pixels on or off; gatherMore() gathers them when nothing moves.
   * @param {((renderer: Renderer) => ExactPixels) | null} make exactPixels() of exact.js; null: turn off
   */
  setExact(make) {
    this.makeExact = make;
    if (make) this.exact ??= make(this);
    else this.exact?.free();
    if (!make) this.exact = null;
    this.painter.exact = this.exact;
    this.isGathering = false;
  }

  /** Whether gatherMore() has more to do for the last frame. */
  get canGather() {
    const { exact } = this;
    if (!exact || (exact.reason && !exact.isTooLarge)) return false;
    return !this.isGathering || exact.isBusy || !exact.isDone;
  }

  /**
   * Gathers exact pixels of the last frame. When they are due, refine() shows them.
   * @param {Frame} frame
   */
  gatherMore(frame) {
    const { exact, painter } = this;
    if (!exact || !this.canGather || exact.isBusy) return;
    if (!this.isGathering) {
      exact.begin(frame.size, frame.pixelFromArtboard, (item) =>
        intersected(this.pageRect(frame, [0, 0]), painter.touched(item)),
      );
      this.isGathering = true;
    }
    if (!exact.isTooLarge) this.hasUnshown = true;
    if (!exact.isDone) exact.step();
  }

  /** Lets refine() show gathered pixels, two or three times a second and at the end. */
  showGathered() {
    const now = performance.now();
    const isDue = !this.canGather || now - this.shownAt > SHOWN_EVERY;
    if (!this.hasUnshown || !isDue) return;
    this.shownAt = now;
    this.hasUnshown = false;
    this.added = 0;
  }

  /** Frees everything on the GPU. No function may be called afterwards. */
  free() {
    const { gl } = this;
    this.exact?.free();
    this.layers.free();
    this.strokes.free();
    this.targets.free();
    this.noInk.free();
    if (this.hasOwnPrograms) this.programs.free();
    gl.bindVertexArray(null);
    gl.deleteVertexArray(this.vertices);
    gl.deleteSync(this.fence);
    this.fence = null;
  }

  /** Whether the GPU is still working. */
  get isBusy() {
    const { gl, fence } = this;
    if (!fence || gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.UNSIGNALED)
      return fence !== null;
    gl.deleteSync(fence);
    this.fence = null;
    return false;
  }

  /** Marks the GPU as busy until it has finished the requested work. */
  markWork() {
    if (this.fence) this.gl.deleteSync(this.fence);
    this.fence = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.gl.flush();
  }

  /**
   * Draws a frame at once.
   * @param {Frame} frame
   */
  draw(frame) {
    this.targets.resize(frame.size);
    this.exact?.leave();
    this.isGathering = this.hasUnshown = false;
    this.added = 0;
    this.paint(frame, [0, 0], false);
    this.present(frame, this.targets.level(0).texture);
    this.markWork();
  }

  /** Whether `refine` has more to do for the last frame, if nothing has changed since. */
  get canRefine() {
    return this.abilities.halfTargets && this.added < SHIFTS.length;
  }

  /**
   * Adds one more image of the same frame towards a finer one; the last one shows it.
   * @param {Frame} frame
   */
  refine(frame) {
    const { gl, targets } = this;
    this.paint(frame, SHIFTS[this.added], true);
    const mean = targets.mean();
    if (this.added === 0) mean.clear(targets.whole, [0, 0, 0, 0]);
    mean.bind(targets.whole);
    this.programs
      .get("screen", "composite", ["WITHOUT_BACKDROP"])
      .use()
      .texture("source", targets.level(0).texture)
      .int("source_scale", 1)
      .float("opacity", 1 / SHIFTS.length);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    this.added += 1;
    if (this.added === SHIFTS.length) {
      this.present(frame, mean.texture);
      targets.rest();
    }
    this.markWork();
  }

  /**
   * @param {Frame} frame
   * @param {number[]} shift
   * @param {boolean} isSameView as in the previous frame
   */
  paint(frame, shift, isSameView) {
    const { targets } = this;
    const page = this.pageRect(frame, shift);
    const level = targets.level(0);
    level.clear(targets.whole, [...frame.desk, 1]);
    const ground = frame.isClear ? [0, 0, 0, 0] : [...this.picture.background, 1];
    if (!isEmptyRect(page)) level.clear(page, ground);
    this.painter.paint(frame.pixelFromArtboard, shift, page, isSameView);
  }

  /**
   * Returns the pixels whose centres lie on the page.
   * @param {Frame} frame
   * @param {number[]} shift
   */
  pageRect({ pixelFromArtboard }, shift) {
    const box = mappedBox(pixelFromArtboard, this.picture.viewport);
    const far = 1e6;
    const edge = (/** @type {number} */ i) =>
      Math.max(-far, Math.min(far, Math.round(box[i] + shift[i % 2])));
    const [x, y] = [edge(0), edge(1)];
    return intersected(this.targets.whole, [x, y, edge(2) - x, edge(3) - y]);
  }

  /**
   * @param {Frame} frame
   * @param {WebGLTexture} picture
   */
  present(frame, picture) {
    const { gl, targets } = this;
    const ink = frame.mesh ? this.drawInk(frame) : this.noInk.texture;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, targets.size[0], targets.size[1]);
    gl.disable(gl.SCISSOR_TEST);
    gl.disable(gl.BLEND);
    this.programs
      .get("screen", "present")
      .use()
      .texture("picture", picture)
      .texture("ink", ink)
      .int("turned", 1)
      .int("premultiplied", 1);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** @param {Frame} frame */
  drawInk(frame) {
    const { gl, targets } = this;
    const ink = targets.ink();
    ink.clear(targets.whole, [0, 0, 0, 0]);
    ink.bind(this.pageRect(frame, [0, 0]));
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    gl.blendEquation(gl.MAX);
    for (const item of this.picture.stack) {
      if (item.kind !== "instance") continue;
      this.layers.drawMesh(item, frame.pixelFromArtboard, targets.size, frame.lineScale);
    }
    gl.blendEquation(gl.FUNC_ADD);
    return ink.texture;
  }
}
