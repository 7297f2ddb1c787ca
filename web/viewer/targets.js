// Images on the GPU, for drawing and reading.

/** @import { Abilities } from "./gl.js" */

/** A rectangle of pixels: x, y, width, height. @typedef {number[]} Rect */

/**
 * @param {Rect} a
 * @param {Rect} b
 * @returns {Rect}
 */
export function intersected(a, b) {
  const x = Math.max(a[0], b[0]),
    y = Math.max(a[1], b[1]);
  const right = Math.min(a[0] + a[2], b[0] + b[2]),
    bottom = Math.min(a[1] + a[3], b[1] + b[3]);
  return [x, y, Math.max(0, right - x), Math.max(0, bottom - y)];
}

/**
 * Returns the smallest rectangle that holds both; an empty rectangle does not count.
 * @param {Rect} a
 * @param {Rect} b
 * @returns {Rect}
 */
export function unitedRects(a, b) {
  if (isEmptyRect(a)) return b;
  if (isEmptyRect(b)) return a;
  const x = Math.min(a[0], b[0]),
    y = Math.min(a[1], b[1]);
  const right = Math.max(a[0] + a[2], b[0] + b[2]),
    bottom = Math.max(a[1] + a[3], b[1] + b[3]);
  return [x, y, right - x, bottom - y];
}

/** @param {Rect} rect */
export function isEmptyRect(rect) {
  return !(rect[2] > 0 && rect[3] > 0);
}

/**
 * Width of the border that is also cleared and resolved, pixels. Along the border of such a rectangle some drivers
 * (Mesa's llvmpipe) leave out samples.
 */
const BORDER = 4;

/**
 * Returns a rectangle with its border.
 * @param {Rect} rect
 * @param {Rect} whole the limit of the result
 */
function bordered([x, y, width, height], whole) {
  const grown = [x - BORDER, y - BORDER, width + 2 * BORDER, height + 2 * BORDER];
  return intersected(whole, grown);
}

/**
 * A texture to draw into; if it is multisampled, with the buffer that receives the drawing first.
 */
export class Target {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {number} format
   * @param {number[]} size
   * @param {number} samples 0: none
   */
  constructor(gl, format, size, samples) {
    this.gl = gl;
    this.size = size;
    this.texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, size[0], size[1]);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
      gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    }
    this.resolved = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.resolved);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.texture, 0);
    this.drawn = this.resolved;
    this.buffer = null;
    if (samples > 0) this.makeBuffer(format, samples);
  }

  /**
   * @param {number} format
   * @param {number} samples
   */
  makeBuffer(format, samples) {
    const { gl, size } = this;
    this.buffer = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, this.buffer);
    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, size[0], size[1]);
    this.drawn = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.drawn);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, this.buffer);
  }

  /**
   * Directs drawing to this target, within a rectangle.
   * @param {Rect} rect
   */
  bind(rect) {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.drawn);
    gl.viewport(0, 0, this.size[0], this.size[1]);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(rect[0], rect[1], rect[2], rect[3]);
  }

  /**
   * Clears a rectangle and its border to transparent, and directs drawing into it.
   * @param {Rect} rect
   */
  begin(rect) {
    this.clear(bordered(rect, [0, 0, this.size[0], this.size[1]]), [0, 0, 0, 0]);
    this.bind(rect);
  }

  /**
   * @param {Rect} rect
   * @param {number[]} color red, green, blue, alpha
   */
  clear(rect, color) {
    this.bind(rect);
    this.gl.clearColor(color[0], color[1], color[2], color[3]);
    this.gl.clear(this.gl.COLOR_BUFFER_BIT);
  }

  /**
   * Copies the drawing into the texture.
   * @param {Rect} rect
   */
  resolve(rect) {
    if (this.drawn === this.resolved) return;
    const { gl } = this;
    const [x, y, width, height] = bordered(rect, [0, 0, this.size[0], this.size[1]]);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.drawn);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, this.resolved);
    gl.disable(gl.SCISSOR_TEST);
    const right = x + width,
      bottom = y + height;
    gl.blitFramebuffer(x, y, right, bottom, x, y, right, bottom, gl.COLOR_BUFFER_BIT, gl.NEAREST);
  }

  free() {
    const { gl } = this;
    gl.deleteTexture(this.texture);
    gl.deleteFramebuffer(this.resolved);
    if (this.drawn !== this.resolved) gl.deleteFramebuffer(this.drawn);
    gl.deleteRenderbuffer(this.buffer);
  }
}

/** Names of the largest targets. */
const SUMS = "sums";
const MEAN = "mean";

/** Targets of one size, made when they are first needed. */
export class Targets {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {Abilities} abilities
   */
  constructor(gl, abilities) {
    this.gl = gl;
    this.abilities = abilities;
    this.size = [0, 0];
    /** @type {Map<string, Target>} */
    this.made = new Map();
  }

  /** @param {number[]} size */
  resize(size) {
    if (size[0] === this.size[0] && size[1] === this.size[1]) return;
    this.free();
    this.size = size;
  }

  free() {
    for (const target of this.made.values()) target.free();
    this.made.clear();
  }

  /** Frees targets whose content is not kept between frames. */
  rest() {
    for (const name of [SUMS, MEAN]) {
      this.made.get(name)?.free();
      this.made.delete(name);
    }
  }

  /** @returns {Rect} */
  get whole() {
    return [0, 0, this.size[0], this.size[1]];
  }

  /**
   * @param {string} name
   * @param {number} format
   * @param {number} samples
   */
  get(name, format, samples) {
    let target = this.made.get(name);
    if (!target) {
      target = new Target(this.gl, format, this.size, samples);
      this.made.set(name, target);
    }
    return target;
  }

  /**
   * Returns the image (0), the image of a nested group, or an image to blend ("source").
   * @param {number | "source"} level
   */
  level(level) {
    return this.get(`level ${level}`, this.format, this.abilities.samples);
  }

  get format() {
    return this.abilities.halfTargets ? this.gl.RGBA16F : this.gl.RGBA8;
  }

  /** Returns the target for summing local curves. */
  sums() {
    return this.get(SUMS, this.abilities.floatSums ? this.gl.RGBA32F : this.format, 0);
  }

  /**
   * Returns the image of a run of strokes.
   * @param {number} slot
   */
  run(slot) {
    return this.get(`run ${slot}`, this.format, 0);
  }

  /** Returns the target for averaging images to a finer one. */
  mean() {
    const { gl, abilities } = this;
    return this.get(MEAN, abilities.floatSums ? gl.RGBA32F : gl.RGBA16F, 0);
  }

  /** Returns the target for the lines of the mesh. */
  ink() {
    return this.get("ink", this.gl.RG8, 0);
  }
}
