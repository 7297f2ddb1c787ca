// Documents of the library; sfumato.mjs has the overview.
import { box, expect, expectIndices, Handle } from "./handle.mjs";
import { SfumatoError, Status } from "./library.mjs";

/** Sides of a curve, kinds of a side, attributes, and units of stop offsets. */
export const Side = Object.freeze({ left: 0, right: 1 });
export const Attribute = Object.freeze({ color: 0, opacity: 1, blur: 2 });
export const Kind = Object.freeze({ open: 0, barrier: 1, stops: 2, paint: 3 });
export const Space = Object.freeze({ arcLength: 0, parameter: 1 });

/** Diffusion curves as their author drew them. Changes go through the context that made the document. */
export class SfumatoDocument extends Handle {
  #context;

  #warnings;

  /** Used by SfumatoContext. */
  constructor(context, address, { isOwn = true, warnings = [] } = {}) {
    super(context.library, "document", address, isOwn);
    this.#context = context;
    this.#warnings = Object.freeze(warnings);
  }

  /** The content that the reader ignored, and probable mistakes, one message each. @type {readonly string[]} */
  get warnings() {
    return this.#warnings;
  }

  copy() {
    const address = this.#context.make("sfumato_document_copy", this.address);
    return new SfumatoDocument(this.#context, address, { warnings: this.warnings });
  }

  /** Calls SfumatoContext.solve() of the context that made the document. */
  solve(options = null) {
    return this.#context.solve(this, options);
  }

  /** Returns the document as SVG. */
  write() {
    const bytes = this.#context.make("sfumato_document_write", this.address);
    return new TextDecoder().decode(this.library.takeBytes(bytes));
  }

  /** x, y, width, height */
  get artboard() {
    return box(this.library, "sfumato_document_artboard", this.address);
  }

  get layerCount() {
    return this.library.call("sfumato_layer_count", this.address);
  }

  curveCount(layer) {
    expectIndices(layer);
    return this.library.call("sfumato_curve_count", this.address, layer);
  }

  /** Returns the id of a layer, which may be ""; null if there is no such layer. */
  layerId(layer) {
    expectIndices(layer);
    return this.library.string(this.library.call("sfumato_layer_id", this.address, layer));
  }

  /** Returns the id of a curve, which may be ""; null if there is no such curve. */
  curveId(layer, curve) {
    expectIndices(layer, curve);
    return this.library.string(this.library.call("sfumato_curve_id", this.address, layer, curve));
  }

  /**
   * Returns the place of a curve in the text that was read: {byteOffset, subpath}, which are the position of its
   * element's `<` in UTF-8 and the index of the subpath; null if unknown.
   */
  curveSource(layer, curve) {
    expectIndices(layer, curve);
    const place = this.library.scratch();
    const asked = [this.address, layer, curve, place, place + 4];
    expect(
      this.library.call("sfumato_curve_source", ...asked),
      `there is no curve ${curve} in layer ${layer}`,
    );
    const [byteOffset, subpath] = [this.library.u32(place), this.library.u32(place + 4)];
    return byteOffset === 0 ? null : { byteOffset, subpath };
  }

  /** Returns the 3 n + 1 control points of a curve with n pieces, as alternating x and y. */
  points(layer, curve) {
    expectIndices(layer, curve);
    const view = this.library.scratch();
    expect(
      this.library.call("sfumato_curve_points", this.address, layer, curve, view),
      `there is no curve ${curve} in layer ${layer}`,
    );
    return this.library.table(view).data.slice();
  }

  /** Moves a curve. @param {ArrayLike<number>} xy as from points() */
  setPoints(layer, curve, xy) {
    expectIndices(layer, curve);
    this.#withPoints(xy, (...points) =>
      this.#context.run("sfumato_set_curve_points", this.address, layer, curve, ...points),
    );
  }

  /** Adds a curve with two open sides before curve `at`; with null, as the last curve. */
  insertCurve(layer, at, xy) {
    expectIndices(layer, at ?? 0);
    this.#withPoints(xy, (...points) =>
      this.#context.run("sfumato_insert_curve", this.address, layer, at ?? 0xffffffff, ...points),
    );
  }

  removeCurve(layer, curve) {
    expectIndices(layer, curve);
    this.#context.run("sfumato_remove_curve", this.address, layer, curve);
  }

  /** Returns a curve's weight relative to other curves; 1 for a curve without a weight. */
  weight(layer, curve) {
    expectIndices(layer, curve);
    const weight = this.library.number("sfumato_curve_weight", this.address, layer, curve);
    if (weight === 0) expect(Status.badUsage, `there is no curve ${curve} in layer ${layer}`);
    return weight;
  }
  setWeight(layer, curve, weight) {
    expectIndices(layer, curve);
    this.#context.run("sfumato_set_curve_weight", this.address, layer, curve, weight);
  }

  /**
   * Returns the stops of a side: {kind, space, rows}. A row is [offset, red, green, blue] or [offset, value].
   * @param {number} side of Side
   * @param {number} attribute of Attribute
   */
  stops(layer, curve, side, attribute) {
    expectIndices(layer, curve, side, attribute);
    const { library } = this;
    const asked = ["sfumato_curve_stops", this.address, layer, curve, side, attribute];
    const numbers = attribute === Attribute.color ? 4 : 2;
    const place = library.scratch();
    const count = library.call(...asked, place, place + 4, 0, 0);
    const [kind, space] = [library.u32(place), library.u32(place + 4)];
    const flat = library.withBytes(new Float64Array(count * numbers), (rows) => {
      library.call(...asked, 0, 0, rows, count);
      return library.doubles(rows, count * numbers);
    });
    const rows = Array.from({ length: count }, (_, i) => [
      ...flat.subarray(i * numbers, (i + 1) * numbers),
    ]);
    return { kind, space, rows };
  }

  /**
   * Sets stops as from stops(): Kind.stops with rows, or Kind.open or Kind.barrier without rows.
   * @param {number} layer
   * @param {number} curve
   * @param {number} side of Side
   * @param {number} attribute of Attribute
   * @param {{kind: number, space?: number, rows?: readonly (readonly number[])[]}} list
   */
  setStops(layer, curve, side, attribute, { kind, space = Space.arcLength, rows = [] }) {
    expectIndices(layer, curve, side, attribute, kind, space);
    const numbers = attribute === Attribute.color ? 4 : 2;
    if (rows.some((row) => row.length !== numbers)) {
      throw new SfumatoError(Status.badUsage, `expected rows of ${numbers} numbers`);
    }
    this.library.withBytes(new Float64Array(rows.flat()), (address) => {
      const which = [this.address, layer, curve, side, attribute];
      const list = [kind, space, address, rows.length];
      this.#context.run("sfumato_set_curve_stops", ...which, ...list);
    });
  }

  #withPoints(xy, body) {
    if (!Number.isInteger(xy?.length)) throw new TypeError("expected an array of numbers");
    if (xy.length % 2 !== 0) throw new SfumatoError(Status.badUsage, "expected pairs of numbers");
    return this.library.withBytes(Float64Array.from(xy), (address) => body(address, xy.length / 2));
  }
}
