// What the library's objects have in common: sfumato.mjs has all of them.
import { SfumatoError, Status } from "./library.mjs";

/** A handle of the library's, which free() gives back; a second time does nothing. */
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
    if (address !== 0 && this.#isOwn) this.#library.call(`sfumato_${this.#kind}_free`, address);
  }
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
