// Sfumato for JavaScript: the C interface (include/sfumato/sfumato.h, docs/c-api.md) with strings,
// typed arrays and exceptions in the place of pointers and codes. docs/wasm.md has a program.
//
// Whatever `load`, a context or a document hands out is given back by its own free(). All arrays
// are copies, but for tableView(). What a call cannot do it throws as SfumatoError.
import { SfumatoContext } from "./context.mjs";
import { Library, optionText, SfumatoError, Status } from "./library.mjs";

export { SfumatoContext } from "./context.mjs";
export { Attribute, Kind, SfumatoDocument, Side, Space } from "./document.mjs";
export { SfumatoField, SfumatoPicture, Table } from "./picture.mjs";
export { SfumatoError, Status };

/** @import { Options } from "./context.mjs" */

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

  /** Whether a trap, likely out of memory, has ended the module: it is to be loaded anew. */
  get isBroken() {
    return this.#library.isBroken;
  }

  /** Bytes of the module's memory, which grows and never shrinks. */
  get memoryBytes() {
    return this.#library.memoryBytes;
  }

  /** @param {Options} options threads, max-memory, max-time, limit.NAME */
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
