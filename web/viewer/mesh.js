// Reads the triangles of a layer from the codes that src/export/html/viewer_mesh.cpp writes. Writer and reader walk
// over the triangles in the same way.

import { ByteReader, PayloadError, unzigzag } from "./bytes.js";

export const NO_MATE = 0xffffffff;

/** The last half-edge on each edge between two vertices, as a hash table. */
class EdgeTable {
  /** @param {number} edgeCount the largest possible count */
  constructor(edgeCount) {
    let size = 16;
    while (size < 2 * edgeCount) size *= 2;
    this.mask = size - 1;
    this.low = new Uint32Array(size).fill(NO_MATE);
    this.high = new Uint32Array(size);
    this.halfEdge = new Uint32Array(size);
  }

  /**
   * Returns the slot of the edge from a to b.
   * @param {number} a
   * @param {number} b
   */
  find(a, b) {
    const low = Math.min(a, b),
      high = Math.max(a, b);
    let slot = (Math.imul(low, 0x9e3779b1) ^ Math.imul(high, 0x85ebca6b)) >>> 0;
    slot = (slot ^ (slot >>> 15)) & this.mask;
    while (this.low[slot] !== NO_MATE && (this.low[slot] !== low || this.high[slot] !== high)) {
      slot = (slot + 1) & this.mask;
    }
    return slot;
  }

  /**
   * Puts a half-edge onto its edge; returns the previous one there, or NO_MATE.
   * @param {number} slot from `find`
   * @param {number} a
   * @param {number} b
   * @param {number} halfEdge the half-edge to put there
   */
  put(slot, a, b, halfEdge) {
    const before = this.low[slot] === NO_MATE ? NO_MATE : this.halfEdge[slot];
    this.low[slot] = Math.min(a, b);
    this.high[slot] = Math.max(a, b);
    this.halfEdge[slot] = halfEdge;
    return before;
  }
}

/**
 * Triangles in the order of the payload. Half-edge 3 t + k runs from corner k of triangle t to the next.
 * @typedef {object} Topology
 * @property {number} triangleCount
 * @property {number} vertexCount
 * @property {Uint32Array} cornerVertex 3 a triangle
 * @property {Uint32Array} mate per half-edge: the previous one on its edge, or NO_MATE
 * @property {Uint32Array} apex per vertex: the half-edge from which it was reached, or NO_MATE
 */

class TopologyDecoder {
  /**
   * @param {Uint8Array} codes
   * @param {number} triangleCount
   * @param {number} vertexCount
   */
  constructor(codes, triangleCount, vertexCount) {
    this.codes = new ByteReader(codes);
    this.triangleCount = triangleCount;
    this.vertexCount = vertexCount;
    this.cornerVertex = new Uint32Array(3 * triangleCount);
    this.mate = new Uint32Array(3 * triangleCount);
    this.apex = new Uint32Array(vertexCount);
    this.edges = new EdgeTable(3 * triangleCount);
    this.slot = new Uint32Array(3 * triangleCount);
    this.placed = 0;
    this.seen = 0;
    /** @type {number[]} */
    this.gates = [];
  }

  /** @returns {Topology} */
  run() {
    while (this.placed < this.triangleCount) {
      const corners = [0, 1, 2].map(() => this.vertex(this.codes.varint(), NO_MATE));
      this.place(corners[0], corners[1], corners[2]);
      this.followGates();
    }
    if (this.seen !== this.vertexCount) throw new PayloadError("a vertex of it has no triangle");
    return this;
  }

  /**
   * @param {number} code 0 for a new vertex, else how many numbers back it was
   * @param {number} across
   */
  vertex(code, across) {
    if (code > this.seen) throw new PayloadError("a triangle of it has no vertex");
    if (code > 0) return this.seen - code;
    if (this.seen === this.vertexCount) throw new PayloadError("it has too many vertices");
    this.apex[this.seen] = across;
    return this.seen++;
  }

  /**
   * @param {number} a
   * @param {number} b
   * @param {number} c
   */
  place(a, b, c) {
    const base = 3 * this.placed++;
    const corner = this.cornerVertex;
    [corner[base], corner[base + 1], corner[base + 2]] = [a, b, c];
    for (let k = 0; k < 3; ++k) {
      const start = corner[base + k],
        end = corner[base + ((k + 1) % 3)];
      const slot = this.edges.find(start, end);
      this.slot[base + k] = slot;
      this.mate[base + k] = this.edges.put(slot, start, end, base + k);
    }
    for (let k = 2; k >= 0; --k) {
      if (this.mate[base + k] === NO_MATE) this.gates.push(base + k);
    }
  }

  followGates() {
    for (let gate = this.gates.pop(); gate !== undefined; gate = this.gates.pop()) {
      if (this.edges.halfEdge[this.slot[gate]] !== gate) continue;
      const code = this.codes.varint();
      if (code === 0) continue;
      if (this.placed === this.triangleCount) throw new PayloadError("it has too many triangles");
      const k = gate % 3,
        base = gate - k;
      const start = this.cornerVertex[gate],
        end = this.cornerVertex[base + ((k + 1) % 3)];
      this.place(end, start, this.vertex(code - 1, gate));
    }
  }
}

/**
 * Reads triangles without positions.
 * @param {ByteReader} reader
 */
export function readTopology(reader) {
  const triangleCount = reader.count(1),
    vertexCount = reader.count(8);
  return new TopologyDecoder(reader.counted(), triangleCount, vertexCount).run();
}

/** The middle of the grid; single precision represents its steps exactly. */
export const GRID_MIDDLE = 2 ** 21;

/**
 * Reads the corner and the step of the grid of the vertices.
 * @param {ByteReader} reader
 */
export function readGridFrame(reader) {
  const min = [reader.finite(), reader.finite()],
    step = [reader.finite(), reader.finite()];
  return { min, step };
}

/**
 * Reads which half-edges are curves.
 * @param {ByteReader} reader
 * @param {number} triangleCount
 */
export function readCurves(reader, triangleCount) {
  const flags = reader.take(triangleCount);
  const edgeIsCurve = new Uint8Array(3 * triangleCount);
  for (let h = 0; h < edgeIsCurve.length; ++h) {
    edgeIsCurve[h] = (flags[(h / 3) | 0] >> (h % 3)) & 1;
  }
  return edgeIsCurve;
}

/**
 * Reads the positions of the vertices, in steps of a grid.
 * @param {ByteReader} reader
 * @param {Topology} topology
 */
function readGrid(reader, topology) {
  const { vertexCount, apex, cornerVertex } = topology;
  const axes = [reader.planes(vertexCount, 4), reader.planes(vertexCount, 4)];
  return axes.map((misses) => {
    const grid = new Int32Array(vertexCount);
    for (let i = 0; i < vertexCount; ++i) {
      let guess = i > 0 ? grid[i - 1] : 0;
      if (apex[i] !== NO_MATE) {
        const k = apex[i] % 3,
          base = apex[i] - k;
        const corner = [0, 1, 2].map((j) => grid[cornerVertex[base + ((k + j) % 3)]]);
        guess = corner[0] + corner[1] - corner[2];
      }
      grid[i] = guess + unzigzag(misses[i]);
    }
    return grid;
  });
}

/**
 * @typedef {object} Mesh
 * @property {Topology} topology
 * @property {number[]} origin what positions are relative to, layer frame
 * @property {number[]} bounds minimum x, y, maximum x, y; layer frame
 * @property {Float32Array} positions 2 a vertex
 * @property {Uint8Array} edgeIsCurve 3 a triangle
 */

/**
 * @param {ByteReader} reader
 * @returns {Mesh}
 */
export function readMesh(reader) {
  const topology = readTopology(reader);
  const { triangleCount, vertexCount } = topology;
  const { min, step } = readGridFrame(reader);
  const grid = readGrid(reader, topology);
  const positions = new Float32Array(2 * vertexCount);
  const middle = GRID_MIDDLE;
  for (let axis = 0; axis < 2; ++axis) {
    for (let i = 0; i < vertexCount; ++i) {
      positions[2 * i + axis] = (grid[axis][i] - middle) * step[axis];
    }
  }
  const extent = grid.map((axis) => axis.reduce((a, b) => Math.max(a, b), 0));
  const edgeIsCurve = readCurves(reader, triangleCount);
  return {
    topology,
    origin: [min[0] + middle * step[0], min[1] + middle * step[1]],
    bounds: [...min, min[0] + extent[0] * step[0], min[1] + extent[1] * step[1]],
    positions,
    edgeIsCurve,
  };
}
