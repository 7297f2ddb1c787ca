// The module's memory, strings and functions, which sfumato.mjs builds on. Runs in browsers, workers and Node.

import { SfumatoError, Status } from "./error.mjs";

export { SfumatoError, Status };

const refused = 52; // WASI's ENOSYS
const scratchBytes = 64;

/** Returns the functions that the module's C library needs from its host: a clock. Everything else is refused. */
function hostOf(module, memoryOf) {
  const host = {
    clock_time_get(clock, precision, address) {
      const nanoseconds = BigInt(Math.round(performance.now() * 1e6));
      new DataView(memoryOf().buffer).setBigUint64(address, nanoseconds, true);
      return 0;
    },
  };
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = host[name] ?? (() => refused);
  }
  return imports;
}

/**
 * Returns a JavaScript function as a WebAssembly function, because a table holds only such functions. A module of
 * 40 bytes imports the function and exports it again.
 * @param {string} signature parameters, ">" and results; i: i32, d: f64
 */
function asWasmFunction(signature, body) {
  const [parameters, results] = signature
    .split(">")
    .map((types) => [...types].map((type) => (type === "d" ? 0x7c : 0x7f)));
  const type = [1, 0x60, parameters.length, ...parameters, results.length, ...results];
  const sections = [
    [1, type.length, ...type],
    [2, 7, 1, 1, 0x65, 1, 0x66, 0, 0], // imports function e.f of type 0
    [7, 5, 1, 1, 0x66, 0, 0], // exports it as f
  ];
  const bytes = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, ...sections.flat()]);
  return new WebAssembly.Instance(new WebAssembly.Module(bytes), { e: { f: body } }).exports.f;
}

/** An instance of the module. It computes one thing at a time. */
export class Library {
  #exports;
  #scratch;
  #broken = null;
  #thrown = null;
  #depth = 0; // of calls that callbacks make within a call

  /** @param {BufferSource | WebAssembly.Module} source */
  static async load(source) {
    const module =
      source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
    let exports;
    ({ exports } = await WebAssembly.instantiate(module, hostOf(module, () => exports.memory)));
    exports._initialize();
    return new Library(exports);
  }

  constructor(exports) {
    this.#exports = exports;
    this.#scratch = this.allocate(scratchBytes);
  }

  /** Whether a trap has ended the module; then every call throws. */
  get isBroken() {
    return this.#broken !== null;
  }

  get memoryBytes() {
    return this.#exports.memory.buffer.byteLength;
  }

  /** Returns 64 zeroed bytes for the result of a call. The next use overwrites them. */
  scratch() {
    this.bytes(this.#scratch, scratchBytes).fill(0);
    return this.#scratch;
  }

  /**
   * Calls a function of the C interface. An exception of a JavaScript function that it called could not pass
   * through the module; this call throws it instead. A trap, for example for lack of memory or a stack overflow,
   * makes the instance unusable.
   */
  call(name, ...values) {
    return this.number(name, ...values) >>> 0; // addresses above 2 GiB are not negative
  }

  /** The same for a function that returns a double. */
  number(name, ...values) {
    if (this.#broken) throw this.#end(this.#broken);
    if (!this.#exports[name]) {
      throw new SfumatoError(Status.unavailable, `this module is without ${name}`);
    }
    ++this.#depth;
    let result;
    try {
      result = this.#exports[name](...values);
    } catch (error) {
      const isTrap = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
      if (!isTrap) throw error;
      this.#broken = error;
      throw this.#end(error);
    } finally {
      --this.#depth;
    }
    const thrown = this.#thrown;
    if (this.#depth > 0 || !thrown) return result;
    this.#thrown = null;
    throw thrown.error;
  }

  #end(cause) {
    const reason = `the module has ended (${cause.message}), likely out of memory; load it anew`;
    return new SfumatoError(Status.outOfMemory, reason, {}, { cause });
  }

  /**
   * Adds a function to the module's table. An exception that it throws is kept until the end of the call.
   * @returns {number} the address of the function in C
   */
  addFunction(signature, instead, body) {
    const table = this.#exports.__indirect_function_table;
    const guarded = (...values) => {
      try {
        return body(...values);
      } catch (error) {
        this.#thrown ??= { error };
        return instead;
      }
    };
    const index = table.grow(1);
    table.set(index, asWasmFunction(signature, guarded));
    return index;
  }

  /** Calls a C function by its address. */
  callAddress(address, ...values) {
    return this.#exports.__indirect_function_table.get(address)(...values);
  }

  /** Returns memory, which call("sfumato_free", address) releases. */
  allocate(byteCount) {
    // A number above 32 bits would be truncated.
    if (!(byteCount < 2 ** 32)) throw new SfumatoError(Status.outOfMemory, "out of memory");
    const address = this.#exports.sfumato_allocate(Math.max(byteCount, 1)) >>> 0;
    if (address === 0) throw new SfumatoError(Status.outOfMemory, "out of memory");
    return address;
  }

  /** Calls body(address, byteCount) with a copy of `bytes` in the module's memory. */
  withBytes(bytes, body) {
    const address = this.allocate(bytes.byteLength);
    try {
      this.bytes(address, bytes.byteLength).set(
        new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength),
      );
      return body(address, bytes.byteLength);
    } finally {
      this.#exports.sfumato_free(address);
    }
  }

  /** The same with a string: UTF-8 that ends with 0. The address of null is 0. */
  withString(text, body) {
    if (text === null) return body(0);
    return this.withBytes(new TextEncoder().encode(`${text}\0`), (address) => body(address));
  }

  /** Returns a view of the memory, valid until the next call. */
  bytes(address, byteCount) {
    return new Uint8Array(this.#exports.memory.buffer, address, byteCount);
  }

  data() {
    return new DataView(this.#exports.memory.buffer);
  }

  /** Returns the string at an address; null at address 0. */
  string(address) {
    if (address === 0) return null;
    const begin = address >>> 0;
    const memory = new Uint8Array(this.#exports.memory.buffer);
    return new TextDecoder().decode(memory.subarray(begin, memory.indexOf(0, begin)));
  }

  u32(address) {
    return this.data().getUint32(address, true);
  }

  /** Returns a copy of `count` doubles at an address. */
  doubles(address, count) {
    return new Float64Array(this.bytes(address, 8 * count).slice().buffer);
  }

  /** Returns the content of a sfumato_bytes and releases it. */
  takeBytes(handle) {
    const count = this.call("sfumato_bytes_size", handle);
    const copy = this.bytes(this.call("sfumato_bytes_data", handle), count).slice();
    this.call("sfumato_bytes_free", handle);
    return copy;
  }

  /**
   * Returns the table of the sfumato_view at `address`, as a view of the memory that is valid until the next call.
   */
  table(address) {
    const data = this.data();
    const [start, rows, , columns, type] = [0, 4, 8, 12, 16].map((at) =>
      data.getUint32(address + at, true),
    );
    const Numbers = { 1: Uint8Array, 2: Uint32Array, 3: Float32Array, 4: Float64Array }[type];
    return { rows, columns, data: new Numbers(data.buffer, start, rows * columns) };
  }
}

/**
 * Returns options in the form of the C interface. A string stays as it is. The keys of an object are the long
 * options of the command, or the same in camel case (maxError). `true` sets a flag; `false`, null and undefined
 * leave an option out.
 */
export function optionText(options) {
  if (options === null || options === undefined) return null;
  if (typeof options === "string") return options;
  if (typeof options !== "object") throw new TypeError("expected options as an object or a string");
  return Object.entries(options)
    .filter(([, value]) => value !== false && value !== null && value !== undefined)
    .map(([key, value]) => [key.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`), value])
    .map(([key, value]) => (value === true ? key : `${key}=${quoted(String(value))}`))
    .join(" ");
}

function quoted(value) {
  return /^[^\s"\\]+$/.test(value) ? value : `"${value.replace(/["\\]/g, "\\$&")}"`;
}
