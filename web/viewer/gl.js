// A thin layer over WebGL2: the abilities of a browser, and programs from shaders.

import { rowsOf } from "./affine.js";
import { shaders } from "./dist/shaders.js";

/** @import { Affine } from "./affine.js" */

/** Samples of antialiasing in one picture; every WebGL 2 supports this many. */
const SAMPLES = 4;

/**
 * The abilities of the browser.
 * @typedef {object} Abilities
 * @property {boolean} floatSums strokes may be summed in single precision
 * @property {boolean} halfTargets targets may have half precision
 * @property {number} samples of antialiasing
 * @property {number} largestSide limit for the side of a target, pixels
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

  /** Returns the compiler's message if it rejects the program; else empty. */
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
   * Sets a map, as two rows.
   * @param {string} name
   * @param {Affine} map
   */
  map(name, map) {
    this.gl.uniform3fv(this.place(name), rowsOf(map));
    return this;
  }

  /**
   * Binds a texture to a unit of its own.
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

/** Programs by name and variant, compiled when they are first needed. */
export class Programs {
  /**
   * @param {WebGL2RenderingContext} gl
   */
  constructor(gl) {
    this.gl = gl;
    /** Texts of shaders by file name. */
    this.texts = { ...shaders };
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
    const { texts } = this;
    const common = head + texts["common.glsl"];
    const paint = defines.includes("WITH_PAINTS") ? texts["paint.glsl"] : "";
    const walk = defines.includes("WITH_WALK") ? texts["exact.glsl"] + texts["point_walk.glsl"] : "";
    program = new Program(
      this.gl,
      common + texts[`${vertex}.vert`],
      common + paint + walk + texts[`${fragment}.frag`],
    );
    const complaint = program.complaint();
    if (complaint) throw new Error(`The graphics driver refuses a shader (${key}): ${complaint}`);
    this.made.set(key, program);
    return program;
  }

  free() {
    for (const { program } of this.made.values()) this.gl.deleteProgram(program);
    this.made.clear();
  }
}
