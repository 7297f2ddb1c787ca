// Contexts of the library: sfumato.mjs has all of it.
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
 * What a trace has reached: decibels to the picture, seconds since the beginning, and how much there is.
 * @typedef {{psnr: number, seconds: number, round: number, roundCount: number, curves: number,
 *   controlPoints: number, stops: number}} TraceState
 */

const channels = { rgb8: 3, rgba8: 4, rgb16: 3, rgba16: 4 };
const formats = Object.keys(channels);

function expectBytes(given) {
  if (given instanceof Uint8Array || given instanceof Uint8ClampedArray) return given;
  throw new TypeError("expected bytes: a Uint8Array or, of pixels, a Uint8ClampedArray");
}

/** Bounds on memory and time; reads, solves and draws. */
export class SfumatoContext extends Handle {
  /** Called with a word and a fraction from 0 to 1 while a call works; it may call cancel(). */
  onProgress = null;
  #callbacks;
  #freed;
  #loader = null;
  #onRound = null;

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
    const bytes = typeof text === "string" ? new TextEncoder().encode(text) : expectBytes(text);
    if (typeof name !== "string") throw new TypeError("expected a name that is a string");
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
    library.withBytes(expectBytes(file), (...bytes) => {
      if (!image) return this.run("sfumato_add_image", ...bytes, 0);
      return this.#withImage(image, (struct) => this.run("sfumato_add_image", ...bytes, struct));
    });
  }

  /** Runs body() with a sfumato_image of RGBA as ImageData has it. */
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

  /**
   * Makes a drawing of a picture: curves along its edges, whose colours and blur are fitted.
   * @param {{width: number, height: number, data: Uint8Array | Uint8ClampedArray}} image RGBA, not
   *   premultiplied, as ImageData has it
   * @param {Options} options of sfumato_trace: points or detail, smooth, stops, blur, …
   * @param {((state: TraceState, drawing: SfumatoDocument) => void) | null} onRound told after each
   *   round what was reached; the drawing is there until it returns; it may call cancel()
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
   * A copy of a document whose curves have the colours of a picture over its artboard.
   * @param {SfumatoDocument} document
   * @param {{width: number, height: number, data: Uint8Array | Uint8ClampedArray}} image as of trace()
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

  /** A sfumato_trace_watch that tells this context's; 0 where there is none. */
  #withWatch(body) {
    if (!this.#onRound) return body(0);
    const struct = new Uint32Array([this.#callbacks.traced, this.#callbacks.number]);
    return this.library.withBytes(struct, (watch) => body(watch));
  }

  /** @param {Options} options of sfumato_solve: max-error, width, drags (for pictures of an editor), … */
  solve(document, options = null) {
    return this.#withOptions(options, (text) => {
      return new SfumatoPicture(this, this.make("sfumato_solve", this.#documentOf(document), text));
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
    const [drawn, solved] = [this.#documentOf(document), this.#pictureOf(picture)];
    if (seconds !== undefined) this.run("sfumato_solve_within", drawn, seconds, solved);
    else this.run("sfumato_solve_again", drawn, quick ? 1 : 0, solved);
  }

  /**
   * Makes a picture that of the next frame of a film: of one that was solved with `coherent`.
   * picture.statistics says how its layers were made: keptLayers, continuedLayers, begunLayers.
   */
  solveNext(document, picture) {
    this.run("sfumato_solve_next", this.#documentOf(document), this.#pictureOf(picture));
  }

  /**
   * Prepares a picture of a document as it is for quick ones in which this curve moves: the first of
   * them comes as soon as the others.
   */
  expectDrag(picture, layer, curve) {
    this.run("sfumato_expect_drag", this.#pictureOf(picture), layer, curve);
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

  /** A picture as a file, exactly: `sfumato render` reads it, too (docs/picture-file.md). */
  writePicture(picture) {
    return this.library.takeBytes(this.make("sfumato_picture_write", this.#pictureOf(picture)));
  }

  /**
   * A picture from the bytes of such a file. It draws what the other one does, and follows no
   * document.
   */
  readPicture(bytes) {
    return this.library.withBytes(
      bytes,
      (address, count) =>
        new SfumatoPicture(this, this.make("sfumato_picture_read", address, count)),
    );
  }

  /**
   * A picture as a file. Only a module with exporters makes them (docs/npm.md); the others throw
   * Status.unavailable.
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

  /** What web/viewer's PictureReader reads. @param {Options} options background */
  viewerPayload(picture, options = null) {
    return this.#withOptions(options, (text) =>
      this.library.takeBytes(this.make("sfumato_viewer_payload", this.#pictureOf(picture), text)),
    );
  }

  /**
   * What web/viewer's readStack() reads: a picture whose layers have no tables; these are the
   * picture's table(). @param options background
   */
  pictureStack(picture, options = null) {
    return this.#withOptions(options, (text) =>
      this.library.takeBytes(this.make("sfumato_picture_stack", this.#pictureOf(picture), text)),
    );
  }

  /**
   * What web/viewer's readExactLayer() reads: a layer's curves as rays meet them. Of a picture that was
   * solved, not read.
   */
  exactLayer(picture, layer) {
    expectIndices(layer);
    return this.library.takeBytes(this.make("sfumato_exact_layer", this.#pictureOf(picture), layer));
  }

  /**
   * Looks for probable mistakes: {file, hints, hint_count}, as `sfumato lint --json` prints it.
   * @param {Options} options verbose
   */
  lint(document, options = null) {
    return this.#withOptions(options, (text) => {
      const json = this.library.takeBytes(this.make("sfumato_lint", this.#documentOf(document), text));
      return JSON.parse(new TextDecoder().decode(json));
    });
  }

  /** A layer's exact colours at points. @param {Options} options of sfumato_field_new */
  field(document, layer, options = null) {
    return this.#withOptions(options, (text) => {
      const field = this.make("sfumato_field_new", this.#documentOf(document), layer, text);
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

  #documentOf(given) {
    return addressOf(given, SfumatoDocument, this.library);
  }

  #pictureOf(given) {
    return addressOf(given, SfumatoPicture, this.library);
  }

  #withOptions(options, body) {
    return this.library.withString(optionText(options), body);
  }

  /** For the files here: a call with this context, whose code becomes an error. */
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

  /** For the files here: the same with a last parameter that receives a handle. */
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

  /** For Sfumato: a trace tells of a round. What is thrown ends the trace, and is its error. */
  traced(state, address) {
    const data = this.library.data();
    const told = {
      psnr: data.getFloat64(state, true),
      seconds: data.getFloat64(state + 8, true),
    };
    ["round", "roundCount", "curves", "controlPoints", "stops"].forEach((name, i) => {
      told[name] = this.library.u32(state + 16 + 4 * i);
    });
    const drawing = new SfumatoDocument(this, address, false);
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
