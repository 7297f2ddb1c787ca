// Sfumato for JavaScript: the C interface (include/sfumato/sfumato.h, docs/c-api.md) with strings,
// typed arrays and exceptions in the place of pointers and codes. docs/wasm.md has a program.
//
// Whatever `load`, a context or a document hands out is given back by its own free(). All arrays
// are copies, but for tableView(). What a call cannot do it throws as SfumatoError.
import { Library, optionText, SfumatoError, Status } from "./library.mjs";

export { SfumatoError, Status };

/** Sides of a curve, what they bear, what they are to it, and what offsets count. */
export const Side = Object.freeze({ left: 0, right: 1 });
export const Attribute = Object.freeze({ color: 0, opacity: 1, blur: 2 });
export const Kind = Object.freeze({ open: 0, barrier: 1, stops: 2, paint: 3 });
export const Space = Object.freeze({ arcLength: 0, parameter: 1 });

/**
 * Options of a call, as the C interface has them (docs/c-api.md): "max-memory=500 max-time=2" or
 * {"max-memory": 500, "max-time": 2}.
 * @typedef {string | Readonly<Record<string, string | number | boolean>> | null} Options
 */

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

/** What a picture counts of the last time that it was solved: the numbers of the C interface. */
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
];

const channels = { rgb8: 3, rgba8: 4, rgb16: 3, rgba16: 4 };
const formats = Object.keys(channels);

/**
 * Loads the module.
 * @param {BufferSource | WebAssembly.Module} source what sfumato.wasm holds
 */
export async function loadSfumato(source) {
  return new Sfumato(await Library.load(source));
}

/** The library. One instance computes one thing at a time; workers have instances of their own. */
export class Sfumato {
  #library;
  #contexts = new Map(); // by the number that callbacks get
  #next = 1;
  #progress;
  #load;

  constructor(library) {
    this.#library = library;
    this.#progress = library.addFunction("iid>", undefined, (user, stage, fraction) =>
      this.#contexts.get(user).progressed(library.string(stage), fraction),
    );
    this.#load = library.addFunction("iiii>i", 1, (user, href, deliver, sink) =>
      this.#contexts.get(user).loaded(library.string(href), deliver, sink),
    );
  }

  get version() {
    return this.#library.string(this.#library.call("sfumato_version"));
  }

  get abi() {
    return this.#library.call("sfumato_abi");
  }

  /** Bytes of the module's memory, which grows and never shrinks. */
  get memoryBytes() {
    return this.#library.memoryBytes;
  }

  /** @param {Options} options threads, max-memory, max-time, limit.NAME */
  context(options = null) {
    const number = this.#next++;
    const callbacks = { number, progress: this.#progress, load: this.#load };
    const context = new SfumatoContext(this.#library, optionText(options), callbacks, () =>
      this.#contexts.delete(number),
    );
    this.#contexts.set(number, context);
    return context;
  }
}

/** A handle of the library's, which free() gives back; a second time does nothing. */
class Handle {
  #library;
  #address;
  #kind;

  constructor(library, kind, address) {
    this.#library = library;
    this.#kind = kind;
    this.#address = address;
  }

  get library() {
    return this.#library;
  }

  /** @throws SfumatoError where it was freed */
  get address() {
    if (this.#address === 0) throw new SfumatoError(Status.badUsage, `a freed ${this.#kind}`);
    return this.#address;
  }

  free() {
    const address = this.#address;
    this.#address = 0;
    if (address !== 0) this.#library.call(`sfumato_${this.#kind}_free`, address);
  }
}

/** Bounds on memory and time; reads, solves and draws. */
export class SfumatoContext extends Handle {
  /** Called with a word and a fraction from 0 to 1 while a call works; it may call cancel(). */
  onProgress = null;
  #callbacks;
  #freed;
  #loader = null;

  /** For Sfumato.context(). */
  constructor(library, options, callbacks, freed) {
    const create = (text) => library.call("sfumato_context_new", text);
    super(library, "context", library.withString(options, create));
    this.#callbacks = callbacks;
    this.#freed = freed;
    const reason = library.string(library.call("sfumato_error_text", this.address));
    if (reason !== "") {
      super.free();
      throw new SfumatoError(Status.badUsage, reason);
    }
    library.call("sfumato_set_progress", this.address, callbacks.progress, callbacks.number);
  }

  free() {
    super.free();
    this.#freed();
  }

  /**
   * Reads SVG or Orzan's XML; not gzip (DecompressionStream unpacks it before).
   * @param {string | Uint8Array} text
   * @param {{name?: string, load?: ((href: string) => Uint8Array | null) | null}} from `name` is for
   *   messages; `load` brings the files that the document names, and gives null where it will not
   */
  read(text, { name = "", load = null } = {}) {
    const { library } = this;
    const bytes = typeof text === "string" ? new TextEncoder().encode(text) : text;
    this.#loader = load;
    try {
      return library.withBytes(bytes, (address, count) =>
        library.withString(name, (label) =>
          this.#withLoader((loader) => {
            const call = ["sfumato_read", address, count, label, loader];
            return new SfumatoDocument(this, this.make(...call));
          }),
        ),
      );
    } finally {
      this.#loader = null;
    }
  }

  /**
   * Hands in the pixels of an image file that a document read later may name or hold: the module
   * decodes none.
   * @param {Uint8Array} file its bytes
   * @param {{width: number, height: number, data: Uint8Array | Uint8ClampedArray} | null} image
   *   RGBA, not premultiplied, as ImageData has it; null forgets it
   */
  addImage(file, image) {
    const { library } = this;
    library.withBytes(file, (...bytes) => {
      if (!image) return this.run("sfumato_add_image", ...bytes, 0);
      const { width, height, data } = image;
      if (data.length !== 4 * width * height) {
        throw new SfumatoError(Status.badUsage, "expected 4 bytes for each pixel");
      }
      return library.withBytes(data, (pixels) =>
        library.withBytes(
          new Uint32Array([pixels, 4 * width, width, height, formats.indexOf("rgba8")]),
          (struct) => this.run("sfumato_add_image", ...bytes, struct),
        ),
      );
    });
  }

  /** A sfumato_loader that calls this context's; 0 where there is none. */
  #withLoader(body) {
    if (!this.#loader) return body(0);
    const struct = new Uint32Array([this.#callbacks.load, this.#callbacks.number]);
    return this.library.withBytes(struct, body);
  }

  /** Warnings of the last read(). */
  get warnings() {
    const found = [];
    for (;;) {
      const next = this.library.call("sfumato_warning", this.address, found.length);
      if (next === 0) return found;
      found.push(this.library.string(next));
    }
  }

  /** @param {Options} options artboard (to be given), interpolation, background */
  newDocument(options) {
    return this.#withOptions(options, (text) => {
      return new SfumatoDocument(this, this.make("sfumato_document_new", text));
    });
  }

  /** @param {Options} options of sfumato_solve: max-error, width, drags (for pictures of an editor), … */
  solve(document, options = null) {
    return this.#withOptions(options, (text) => {
      const picture = this.make("sfumato_solve", document.address, text);
      return new SfumatoPicture(this.library, picture);
    });
  }

  /**
   * Makes a picture that of a document.
   * @param {SfumatoDocument} document
   * @param {SfumatoPicture} picture
   * @param {{quick?: boolean, seconds?: number | undefined}} way quick: to look at while curves
   *   move, rough where it is not one alone; seconds: so, and once they are over, values wait (picture.statistics.waitingNodes)
   */
  solveAgain(document, picture, { quick = false, seconds = undefined } = {}) {
    if (seconds !== undefined) {
      this.run("sfumato_solve_within", document.address, seconds, picture.address);
    } else {
      this.run("sfumato_solve_again", document.address, quick ? 1 : 0, picture.address);
    }
  }

  /**
   * Draws a picture.
   * @param {SfumatoPicture} picture
   * @param {{width: number, height: number, format?: string}} image format: rgb8, rgba8 (that of
   *   ImageData), rgb16 or rgba16
   * @param {Options} options of sfumato_raster
   * @returns {Uint8ClampedArray | Uint16Array} rows from the top, alpha not premultiplied
   */
  raster(picture, { width, height, format = "rgba8" }, options = null) {
    const index = formats.indexOf(format);
    const is16 = index >= 2;
    const rowBytes = width * (channels[format] ?? 0) * (is16 ? 2 : 1);
    const pixels = this.library.allocate(rowBytes * height);
    try {
      const image = new Uint32Array([pixels, rowBytes, width, height, index]);
      this.library.withBytes(image, (struct) =>
        this.#withOptions(options, (text) =>
          this.run("sfumato_raster", picture.address, struct, text),
        ),
      );
      const { buffer } = this.library.bytes(pixels, rowBytes * height).slice();
      return is16 ? new Uint16Array(buffer) : new Uint8ClampedArray(buffer);
    } finally {
      this.library.call("sfumato_free", pixels);
    }
  }

  /** What web/viewer's PictureReader reads. @param {Options} options background */
  viewerPayload(picture, options = null) {
    return this.#withOptions(options, (text) =>
      this.library.takeBytes(this.make("sfumato_viewer_payload", picture.address, text)),
    );
  }

  /**
   * What web/viewer's readStack() reads: a picture whose layers have no tables; these are the
   * picture's table(). @param options background
   */
  pictureStack(picture, options = null) {
    return this.#withOptions(options, (text) =>
      this.library.takeBytes(this.make("sfumato_picture_stack", picture.address, text)),
    );
  }

  /**
   * Looks for probable mistakes: {file, hints, hint_count}, as `sfumato lint --json` prints it.
   * @param {Options} options verbose
   */
  lint(document, options = null) {
    return this.#withOptions(options, (text) => {
      const json = this.library.takeBytes(this.make("sfumato_lint", document.address, text));
      return JSON.parse(new TextDecoder().decode(json));
    });
  }

  /** A layer's exact colours at points. @param {Options} options of sfumato_field_new */
  field(document, layer, options = null) {
    return this.#withOptions(options, (text) => {
      const field = this.make("sfumato_field_new", document.address, layer, text);
      return new SfumatoField(this, field);
    });
  }

  /**
   * Within onProgress: ends the call that runs, and later ones until resume(), with
   * Status.cancelled. From elsewhere nothing reaches a module that works: end its worker.
   */
  cancel() {
    this.library.call("sfumato_cancel", this.address);
  }

  resume() {
    this.library.call("sfumato_resume", this.address);
  }

  #withOptions(options, body) {
    return this.library.withString(optionText(options), body);
  }

  /** For this file: a call with this context, whose code becomes an error. */
  run(name, ...values) {
    const { library } = this;
    const code = library.call(name, this.address, ...values);
    if (code === Status.ok) return;
    const reason = library.string(library.call("sfumato_error_text", this.address));
    const file = library.string(library.call("sfumato_error_file", this.address));
    const place = library.scratch();
    library.call("sfumato_error_place", this.address, place, place + 4);
    const [line, column] = [library.u32(place), library.u32(place + 4)];
    throw new SfumatoError(code, reason, { file, line, column });
  }

  /** For this file: the same with a last parameter that receives a handle. */
  make(name, ...values) {
    const out = this.library.scratch();
    this.run(name, ...values, out);
    return this.library.u32(out);
  }

  /** For Sfumato: the module reports. What onProgress throws ends the call, and is its error. */
  progressed(stage, fraction) {
    try {
      this.onProgress?.(stage, fraction);
    } catch (error) {
      this.cancel();
      throw error;
    }
  }

  /** For Sfumato: the module asks for a file. */
  loaded(href, deliver, sink) {
    const bytes = this.#loader(href);
    if (!bytes) return 1;
    this.library.withBytes(bytes, (address, count) =>
      this.library.callAddress(deliver, sink, address, count),
    );
    return 0;
  }
}

/** Diffusion curves as their author drew them. It is changed through the context that made it. */
export class SfumatoDocument extends Handle {
  #context;

  /** For SfumatoContext. */
  constructor(context, address) {
    super(context.library, "document", address);
    this.#context = context;
  }

  copy() {
    return new SfumatoDocument(
      this.#context,
      this.#context.make("sfumato_document_copy", this.address),
    );
  }

  /** The document as SVG. */
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
    return this.library.call("sfumato_curve_count", this.address, layer);
  }

  /** Perhaps ""; null where there is no such layer. */
  layerId(layer) {
    return this.library.string(this.library.call("sfumato_layer_id", this.address, layer));
  }

  /** Perhaps ""; null where there is no such curve. */
  curveId(layer, curve) {
    return this.library.string(this.library.call("sfumato_curve_id", this.address, layer, curve));
  }

  /**
   * Where a curve stands in the text that was read: {byteOffset, subpath}, the place of its
   * element's `<` in UTF-8, and which of the element's subpaths it is; null where that is not known.
   */
  curveSource(layer, curve) {
    const place = this.library.scratch();
    const asked = [this.address, layer, curve, place, place + 4];
    expect(
      this.library.call("sfumato_curve_source", ...asked),
      `there is no curve ${curve} in layer ${layer}`,
    );
    const [byteOffset, subpath] = [this.library.u32(place), this.library.u32(place + 4)];
    return byteOffset === 0 ? null : { byteOffset, subpath };
  }

  /** 3 n + 1 control points, x and y in turn. */
  points(layer, curve) {
    const view = this.library.scratch();
    expect(
      this.library.call("sfumato_curve_points", this.address, layer, curve, view),
      `there is no curve ${curve} in layer ${layer}`,
    );
    return this.library.table(view).data.slice();
  }

  /** @param {ArrayLike<number>} xy as points() gives them */
  setPoints(layer, curve, xy) {
    this.#withPoints(xy, (...points) =>
      this.#context.run("sfumato_set_curve_points", this.address, layer, curve, ...points),
    );
  }

  /** Adds a curve whose sides bear nothing, before curve `at` or, with null, as the last. */
  insertCurve(layer, at, xy) {
    this.#withPoints(xy, (...points) =>
      this.#context.run("sfumato_insert_curve", this.address, layer, at ?? 0xffffffff, ...points),
    );
  }

  removeCurve(layer, curve) {
    this.#context.run("sfumato_remove_curve", this.address, layer, curve);
  }

  /** How strongly a curve counts beside others; 1 for one without a weight. */
  weight(layer, curve) {
    const weight = this.library.number("sfumato_curve_weight", this.address, layer, curve);
    if (weight === 0) expect(Status.badUsage, `there is no curve ${curve} in layer ${layer}`);
    return weight;
  }
  setWeight(layer, curve, weight) {
    this.#context.run("sfumato_set_curve_weight", this.address, layer, curve, weight);
  }

  /**
   * What a side bears: {kind, space, rows}; a row is [offset, red, green, blue] or [offset, value].
   * @param {number} side of Side
   * @param {number} attribute of Attribute
   */
  stops(layer, curve, side, attribute) {
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
   * Sets what stops() gives: Kind.stops with rows, or Kind.open or Kind.barrier without.
   * @param {number} layer
   * @param {number} curve
   * @param {number} side of Side
   * @param {number} attribute of Attribute
   * @param {{kind: number, space?: number, rows?: readonly (readonly number[])[]}} list
   */
  setStops(layer, curve, side, attribute, { kind, space = Space.arcLength, rows = [] }) {
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
    if (xy.length % 2 !== 0) throw new SfumatoError(Status.badUsage, "expected pairs of numbers");
    return this.library.withBytes(Float64Array.from(xy), (address) => body(address, xy.length / 2));
  }
}

/** A solved document, of no resolution. */
export class SfumatoPicture extends Handle {
  /** For SfumatoContext. */
  constructor(library, address) {
    super(library, "picture", address);
  }

  /** x, y, width, height */
  get viewport() {
    return box(this.library, "sfumato_picture_viewport", this.address);
  }

  get layerCount() {
    return this.library.call("sfumato_picture_layer_count", this.address);
  }

  /**
   * {rows, columns, data}: a table of a layer, copied.
   * @param {number} table of Table
   */
  table(layer, table) {
    const view = this.tableView(layer, table);
    return { ...view, data: view.data.slice() };
  }

  /** The same without a copy: `data` lasts until the next call of anything of this module. */
  tableView(layer, table) {
    return this.#look("sfumato_picture_table", layer, table);
  }

  /** The rows that the last solveAgain() made anew: ranges [from, up to], ascending and apart. */
  changes(layer, table) {
    const { rows, data } = this.#look("sfumato_picture_changes", layer, table);
    return Array.from({ length: rows }, (_, i) => [data[2 * i], data[2 * i + 1]]);
  }

  /** What the last solve() or solveAgain() did: { curves, nodes, gatherSeconds... }, and waitingNodes. */
  get statistics() {
    const number = (i) => this.library.number("sfumato_picture_statistic", this.address, i);
    return Object.fromEntries(statistics.map((name, i) => [name, number(i)]));
  }

  #look(name, layer, table) {
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

  /** For SfumatoContext. */
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

function expect(code, complaint) {
  if (code !== Status.ok) throw new SfumatoError(code, complaint);
}

function box(library, name, address) {
  const place = library.scratch();
  library.call(name, address, place);
  return [...library.doubles(place, 4)];
}
