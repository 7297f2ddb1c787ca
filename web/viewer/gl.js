// A thin layer over WebGL2: programs from the shaders in the page, data textures, targets.

import { rowsOf } from "./affine.js";

/** @import { Affine } from "./affine.js" */

export const TABLE_WIDTH = 2048;

/** Of antialiasing in one picture; all that have WebGL 2 have as many. */
const SAMPLES = 4;

/**
 * What the browser can do.
 * @typedef {object} Abilities
 * @property {boolean} floatSums strokes may add up in single precision
 * @property {boolean} halfTargets targets may be in half precision
 * @property {number} samples of antialiasing
 * @property {number} largestSide of a target, pixels
 */

/**
 * @param {WebGL2RenderingContext} gl
 * @returns {Abilities}
 */
export function abilitiesOf(gl) {
  const floats = gl.getExtension("EXT_color_buffer_float") !== null;
  const halves = floats || gl.getExtension("EXT_color_buffer_half_float") !== null;
  const format = halves ? gl.RGBA16F : gl.RGBA8;
  const counts = gl.getInternalformatParameter(gl.RENDERBUFFER, format, gl.SAMPLES);
  return {
    floatSums: floats && gl.getExtension("EXT_float_blend") !== null,
    halfTargets: halves,
    samples: counts && counts.length > 0 ? Math.min(counts[0], SAMPLES) : 0,
    largestSide: Math.min(
      gl.getParameter(gl.MAX_TEXTURE_SIZE),
      gl.getParameter(gl.MAX_RENDERBUFFER_SIZE),
      gl.getParameter(gl.MAX_VIEWPORT_DIMS)[0],
    ),
  };
}

/** A program and the places of its uniforms. */
export class Program {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {string} vertex text of the shader
   * @param {string} fragment
   */
  constructor(gl, vertex, fragment) {
    this.gl = gl;
    this.program = gl.createProgram();
    for (const [type, text] of /** @type {const} */ ([
      [gl.VERTEX_SHADER, vertex],
      [gl.FRAGMENT_SHADER, fragment],
    ])) {
      const shader = /** @type {WebGLShader} */ (gl.createShader(type));
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
      gl.deleteShader(shader);
    }
    gl.linkProgram(this.program);
    /** @type {Map<string, WebGLUniformLocation | null>} */
    this.places = new Map();
    /** @type {Map<string, number>} */
    this.units = new Map();
  }

  /** What the compiler says where it refuses; empty where all is well. */
  complaint() {
    const { gl } = this;
    if (gl.getProgramParameter(this.program, gl.LINK_STATUS) || gl.isContextLost()) return "";
    const logs = (gl.getAttachedShaders(this.program) ?? []).map(
      (s) => gl.getShaderInfoLog(s) ?? "",
    );
    return (
      [gl.getProgramInfoLog(this.program) ?? "", ...logs].join("\n").trim() || "it does not link"
    );
  }

  /** @param {string} name */
  place(name) {
    let place = this.places.get(name);
    if (place === undefined) {
      place = this.gl.getUniformLocation(this.program, name);
      this.places.set(name, place);
    }
    return place;
  }

  use() {
    this.gl.useProgram(this.program);
    return this;
  }

  /**
   * @param {string} name
   * @param {number} value
   */
  int(name, value) {
    this.gl.uniform1i(this.place(name), value);
    return this;
  }

  /**
   * @param {string} name
   * @param {number} value
   */
  float(name, value) {
    this.gl.uniform1f(this.place(name), value);
    return this;
  }

  /**
   * @param {string} name
   * @param {number} x
   * @param {number} y
   */
  vec2(name, x, y) {
    this.gl.uniform2f(this.place(name), x, y);
    return this;
  }

  /**
   * A map, as two rows.
   * @param {string} name
   * @param {Affine} map
   */
  map(name, map) {
    this.gl.uniform3fv(this.place(name), rowsOf(map));
    return this;
  }

  /**
   * A texture, on a unit of its own.
   * @param {string} name
   * @param {WebGLTexture | null} texture
   */
  texture(name, texture) {
    let unit = this.units.get(name);
    if (unit === undefined) {
      unit = this.units.size;
      this.units.set(name, unit);
    }
    this.gl.activeTexture(this.gl.TEXTURE0 + unit);
    this.gl.bindTexture(this.gl.TEXTURE_2D, texture);
    return this.int(name, unit);
  }
}

/** Programs by name and variant, made when they are first wanted. */
export class Programs {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {(name: string) => string} textOf a file of shaders/
   */
  constructor(gl, textOf) {
    this.gl = gl;
    this.textOf = textOf;
    /** @type {Map<string, Program>} */
    this.made = new Map();
  }

  /**
   * @param {string} vertex name of its file, without .vert
   * @param {string} fragment
   * @param {string[]} defines
   */
  get(vertex, fragment, defines = []) {
    const key = [vertex, fragment, ...defines].join(" ");
    let program = this.made.get(key);
    if (program) return program;
    const head = ["#version 300 es", ...defines.map((name) => `#define ${name}`), ""].join("\n");
    const common = head + this.textOf("common.glsl");
    const paint = defines.includes("WITH_PAINTS") ? this.textOf("paint.glsl") : "";
    program = new Program(
      this.gl,
      common + this.textOf(`${vertex}.vert`),
      common + paint + this.textOf(`${fragment}.frag`),
    );
    const complaint = program.complaint();
    if (complaint) throw new Error(`The graphics driver refuses a shader (${key}): ${complaint}`);
    this.made.set(key, program);
    return program;
  }
}

/**
 * How the texels of a data texture look: format, layout, type and numbers a texel.
 * @param {WebGL2RenderingContext} gl
 */
function tableFormats(gl) {
  return {
    index: { internal: gl.R32UI, format: gl.RED_INTEGER, type: gl.UNSIGNED_INT, size: 1 },
    byte: { internal: gl.R8UI, format: gl.RED_INTEGER, type: gl.UNSIGNED_BYTE, size: 1 },
    scalar: { internal: gl.R32F, format: gl.RED, type: gl.FLOAT, size: 1 },
    point: { internal: gl.RG32F, format: gl.RG, type: gl.FLOAT, size: 2 },
    vector: { internal: gl.RGBA32F, format: gl.RGBA, type: gl.FLOAT, size: 4 },
    texel: { internal: gl.RGBA16UI, format: gl.RGBA_INTEGER, type: gl.UNSIGNED_SHORT, size: 4 },
  };
}

/** @typedef {keyof ReturnType<typeof tableFormats>} TableKind */
/** @typedef {Float32Array | Uint32Array | Uint16Array | Uint8Array} TableValues */

/**
 * A texture that holds an array: entry i at (i & 2047, i >> 11).
 * @param {WebGL2RenderingContext} gl
 * @param {TableKind} kind
 * @param {TableValues} values
 */
export function makeTable(gl, kind, values) {
  const { internal, format, type, size } = tableFormats(gl)[kind];
  const rows = Math.max(1, Math.ceil(values.length / size / TABLE_WIDTH));
  if (rows > gl.getParameter(gl.MAX_TEXTURE_SIZE)) {
    throw new Error("The picture is too large for this device's graphics.");
  }
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, internal, TABLE_WIDTH, rows);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  const whole = Math.floor(values.length / size / TABLE_WIDTH);
  const upload = (
    /** @type {number} */ row,
    /** @type {number} */ width,
    /** @type {number} */ height,
  ) => {
    const first = row * TABLE_WIDTH * size;
    const part = values.subarray(first, first + width * height * size);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, row, width, height, format, type, part);
  };
  if (whole > 0) upload(0, TABLE_WIDTH, whole);
  const rest = values.length / size - whole * TABLE_WIDTH;
  if (rest > 0) upload(whole, rest, 1);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
    gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
  }
  return texture;
}
