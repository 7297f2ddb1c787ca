// Arrays as textures for lookups in shaders.

export const TABLE_WIDTH = 2048;

/** Spare length of the texture of a growing array, as a factor. */
const ROOM = 1.3;

/**
 * Returns the formats of data textures: format, layout, type and numbers per texel.
 * @param {WebGL2RenderingContext} gl
 */
function tableFormats(gl) {
  return {
    index: { internal: gl.R32UI, format: gl.RED_INTEGER, type: gl.UNSIGNED_INT, size: 1 },
    byte: { internal: gl.R8UI, format: gl.RED_INTEGER, type: gl.UNSIGNED_BYTE, size: 1 },
    scalar: { internal: gl.R32F, format: gl.RED, type: gl.FLOAT, size: 1 },
    point: { internal: gl.RG32F, format: gl.RG, type: gl.FLOAT, size: 2 },
    vector: { internal: gl.RGBA32F, format: gl.RGBA, type: gl.FLOAT, size: 4 },
    bits: { internal: gl.RGBA32I, format: gl.RGBA_INTEGER, type: gl.INT, size: 4 },
    texel: { internal: gl.RGBA16UI, format: gl.RGBA_INTEGER, type: gl.UNSIGNED_SHORT, size: 4 },
  };
}

/** @typedef {keyof ReturnType<typeof tableFormats>} TableKind */
/** @typedef {Float32Array | Int32Array | Uint32Array | Uint16Array | Uint8Array} TableValues */

/** A range of entries of an array: from, up to. @typedef {readonly [number, number] | number[]} Range */

/**
 * The content of a table. Parts are computed when they are uploaded.
 * @typedef {object} TableSource
 * @property {number} count texels
 * @property {(first: number, count: number) => TableValues} part returns these texels
 */

/**
 * Returns a source for an existing array.
 * @param {TableValues} values
 * @param {number} size numbers per texel
 * @returns {TableSource}
 */
export function arraySource(values, size) {
  return {
    count: values.length / size,
    part: (first, count) => values.subarray(size * first, size * (first + count)),
  };
}

/**
 * Returns the rows of a texture that hold some texels, as separate ascending ranges.
 * @param {readonly Range[]} ranges of texels
 * @param {number} count of all texels
 */
function touchedRows(ranges, count) {
  const rows = ranges
    .map(([from, to]) => [
      Math.floor(from / TABLE_WIDTH),
      Math.ceil(Math.min(to, count) / TABLE_WIDTH),
    ])
    .filter(([from, to]) => from < to)
    .sort((a, b) => a[0] - b[0]);
  /** @type {number[][]} */
  const apart = [];
  for (const [from, to] of rows) {
    const last = apart.at(-1);
    if (last && from <= last[1]) last[1] = Math.max(last[1], to);
    else apart.push([from, to]);
  }
  return apart;
}

/** A texture that holds an array: entry i at (i & 2047, i >> 11). */
export class DataTable {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {TableKind} kind
   */
  constructor(gl, kind) {
    this.gl = gl;
    this.layout = tableFormats(gl)[kind];
    /** @type {WebGLTexture | null} */
    this.texture = null;
    /** Number of rows in the texture. */
    this.rows = 0;
  }

  /**
   * Updates the texture to the present content of the source. A texture that is too short is replaced by one with
   * room to grow.
   * @param {TableSource} source
   * @param {readonly Range[] | null} changes changed texels; null: all
   * @returns {this}
   */
  write(source, changes = null) {
    const { gl } = this;
    const rows = Math.max(1, Math.ceil(source.count / TABLE_WIDTH));
    const isOutgrown = rows > this.rows;
    if (isOutgrown) this.make(rows);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    const parts = changes && !isOutgrown ? touchedRows(changes, source.count) : [[0, rows]];
    for (const [from, to] of parts) this.upload(source, from, to);
    return this;
  }

  /** @param {number} rows the smallest number of rows */
  make(rows) {
    const { gl } = this;
    const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    if (rows > most) throw new Error("The picture is too large for this device's graphics.");
    // Static arrays get no spare room.
    this.rows = this.texture ? Math.min(most, Math.ceil(ROOM * rows)) : rows;
    gl.deleteTexture(this.texture);
    this.texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, this.layout.internal, TABLE_WIDTH, this.rows);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
      gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    }
  }

  /**
   * @param {TableSource} source
   * @param {number} from row
   * @param {number} to row
   */
  upload(source, from, to) {
    const whole = Math.min(to, Math.floor(source.count / TABLE_WIDTH));
    if (whole > from) this.uploadPart(source, from, TABLE_WIDTH, whole - from);
    const rest = source.count - whole * TABLE_WIDTH;
    if (to > whole && rest > 0) this.uploadPart(source, whole, rest, 1);
  }

  /**
   * @param {TableSource} source
   * @param {number} row
   * @param {number} width
   * @param {number} height
   */
  uploadPart(source, row, width, height) {
    const { gl, layout } = this;
    const part = source.part(row * TABLE_WIDTH, width * height);
    gl.texSubImage2D(
      gl.TEXTURE_2D,
      0,
      0,
      row,
      width,
      height,
      layout.format,
      layout.type,
      part,
    );
  }

  free() {
    this.gl.deleteTexture(this.texture);
    this.texture = null;
    this.rows = 0;
  }
}
