// Draws an instance of a layer.

import { composed, inverted, mappedBox, translation } from "./affine.js";
import { arraySource, DataTable } from "./tables.js";
import { LayerTables } from "./layer_tables.js";

/** @import { Affine } from "./affine.js" */
/** @import { Program, Programs } from "./gl.js" */
/** @import { LayerDelta } from "./layer_tables.js" */
/** @import { Instance, Layer, Picture } from "./payload.js" */

/** Limit for the paints in the shader: views in its uniform block, two vectors each. */
const MOST_PAINTS = 128;

export class LayerDrawer {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {Programs} programs
   * @param {Picture} picture
   * @param {Uint16Array} texels texels of the paints
   */
  constructor(gl, programs, picture, texels) {
    this.gl = gl;
    this.programs = programs;
    /** @type {Map<Layer, LayerTables>} */
    this.tables = new Map();
    this.paintTable = new DataTable(gl, "vector");
    this.paintTexels = new DataTable(gl, "texel");
    this.paintViews = gl.createBuffer();
    this.picture = picture;
    this.texels = texels;
    this.writeLayers(picture.layers);
    this.paintTable.write(arraySource(picture.paints.table, 4));
    this.paintTexels.write(arraySource(texels, 4));
  }

  /**
   * Switches to another picture. Tables of layers that both pictures have are kept.
   * @param {Picture} picture
   * @param {Uint16Array} texels texels of the paints
   */
  setPicture(picture, texels) {
    const before = this.picture;
    this.writeLayers(picture.layers);
    this.picture = picture;
    if (picture.paints !== before.paints)
      this.paintTable.write(arraySource(picture.paints.table, 4));
    if (texels !== this.texels) this.paintTexels.write(arraySource(texels, 4));
    this.texels = texels;
  }

  /**
   * Makes tables for layers, and frees the tables of other layers. Throws if a layer is too large; the other layers
   * then still have their tables.
   * @param {Layer[]} layers
   */
  writeLayers(layers) {
    const wanted = new Set(layers);
    for (const layer of wanted) {
      if (!this.tables.has(layer)) this.tables.set(layer, new LayerTables(this.gl, layer));
    }
    for (const [layer, tables] of this.tables) {
      if (wanted.has(layer)) continue;
      tables.free();
      this.tables.delete(layer);
    }
  }

  /**
   * Updates the tables of a layer that has changed.
   * @param {Layer} layer
   * @param {LayerDelta | null} delta null: everything may have changed
   */
  update(layer, delta) {
    this.tablesOf(layer).update(delta);
  }

  /** @param {Layer} layer */
  tablesOf(layer) {
    const tables = this.tables.get(layer);
    if (!tables) throw new Error("The layer is not in the picture that is drawn.");
    return tables;
  }

  free() {
    for (const tables of this.tables.values()) tables.free();
    this.tables.clear();
    this.paintTable.free();
    this.paintTexels.free();
    this.gl.deleteBuffer(this.paintViews);
  }

  /**
   * Returns the map from the layer's own frame, relative to the origin of its positions.
   * @param {Instance} instance
   * @param {Affine} pixelFromArtboard
   */
  pixelFromPositions(instance, pixelFromArtboard) {
    const { origin } = this.picture.layers[instance.layer];
    const artboard = composed(instance.artboardFromLayer, translation(origin[0], origin[1]));
    return composed(pixelFromArtboard, artboard);
  }

  /**
   * Draws an instance into the bound target, source over.
   * @param {Instance} instance
   * @param {number} opacity
   * @param {Affine} pixelFromArtboard
   * @param {Affine} clipFromPixel
   */
  draw(instance, opacity, pixelFromArtboard, clipFromPixel) {
    const { gl, picture } = this;
    const layer = picture.layers[instance.layer],
      tables = this.tablesOf(layer);
    const hasPaints = layer.color.shaders.length > 0 || (layer.opacity?.shaders.length ?? 0) > 0;
    const defines = [];
    if (layer.opacity) defines.push("WITH_OPACITY");
    if (hasPaints) defines.push("WITH_PAINTS");
    const program = this.programs.get("patch", "patch", defines).use();
    const pixel = this.pixelFromPositions(instance, pixelFromArtboard);
    program
      .texture("triangle_vertex", tables.texture("triangleVertex"))
      .texture("vertex_position", tables.texture("vertexPosition"))
      .texture("triangle_node", tables.texture("triangleNode"))
      .texture("node_color", tables.texture("nodeColor"))
      .int("first_triangle", 0)
      .map("clip_from_layer", composed(clipFromPixel, pixel))
      .int("patch_order", layer.order + 1)
      .int("interpolation", picture.interpolation)
      .float("opacity", opacity);
    if (layer.opacity) {
      program
        .texture("triangle_opacity_node", tables.texture("triangleOpacityNode"))
        .texture("node_opacity", tables.texture("nodeOpacity"));
    }
    if (hasPaints) this.setPaints(program, instance, pixelFromArtboard);
    gl.drawArrays(gl.TRIANGLES, 0, layer.triangleVertex.length);
  }

  /**
   * @param {Program} program
   * @param {Instance} instance
   * @param {Affine} pixelFromArtboard
   */
  setPaints(program, instance, pixelFromArtboard) {
    const { gl, picture } = this;
    const layer = picture.layers[instance.layer],
      tables = this.tablesOf(layer);
    const { color, opacity } = layer;
    const opacityShaders = opacity ? opacity.shaders : [];
    program
      .texture("paint_table", this.paintTable.texture)
      .texture("paint_texels", this.paintTexels.texture)
      .texture("color_weight", tables.texture("colorWeight") ?? this.paintTable.texture)
      .float("paint_step", 1);
    gl.uniform2i(program.place("paint_count"), color.shaders.length, opacityShaders.length);
    if (opacity) {
      const weight = tables.texture("opacityWeight") ?? this.paintTable.texture;
      program.texture("opacity_weight", weight);
    }
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
   * Draws the edges of the instance's triangles as ink.
   * @param {Instance} instance
   * @param {Affine} pixelFromArtboard
   * @param {number[]} size of the target
   * @param {number} lineScale
   */
  drawMesh(instance, pixelFromArtboard, size, lineScale) {
    const { gl } = this;
    const layer = this.picture.layers[instance.layer],
      tables = this.tablesOf(layer);
    tables.wantEdges();
    this.programs
      .get("overlay", "overlay")
      .use()
      .texture("triangle_vertex", tables.texture("triangleVertex"))
      .texture("vertex_position", tables.texture("vertexPosition"))
      .texture("edge_is_curve", tables.texture("edgeIsCurve"))
      .int("first_triangle", 0)
      .map("pixel_from_layer", this.pixelFromPositions(instance, pixelFromArtboard))
      .vec2("target_size", size[0], size[1])
      .float("line_scale", lineScale);
    gl.drawArrays(gl.TRIANGLES, 0, 6 * layer.triangleVertex.length);
  }

  /**
   * Returns the area that the instance can touch, artboard units.
   * @param {Instance} instance
   */
  bounds(instance) {
    return mappedBox(instance.artboardFromLayer, this.picture.layers[instance.layer].bounds);
  }
}
