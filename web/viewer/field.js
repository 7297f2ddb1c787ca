// Reads the nodes of a layer's field, as src/export/html/viewer_field.cpp writes them: corners first, then edges,
// then centres. Values stay whole numbers of steps until the end.

import { ByteReader, PayloadError, unzigzag } from "./bytes.js";
import { NO_MATE } from "./mesh.js";

/** @import { Topology } from "./mesh.js" */

// Nodes of a triangle: its corners, two on each edge from EDGES on, and one at the centre.
const NODES = 10;
const EDGES = 3;
const CENTER = 9;
const NO_NODE = 0xffffffff;

/**
 * @typedef {object} Field
 * @property {number} channelCount
 * @property {number[]} shaders indices of the picture's shaders, the last channels
 * @property {Uint32Array} triangleNode NODES a triangle: Z0 Z1 Z2 Z01 Z10 Z12 Z21 Z20 Z02 Z012
 * @property {Float32Array} value channelCount a node
 */

class FieldDecoder {
  /**
   * @param {ByteReader} reader
   * @param {Topology} topology
   * @param {number} channelCount
   */
  constructor(reader, topology, channelCount) {
    this.reader = reader;
    this.topology = topology;
    this.channelCount = channelCount;
    this.triangleNode = new Uint32Array(NODES * topology.triangleCount);
    this.nodeCount = 0;
    this.firstAtVertex = new Uint32Array(topology.vertexCount).fill(NO_NODE);
    this.value = new Int32Array(0);
    this.nextAtVertex = new Uint32Array(0);
    this.codes = new ByteReader(new Uint8Array(0));
    /** @type {Uint32Array[]} */
    this.misses = [];
    this.firstNode = 0;
  }

  /** @returns {{triangleNode: Uint32Array, value: Int32Array, nodeCount: number}} */
  run() {
    const { triangleCount } = this.topology;
    this.beginPass();
    for (let t = 0; t < triangleCount; ++t) this.readCorners(t);
    this.endPass();
    for (let t = 0; t < triangleCount; ++t) this.readEdges(t);
    this.endPass();
    for (let t = 0; t < triangleCount; ++t) this.readCenter(t);
    this.checkPass();
    return this;
  }

  /** Reads the codes and residuals of the nodes of one kind, and makes room for the nodes. */
  beginPass() {
    this.codes = new ByteReader(this.reader.counted());
    const count = this.reader.count(3 * this.channelCount);
    this.misses = [];
    for (let c = 0; c < this.channelCount; ++c) this.misses.push(this.reader.planes(count, 3));
    this.firstNode = this.nodeCount;
    const room = this.nodeCount + count;
    const value = new Int32Array(room * this.channelCount);
    value.set(this.value);
    this.value = value;
    const next = new Uint32Array(room).fill(NO_NODE);
    next.set(this.nextAtVertex);
    this.nextAtVertex = next;
  }

  checkPass() {
    if (this.nextAtVertex.length !== this.nodeCount) {
      throw new PayloadError("a node of it has no triangle");
    }
  }

  endPass() {
    this.checkPass();
    this.beginPass();
  }

  /**
   * Adds a node at a slot; guess(channel) predicts its value.
   * @param {number} slot of triangleNode
   * @param {(channel: number) => number} guess
   */
  addNode(slot, guess) {
    const node = this.nodeCount++;
    if (node >= this.nextAtVertex.length) throw new PayloadError("it has too few nodes");
    this.triangleNode[slot] = node;
    for (let c = 0; c < this.channelCount; ++c) {
      const miss = unzigzag(this.misses[c][node - this.firstNode]);
      this.value[this.channelCount * node + c] = guess(c) + miss;
    }
    return node;
  }

  /**
   * Moves the vertex's node at a place, from 1, of its list to the front, and returns it.
   * @param {number} vertex
   * @param {number} place
   */
  recall(vertex, place) {
    let before = NO_NODE,
      found = this.firstAtVertex[vertex];
    for (let i = 1; i < place && found !== NO_NODE; ++i) {
      before = found;
      found = this.nextAtVertex[found];
    }
    if (found === NO_NODE) throw new PayloadError("a corner of it has no node");
    if (before !== NO_NODE) {
      this.nextAtVertex[before] = this.nextAtVertex[found];
      this.nextAtVertex[found] = this.firstAtVertex[vertex];
      this.firstAtVertex[vertex] = found;
    }
    return found;
  }

  /** @param {number} t */
  readCorners(t) {
    for (let k = 0; k < 3; ++k) {
      const slot = NODES * t + k;
      const vertex = this.topology.cornerVertex[3 * t + k];
      const first = this.firstAtVertex[vertex];
      if (first !== NO_NODE) {
        const place = this.codes.u8();
        if (place > 0) {
          this.triangleNode[slot] = this.recall(vertex, place);
          continue;
        }
      }
      const node = this.addNode(slot, (c) => this.cornerGuess(t, k, first, c));
      this.nextAtVertex[node] = first;
      this.firstAtVertex[vertex] = node;
    }
  }

  /**
   * @param {number} t
   * @param {number} k
   * @param {number} other a node of the same vertex
   * @param {number} c
   */
  cornerGuess(t, k, other, c) {
    const { channelCount: n, value, triangleNode } = this;
    const corner = (/** @type {number} */ i) => value[n * triangleNode[NODES * t + i] + c];
    if (k === 2) return Math.floor((corner(0) + corner(1)) / 2);
    if (k === 1) return corner(0);
    if (other !== NO_NODE) return value[n * other + c];
    return this.nodeCount > 1 ? value[n * (this.nodeCount - 2) + c] : 0;
  }

  /** @param {number} t */
  readEdges(t) {
    const { channelCount: n, value, triangleNode, topology } = this;
    for (let k = 0; k < 3; ++k) {
      const slot = NODES * t + EDGES + 2 * k,
        mate = topology.mate[3 * t + k];
      if (mate !== NO_MATE && this.codes.u8() > 0) {
        const sameWay = topology.cornerVertex[mate] === topology.cornerVertex[3 * t + k];
        const other = NODES * Math.floor(mate / 3) + EDGES + 2 * (mate % 3);
        triangleNode[slot] = triangleNode[other + (sameWay ? 0 : 1)];
        triangleNode[slot + 1] = triangleNode[other + (sameWay ? 1 : 0)];
        continue;
      }
      const a = n * triangleNode[NODES * t + k],
        b = n * triangleNode[NODES * t + ((k + 1) % 3)];
      this.addNode(slot, (c) => Math.floor((2 * value[a + c] + value[b + c] + 1) / 3));
      this.addNode(slot + 1, (c) => Math.floor((2 * value[b + c] + value[a + c] + 1) / 3));
    }
  }

  /** @param {number} t */
  readCenter(t) {
    const { channelCount: n, value, triangleNode } = this;
    this.addNode(NODES * t + CENTER, (c) => {
      let corners = 0,
        edges = 0;
      for (let i = 0; i < 3; ++i) corners += value[n * triangleNode[NODES * t + i] + c];
      for (let i = EDGES; i < CENTER; ++i) edges += value[n * triangleNode[NODES * t + i] + c];
      return Math.floor((3 * edges - 2 * corners + 6) / 12);
    });
  }
}

/**
 * Reads the shaders whose weights are a field's last channels.
 * @param {ByteReader} reader
 * @param {number} shaderCount of the picture
 * @returns {number[]}
 */
export function readShaders(reader, shaderCount) {
  return Array.from({ length: reader.count(1) }, () => {
    const shader = reader.varint();
    if (shader >= shaderCount) throw new PayloadError("a shader of it is not there");
    return shader;
  });
}

/**
 * @param {ByteReader} reader
 * @param {Topology} topology
 * @param {number} ownChannels channels that are not the weight of a shader
 * @param {number} shaderCount of the picture
 * @returns {Field}
 */
export function readField(reader, topology, ownChannels, shaderCount) {
  const shaders = readShaders(reader, shaderCount);
  const channelCount = ownChannels + shaders.length;
  const steps = Array.from({ length: channelCount }, () => reader.f32());
  const nodes = new FieldDecoder(reader, topology, channelCount).run();
  const value = new Float32Array(nodes.value.length);
  for (let c = 0; c < channelCount; ++c) {
    for (let i = c; i < value.length; i += channelCount) value[i] = nodes.value[i] * steps[c];
  }
  return { channelCount, shaders, triangleNode: nodes.triangleNode, value };
}
