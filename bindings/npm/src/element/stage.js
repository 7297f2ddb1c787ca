// The page's only WebGL context, because browsers allow a page about sixteen. Elements ask for frames, which are
// drawn one at a time and copied to the elements' own canvases.
import { Programs } from "../../../../web/viewer/gl.js";
import { makeTexels } from "../../../../web/viewer/paints.js";
import { drawPage } from "../../../../web/viewer/paper.js";
import { Renderer } from "../../../../web/viewer/renderer.js";

/** @import { Picture } from "../../../../web/viewer/payload.js" */
/** @import { Frame } from "../../../../web/viewer/renderer.js" */

/**
 * An element that shows a picture.
 * @typedef {object} Client
 * @property {Picture | null} picture
 * @property {boolean} isMoving
 * @property {boolean} isDirty something visible was not drawn yet
 * @property {boolean} isFine the last frame is as fine as possible
 * @property {() => Frame} frame
 * @property {(now: number) => void} step continues a motion
 * @property {(canvas: OffscreenCanvas | HTMLCanvasElement, isFine: boolean) => void} show
 * @property {(error: unknown) => void} fail
 */

/** Limit for the pictures with tables on the GPU. */
const MOST_RENDERERS = 8;
/** How long to wait for a lost context, milliseconds. */
const PATIENCE = 2000;
const settings = { alpha: true, antialias: false, depth: false, stencil: false };

class Stage {
  /** @param {() => void} onLost */
  constructor(onLost) {
    this.canvas =
      typeof OffscreenCanvas === "undefined" ? document.createElement("canvas") : new OffscreenCanvas(1, 1);
    this.gl = /** @type {WebGL2RenderingContext | null} */ (this.canvas.getContext("webgl2", settings));
    if (!this.gl) throw new Error("This browser has no WebGL 2.");
    /** By picture, the one used last at the end. @type {Map<Picture, Renderer>} */
    this.renderers = new Map();
    /** @type {WeakMap<Picture, Promise<Uint16Array>>} */
    this.texels = new WeakMap();
    /** @type {WeakMap<Picture, Uint16Array>} */
    this.madeTexels = new WeakMap();
    /** The client whose frame the targets hold. @type {Client | null} */
    this.owner = null;
    this.programs = new Programs(this.gl);
    this.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.forget();
      onLost();
    });
  }

  /** Forgets everything that was on the GPU, after the context was lost. */
  forget() {
    this.renderers.clear();
    this.owner = null;
    if (this.gl) this.programs = new Programs(this.gl);
  }

  /** Decodes the textures of a picture, after which it can be drawn. @param {Picture} picture */
  async prepare(picture) {
    const { gl } = this;
    if (!gl) return;
    let texels = this.texels.get(picture);
    if (!texels) {
      texels = makeTexels(gl, picture.paints);
      this.texels.set(picture, texels);
    }
    this.madeTexels.set(picture, await texels);
  }

  /** @param {Picture} picture */
  isPrepared(picture) {
    return this.madeTexels.has(picture);
  }

  /** @param {Picture} picture */
  rendererOf(picture) {
    const { gl } = this;
    const texels = this.madeTexels.get(picture);
    if (!gl || !texels) throw new Error("The picture was not prepared.");
    const renderer = this.renderers.get(picture) ?? new Renderer(gl, picture, texels, this.programs);
    this.renderers.delete(picture);
    this.renderers.set(picture, renderer);
    for (const [other, oldest] of this.renderers) {
      if (this.renderers.size <= MOST_RENDERERS) break;
      this.renderers.delete(other);
      oldest.free();
    }
    return renderer;
  }

  /** Frees the memory that a picture uses on the GPU. @param {Picture} picture */
  drop(picture) {
    const renderer = this.renderers.get(picture);
    if (!renderer) return;
    this.renderers.delete(picture);
    if (this.owner?.picture === picture) this.owner = null;
    renderer.free();
  }

  get isBusy() {
    const renderer = [...this.renderers.values()].at(-1);
    return renderer?.isBusy ?? false;
  }

  /** Draws one frame, or one step towards a finer one. @param {Client} client */
  draw(client) {
    const picture = /** @type {Picture} */ (client.picture);
    const renderer = this.rendererOf(picture);
    const frame = client.frame();
    // Targets are large, so only one picture keeps them.
    for (const other of this.renderers.values()) if (other !== renderer) other.targets.free();
    const [width, height] = frame.size;
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    if (client.isDirty || this.owner !== client) {
      renderer.draw(frame);
      this.owner = client;
      client.show(this.canvas, !renderer.canRefine);
      return;
    }
    renderer.refine(frame);
    if (!renderer.canRefine) client.show(this.canvas, true);
  }

  /** Called when there is nothing more to draw. */
  rest() {
    for (const renderer of this.renderers.values()) renderer.targets.free();
    this.owner = null;
    [this.canvas.width, this.canvas.height] = [1, 1];
  }

  /**
   * Draws the whole page of a client's picture, as fine as possible.
   * @param {Client} client
   * @param {number} side the longer one, pixels
   */
  page(client, side) {
    const renderer = this.rendererOf(/** @type {Picture} */ (client.picture));
    this.owner = null;
    drawPage(renderer, this.canvas, client.frame(), side);
    return this.canvas;
  }
}

/** @type {Stage | null} */
let stage = null;
/** @type {Set<Client>} */
const asked = new Set();
/** All clients that show a picture, to draw again when the context is restored. @type {Set<Client>} */
export const clients = new Set();
let isScheduled = false;
/** Number of reasons not to draw frames. */
let pauses = 0;

function redrawAll() {
  for (const client of clients) {
    client.isDirty = true;
    ask(client);
  }
}

/** Waits until a lost context is restored, or replaces it. */
function waitForAnother() {
  const lost = stage;
  setTimeout(() => {
    if (stage !== lost || !lost?.gl?.isContextLost()) return;
    stage = null;
    redrawAll();
  }, PATIENCE);
  lost?.canvas.addEventListener("webglcontextrestored", redrawAll, { once: true });
}

/** Returns the stage. Throws without WebGL 2. */
function theStage() {
  stage ??= new Stage(waitForAnother);
  return stage;
}

/** Returns the largest side that a frame can have, pixels. */
export function largestSide() {
  const { gl } = theStage();
  return Math.min(gl?.getParameter(gl.MAX_TEXTURE_SIZE) ?? Infinity, ...(gl?.getParameter(gl.MAX_VIEWPORT_DIMS) ?? []));
}

/** Makes a picture ready for drawing. @param {Picture} picture */
export async function prepare(picture) {
  await theStage().prepare(picture);
}

/** Asks for frames of a client until its frame is as fine as possible. @param {Client} client */
export function ask(client) {
  asked.add(client);
  schedule();
}

/** @param {Client} client */
export function leave(client) {
  asked.delete(client);
  clients.delete(client);
  if (stage?.owner === client) stage.owner = null;
  const { picture } = client;
  if (picture && ![...clients].some((other) => other.picture === picture)) stage?.drop(picture);
}

/** Stops drawing a client until it asks again. @param {Client} client */
export function unask(client) {
  asked.delete(client);
}

/** Draws no frames for the screen until a promise settles. @param {Promise<unknown>} end */
export function pauseUntil(end) {
  pauses += 1;
  void end.finally(() => {
    pauses -= 1;
    if (asked.size > 0) schedule();
  });
}

function schedule() {
  if (isScheduled || pauses > 0) return;
  isScheduled = true;
  requestAnimationFrame((now) => {
    isScheduled = false;
    if (pauses === 0) tick(now);
  });
}

/** Returns the next client: first one that a person moves, then one never shown, then one to refine. */
function next() {
  let best = null;
  let rank = -1;
  for (const client of asked) {
    const own = client.isMoving ? 3 : client.isDirty ? 2 : client === stage?.owner ? 1 : 0;
    if (own > rank) [best, rank] = [client, own];
  }
  return best;
}

/** @param {number} now milliseconds */
function tick(now) {
  for (const client of asked) if (client.isMoving) client.step(now);
  const client = next();
  if (!client) return;
  // Do not queue more work on a busy GPU.
  if (stage?.isBusy && !stage.gl?.isContextLost()) return schedule();
  try {
    drawOne(client);
  } catch (error) {
    asked.delete(client);
    client.fail(error);
  }
  if (asked.size > 0) schedule();
  else if (!stage?.gl?.isContextLost()) stage?.rest();
}

/** @param {Client} client */
function drawOne(client) {
  const here = theStage();
  if (here.gl?.isContextLost()) return void asked.clear(); // all are drawn again afterwards
  const { picture } = client;
  if (!picture) return void asked.delete(client);
  if (!here.isPrepared(picture)) {
    asked.delete(client);
    here.prepare(picture).then(() => ask(client), (error) => client.fail(error));
    return;
  }
  here.draw(client);
  if (client.isFine && !client.isMoving && !client.isDirty) asked.delete(client);
}

/**
 * Draws a client's whole page at once.
 * @param {Client} client
 * @param {number} side the longer one, pixels
 * @returns {OffscreenCanvas | HTMLCanvasElement | null} null: it cannot be drawn now
 */
export function pageOf(client, side) {
  if (!stage || !client.picture || stage.gl?.isContextLost() || !stage.isPrepared(client.picture)) return null;
  return stage.page(client, side);
}
