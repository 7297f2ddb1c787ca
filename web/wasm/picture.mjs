// Solved documents, and exact colours at points; sfumato.mjs has the overview.
import { box, expect, expectIndices, Handle } from "./handle.mjs";

/** Tables of a solved layer. */
export const Table = Object.freeze({
  vertices: 0,
  triangles: 1,
  curveEdges: 2,
  colorNodes: 3,
  colorValues: 4,
  opacityNodes: 5,
  opacityValues: 6,
});

/** The counts and times of the last solve, in the order of the C interface. */
const statistics = [
  "curves",
  "segments",
  "triangles",
  "vertices",
  "nodes",
  "geometrySeconds",
  "triangulationSeconds",
  "gatherSeconds",
  "waitingNodes",
  "keptLayers",
  "continuedLayers",
  "begunLayers",
];

/** A solved document, which has no resolution. */
export class SfumatoPicture extends Handle {
  #context;

  /** Used by SfumatoContext. */
  constructor(context, address) {
    super(context.library, "picture", address);
    this.#context = context;
  }

  /**
   * Returns RGBA pixels for ImageData. Give the width or the height, and the other one follows; without both, a
   * user unit is one pixel.
   * @param {{width?: number, height?: number} & Record<string, string | number | boolean | undefined>}
   *   options size, and options of sfumato_raster
   * @returns {{width: number, height: number, data: Uint8ClampedArray}}
   */
  raster({ width = undefined, height = undefined, ...options } = {}) {
    const [, , across, down] = this.viewport;
    const ratio = across / down;
    const whole = (length) => Math.max(1, Math.round(length));
    const size = {
      width: width ?? whole(height === undefined ? across : height * ratio),
      height: height ?? whole(width === undefined ? down : width / ratio),
    };
    return { ...size, data: this.#context.raster(this, size, options) };
  }

  /** Returns the picture as a file: SfumatoContext.export(). */
  export(format, options = null) {
    return this.#context.export(this, format, options);
  }

  /** Returns the data for PictureReader of web/viewer. @param options background */
  viewerPayload(options = null) {
    return this.#context.viewerPayload(this, options);
  }

  /** x, y, width, height */
  get viewport() {
    return box(this.library, "sfumato_picture_viewport", this.address);
  }

  get layerCount() {
    return this.library.call("sfumato_picture_layer_count", this.address);
  }

  /**
   * Returns a copy of a layer's table: {rows, columns, data}.
   * @param {number} table of Table
   */
  table(layer, table) {
    const view = this.tableView(layer, table);
    return { ...view, data: view.data.slice() };
  }

  /** The same without a copy: `data` is valid until the next call of any function of this module. */
  tableView(layer, table) {
    return this.#look("sfumato_picture_table", layer, table);
  }

  /** Returns the rows that the last solveAgain() computed again: separate ascending ranges [from, up to]. */
  changes(layer, table) {
    const { rows, data } = this.#look("sfumato_picture_changes", layer, table);
    return Array.from({ length: rows }, (_, i) => [data[2 * i], data[2 * i + 1]]);
  }

  /**
   * Counts and times of the last solve() or solveAgain(): { curves, nodes, gatherSeconds... }, waitingNodes, and,
   * for a frame, how its layers were made.
   */
  get statistics() {
    const number = (i) => this.library.number("sfumato_picture_statistic", this.address, i);
    return Object.fromEntries(statistics.map((name, i) => [name, number(i)]));
  }

  #look(name, layer, table) {
    expectIndices(layer, table);
    const view = this.library.scratch();
    expect(
      this.library.call(name, this.address, layer, table, view),
      `there is no layer ${layer} or no table ${table}`,
    );
    return this.library.table(view);
  }
}

/** The exact colours of one layer at points. */
export class SfumatoField extends Handle {
  #context;

  /** Used by SfumatoContext. */
  constructor(context, address) {
    super(context.library, "field", address);
    this.#context = context;
  }

  /**
   * @param {ArrayLike<number>} xy pairs, in the frame of the layer
   * @returns {Float32Array} red, green, blue, opacity of each point
   */
  colors(xy) {
    const { library } = this;
    const count = xy.length / 2;
    return library.withBytes(Float64Array.from(xy), (points) =>
      library.withBytes(new Float32Array(4 * count), (rgba, byteCount) => {
        this.#context.run("sfumato_field_colors", this.address, points, count, rgba);
        return new Float32Array(library.bytes(rgba, byteCount).slice().buffer);
      }),
    );
  }
}
