// Draws parts of a picture separately and small, with the tables that a renderer has on the GPU.

import { Painter } from "./painter.js";
import { StrokeDrawer } from "./strokes.js";
import { Targets } from "./targets.js";

/** @import { Affine } from "./affine.js" */
/** @import { Item } from "./payload.js" */
/** @import { Renderer } from "./renderer.js" */

/** @param {number} value */
const byteOf = (value) => Math.round(255 * Math.max(0, Math.min(1, value)));

export class SmallPictures {
  /** @param {Renderer} renderer the renderer of the picture that contains the items */
  constructor(renderer) {
    this.renderer = renderer;
    this.targets = new Targets(renderer.gl, renderer.abilities);
  }

  /**
   * Draws items of the renderer's picture onto a transparent image. The renderer's frame is not affected. The call
   * waits for the GPU: use it for small images while nothing moves.
   * @param {Item[]} items properly nested
   * @param {number[]} size pixels
   * @param {Affine} pixelFromArtboard
   * @returns {Uint8ClampedArray<ArrayBuffer>} red, green, blue, alpha, not premultiplied; the upper
   *   row first
   */
  draw(items, size, pixelFromArtboard) {
    const { targets } = this;
    const { gl, programs, picture, layers } = this.renderer;
    targets.resize(size);
    targets.level(0).clear(targets.whole, [0, 0, 0, 0]);
    const part = { ...picture, stack: items };
    // The renderer's strokes have the nodes for its own zoom.
    const strokes = new StrokeDrawer(gl, programs, part);
    const painter = new Painter(gl, programs, targets, part, layers, strokes);
    painter.paint(pixelFromArtboard, [0, 0], targets.whole, false);
    strokes.free();
    return this.read();
  }

  read() {
    const { gl, abilities } = this.renderer;
    const { targets } = this;
    const [width, height] = targets.size;
    const isHalf = abilities.halfTargets;
    const values = isHalf
      ? new Float32Array(4 * width * height)
      : new Uint8Array(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, targets.level(0).resolved);
    gl.readPixels(0, 0, width, height, gl.RGBA, isHalf ? gl.FLOAT : gl.UNSIGNED_BYTE, values);
    const one = isHalf ? 1 : 255;
    const out = new Uint8ClampedArray(values.length);
    for (let i = 0; i < values.length; i += 4) {
      const alpha = values[i + 3] / one;
      for (let c = 0; c < 3; ++c) out[i + c] = alpha > 0 ? byteOf(values[i + c] / one / alpha) : 0;
      out[i + 3] = byteOf(alpha);
    }
    return out;
  }

  free() {
    this.targets.free();
  }
}
