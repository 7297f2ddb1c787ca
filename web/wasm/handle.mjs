// The common base of the library's objects; sfumato.mjs has the overview.
import { SfumatoError, Status } from "./library.mjs";

/** Releases objects that were garbage collected. */
const forgotten = new FinalizationRegistry(({ library, kind, address }) => {
  if (!library.isBroken) library.call(`sfumato_${kind}_free`, address);
});

/**
 * A handle of an object of the library. free() releases the object; otherwise garbage collection releases it later.
 * A second free() does nothing.
 */
export class Handle {
  #library;
  #address;
  #kind;
  #isOwn;

  /** @param isOwn false: the library owns the object, and free() only drops the handle */
  constructor(library, kind, address, isOwn = true) {
    this.#library = library;
    this.#kind = kind;
    this.#address = address;
    this.#isOwn = isOwn;
    if (isOwn) forgotten.register(this, { library, kind, address }, this);
  }

  get library() {
    return this.#library;
  }

  /** @throws SfumatoError after free() */
  get address() {
    if (this.#address === 0) throw new SfumatoError(Status.badUsage, `a freed ${this.#kind}`);
    return this.#address;
  }

  free() {
    const address = this.#address;
    this.#address = 0;
    forgotten.unregister(this);
    if (address !== 0 && this.#isOwn) this.#library.call(`sfumato_${this.#kind}_free`, address);
  }
}

// For `using picture = ...`, in languages that have it.
if (Symbol.dispose) {
  Handle.prototype[Symbol.dispose] = function () {
    this.free();
  };
}

/**
 * Returns the address of a handle. Without this check any other value would be taken for an address.
 * @throws TypeError if `given` is not a Kind, or belongs to another instance of the module
 */
export function addressOf(given, Kind, library) {
  if (!(given instanceof Kind)) throw new TypeError(`expected a ${Kind.name}`);
  if (given.library !== library) {
    throw new TypeError(`expected a ${Kind.name} of the same instance of the module`);
  }
  return given.address;
}

/** @throws TypeError if a value is not a whole number from 0 */
export function expectIndices(...values) {
  if (values.every((value) => Number.isInteger(value) && value >= 0 && value < 2 ** 32)) return;
  throw new TypeError("expected whole numbers from 0");
}

/** @throws SfumatoError if a code is not Status.ok */
export function expect(code, complaint) {
  if (code !== Status.ok) throw new SfumatoError(code, complaint);
}

/** Returns four numbers that the library writes. */
export function box(library, name, address) {
  const place = library.scratch();
  library.call(name, address, place);
  return [...library.doubles(place, 4)];
}
