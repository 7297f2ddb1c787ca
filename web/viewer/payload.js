// Reads the picture from the page: base64, inflate, then the tables (docs/viewer.md, "Payload").

import { ByteReader, PayloadError } from "./bytes.js";
import { readMesh } from "./mesh.js";
import { readField, readShaders } from "./field.js";
import { readPaints } from "./paints.js";
import { readSegments } from "./segments.js";

/** @import { Affine } from "./affine.js" */
/** @import { Field } from "./field.js" */
/** @import { Paints } from "./paints.js" */
/** @import { Segments } from "./segments.js" */

const MAGIC = "SFUMATO";
const VERSION = 1;
/** Added to the version if layers have no tables. */
const WITHOUT_TABLES = 128;
const MOST_GROUPS = 16;
const MOST_BLEND = 15;

/**
 * A layer ready for drawing. Its tables are as from sfumato_picture_table(), except the positions.
 * @typedef {object} Layer
 * @property {number} order 0 linear, 1 quadratic, 2 cubic
 * @property {number[]} origin layer frame; positions are relative to it
 * @property {number[]} bounds minimum x, y, maximum x, y of the area that it can touch; layer frame
 * @property {Float32Array} positions 2 a vertex, layer frame, relative to the origin
 * @property {Uint32Array} triangleVertex 3 a triangle
 * @property {Uint8Array} edgeIsCurve 3 a triangle
 * @property {Field} color channels red, green, blue, weights of shaders
 * @property {Field | null} opacity channels opacity, weights of shaders; null: the layer is opaque
 */

/**
 * @typedef {object} Instance
 * @property {"instance"} kind
 * @property {number} layer
 * @property {Affine} artboardFromLayer
 * @property {number} opacity
 * @property {number} blend
 */

/**
 * A local curve as segments for the shaders. Frame: the stroke's, relative to `origin`.
 * @typedef {object} Stroke
 * @property {"stroke"} kind
 * @property {Affine} artboardFromStroke
 * @property {number[]} origin
 * @property {number} alpha
 * @property {boolean} twoSided
 * @property {Segments} segments
 */

/** @typedef {{kind: "begin", opacity: number, blend: number}} GroupBegin */
/** @typedef {{kind: "end"}} GroupEnd */
/** @typedef {Instance | Stroke | GroupBegin | GroupEnd} Item */

/**
 * The properties of a layer that are not in its tables.
 * @typedef {object} BareLayer
 * @property {number} order 0 linear, 1 quadratic, 2 cubic
 * @property {number[]} colorShaders indices of the picture's shaders, the last channels of its colour
 * @property {number[] | null} opacityShaders null: the layer is opaque
 */

/**
 * A picture with layers of type L.
 * @template L
 * @typedef {object} PictureOf
 * @property {number[]} artboard
 * @property {number[]} viewport
 * @property {number} interpolation 0 code values, 1 linear light, 2 OKLab
 * @property {number[]} background
 * @property {Paints} paints
 * @property {L[]} layers
 * @property {Item[]} stack
 */

/**
 * A picture with the bytes of its layers as rays meet them, for readExactLayers() of exact_fields.js.
 * @typedef {PictureOf<Layer> & {exact?: Uint8Array}} Picture
 */
/** @typedef {PictureOf<BareLayer>} Stack */

/**
 * Returns the bytes of base64 text.
 * @param {string} text
 */
function bytesOfBase64(text) {
  let binary;
  try {
    binary = atob(text.trim());
  } catch {
    throw new PayloadError("its text is not base64");
  }
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/**
 * @param {Uint8Array<ArrayBuffer>} bytes in zlib's format
 */
async function inflated(bytes) {
  if (typeof DecompressionStream === "undefined") {
    throw new Error("This browser cannot unpack the picture: it has no DecompressionStream.");
  }
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  try {
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new PayloadError("it does not unpack");
  }
}

/** Reads the parts of a picture that are the same with layers' tables and without. */
class StackReader {
  /** @param {Uint8Array} bytes */
  constructor(bytes) {
    this.reader = new ByteReader(bytes);
    this.shaderCount = 0;
    this.layerCount = 0;
  }

  /**
   * @template L
   * @param {number} expected version
   * @param {() => L} readLayer
   * @returns {PictureOf<L>}
   */
  picture(expected, readLayer) {
    const { reader } = this;
    const magic = String.fromCharCode(...reader.take(MAGIC.length));
    if (magic !== MAGIC) throw new PayloadError("it does not begin as it should");
    const version = reader.u8();
    if (version !== expected) throw new PayloadError(`its version is ${version}, not ${expected}`);
    const artboard = this.box(),
      viewport = this.box();
    const interpolation = this.below(3);
    const background = [reader.f32(), reader.f32(), reader.f32()];
    const paints = readPaints(reader);
    this.shaderCount = paints.paint.length;
    const layers = this.list(readLayer);
    this.layerCount = layers.length;
    const stack = this.list(() => this.item());
    this.checkGroups(stack);
    return { artboard, viewport, interpolation, background, paints, layers, stack };
  }

  /**
   * @template T
   * @param {() => T} readOne
   * @returns {T[]}
   */
  list(readOne) {
    return Array.from({ length: this.reader.count(1) }, readOne);
  }

  /** @param {number} bound */
  below(bound) {
    const value = this.reader.u8();
    if (value >= bound) throw new PayloadError("a number in it is too large");
    return value;
  }

  box() {
    const box = Array.from({ length: 4 }, () => this.reader.finite());
    if (!(box[0] <= box[2] && box[1] <= box[3]))
      throw new PayloadError("a rectangle of it is empty");
    return box;
  }

  /** @returns {Item} */
  item() {
    switch (this.below(4)) {
      case 0:
        return this.instance();
      case 1:
        return this.stroke();
      case 2:
        return { kind: "begin", ...this.blending() };
      default:
        return { kind: "end" };
    }
  }

  affine() {
    return Array.from({ length: 6 }, () => this.reader.finite());
  }

  blending() {
    const opacity = this.reader.f32();
    if (!(opacity >= 0 && opacity <= 1))
      throw new PayloadError("an opacity of it is not from 0 to 1");
    return { opacity, blend: this.below(MOST_BLEND + 1) };
  }

  /** @returns {Instance} */
  instance() {
    const layer = this.reader.varint();
    if (layer >= this.layerCount) throw new PayloadError("a layer of it is not there");
    return { kind: "instance", layer, artboardFromLayer: this.affine(), ...this.blending() };
  }

  /** @returns {Stroke} */
  stroke() {
    const { reader } = this;
    const artboardFromStroke = this.affine();
    const origin = [reader.finite(), reader.finite()];
    const alpha = reader.f32();
    const twoSided = this.below(2) === 1;
    const segments = readSegments(reader);
    return { kind: "stroke", artboardFromStroke, origin, alpha, twoSided, segments };
  }

  /** @param {Item[]} stack */
  checkGroups(stack) {
    let depth = 0;
    for (const { kind } of stack) {
      if (kind === "begin") depth += 1;
      if (kind === "end") depth -= 1;
      if (depth < 0 || depth > MOST_GROUPS) throw new PayloadError("its groups do not nest");
    }
    if (depth !== 0) throw new PayloadError("its groups do not nest");
  }
}

export class PictureReader extends StackReader {
  /** @returns {Picture} */
  run() {
    const picture = this.picture(VERSION, () => this.layer());
    return { ...picture, exact: this.reader.rest() };
  }

  /** @returns {Layer} */
  layer() {
    const order = this.below(3);
    const { topology, ...mesh } = readMesh(this.reader);
    const color = readField(this.reader, topology, 3, this.shaderCount);
    const hasOpacity = this.below(2) === 1;
    const opacity = hasOpacity ? readField(this.reader, topology, 1, this.shaderCount) : null;
    return { order, ...mesh, triangleVertex: topology.cornerVertex, color, opacity };
  }
}

/**
 * Reads a picture whose layers have no tables, from sfumato_picture_stack(). Throws PayloadError.
 * @param {Uint8Array} bytes
 * @returns {Stack}
 */
export function readStack(bytes) {
  const reader = new StackReader(bytes);
  return reader.picture(VERSION + WITHOUT_TABLES, () => ({
    order: reader.below(3),
    colorShaders: readShaders(reader.reader, reader.shaderCount),
    opacityShaders: reader.below(2) === 1 ? readShaders(reader.reader, reader.shaderCount) : null,
  }));
}

/**
 * @param {string} base64
 * @returns {Promise<Picture>}
 */
export async function readPicture(base64) {
  const bytes = await inflated(bytesOfBase64(base64));
  return new PictureReader(bytes).run();
}
