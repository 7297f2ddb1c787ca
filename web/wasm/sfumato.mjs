// Loads sfumato.wasm and gives its C functions (sfumato_wasm.cpp) the shape of a JavaScript library.
// Runs in browsers, workers and node alike.

/// Why a document could not be diffused; the message is the library's own.
export class SfumatoError extends Error {}

const unsupported = 52; // WASI's ENOSYS

/// What the module's C library asks of its host: a clock. Everything else is refused.
function hostOf(module, memoryOf) {
  const host = {
    clock_time_get(clock, precision, address) {
      const nanoseconds = BigInt(Math.round(performance.now() * 1e6));
      new DataView(memoryOf().buffer).setBigUint64(address, nanoseconds, true);
      return 0;
    },
    proc_exit(code) {
      throw new SfumatoError(`the module ended itself with code ${code}`);
    },
  };
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = host[name] ?? (() => unsupported);
  }
  return imports;
}

/// bytes: the content of sfumato.wasm. One instance computes one thing at a time.
export async function loadSfumato(bytes) {
  const module = await WebAssembly.compile(bytes);
  let exports;
  ({ exports } = await WebAssembly.instantiate(module, hostOf(module, () => exports.memory)));
  exports._initialize();
  return new Sfumato(exports);
}

class Sfumato {
  #exports;

  constructor(exports) {
    this.#exports = exports;
  }

  /// The node values of a document (bytes: SVG without images, or Orzan's XML), as diffuse() stores
  /// them (a copy): layer by layer, those of colour, then those of opacity.
  /// maxError: DiffuseOptions::max_error. Throws SfumatoError.
  nodeValues(document, maxError = 1) {
    const library = this.#exports;
    const text = library.sfumato_allocate(document.length);
    if (text === 0) throw new SfumatoError("no memory for the document");
    new Uint8Array(library.memory.buffer, text, document.length).set(document);
    const failed = library.sfumato_diffuse(text, document.length, maxError);
    library.sfumato_free(text);
    if (failed) throw new SfumatoError(this.#stringAt(library.sfumato_error()));
    const count = library.sfumato_node_value_count();
    return new Float32Array(library.memory.buffer, library.sfumato_node_values(), count).slice();
  }

  #stringAt(address) {
    const memory = new Uint8Array(this.#exports.memory.buffer);
    return new TextDecoder().decode(memory.subarray(address, memory.indexOf(0, address)));
  }
}
