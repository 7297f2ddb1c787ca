// Paints the stack of a picture from the bottom: normal items are drawn directly, other items are drawn separately
// and then blended (docs/mathematics.md, "Pixels").

import { mappedBox } from "./affine.js";
import { intersected, isEmptyRect, unitedRects } from "./targets.js";

/** @import { Affine } from "./affine.js" */
/** @import { ExactPixels } from "./exact.js" */
/** @import { Programs } from "./gl.js" */
/** @import { GroupBegin, Instance, Item, Picture, Stroke } from "./payload.js" */
/** @import { LayerDrawer } from "./layers.js" */
/** @import { StrokeDrawer } from "./strokes.js" */
/** @import { Rect, Target, Targets } from "./targets.js" */

const NORMAL = 0;

/**
 * Returns the groups that need an image of their own. All other groups have no effect.
 * @param {Item[]} stack
 * @returns {Set<Item>} the beginnings and ends of these groups
 */
function realGroups(stack) {
  /** @type {Set<Item>} */
  const real = new Set();
  /** @type {{begin: GroupBegin, isReal: boolean}[]} */
  const open = [];
  for (const item of stack) {
    const isBlended = (item.kind === "instance" || item.kind === "begin") && item.blend !== NORMAL;
    // A blended item sees nothing below its group.
    if (isBlended && open.length > 0) open[open.length - 1].isReal = true;
    if (item.kind === "begin") open.push({ begin: item, isReal: isBlended || item.opacity < 1 });
    const group = item.kind === "end" ? open.pop() : undefined;
    if (!group) continue;
    if (group.isReal) real.add(group.begin).add(item);
  }
  return real;
}

/**
 * Strokes that the GPU keeps as one image.
 * @typedef {object} Run
 * @property {number} slot index of the image
 * @property {number[]} items indices into the stack
 */

/** Limit for the runs of strokes that are kept; each is an image on the GPU. */
const MOST_RUNS = 4;

/**
 * Returns the runs of consecutive strokes. Painting a run onto a transparent image and compositing it once gives
 * the same result.
 * @param {Item[]} stack
 * @param {Set<Item>} real groups
 * @returns {Map<number, Run>} by the index of the first stroke
 */
function strokeRuns(stack, real) {
  /** @type {number[][]} */
  const runs = [[]];
  stack.forEach((item, i) => {
    if (item.kind === "stroke") runs[runs.length - 1].push(i);
    else if (item.kind === "instance" || real.has(item)) runs.push([]);
  });
  const long = runs.filter((run) => run.length > 1).sort((a, b) => b.length - a.length);
  return new Map(long.slice(0, MOST_RUNS).map((items, slot) => [items[0], { slot, items }]));
}

export class Painter {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {Programs} programs
   * @param {Targets} targets
   * @param {Picture} picture
   * @param {LayerDrawer} layers
   * @param {StrokeDrawer} strokes
   */
  constructor(gl, programs, targets, picture, layers, strokes) {
    this.gl = gl;
    this.programs = programs;
    this.targets = targets;
    this.layers = layers;
    this.strokes = strokes;
    this.picture = picture;
    /** @type {Set<Item>} */
    this.realGroups = new Set();
    /** @type {Map<number, Run>} */
    this.runs = new Map();
    /** @type {Set<number>} */
    this.inRun = new Set();
    this.setPicture(picture);
    /** Whether runs look as in the previous frame. */
    this.runsAreKept = false;
    /** @type {Affine} */
    this.pixelFromArtboard = [1, 0, 0, 1, 0, 0];
    /** @type {Affine} */
    this.clipFromPixel = [1, 0, 0, 1, 0, 0];
    this.level = 0;
    /** Exact pixels, which replace others. @type {ExactPixels | null} */
    this.exact = null;
    /** Groups that are being painted. @type {GroupBegin[]} */
    this.open = [];
  }

  /**
   * Switches to another picture, whose layers and strokes the drawers already have.
   * @param {Picture} picture
   */
  setPicture(picture) {
    this.picture = picture;
    this.realGroups = realGroups(picture.stack);
    this.runs = strokeRuns(picture.stack, this.realGroups);
    this.inRun = new Set([...this.runs.values()].flatMap(({ items }) => items));
  }

  /**
   * Paints the picture onto level 0, which must be clear.
   * @param {Affine} pixelFromArtboard y down: pixel row 0 is the upper one
   * @param {number[]} shift of edges, pixels; samples at pixel centres do not move
   * @param {Rect} page the part of the target to paint
   * @param {boolean} isSameView as in the previous frame
   */
  paint(pixelFromArtboard, shift, page, isSameView) {
    const [width, height] = this.targets.size;
    this.pixelFromArtboard = pixelFromArtboard;
    this.clipFromPixel = [
      2 / width,
      0,
      0,
      2 / height,
      (2 * shift[0]) / width - 1,
      (2 * shift[1]) / height - 1,
    ];
    this.level = 0;
    this.runsAreKept = isSameView;
    this.strokes.prepare(pixelFromArtboard);
    const rects = this.itemRects(page);
    this.picture.stack.forEach((item, i) => {
      const run = this.runs.get(i);
      if (run) this.paintRun(run, rects);
      else if (!this.inRun.has(i) && !isEmptyRect(rects[i])) this.paintItem(item, rects[i]);
    });
    this.targets.level(0).resolve(this.targets.whole);
  }

  /**
   * Returns the area that each item can touch; at the beginning and end of a group, the area of its content.
   * @param {Rect} page
   */
  itemRects(page) {
    /** @type {Rect[]} */
    const rects = [];
    /** @type {number[]} */
    const open = [];
    this.picture.stack.forEach((item, i) => {
      rects.push([0, 0, 0, 0]);
      if (item.kind === "begin") {
        open.push(i);
      } else if (item.kind === "end") {
        const begin = /** @type {number} */ (open.pop());
        rects[i] = rects[begin];
      } else {
        rects[i] = intersected(page, this.touched(item));
      }
      const parent = open.at(-1);
      if (parent !== undefined && parent !== i)
        rects[parent] = unitedRects(rects[parent], rects[i]);
    });
    return rects;
  }

  /**
   * @param {Instance | Stroke} item
   * @returns {Rect}
   */
  touched(item) {
    if (item.kind === "instance" && item.opacity === 0) return [0, 0, 0, 0];
    const bounds = item.kind === "stroke" ? this.strokes.bounds(item) : this.layers.bounds(item);
    if (!(bounds[0] <= bounds[2])) return [0, 0, 0, 0];
    const box = mappedBox(this.pixelFromArtboard, bounds);
    // Thin strokes are a pixel wide, and edges are shifted.
    const margin = 3,
      far = 1e6;
    const [x0, y0] = [box[0], box[1]].map((v) => Math.max(-far, Math.floor(v) - margin));
    const [x1, y1] = [box[2], box[3]].map((v) => Math.min(far, Math.ceil(v) + margin));
    return [x0, y0, x1 - x0, y1 - y0];
  }

  /**
   * @param {Item} item
   * @param {Rect} rect
   */
  paintItem(item, rect) {
    switch (item.kind) {
      case "instance":
        return this.paintInstance(item, rect);
      case "stroke":
        return this.paintStroke(item, rect, this.targets.level(this.level));
      case "begin":
        if (!this.realGroups.has(item)) return;
        this.open.push(item);
        return this.targets.level(++this.level).begin(rect);
      default: {
        if (!this.realGroups.has(item)) return;
        const group = /** @type {GroupBegin} */ (this.open.pop());
        const source = this.targets.level(this.level--);
        return this.blend(source, group.opacity, group.blend, rect);
      }
    }
  }

  /**
   * @param {Instance} instance
   * @param {Rect} rect
   */
  paintInstance(instance, rect) {
    const { gl } = this;
    const exact = this.exact?.shownOf(instance) ?? null;
    const isStraight = instance.blend === NORMAL && !exact;
    const target = this.targets.level(isStraight ? this.level : "source");
    if (isStraight) target.bind(rect);
    else target.begin(rect);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    const opacity = isStraight ? instance.opacity : 1;
    this.layers.draw(instance, opacity, this.pixelFromArtboard, this.clipFromPixel);
    if (exact) this.putExact(exact);
    if (!isStraight) this.blend(target, instance.opacity, instance.blend, rect);
  }

  /**
   * Replaces the pixels that were drawn there.
   * @param {{target: Target}} exact
   */
  putExact({ target }) {
    const { gl } = this;
    gl.disable(gl.BLEND);
    this.programs.get("screen", "exact_copy").use().texture("exact", target.texture);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /**
   * @param {Stroke} stroke
   * @param {Rect} rect
   * @param {Target} target
   */
  paintStroke(stroke, rect, target) {
    const sums = this.targets.sums();
    sums.begin(rect);
    this.strokes.addUp(stroke, this.pixelFromArtboard, this.targets.size);
    target.bind(rect);
    this.strokes.show(stroke, sums.texture);
  }

  /**
   * @param {Run} run
   * @param {Rect[]} rects of all items
   */
  paintRun({ slot, items }, rects) {
    const rect = items.reduce((all, i) => unitedRects(all, rects[i]), [0, 0, 0, 0]);
    if (isEmptyRect(rect)) return;
    const target = this.targets.run(slot);
    if (!this.runsAreKept) {
      target.begin(rect);
      for (const i of items) {
        const stroke = /** @type {Stroke} */ (this.picture.stack[i]);
        if (!isEmptyRect(rects[i])) this.paintStroke(stroke, rects[i], target);
      }
    }
    this.blend(target, 1, NORMAL, rect);
  }

  /**
   * Composites an image onto the present level.
   * @param {Target} source
   * @param {number} opacity
   * @param {number} mode
   * @param {Rect} rect
   */
  blend(source, opacity, mode, rect) {
    const { gl } = this;
    const target = this.targets.level(this.level);
    source.resolve(rect);
    if (mode !== NORMAL) target.resolve(rect);
    target.bind(rect);
    const program = this.programs
      .get("screen", "composite", mode === NORMAL ? ["WITHOUT_BACKDROP"] : [])
      .use()
      .texture("source", source.texture)
      .int("source_scale", 1)
      .float("opacity", opacity);
    if (mode === NORMAL) {
      gl.enable(gl.BLEND);
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    } else {
      program.texture("backdrop", target.texture).int("blend_mode", mode);
      gl.disable(gl.BLEND);
    }
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
