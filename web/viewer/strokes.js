// Draws local curves on the GPU: sums the nodes of their segments, then shows the sums.

import { composed, inverted, mappedBox, translation } from "./affine.js";
import { arraySource, DataTable } from "./tables.js";
import { NODES_PER_SEGMENT, SegmentTable } from "./segments.js";

/** @import { Affine } from "./affine.js" */
/** @import { Programs } from "./gl.js" */
/** @import { Picture, Stroke } from "./payload.js" */

/** Segments per draw call. */
const SEGMENTS_PER_DRAW = 65536;

/** The corners of a quad as a strip; two of its six vertices are repeated. */
const QUAD = new Uint8Array([0, 1, 2, 4]);

/**
 * Returns the area that a stroke can reach without the widening of radii below a pixel; its own frame.
 * @param {Stroke} stroke
 */
function strokeBounds({ segments, origin }) {
  const { count, start, coefficient, attribute } = segments;
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < count; ++i) {
    const radius = Math.max(attribute[0][i], attribute[1][i]);
    for (let axis = 0; axis < 2; ++axis) {
      let reach = radius;
      for (let c = axis; c < 6; c += 2) reach += Math.abs(coefficient[c][i]);
      const middle = origin[axis] + start[axis][i];
      box[axis] = Math.min(box[axis], middle - reach);
      box[axis + 2] = Math.max(box[axis + 2], middle + reach);
    }
  }
  return box;
}

export class StrokeDrawer {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {Programs} programs
   * @param {Picture} picture
   */
  constructor(gl, programs, picture) {
    this.gl = gl;
    this.programs = programs;
    this.table = new DataTable(gl, "vector");
    /** Logarithm, base 2, of the table's device pixels per user unit. */
    this.octave = NaN;
    this.quad = gl.createBuffer();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.quad);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, QUAD, gl.STATIC_DRAW);
    this.interpolation = 0;
    /** @type {Stroke[]} */
    this.strokes = [];
    /** @type {Map<Stroke, number[]>} */
    this.boundsOf = new Map();
    /** First segment in the table, and their count. @type {Map<Stroke, number[]>} */
    this.places = new Map();
    this.setPicture(picture);
  }

  /**
   * Switches to the strokes of another picture.
   * @param {Picture} picture
   */
  setPicture({ interpolation, stack }) {
    const before = this.boundsOf;
    this.interpolation = interpolation;
    this.strokes = stack.filter((item) => item.kind === "stroke");
    this.boundsOf = new Map(
      this.strokes.map((stroke) => [stroke, before.get(stroke) ?? strokeBounds(stroke)]),
    );
    this.places = new Map();
    this.octave = NaN;
  }

  /**
   * Gives the segments as many nodes as a zoom needs. Does nothing within an octave.
   * @param {Affine} pixelFromArtboard
   */
  prepare([a, b, c, d]) {
    const octave = Math.ceil(Math.log2(Math.sqrt(Math.abs(a * d - b * c))));
    if (octave === this.octave || this.strokes.length === 0) return;
    this.octave = octave;
    const table = new SegmentTable();
    for (const stroke of this.strokes) {
      const [p, q, r, s] = stroke.artboardFromStroke;
      const first = table.count;
      table.add(stroke, 2 ** -octave / Math.sqrt(Math.abs(p * s - q * r)));
      this.places.set(stroke, [first, table.count - first]);
    }
    this.table.write(arraySource(new Float32Array(table.values), 4));
  }

  /**
   * Returns the area that the stroke can touch, artboard units; empty if there is none.
   * @param {Stroke} stroke
   */
  bounds(stroke) {
    const box = /** @type {number[]} */ (this.boundsOf.get(stroke));
    return stroke.segments.count > 0 ? mappedBox(stroke.artboardFromStroke, box) : box;
  }

  /**
   * Sums the stroke's nodes in the bound target, which must be clear.
   * @param {Stroke} stroke
   * @param {Affine} pixelFromArtboard
   * @param {number[]} size of the target
   */
  addUp(stroke, pixelFromArtboard, size) {
    const { gl } = this;
    const artboard = composed(
      stroke.artboardFromStroke,
      translation(stroke.origin[0], stroke.origin[1]),
    );
    const pixelFromFrame = composed(pixelFromArtboard, artboard);
    const [a, b, c, d] = inverted(pixelFromFrame);
    const program = this.programs
      .get("stroke", "stroke")
      .use()
      .texture("stroke_segment", this.table.texture)
      .map("pixel_from_frame", pixelFromFrame)
      .vec2("target_size", size[0], size[1])
      .float("smallest_radius", Math.sqrt(Math.abs(a * d - b * c)))
      .int("two_sided", stroke.twoSided ? 1 : 0);
    gl.uniformMatrix2fv(program.place("frame_from_pixel"), false, [a, b, c, d]);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    const [first, count] = this.places.get(stroke) ?? [0, 0];
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.quad);
    for (let i = 0; i < count; i += SEGMENTS_PER_DRAW) {
      program.int("first_segment", first + i);
      const part = Math.min(SEGMENTS_PER_DRAW, count - i);
      const nodes = NODES_PER_SEGMENT * part;
      gl.drawElementsInstanced(gl.TRIANGLE_STRIP, QUAD.length, gl.UNSIGNED_BYTE, 0, nodes);
    }
  }

  /**
   * Shows sums on the bound target, source over.
   * @param {Stroke} stroke
   * @param {WebGLTexture} sums
   */
  show(stroke, sums) {
    const { gl } = this;
    this.programs
      .get("screen", "stroke_resolve")
      .use()
      .texture("sums", sums)
      .int("interpolation", this.interpolation)
      .float("alpha", stroke.alpha);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  free() {
    this.table.free();
    this.gl.deleteBuffer(this.quad);
  }
}
