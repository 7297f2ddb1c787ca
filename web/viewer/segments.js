// Reads the segments of local curves, as src/export/html/viewer_stroke.cpp writes them, and computes the nodes that
// they need for a zoom.

import { PayloadError } from "./bytes.js";

/** @import { ByteReader } from "./bytes.js" */
/** @import { Stroke } from "./payload.js" */

/**
 * Segments of a curve in walking order, as arrays of columns. Frame: the stroke's, relative to its origin.
 * @typedef {object} Segments
 * @property {number} count
 * @property {Uint32Array} nodeCount nodes at a density of 4 per influence radius
 * @property {Float32Array[]} coefficient 6: x, y of start + u (c0 + u (c1 + u c2))
 * @property {Float32Array[]} start 2: x, y
 * @property {Float32Array[]} attribute 16: start and end of influence radius, blur radius, left
 *   red, green, blue, right red, green, blue
 */

/** Nodes per influence radius in `nodeCount`. */
const CODED_NODES = 4;

/**
 * Nodes per influence radius when drawing: for similar sides or thin curves, different sides, sharply different
 * sides.
 */
const NODES_PLAIN = 6;
const NODES_TWO_SIDED = 8;
const NODES_SHARP = 12;
/** A blur radius below this is sharp, pixels. */
const SHARP_BLUR = 5;

/** Limit for the nodes of a segment in the table, and its numbers there; docs/gpu.md. */
export const NODES_PER_SEGMENT = 16;
const SEGMENT_FLOATS = 28;

const FLOATS_A_SEGMENT = 24;

/**
 * @param {ByteReader} reader
 * @returns {Segments}
 */
export function readSegments(reader) {
  const count = reader.count(1 + 4 * FLOATS_A_SEGMENT);
  const nodeCount = reader.planes(count, 1);
  /** Reads numbers whose bits differ from a guess by the stored bits. */
  const column = (/** @type {(i: number, bits: Uint32Array) => number} */ guess) => {
    const bits = reader.planes(count, 4);
    for (let i = 0; i < count; ++i) bits[i] ^= guess(i, bits);
    return new Float32Array(bits.buffer);
  };
  const coefficient = Array.from({ length: 6 }, () => column(() => 0));
  const bitsOf = new Float32Array(1),
    codeOf = new Uint32Array(bitsOf.buffer);
  const start = [0, 1].map((axis) =>
    column((i, bits) => {
      if (i === 0) return 0;
      let guess = new Float32Array(bits.buffer)[i - 1];
      for (let c = axis; c < 6; c += 2) guess += coefficient[c][i - 1];
      bitsOf[0] = guess;
      return codeOf[0];
    }),
  );
  const attribute = [];
  for (let a = 0; a < 8; ++a) attribute.push(...readAttribute(reader, count));
  for (const values of [...coefficient, ...start, ...attribute]) {
    if (!values.every(Number.isFinite)) throw new PayloadError("a number in it is not finite");
  }
  return { count, nodeCount, coefficient, start, attribute };
}

/**
 * Reads the column of an attribute at the segments' starts and at their ends. The predictions depend on each other:
 * a start is predicted as the end before it, an end as the start of the same segment.
 * @param {ByteReader} reader
 * @param {number} count
 */
function readAttribute(reader, count) {
  const start = reader.planes(count, 4),
    end = reader.planes(count, 4);
  for (let i = 0; i < count; ++i) {
    if (i > 0) start[i] ^= end[i - 1];
    end[i] ^= start[i];
  }
  return [new Float32Array(start.buffer), new Float32Array(end.buffer)];
}

/**
 * Returns the number of nodes that a segment needs at a pixel size of `pixel`.
 * @param {Segments} segments
 * @param {number} i
 * @param {boolean} twoSided
 * @param {number} pixel frame of the segments
 */
function nodesNeeded({ nodeCount, attribute }, i, twoSided, pixel) {
  const radius = Math.min(attribute[0][i], attribute[1][i]);
  const blur = Math.min(attribute[2][i], attribute[3][i]);
  let density = NODES_PLAIN;
  // Below two pixels the sides are not visible.
  if (twoSided && radius > 2 * pixel)
    density = blur < SHARP_BLUR * pixel ? NODES_SHARP : NODES_TWO_SIDED;
  const shrink = radius / Math.max(radius, pixel);
  return Math.max(1, Math.ceil((nodeCount[i] * density * shrink) / CODED_NODES));
}

/** Writes parts of segments into the table that the shader reads. */
export class SegmentTable {
  constructor() {
    /** @type {number[]} */
    this.values = [];
  }

  get count() {
    return this.values.length / SEGMENT_FLOATS;
  }

  /**
   * Adds all segments of a stroke, each in as many parts as its nodes need.
   * @param {Stroke} stroke
   * @param {number} pixel frame of the segments
   */
  add({ segments, twoSided }, pixel) {
    for (let i = 0; i < segments.count; ++i) {
      const nodes = nodesNeeded(segments, i, twoSided, pixel);
      const parts = Math.ceil(nodes / NODES_PER_SEGMENT);
      for (let k = 0; k < parts; ++k) {
        this.addPart(segments, i, k / parts, (k + 1) / parts, Math.ceil(nodes / parts));
      }
    }
  }

  /**
   * Adds the part of a segment between u and v, with its own parameter from 0 to 1.
   * @param {Segments} segments
   * @param {number} i
   * @param {number} u
   * @param {number} v
   * @param {number} nodes
   */
  addPart({ start, coefficient, attribute }, i, u, v, nodes) {
    const width = v - u;
    const [begin, first, second, third] = [
      [0, 0],
      [0, 0],
      [0, 0],
      [0, 0],
    ];
    for (let axis = 0; axis < 2; ++axis) {
      const [c0, c1, c2] = [0, 2, 4].map((k) => coefficient[k + axis][i]);
      begin[axis] = start[axis][i] + u * (c0 + u * (c1 + u * c2));
      first[axis] = width * (c0 + u * (2 * c1 + 3 * u * c2));
      second[axis] = width * width * (c1 + 3 * u * c2);
      third[axis] = width * width * width * c2;
    }
    const at = (/** @type {number} */ a) => {
      const from = attribute[2 * a][i],
        to = attribute[2 * a + 1][i];
      return [from + (to - from) * u, from + (to - from) * v];
    };
    const [lr, lg, lb, rr, rg, rb] = [2, 3, 4, 5, 6, 7].map(at);
    this.values.push(
      ...begin,
      ...first,
      ...second,
      ...third,
      lengthPerSpeed(first, second, third, nodes),
      nodes,
      ...at(0),
      ...at(1),
      lr[0],
      lg[0],
      lb[0],
      lr[1],
      lg[1],
      lb[1],
      rr[0],
      rg[0],
      rb[0],
      rr[1],
      rg[1],
      rb[1],
      0,
      0,
    );
  }
}

/**
 * Returns the factor for the nodes' speeds that makes the nodes' lengths add up to the part's length.
 * @param {number[]} first
 * @param {number[]} second
 * @param {number[]} third
 * @param {number} nodes
 */
function lengthPerSpeed(first, second, third, nodes) {
  const meanSpeed = (/** @type {number} */ count) => {
    let sum = 0;
    for (let k = 0; k < count; ++k) {
      const u = (k + 0.5) / count;
      const speed = (/** @type {number} */ axis) =>
        first[axis] + u * (2 * second[axis] + 3 * u * third[axis]);
      sum += Math.hypot(speed(0), speed(1));
    }
    return sum / count;
  };
  const mean = meanSpeed(nodes);
  return mean > 0 ? meanSpeed(2 * NODES_PER_SEGMENT) / mean / nodes : 0;
}
