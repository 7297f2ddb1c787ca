// Contexts of the library; sfumato.mjs has the overview.
import { SfumatoDocument } from "./document.mjs";
import { addressOf, expectIndices, Handle } from "./handle.mjs";
import { optionText, SfumatoError, Status } from "./library.mjs";
import { SfumatoField, SfumatoPicture } from "./picture.mjs";

/**
 * Options of a call, as the C interface has them (docs/c-api.md): "max-memory=500 max-time=2" or
 * {"max-memory": 500, "max-time": 2}.
 * @typedef {string | Readonly<Record<string, string | number | boolean>> | null} Options
 */

/**
 * The progress of a trace: decibels against the picture, seconds since the start, and counts.
 * @typedef {{psnr: number, seconds: number, round: number, roundCount: number, curves: number,
 *   controlPoints: number, stops: number}} TraceState
 */

const channels = { rgb8: 3, rgba8: 4, rgb16: 3, rgba16: 4 };
const formats = Object.keys(channels);

function expectBytes(given) {
  if (given instanceof Uint8Array || given instanceof Uint8ClampedArray) return given;
  throw new TypeError("expected bytes: a Uint8Array or, of pixels, a Uint8ClampedArray");
}

/** Limits on memory and time, and the functions that read, solve and draw. */
export class SfumatoContext extends Handle {
  /**
   * Called while a call works, with the name of a stage and a fraction from 0 to 1. It may call cancel().
   * @type {((stage: string, fraction: number) => void) | null}
   */
  onProgress = null;
  #callbacks;
  #freed;
  #loader = null;
  #onRound = null;

  /** Used by Sfumato.context(). */
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
   * Reads SVG or the XML of Orzan et al. It does not read gzip: use DecompressionStream first.
   * @param {string | Uint8Array} text
   * @param {{name?: string, load?: ((href: string) => Uint8Array | null) | null}} from `name` is for messages;
   *   `load` returns the files that the document names, or null if there is no such file
   */
  read(text, from = {}) {
    return this.#readBy("sfumato_read", text, from);
  }

  /**
   * Converts an ordinary SVG to a drawing, with curves along the boundaries of its fills and strokes. `warnings`
   * names the content that was left out. The parameters are as for read().
   * @param {string | Uint8Array} text
   * @param {{name?: string, load?: ((href: string) => Uint8Array | null) | null}} from
   */
  importSvg(text, from = {}) {
    return this.#readBy("sfumato_import_svg", text, from);
  }

  /**
   * Combines two regions: path data of SVG, filled by the nonzero rule.
   * @param {"unite" | "intersect" | "subtract" | "exclude"} operation "subtract": the first without the second
   * @param {string} first
   * @param {string} second
   * @param {number} tolerance accuracy of crossings, in the paths' units, above 0
   * @returns {string} path data, its inside on the right; "" if nothing is left
   */
  combinePaths(operation, first, second, tolerance) {
    const { library } = this;
    const within = (texts, addresses) => {
      const [text, ...rest] = texts;
      if (text !== undefined) return library.withString(text, (at) => within(rest, [...addresses, at]));
      return library.takeBytes(this.make("sfumato_combine_paths", ...addresses, tolerance));
    };
    return new TextDecoder().decode(within([operation, first, second].map(String), []));
  }

  #readBy(reader, text, { name = "", load = null }) {
    const { library } = this;
    const bytes = typeof text === "string" ? new TextEncoder().encode(text) : expectBytes(text);
    if (typeof name !== "string") throw new TypeError("expected a name that is a string");
    this.#loader = load;
    try {
      return library.withBytes(bytes, (address, count) =>
        library.withString(name, (label) =>
          this.#withLoader((loader) => {
            const call = [reader, address, count, label, loader];
            const made = this.make(...call);
            return new SfumatoDocument(this, made, { warnings: this.warnings });
          }),
        ),
      );
    } finally {
      this.#loader = null;
    }
  }

  /**
   * Adds the pixels of an image file that a document read later may name or contain. The module has no image
   * decoders.
   * @param {Uint8Array} file its bytes
   * @param {{width: number, height: number, data: Uint8Array | Uint8ClampedArray} | null} image
   *   RGBA, not premultiplied, in the layout of ImageData; null removes the pixels
   */
  addImage(file, image) {
    const { library } = this;
    library.withBytes(expectBytes(file), (...bytes) => {
      if (!image) return this.run("sfumato_add_image", ...bytes, 0);
      return this.#withImage(image, (struct) => this.run("sfumato_add_image", ...bytes, struct));
    });
  }

  /** Calls body() with a sfumato_image of RGBA pixels in the layout of ImageData. */
  #withImage({ width, height, data }, body) {
    const { library } = this;
    if (expectBytes(data).length !== 4 * width * height) {
      throw new SfumatoError(Status.badUsage, "expected 4 bytes for each pixel");
    }
    return library.withBytes(data, (pixels) => {
      const image = [pixels, 4 * width, width, height, formats.indexOf("rgba8")];
      return library.withBytes(new Uint32Array(image), (struct) => body(struct));
    });
  }

  /** Calls body() with a sfumato_loader for this context's load function; with 0 if there is none. */
  #withLoader(body) {
    if (!this.#loader) return body(0);
    const struct = new Uint32Array([this.#callbacks.load, this.#callbacks.number]);
    return this.library.withBytes(struct, body);
  }

  /** The warnings of the last read() or importSvg(). */
  get warnings() {
    const found = [];
    for (;;) {
      const next = this.library.call("sfumato_warning", this.address, found.length);
      if (next === 0) return found;
      found.push(this.library.string(next));
    }
  }

  /** Creates a document. @param {Options} options artboard (required), interpolation, background */
  newDocument(options) {
    return this.#withOptions(options, (text) => {
      return new SfumatoDocument(this, this.make("sfumato_document_new", text));
    });
  }

  /**
   * Traces a picture: makes a drawing with curves along its edges and with fitted colours and blur.
   * @param {{width: number, height: number, data: Uint8Array | Uint8ClampedArray}} image RGBA, not premultiplied,
   *   in the layout of ImageData
   * @param {Options} options of sfumato_trace: points or detail, smooth, stops, blur, …
   * @param {((state: TraceState, drawing: SfumatoDocument) => void) | null} onRound called after each round with
   *   the progress and with the drawing, which is valid until it returns; it may call cancel()
   */
  trace(image, options = null, onRound = null) {
    this.#onRound = onRound;
    try {
      return this.#withImage(image, (pixels) =>
        this.#withOptions(options, (text) =>
          this.#withWatch((watch) => {
            return new SfumatoDocument(this, this.make("sfumato_trace", pixels, text, watch));
          }),
        ),
      );
    } finally {
      this.#onRound = null;
    }
  }

  /**
   * Returns a copy of a document with the colours of a picture that covers its artboard.
   * @param {SfumatoDocument} document
   * @param {{width: number, height: number, data: Uint8Array | Uint8ClampedArray}} image as for trace()
   * @param {Options} options of sfumato_fit_colors
   */
  fitColors(document, image, options = null) {
    return this.#withImage(image, (pixels) =>
      this.#withOptions(options, (text) => {
        const asked = [this.#documentOf(document), pixels, text];
        return new SfumatoDocument(this, this.make("sfumato_fit_colors", ...asked));
      }),
    );
  }

  /** Calls body() with a sfumato_trace_watch that reports to this context; with 0 if nobody listens. */
  #withWatch(body) {
    if (!this.#onRound) return body(0);
    const struct = new Uint32Array([this.#callbacks.traced, this.#callbacks.number]);
    return this.library.withBytes(struct, (watch) => body(watch));
  }

  /** Solves. @param {Options} options of sfumato_solve: max-error, width, drags (for pictures of an editor), … */
  solve(document, options = null) {
    return this.#withOptions(options, (text) => {
      return new SfumatoPicture(this, this.make("sfumato_solve", this.#documentOf(document), text));
    });
  }

  /**
   * Updates a picture to the present state of a document.
   * @param {SfumatoDocument} document
   * @param {SfumatoPicture} picture
   * @param {{quick?: boolean, seconds?: number | undefined}} way quick: a preview while curves move, rough if more
   *   than one curve moves; seconds: a preview with a deadline, after which the remaining values wait
   *   (picture.statistics.waitingNodes)
   */
  solveAgain(document, picture, { quick = false, seconds = undefined } = {}) {
    const [drawn, solved] = [this.#documentOf(document), this.#pictureOf(picture)];
    if (seconds !== undefined) this.run("sfumato_solve_within", drawn, seconds, solved);
    else this.run("sfumato_solve_again", drawn, quick ? 1 : 0, solved);
  }

  /**
   * Turns a picture, solved with `coherent`, into the next frame of a film. picture.statistics counts the layers by
   * how they were made: keptLayers, continuedLayers, begunLayers.
   */
  solveNext(document, picture) {
    this.run("sfumato_solve_next", this.#documentOf(document), this.#pictureOf(picture));
  }

  /**
   * Prepares a picture for quick updates while curves of a layer move together. The first update then takes no longer
   * than the next ones. The picture must show the present document.
   * @param {readonly number[]} curves
   */
  expectDrag(picture, layer, curves) {
    const solved = this.#pictureOf(picture);
    this.library.withBytes(new Uint32Array(curves), (list) =>
      this.run("sfumato_expect_drag", solved, layer, list, curves.length),
    );
  }

  /**
   * Renders a picture.
   * @param {SfumatoPicture} picture
   * @param {{width: number, height: number, format?: string}} image format: rgb8, rgba8 (as in ImageData), rgb16 or
   *   rgba16
   * @param {Options} options of sfumato_raster
   * @returns {Uint8ClampedArray | Uint16Array} rows from the top, alpha not premultiplied
   */
  raster(picture, { width, height, format = "rgba8" }, options = null) {
    const solved = this.#pictureOf(picture);
    if (!Number.isFinite(width) || !Number.isFinite(height)) {
      throw new TypeError("expected a width and a height");
    }
    if (!(Number.isInteger(width) && Number.isInteger(height) && Math.min(width, height) > 0)) {
      throw new RangeError("expected whole numbers from 1 as width and height");
    }
    const index = formats.indexOf(format);
    if (index < 0) throw new RangeError(`expected a format of ${formats.join(", ")}`);
    const is16 = index >= 2;
    const rowBytes = width * (channels[format]) * (is16 ? 2 : 1);
    const pixels = this.library.allocate(rowBytes * height);
    try {
      const image = new Uint32Array([pixels, rowBytes, width, height, index]);
      this.library.withBytes(image, (struct) =>
        this.#withOptions(options, (text) =>
          this.run("sfumato_raster", solved, struct, text),
        ),
      );
      const { buffer } = this.library.bytes(pixels, rowBytes * height).slice();
      return is16 ? new Uint16Array(buffer) : new Uint8ClampedArray(buffer);
    } finally {
      this.library.call("sfumato_free", pixels);
    }
  }

  /** Returns a picture as an exact file, which `sfumato render` also reads (docs/picture-file.md). */
  writePicture(picture) {
    return this.library.takeBytes(this.make("sfumato_picture_write", this.#pictureOf(picture)));
  }

  /**
   * Reads a picture from the bytes of such a file. It draws the same as the original and belongs to no document.
   */
  readPicture(bytes) {
    return this.library.withBytes(
      bytes,
      (address, count) =>
        new SfumatoPicture(this, this.make("sfumato_picture_read", address, count)),
    );
  }

  /**
   * Returns a picture as a file. The editor's module makes PDF and SVG, the package's module all formats below
   * (docs/npm.md). Other formats throw Status.unavailable.
   * @param {SfumatoPicture} picture
   * @param {string} format png, svg, pdf, eps, glb, html, npz, ply or json
   * @param {Options} options of sfumato_export
   * @returns {Uint8Array}
   */
  export(picture, format, options = null) {
    return this.library.withString(String(format), (name) =>
      this.#withOptions(options, (text) => {
        const asked = [this.#pictureOf(picture), name, text];
        return this.library.takeBytes(this.make("sfumato_export", ...asked));
      }),
    );
  }

  /** Returns the data for PictureReader of web/viewer. @param {Options} options background */
  viewerPayload(picture, options = null) {
    return this.#withOptions(options, (text) =>
      this.library.takeBytes(this.make("sfumato_viewer_payload", this.#pictureOf(picture), text)),
    );
  }

  /**
   * Returns the data for readStack() of web/viewer: a picture whose layers have no tables. The tables are available
   * from picture.table(). @param options background
   */
  pictureStack(picture, options = null) {
    return this.#withOptions(options, (text) =>
      this.library.takeBytes(this.make("sfumato_picture_stack", this.#pictureOf(picture), text)),
    );
  }

  /**
   * Returns the data for readExactLayer() of web/viewer: a layer's curves as rays meet them. The picture must come
   * from a solve, not from a file.
   */
  exactLayer(picture, layer) {
    expectIndices(layer);
    return this.library.takeBytes(this.make("sfumato_exact_layer", this.#pictureOf(picture), layer));
  }

  /**
   * Returns probable mistakes: {file, hints, hint_count}, in the form of `sfumato lint --json`.
   * @param {Options} options verbose
   */
  lint(document, options = null) {
    return this.#withOptions(options, (text) => {
      const json = this.library.takeBytes(this.make("sfumato_lint", this.#documentOf(document), text));
      return JSON.parse(new TextDecoder().decode(json));
    });
  }

  /** Returns a layer's exact colours at points. @param {Options} options of sfumato_field_new */
  field(document, layer, options = null) {
    return this.#withOptions(options, (text) => {
      const field = this.make("sfumato_field_new", this.#documentOf(document), layer, text);
      return new SfumatoField(this, field);
    });
  }

  /**
   * Call it within onProgress: ends the running call, and later ones until resume(), with Status.cancelled. From
   * outside, a module that works cannot be reached: end its worker.
   */
  cancel() {
    this.library.call("sfumato_cancel", this.address);
  }

  resume() {
    this.library.call("sfumato_resume", this.address);
  }

  #documentOf(given) {
    return addressOf(given, SfumatoDocument, this.library);
  }

  #pictureOf(given) {
    return addressOf(given, SfumatoPicture, this.library);
  }

  #withOptions(options, body) {
    return this.library.withString(optionText(options), body);
  }

  /** For this folder: makes a call with this context and throws if its code is an error. */
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

  /** For this folder: the same for a call whose last parameter receives a handle. */
  make(name, ...values) {
    const out = this.library.scratch();
    this.run(name, ...values, out);
    return this.library.u32(out);
  }

  /** For Sfumato: the module reports progress. An exception of onProgress ends the call, which throws it. */
  progressed(stage, fraction) {
    try {
      this.onProgress?.(stage, fraction);
    } catch (error) {
      this.cancel();
      throw error;
    }
  }

  /** For Sfumato: a trace reports a round. An exception of onRound ends the trace, which throws it. */
  traced(state, address) {
    const data = this.library.data();
    const told = {
      psnr: data.getFloat64(state, true),
      seconds: data.getFloat64(state + 8, true),
    };
    ["round", "roundCount", "curves", "controlPoints", "stops"].forEach((name, i) => {
      told[name] = this.library.u32(state + 16 + 4 * i);
    });
    const drawing = new SfumatoDocument(this, address, { isOwn: false });
    try {
      this.#onRound(told, drawing);
    } catch (error) {
      this.cancel();
      throw error;
    } finally {
      drawing.free();
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
