// Local curves on the GPU: the nodes of their segments are added up, then shown.

/** Nodes that a segment has at most; docs/gpu.md. */
const NODES_PER_SEGMENT = 16;

/** Segments drawn by one call. */
const SEGMENTS_PER_DRAW = 65536;

/**
 * What a stroke can reach, without what is added to radii below a pixel; its own frame.
 * @param {Stroke} stroke
 */
function strokeBounds({ segments, count, origin }) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (let at = 0; at < SEGMENT_FLOATS * count; at += SEGMENT_FLOATS) {
    const radius = Math.max(segments[at + 10], segments[at + 11]);
    for (let axis = 0; axis < 2; ++axis) {
      const start = origin[axis] + segments[at + axis];
      let reach = radius;
      for (let k = 2; k < 8; k += 2) reach += Math.abs(segments[at + k + axis]);
      box[axis] = Math.min(box[axis], start - reach);
      box[axis + 2] = Math.max(box[axis + 2], start + reach);
    }
  }
  return box;
}

class StrokeDrawer {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {Programs} programs
   * @param {Picture} picture
   */
  constructor(gl, programs, picture) {
    this.gl = gl;
    this.programs = programs;
    this.interpolation = picture.interpolation;
    const strokes = picture.stack.filter((item) => item.kind === "stroke");
    const all = new Float32Array(SEGMENT_FLOATS * strokes.reduce((sum, { count }) => sum + count, 0));
    for (const { segments, first } of strokes) all.set(segments, SEGMENT_FLOATS * first);
    this.table = makeTable(gl, "vector", all);
    this.boundsOf = new Map(strokes.map((stroke) => [stroke, strokeBounds(stroke)]));
  }

  /**
   * What the stroke can touch, artboard units; empty where there is nothing.
   * @param {Stroke} stroke
   */
  bounds(stroke) {
    const box = /** @type {number[]} */ (this.boundsOf.get(stroke));
    return stroke.count > 0 ? mappedBox(stroke.artboardFromStroke, box) : box;
  }

  /**
   * Adds the stroke up in the target that is bound, which was cleared.
   * @param {Stroke} stroke
   * @param {Affine} pixelFromArtboard
   * @param {number[]} size of the target
   */
  addUp(stroke, pixelFromArtboard, size) {
    const { gl } = this;
    const artboard = composed(stroke.artboardFromStroke, translation(stroke.origin[0], stroke.origin[1]));
    const pixelFromFrame = composed(pixelFromArtboard, artboard);
    const frameFromPixel = inverted(pixelFromFrame);
    const [a, b, c, d] = frameFromPixel;
    const program = this.programs
      .get("stroke", "stroke")
      .use()
      .texture("stroke_segment", this.table)
      .map("pixel_from_frame", pixelFromFrame)
      .vec2("target_size", size[0], size[1])
      .float("smallest_radius", Math.sqrt(Math.abs(a * d - b * c)))
      .int("two_sided", stroke.twoSided ? 1 : 0);
    gl.uniformMatrix2fv(program.place("frame_from_pixel"), false, [a, b, c, d]);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    for (let i = 0; i < stroke.count; i += SEGMENTS_PER_DRAW) {
      const count = Math.min(SEGMENTS_PER_DRAW, stroke.count - i);
      program.int("first_segment", stroke.first + i);
      gl.drawArraysInstanced(gl.TRIANGLES, 0, 6, NODES_PER_SEGMENT * count);
    }
  }

  /**
   * Shows sums on the target that is bound, source over.
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
}
