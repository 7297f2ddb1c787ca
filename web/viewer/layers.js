// Layers on the GPU: their tables, and how an instance is drawn.

import { composed, inverted, mappedBox, translation } from "./affine.js";
import { makeTable } from "./gl.js";

/** @import { Affine } from "./affine.js" */
/** @import { Field } from "./field.js" */
/** @import { Program, Programs } from "./gl.js" */
/** @import { Instance, Layer, Picture } from "./payload.js" */

/**
 * @typedef {object} LayerTables
 * @property {WebGLTexture} triangleVertex
 * @property {WebGLTexture} vertexPosition
 * @property {WebGLTexture} triangleNode
 * @property {WebGLTexture} nodeColor
 * @property {WebGLTexture | null} colorWeight
 * @property {WebGLTexture | null} triangleOpacityNode
 * @property {WebGLTexture | null} nodeOpacity
 * @property {WebGLTexture | null} opacityWeight
 * @property {WebGLTexture | null} edgeIsCurve made when the mesh is first shown
 */

/** Paints that the shader has room for: views in its uniform block, two vectors each. */
const MOST_PAINTS = 128;

/**
 * Channels of a field's nodes as texels of `size` numbers, what is missing 0.
 * @param {Field} field
 * @param {number} first channel
 * @param {number} count of channels
 * @param {number} size
 */
function nodeTexels(field, first, count, size) {
  const texels = new Float32Array(size * field.nodeCount);
  for (let i = 0; i < field.nodeCount; ++i) {
    for (let c = 0; c < count; ++c) {
      texels[size * i + c] = field.value[field.channelCount * i + first + c];
    }
  }
  return texels;
}

/**
 * Four weights to a texel, as many texels to a node as it needs.
 * @param {WebGL2RenderingContext} gl
 * @param {Field} field
 */
function makeWeights(gl, field) {
  const count = field.shaders.length;
  if (count === 0) return null;
  const size = 4 * Math.ceil(count / 4);
  return makeTable(gl, "vector", nodeTexels(field, field.channelCount - count, count, size));
}

export class LayerDrawer {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {Programs} programs
   * @param {Picture} picture
   * @param {Uint16Array} texels of the paints
   */
  constructor(gl, programs, picture, texels) {
    this.gl = gl;
    this.programs = programs;
    this.picture = picture;
    this.tables = picture.layers.map((layer) => this.upload(layer));
    this.paintTable = makeTable(gl, "vector", picture.paints.table);
    this.paintTexels = makeTable(gl, "texel", texels);
    this.paintViews = gl.createBuffer();
  }

  /**
   * @param {Layer} layer
   * @returns {LayerTables}
   */
  upload({ mesh, color, opacity }) {
    const { gl } = this;
    return {
      triangleVertex: makeTable(gl, "index", mesh.topology.cornerVertex),
      vertexPosition: makeTable(gl, "point", mesh.position),
      triangleNode: makeTable(gl, "index", color.triangleNode),
      nodeColor: makeTable(gl, "vector", nodeTexels(color, 0, 3, 4)),
      colorWeight: makeWeights(gl, color),
      triangleOpacityNode: opacity && makeTable(gl, "index", opacity.triangleNode),
      nodeOpacity: opacity && makeTable(gl, "scalar", nodeTexels(opacity, 0, 1, 1)),
      opacityWeight: opacity && makeWeights(gl, opacity),
      edgeIsCurve: null,
    };
  }

  /**
   * The layer's own frame, relative to the origin of its positions.
   * @param {Instance} instance
   * @param {Affine} pixelFromArtboard
   */
  pixelFromPositions(instance, pixelFromArtboard) {
    const { origin } = this.picture.layers[instance.layer].mesh;
    const artboard = composed(instance.artboardFromLayer, translation(origin[0], origin[1]));
    return composed(pixelFromArtboard, artboard);
  }

  /**
   * Draws an instance into the target that is bound, source over.
   * @param {Instance} instance
   * @param {number} opacity
   * @param {Affine} pixelFromArtboard
   * @param {Affine} clipFromPixel
   */
  draw(instance, opacity, pixelFromArtboard, clipFromPixel) {
    const { gl, picture } = this;
    const layer = picture.layers[instance.layer],
      tables = this.tables[instance.layer];
    const hasPaints = tables.colorWeight !== null || tables.opacityWeight !== null;
    const defines = [];
    if (layer.opacity) defines.push("WITH_OPACITY");
    if (hasPaints) defines.push("WITH_PAINTS");
    const program = this.programs.get("patch", "patch", defines).use();
    const pixel = this.pixelFromPositions(instance, pixelFromArtboard);
    program
      .texture("triangle_vertex", tables.triangleVertex)
      .texture("vertex_position", tables.vertexPosition)
      .texture("triangle_node", tables.triangleNode)
      .texture("node_color", tables.nodeColor)
      .int("first_triangle", 0)
      .map("clip_from_layer", composed(clipFromPixel, pixel))
      .int("patch_order", layer.order + 1)
      .int("interpolation", picture.interpolation)
      .float("opacity", opacity);
    if (layer.opacity) {
      program
        .texture("triangle_opacity_node", tables.triangleOpacityNode)
        .texture("node_opacity", tables.nodeOpacity);
    }
    if (hasPaints) this.setPaints(program, instance, pixelFromArtboard);
    gl.drawArrays(gl.TRIANGLES, 0, 3 * layer.mesh.topology.triangleCount);
  }

  /**
   * @param {Program} program
   * @param {Instance} instance
   * @param {Affine} pixelFromArtboard
   */
  setPaints(program, instance, pixelFromArtboard) {
    const { gl, picture } = this;
    const { color, opacity } = picture.layers[instance.layer];
    const tables = this.tables[instance.layer];
    const opacityShaders = opacity ? opacity.shaders : [];
    program
      .texture("paint_table", this.paintTable)
      .texture("paint_texels", this.paintTexels)
      .texture("color_weight", tables.colorWeight ?? this.paintTable)
      .float("paint_step", 1);
    gl.uniform2i(program.place("paint_count"), color.shaders.length, opacityShaders.length);
    if (opacity) program.texture("opacity_weight", tables.opacityWeight ?? this.paintTable);
    const layerFromPixel = inverted(composed(pixelFromArtboard, instance.artboardFromLayer));
    const views = new Float32Array(8 * MOST_PAINTS);
    [...color.shaders, ...opacityShaders].forEach((shader, i) => {
      const paint = picture.paints.paint[shader];
      const [a, b, c, d, e, f] = composed(paint.paintFromLayer, layerFromPixel);
      views.set([a, c, e, paint.first, b, d, f, 0], 8 * i);
    });
    gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, this.paintViews);
    gl.bufferData(gl.UNIFORM_BUFFER, views, gl.DYNAMIC_DRAW);
    gl.uniformBlockBinding(
      program.program,
      gl.getUniformBlockIndex(program.program, "PaintViews"),
      0,
    );
  }

  /**
   * Draws the lines of the instance's triangles as ink.
   * @param {Instance} instance
   * @param {Affine} pixelFromArtboard
   * @param {number[]} size of the target
   * @param {number} lineScale
   */
  drawMesh(instance, pixelFromArtboard, size, lineScale) {
    const { gl } = this;
    const { mesh } = this.picture.layers[instance.layer];
    const tables = this.tables[instance.layer];
    tables.edgeIsCurve ??= makeTable(gl, "byte", mesh.edgeIsCurve);
    this.programs
      .get("overlay", "overlay")
      .use()
      .texture("triangle_vertex", tables.triangleVertex)
      .texture("vertex_position", tables.vertexPosition)
      .texture("edge_is_curve", tables.edgeIsCurve)
      .int("first_triangle", 0)
      .map("pixel_from_layer", this.pixelFromPositions(instance, pixelFromArtboard))
      .vec2("target_size", size[0], size[1])
      .float("line_scale", lineScale);
    gl.drawArrays(gl.TRIANGLES, 0, 18 * mesh.topology.triangleCount);
  }

  /**
   * What the instance can touch, artboard units.
   * @param {Instance} instance
   */
  bounds(instance) {
    return mappedBox(instance.artboardFromLayer, this.picture.layers[instance.layer].mesh.bounds);
  }
}
