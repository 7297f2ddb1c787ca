// The GPU tables of a layer, which follow the tables in memory.

import { arraySource, DataTable } from "./tables.js";

/** @import { Field } from "./field.js" */
/** @import { Layer } from "./payload.js" */
/** @import { Range, TableKind, TableSource } from "./tables.js" */

/**
 * The changed rows of a layer's tables, by the tables' names in web/wasm/sfumato.mjs. A missing table has not
 * changed. If a table has grown, its new rows are included.
 * @typedef {object} LayerDelta
 * @property {readonly Range[]} [vertices]
 * @property {readonly Range[]} [triangles]
 * @property {readonly Range[]} [curveEdges]
 * @property {readonly Range[]} [colorNodes]
 * @property {readonly Range[]} [colorValues]
 * @property {readonly Range[]} [opacityNodes]
 * @property {readonly Range[]} [opacityValues]
 */

/**
 * Returns channels of a field's nodes; missing channels are 0.
 * @param {Field} field
 * @param {number} first channel
 * @param {number} count of channels
 * @param {number} texels per node
 * @param {number} size numbers per texel
 * @returns {TableSource}
 */
function channelSource(field, first, count, texels, size) {
  const { channelCount, value } = field;
  const part = (/** @type {number} */ from, /** @type {number} */ partCount) => {
    const numbers = new Float32Array(size * partCount);
    let node = Math.floor(from / texels),
      channel = size * (from % texels);
    for (let i = 0; i < numbers.length; ++i) {
      if (channel < count) numbers[i] = value[channelCount * node + first + channel];
      channel += 1;
      if (channel < size * texels) continue;
      channel = 0;
      node += 1;
    }
    return numbers;
  };
  return { count: texels * (value.length / channelCount), part };
}

/**
 * Returns the properties of a layer that decide which tables it has, and the size of their texels.
 * @param {Layer} layer
 */
function shapeOf({ color, opacity }) {
  return [color, opacity].map((field) => (field ? field.shaders.length : "none")).join();
}

export class LayerTables {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {Layer} layer
   */
  constructor(gl, layer) {
    this.gl = gl;
    this.layer = layer;
    /** @type {Map<string, DataTable>} */
    this.tables = new Map();
    /** The shapeOf() at the time when all tables were written; empty if some are not written. */
    this.shape = "";
    try {
      this.update(null);
    } catch (error) {
      this.free();
      throw error;
    }
  }

  /**
   * @param {string} name
   * @returns {WebGLTexture | null} null if the layer has no such table
   */
  texture(name) {
    return this.tables.get(name)?.texture ?? null;
  }

  /**
   * Updates the tables. Throws if the layer is too large for the GPU; then the next update writes everything.
   * @param {LayerDelta | null} delta null: everything may have changed
   */
  update(delta) {
    const { layer } = this;
    const shape = shapeOf(layer);
    const isSame = delta !== null && shape === this.shape;
    if (shape !== this.shape) this.free();
    this.shape = "";
    const changed = (/** @type {keyof LayerDelta} */ name) => (isSame ? (delta[name] ?? []) : null);
    const { positions, triangleVertex } = layer;
    this.write("vertexPosition", "point", arraySource(positions, 2), changed("vertices"), 1);
    this.write("triangleVertex", "index", arraySource(triangleVertex, 1), changed("triangles"), 3);
    if (this.tables.has("edgeIsCurve")) this.writeEdges(changed("curveEdges"));
    this.writeColor(layer.color, changed("colorNodes"), changed("colorValues"));
    if (layer.opacity) {
      this.writeOpacity(layer.opacity, changed("opacityNodes"), changed("opacityValues"));
    }
    this.shape = shape;
  }

  /** Adds a table of curve edges, which only the mesh overlay needs. */
  wantEdges() {
    if (!this.tables.has("edgeIsCurve")) this.writeEdges(null);
  }

  /** @param {readonly Range[] | null} rows */
  writeEdges(rows) {
    this.write("edgeIsCurve", "byte", arraySource(this.layer.edgeIsCurve, 1), rows, 3);
  }

  /**
   * @param {Field} field
   * @param {readonly Range[] | null} nodes
   * @param {readonly Range[] | null} values
   */
  writeColor(field, nodes, values) {
    this.write("triangleNode", "index", arraySource(field.triangleNode, 1), nodes, 10);
    this.write("nodeColor", "vector", channelSource(field, 0, 3, 1, 4), values, 1);
    this.writeWeights("colorWeight", field, values);
  }

  /**
   * @param {Field} field
   * @param {readonly Range[] | null} nodes
   * @param {readonly Range[] | null} values
   */
  writeOpacity(field, nodes, values) {
    this.write("triangleOpacityNode", "index", arraySource(field.triangleNode, 1), nodes, 10);
    this.write("nodeOpacity", "scalar", channelSource(field, 0, 1, 1, 1), values, 1);
    this.writeWeights("opacityWeight", field, values);
  }

  /**
   * Writes four weights to a texel, with as many texels per node as needed.
   * @param {string} name
   * @param {Field} field
   * @param {readonly Range[] | null} values
   */
  writeWeights(name, field, values) {
    const count = field.shaders.length;
    if (count === 0) return;
    const texels = Math.ceil(count / 4);
    const source = channelSource(field, field.channelCount - count, count, texels, 4);
    this.write(name, "vector", source, values, texels);
  }

  /**
   * @param {string} name
   * @param {TableKind} kind
   * @param {TableSource} source
   * @param {readonly Range[] | null} rows changed rows; null: all
   * @param {number} texels per row
   */
  write(name, kind, source, rows, texels) {
    let table = this.tables.get(name);
    if (!table) {
      table = new DataTable(this.gl, kind);
      this.tables.set(name, table);
    }
    table.write(source, rows && rows.map(([from, to]) => [texels * from, texels * to]));
  }

  free() {
    for (const table of this.tables.values()) table.free();
    this.tables.clear();
  }
}
