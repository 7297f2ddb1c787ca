// Sfumato for JavaScript: the C interface (include/sfumato/sfumato.h, docs/c-api.md) with strings, typed arrays and
// exceptions instead of pointers and codes. docs/wasm.md has an example.
//
// Each object from `load`, a context or a document is released by its own free(). All arrays
// are copies, except the results of tableView(). A call that fails throws a SfumatoError.
import { SfumatoContext } from "./context.mjs";
import { Library, optionText, SfumatoError, Status } from "./library.mjs";

export { SfumatoContext } from "./context.mjs";
export { Attribute, Kind, SfumatoDocument, Side, Space } from "./document.mjs";
export { SfumatoField, SfumatoPicture, Table } from "./picture.mjs";
export { SfumatoError, Status };

/** @import { Options } from "./context.mjs" */

/**
 * Loads the module.
 * @param {BufferSource | WebAssembly.Module} source the content of sfumato.wasm
 */
export async function loadSfumato(source) {
  return new Sfumato(await Library.load(source));
}

/** The library. One instance computes one task at a time; each worker has its own instance. */
export class Sfumato {
  #library;
  #contexts = new Map(); // by the number that callbacks receive
  #next = 1;
  #progress;
  #load;
  #traced;

  constructor(library) {
    this.#library = library;
    this.#progress = library.addFunction("iid>", undefined, (user, stage, fraction) =>
      this.#contexts.get(user).progressed(library.string(stage), fraction),
    );
    this.#load = library.addFunction("iiii>i", 1, (user, href, deliver, sink) =>
      this.#contexts.get(user).loaded(library.string(href), deliver, sink),
    );
    this.#traced = library.addFunction("iii>", undefined, (user, state, drawing) =>
      this.#contexts.get(user).traced(state, drawing),
    );
  }

  get version() {
    return this.#library.string(this.#library.call("sfumato_version"));
  }

  get abi() {
    return this.#library.call("sfumato_abi");
  }

  /** Whether a trap, usually for lack of memory, has ended the module. Then load it again. */
  get isBroken() {
    return this.#library.isBroken;
  }

  /** The module's memory in bytes; it grows and never shrinks. */
  get memoryBytes() {
    return this.#library.memoryBytes;
  }

  /** Creates a context. @param {Options} options threads, max-memory, max-time, limit.NAME */
  context(options = null) {
    const number = this.#next++;
    const callbacks = {
      number,
      progress: this.#progress,
      load: this.#load,
      traced: this.#traced,
    };
    const context = new SfumatoContext(this.#library, optionText(options), callbacks, () =>
      this.#contexts.delete(number),
    );
    this.#contexts.set(number, context);
    return context;
  }
}
