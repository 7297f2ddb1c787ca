// Exact pixels: gathered on the GPU, part by part, while the picture stands still (docs/viewer.md,
// "Exact pixels").

import { composed, inverted, mappedBox, translation } from "./affine.js";
import { PayloadError } from "./bytes.js";
import { exactShaders } from "./dist/shaders.js";
import { readExactLayers } from "./exact_fields.js";
import { ExactScene, wholeShift } from "./exact_scene.js";
import { Pace, TILE, without, Work } from "./exact_work.js";
import { intersected, isEmptyRect, Target } from "./targets.js";

/** @import { Affine } from "./affine.js" */
/** @import { Programs } from "./gl.js" */
/** @import { ExactLayer } from "./exact_fields.js" */
/** @import { Instance, Layer, Picture } from "./payload.js" */
/** @import { Renderer } from "./renderer.js" */
/** @import { Rect } from "./targets.js" */

/** kPointNegligible of src/gather/kernels. */
const NEGLIGIBLE = 1e-5;
/** Limit for the triangles that one pixel walks through; above it, the pixel of the patches remains. */
const STEP_LIMIT = 1 << 15;
/** Samples in a pixel that a curve cuts, where the curve's chords are finer than the patches' chords. */
const CUT_SAMPLES = 16;
/** Limit for the memory of all exact images, and the size of one pixel in them, bytes. */
const MOST_BYTES = 1 << 28;
const PIXEL_BYTES = 8;

/** Matches drivers that draw in software. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render|apple software/i;

/**
 * Returns whether the driver draws in software.
 * @param {WebGL2RenderingContext} gl
 */
export function isSoftware(gl) {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  return SOFTWARE.test(String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)));
}

/**
 * Returns the layers as rays meet them, or the reason why exact pixels are impossible.
 * @param {WebGL2RenderingContext} gl
 * @param {Picture} picture
 * @param {(ExactLayer | null)[] | null} known null: they are in the payload
 * @returns {(ExactLayer | null)[] | string}
 */
function layersOrReason(gl, picture, known) {
  if (!gl.getExtension("EXT_color_buffer_float")) return "the graphics driver lacks float targets";
  if (known) return wholeOrReason(picture, known);
  if (!picture.exact || picture.exact.length === 0) return "this file holds no curves for them";
  try {
    return wholeOrReason(picture, readExactLayers(picture.exact, picture.layers));
  } catch (error) {
    if (error instanceof PayloadError) return "the curves in this file are damaged";
    throw error;
  }
}

/**
 * Returns the layers, or a message about the layers that lack curves.
 * @param {Picture} picture
 * @param {(ExactLayer | null)[]} layers
 */
function wholeOrReason(picture, layers) {
  const used = new Set(picture.stack.map((item) => (item.kind === "instance" ? item.layer : -1)));
  const isWhole = layers.every(
    (layer, i) => layer || !used.has(i) || picture.layers[i].triangleVertex.length === 0,
  );
  if (layers.every((layer) => layer === null)) return "this picture has no layers of curves";
  return isWhole ? layers : "a layer has image-domain shaders";
}

/** The gathered pixels of one instance. */
class ExactImage {
  /**
   * @param {ExactScene} scene
   * @param {Target} target
   * @param {Affine} pixelFromLayer
   * @param {Rect} rect
   * @param {Rect[]} todo
   */
  constructor(scene, target, pixelFromLayer, rect, todo) {
    this.scene = scene;
    this.target = target;
    this.pixelFromLayer = pixelFromLayer;
    this.rect = rect;
    this.work = new Work(todo);
    this.hasAny = false;
  }
}

export class ExactPixels {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {Programs} programs
   * @param {Picture} picture
   * @param {(ExactLayer | null)[] | null} known its layers as rays meet them; null: read them
   */
  constructor(gl, programs, picture, known) {
    this.gl = gl;
    this.programs = programs;
    // Added here, because a program that never shows exact pixels is bundled without them.
    Object.assign(programs.texts, exactShaders);
    this.picture = picture;
    this.format = gl.RGBA16F;
    this.stepLimit = STEP_LIMIT;
    this.pace = new Pace(isSoftware(gl));
    /** @type {Map<Layer, ExactScene>} */
    this.scenes = new Map();
    /** @type {Map<Instance, ExactImage>} */
    this.images = new Map();
    /** Where triangles lie in the present tile. @type {Target | null} */
    this.places = null;
    /** @type {Rect} */
    this.tile = [0, 0, 0, 0];
    /** Whether the gathered pixels belong to the present view. */
    this.isShown = false;
    /** @type {WebGLSync | null} */
    this.fence = null;
    /** Why exact pixels are impossible; empty if they are possible. */
    this.reason = "";
    const layers = layersOrReason(gl, picture, known);
    if (typeof layers === "string") {
      this.reason = layers;
      return;
    }
    layers.forEach((layer, i) => {
      if (layer) this.scenes.set(picture.layers[i], new ExactScene(gl, layer));
    });
  }

  /** Stops showing the gathered pixels, but keeps them for a view that differs only by a shift. */
  leave() {
    this.isShown = false;
  }

  /** Whether the reason depends on the view, so that another view may have exact pixels. */
  isTooLarge = false;

  /**
   * Starts gathering the pixels of a view.
   * @param {number[]} size of the target, pixels
   * @param {Affine} pixelFromArtboard
   * @param {(instance: Instance) => Rect} touched returns the area that an instance can touch
   */
  begin(size, pixelFromArtboard, touched) {
    const seen = this.seen(size, touched);
    const before = this.images;
    this.images = new Map();
    if (this.isTooLarge) this.reason = "";
    this.isTooLarge = seen.length * PIXEL_BYTES * size[0] * size[1] > MOST_BYTES;
    if (this.isTooLarge) this.reason = "the window has too many pixels for so many layers";
    for (const { instance, scene, rect } of this.isTooLarge ? [] : seen) {
      const pixelFromLayer = composed(pixelFromArtboard, instance.artboardFromLayer);
      scene.look(pixelFromLayer, size);
      const known = before.get(instance);
      this.images.set(instance, this.imageFor(scene, known, size, pixelFromLayer, rect));
      before.delete(instance);
    }
    for (const { target } of before.values()) target.free();
    this.isShown = true;
  }

  /**
   * Returns the instances that can touch the window, and where.
   * @param {number[]} size
   * @param {(instance: Instance) => Rect} touched
   */
  seen(size, touched) {
    return this.picture.stack.flatMap((item) => {
      const scene = item.kind === "instance" && this.scenes.get(this.picture.layers[item.layer]);
      if (!scene) return [];
      const rect = intersected([0, 0, ...size], touched(item));
      return isEmptyRect(rect) ? [] : [{ instance: item, scene, rect }];
    });
  }

  /**
   * Returns an image for the visible part of an instance, with all usable pixels of an earlier image.
   * @param {ExactScene} scene
   * @param {ExactImage | undefined} before
   * @param {number[]} size
   * @param {Affine} pixelFromLayer
   * @param {Rect} rect
   */
  imageFor(scene, before, size, pixelFromLayer, rect) {
    const target = new Target(this.gl, this.format, size, 0);
    target.clear([0, 0, ...size], [0, 0, 0, -1]);
    const shift = before && wholeShift(before.pixelFromLayer, pixelFromLayer);
    let todo = [rect];
    let kept = [0, 0, 0, 0];
    if (before && shift && before.work.isDone) {
      const moved = [before.rect[0] + shift[0], before.rect[1] + shift[1], ...before.rect.slice(2)];
      kept = intersected(rect, moved);
      todo = without(rect, kept);
      this.copy(before.target, target, kept, shift);
    }
    before?.target.free();
    const image = new ExactImage(scene, target, pixelFromLayer, rect, todo);
    image.hasAny = kept[2] * kept[3] > 0;
    return image;
  }

  /**
   * @param {Target} from
   * @param {Target} to
   * @param {Rect} rect in `to`
   * @param {number[]} shift
   */
  copy(from, to, [x, y, width, height], [dx, dy]) {
    if (width * height === 0) return;
    const { gl } = this;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from.resolved);
    gl.bindTexture(gl.TEXTURE_2D, to.texture);
    gl.copyTexSubImage2D(gl.TEXTURE_2D, 0, x, y, x - dx, y - dy, width, height);
  }

  /** Returns the exact pixels to show for an instance, or null. @param {Instance} instance */
  shownOf(instance) {
    const image = this.isShown ? this.images.get(instance) : undefined;
    return image?.hasAny ? image : null;
  }

  get isDone() {
    return [...this.images.values()].every(({ work }) => work.isDone);
  }

  /** The share of the pixels that are gathered, from 0 to 1. */
  get progress() {
    let all = 0,
      left = 0;
    for (const { rect, work } of this.images.values()) {
      all += rect[2] * rect[3];
      left += work.left;
    }
    return all > 0 ? 1 - left / all : 1;
  }

  /** Whether pixels that curves cut are gathered as well, at several points. */
  get hasCuts() {
    return [...this.images.values()].every(({ scene }) => scene.isRefined);
  }

  /** Whether the GPU still gathers. */
  get isBusy() {
    return this.fence !== null;
  }

  /** Gathers as many pixels as fit into a frame. */
  step() {
    const { gl } = this;
    let most = this.pace.pixels;
    const start = performance.now();
    for (const image of this.images.values()) {
      while (most > 0 && !image.work.isDone) most -= this.gather(image, most);
    }
    gl.colorMask(true, true, true, true);
    this.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    this.wait(start);
  }

  /**
   * Polls the GPU until it is done, to measure the time.
   * @param {number} start
   */
  wait(start) {
    const { gl, fence } = this;
    if (!fence) return;
    const isDone = gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.UNSIGNALED;
    if (!isDone && !gl.isContextLost()) {
      setTimeout(() => this.wait(start), 1);
      return;
    }
    gl.deleteSync(fence);
    this.fence = null;
    this.pace.learn(performance.now() - start);
  }

  /**
   * Gathers a part of an image.
   * @param {ExactImage} image
   * @param {number} most limit for the pixels
   * @returns {number} how many were gathered
   */
  gather(image, most) {
    const { scene } = image;
    const [x, y] = scene.tablesMade.origin;
    const pixelFromScene = composed(image.pixelFromLayer, translation(x, y));
    const tile = image.work.nextTile();
    if (tile) this.place(scene, tile, pixelFromScene);
    const rect = image.work.take(most);
    this.walk(image, rect, pixelFromScene);
    image.hasAny = true;
    return rect[2] * rect[3];
  }

  /**
   * Finds the triangle of each pixel of a tile, and the pixels that curves cut.
   * @param {ExactScene} scene
   * @param {Rect} tile
   * @param {Affine} pixelFromScene
   */
  place(scene, tile, pixelFromScene) {
    const { gl, programs } = this;
    const { triangleCount, sideCount } = scene.tablesMade;
    this.tile = tile;
    this.places ??= new Target(gl, gl.RG32F, [TILE, TILE], 0);
    const all = [0, 0, TILE, TILE];
    this.places.clear(all, [-1, 1, 0, 0]);
    gl.disable(gl.BLEND);
    const placed = composed(translation(-tile[0], -tile[1]), pixelFromScene);
    const place = programs.get("exact_place", "exact_place").use();
    scene.bind(place);
    place.map("clip_from_scene", composed([2 / TILE, 0, 0, 2 / TILE, -1, -1], placed));
    gl.drawArrays(gl.TRIANGLES, 0, 3 * triangleCount);
    gl.colorMask(false, true, false, false);
    const edges = programs.get("exact_edges", "edges").use();
    scene.bind(edges);
    edges.map("pixel_from_scene", placed).vec2("target_size", TILE, TILE);
    gl.drawArraysInstanced(gl.TRIANGLES, 0, 6, sideCount);
    gl.colorMask(true, true, true, true);
  }

  /**
   * @param {ExactImage} image
   * @param {Rect} rect in the present tile
   * @param {Affine} pixelFromScene
   */
  walk({ scene, target }, rect, pixelFromScene) {
    const { gl, programs, picture, places, tile } = this;
    const { triangleCount } = scene.tablesMade;
    const program = programs.get("screen", "exact", scene.defines).use();
    const sceneFromPixel = inverted(pixelFromScene);
    target.bind(rect);
    gl.disable(gl.BLEND);
    const [x, y, width, height] = rect;
    scene.bindEnds(program, mappedBox(sceneFromPixel, [x, y, x + width, y + height]));
    scene.bind(program);
    program
      .texture("places", places?.texture ?? null)
      .map("scene_from_pixel", sceneFromPixel)
      .float("negligible", NEGLIGIBLE)
      .int("step_limit", this.stepLimit)
      .int("triangle_count", triangleCount)
      .int("cut_samples", scene.isRefined ? CUT_SAMPLES : 0)
      .int("interpolation", picture.interpolation);
    gl.uniform2i(program.place("first_place"), tile[0], tile[1]);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  free() {
    const { gl } = this;
    for (const { target } of this.images.values()) target.free();
    for (const scene of this.scenes.values()) scene.free();
    this.images.clear();
    this.scenes.clear();
    this.places?.free();
    gl.deleteSync(this.fence);
    this.fence = null;
  }
}

/**
 * Returns a factory for Renderer.setExact().
 * @param {(ExactLayer | null)[] | null} known the layers as rays meet them; null: read the payload
 * @returns {(renderer: Renderer) => ExactPixels}
 */
export function exactPixels(known = null) {
  return ({ gl, programs, picture }) => new ExactPixels(gl, programs, picture, known);
}
