// What the library's objects have in common: sfumato.mjs has all of them.
import { SfumatoError, Status } from "./library.mjs";

/** Gives back what nobody holds any more. */
const forgotten = new FinalizationRegistry(({ library, kind, address }) => {
  if (!library.isBroken) library.call(`sfumato_${kind}_free`, address);
});

/**
 * A handle of the library's, which free() gives back, or some time after nobody holds it the collector;
 * a second time does nothing.
 */
export class Handle {
  #library;
  #address;
  #kind;
  #isOwn;

  /** @param isOwn false: the library's own, which free() only forgets */
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

  /** @throws SfumatoError where it was freed */
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

// `using picture = ...` where the language has it.
if (Symbol.dispose) {
  Handle.prototype[Symbol.dispose] = function () {
    this.free();
  };
}

/**
 * The address of what a caller gives; anything else would be taken for an address all the same.
 * @throws TypeError where it is no Kind, or one of another instance of the module
 */
export function addressOf(given, Kind, library) {
  if (!(given instanceof Kind)) throw new TypeError(`expected a ${Kind.name}`);
  if (given.library !== library) {
    throw new TypeError(`expected a ${Kind.name} of the same instance of the module`);
  }
  return given.address;
}

/** @throws TypeError where one of the values is no whole number from 0 */
export function expectIndices(...values) {
  if (values.every((value) => Number.isInteger(value) && value >= 0 && value < 2 ** 32)) return;
  throw new TypeError("expected whole numbers from 0");
}

/** @throws SfumatoError where a code is not Status.ok */
export function expect(code, complaint) {
  if (code !== Status.ok) throw new SfumatoError(code, complaint);
}

/** Four numbers that the library writes. */
export function box(library, name, address) {
  const place = library.scratch();
  library.call(name, address, place);
  return [...library.doubles(place, 4)];
}
