// Converts an ExactMesh to the tables that the walk reads: src/gather/kernels/scene_layout.hpp.

import { NO_MATE } from "./mesh.js";
import { nextEdge, OPEN, previousEdge, SIDE } from "./exact_fields.js";

/** @import { ExactMesh, MeshField } from "./exact_mesh.js" */

const NO_PASSAGE = -1;
/** Numbers in an EdgeBeyond, in a HitEdge with a HitBlend, and in a SceneTriangle; a texel holds four. */
const BEYOND = 8;
const HIT = 16;
const TRIANGLE = 12;
/** Numbers of a free end in the table of ends. */
export const END = 20;

/** Rows of numbers, some of them integers. */
class Bits {
  /** @param {number} count */
  constructor(count) {
    this.int = new Int32Array(count);
    this.float = new Float32Array(this.int.buffer);
  }
}

/**
 * A free end, ready for the GPU.
 * @typedef {object} PlacedEnd
 * @property {number[]} position relative to the tables' origin
 * @property {number} reach
 * @property {Float32Array} numbers END of them
 */

/**
 * All tables of a layer that the walk reads. Triangles of the opacity follow the triangles of the colour.
 * @typedef {object} ExactTables
 * @property {number[]} origin what positions are relative to, layer frame
 * @property {number} triangleCount of one field
 * @property {number} sideCount of all fields
 * @property {boolean} isBlurred
 * @property {Int32Array} beyond
 * @property {Int32Array} hit
 * @property {Int32Array} blend
 * @property {Int32Array} triangle
 * @property {PlacedEnd[][]} ends per field
 */

class TableWriter {
  /**
   * @param {ExactMesh} mesh
   * @param {number[]} origin
   */
  constructor(mesh, origin) {
    this.mesh = mesh;
    this.origin = origin;
    const edges = mesh.vertex.length,
      fields = mesh.fields.length;
    const sides = mesh.fields.reduce((sum, field) => sum + field.sideCount, 0);
    const open = mesh.fields.reduce(
      (sum, { edge }) => sum + edge.reduce((n, kind) => n + (kind === OPEN ? 1 : 0), 0),
      0,
    );
    this.sideCount = sides;
    this.beyond = new Bits(BEYOND * open);
    this.hit = new Bits(HIT * sides);
    this.blend = new Bits(HIT * sides);
    this.triangle = new Bits(TRIANGLE * fields * mesh.triangleCount);
    /** Codes of the half-edges of the present field. */
    this.code = new Int32Array(edges);
    this.passages = 0;
    this.hits = 0;
    this.isBlurred = false;
    const [dx, dy] = [0, 1].map((axis) => mesh.origin[axis] - origin[axis]);
    this.x = Float32Array.from(mesh.x, (x) => x + dx);
    this.y = Float32Array.from(mesh.y, (y) => y + dy);
  }

  /** @returns {ExactTables} */
  run() {
    const { mesh, origin, sideCount } = this;
    mesh.fields.forEach((field, index) => this.addField(field, index * mesh.triangleCount));
    return {
      origin,
      triangleCount: mesh.triangleCount,
      sideCount,
      isBlurred: this.isBlurred,
      beyond: this.beyond.int,
      hit: this.hit.int,
      blend: this.blend.int,
      triangle: this.triangle.int,
      ends: mesh.fields.map((field) => this.endsOf(field)),
    };
  }

  /**
   * @param {MeshField} field
   * @param {number} firstTriangle
   */
  addField(field, firstTriangle) {
    const { mesh, code } = this;
    const unit = field.weight.reduce((most, k) => Math.max(most, k), 0) || 1;
    const passages = this.passages;
    for (let h = 0; h < mesh.vertex.length; ++h) {
      if (field.edge[h] === SIDE) {
        code[h] = -2 - this.hits;
        this.addHit(field, h, unit);
      } else {
        code[h] = field.edge[h] === OPEN ? this.passages++ : NO_PASSAGE;
      }
    }
    this.passages = passages;
    for (let h = 0; h < mesh.vertex.length; ++h) {
      if (field.edge[h] === OPEN) this.addPassage(h);
    }
    for (let t = 0; t < mesh.triangleCount; ++t) this.addTriangle(t, firstTriangle);
  }

  /** @param {number} h */
  addPassage(h) {
    const { mesh, x, y, code } = this;
    const { int, float } = this.beyond;
    const at = BEYOND * this.passages++;
    const across = mesh.twin[h],
      apex = mesh.apex(across);
    const a = mesh.vertex[h],
      b = mesh.target(h);
    const [ex, ey] = [mesh.x[b] - mesh.x[a], mesh.y[b] - mesh.y[a]];
    const length = Math.hypot(ex, ey) || 1;
    const [nx, ny] = [-ey / length, ex / length];
    float[at] = x[apex];
    float[at + 1] = y[apex];
    int[at + 2] = code[nextEdge(across)];
    int[at + 3] = code[previousEdge(across)];
    float[at + 4] = nx;
    float[at + 5] = ny;
    float[at + 6] = -(nx * x[a] + ny * y[a]);
  }

  /**
   * @param {MeshField} field
   * @param {number} h
   * @param {number} unit of weights
   */
  addHit(field, h, unit) {
    const { mesh, x, y } = this;
    const { float } = this.hit;
    const at = HIT * this.hits++;
    const side = field.sideOf[h],
      weight = field.weight[side] / unit;
    const a = mesh.vertex[h],
      b = mesh.target(h);
    float.set([x[a], y[a], x[b], y[b]], at);
    const ex = Math.fround(x[b] - x[a]),
      ey = Math.fround(y[b] - y[a]);
    float.set([ex, ey, ex * ex + ey * ey, weight], at + 4);
    for (let c = 0; c < field.channelCount; ++c) {
      const i = field.channelCount * side + c;
      float[at + 8 + c] = 0.5 * weight * (field.from[i] + field.to[i]);
      float[at + 12 + c] = 0.5 * weight * (field.to[i] - field.from[i]);
    }
    this.addBlend(field, h, at, weight, Math.hypot(ex, ey));
  }

  /**
   * Adds the share of the other side that a blur shows, if that side has a value.
   * @param {MeshField} field
   * @param {number} h
   * @param {number} at
   * @param {number} weight
   * @param {number} length
   */
  addBlend(field, h, at, weight, length) {
    const { int, float } = this.blend;
    const side = field.sideOf[h],
      across = this.mesh.twin[h];
    const [from, to] = [field.blurFrom[side], field.blurTo[side]];
    const hasBack = across !== NO_MATE && field.edge[across] === SIDE;
    int[at + 3] = -1;
    int[at + 4] = -1;
    if (!hasBack || !(from > 0 || to > 0)) return;
    this.isBlurred = true;
    float.set([1 / length, 0.5 * (from + to), 0.5 * (to - from)], at);
    const other = field.sideOf[across];
    for (let c = 0; c < field.channelCount; ++c) {
      const i = field.channelCount * other + c;
      float[at + 5 + c] = 0.5 * weight * (field.to[i] + field.from[i]);
      float[at + 9 + c] = 0.5 * weight * (field.from[i] - field.to[i]);
    }
  }

  /**
   * @param {number} t
   * @param {number} first triangle of the field
   */
  addTriangle(t, first) {
    const { mesh, code, x, y } = this;
    const { int, float } = this.triangle;
    const at = TRIANGLE * (first + t);
    for (let k = 0; k < 3; ++k) {
      const h = 3 * t + k,
        across = mesh.twin[h];
      float[at + k] = x[mesh.vertex[h]];
      float[at + 3 + k] = y[mesh.vertex[h]];
      int[at + 6 + k] = code[h];
      int[at + 9 + k] = across === NO_MATE ? -1 : across + 3 * first;
    }
  }

  /**
   * @param {MeshField} field
   * @returns {PlacedEnd[]}
   */
  endsOf(field) {
    const unit = field.weight.reduce((most, k) => Math.max(most, k), 0) || 1;
    return field.ends.map((end) => {
      const [x, y] = [0, 1].map((axis) => end.position[axis] + this.mesh.origin[axis] - this.origin[axis],
      );
      const numbers = new Float32Array(END);
      const reach = end.reach > 0 ? 1 / (end.reach * end.reach) : Infinity;
      numbers.set([x, y, ...end.direction, end.bend, reach, end.weight / unit, ...end.blur]);
      numbers.set(end.positive, 12);
      numbers.set(end.negative, 16);
      return { position: [x, y], reach: end.reach, numbers };
    });
  }
}

/**
 * @param {ExactMesh} mesh
 * @param {number[]} origin layer frame; near the visible part, where floats are then fine
 */
export function exactTables(mesh, origin) {
  return new TableWriter(mesh, origin).run();
}
