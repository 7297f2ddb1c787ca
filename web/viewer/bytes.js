// Reads the payload's bytes (docs/viewer.md, "Payload").

/** The payload is damaged; the message tells the reader of the page how. */
export class PayloadError extends Error {}

/** Reads numbers one after another, never beyond the end. */
export class ByteReader {
  /** @param {Uint8Array} bytes */
  constructor(bytes) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.at = 0;
  }

  /**
   * Returns the next `count` bytes, as a view.
   * @param {number} count
   */
  take(count) {
    if (!(count <= this.bytes.length - this.at)) throw new PayloadError("it ends too early");
    this.at += count;
    return this.bytes.subarray(this.at - count, this.at);
  }

  /** Returns all remaining bytes, as a view. */
  rest() {
    return this.take(this.bytes.length - this.at);
  }

  u8() {
    return this.take(1)[0];
  }

  f32() {
    this.take(4);
    return this.view.getFloat32(this.at - 4, true);
  }

  f64() {
    this.take(8);
    return this.view.getFloat64(this.at - 8, true);
  }

  /** Reads a number of seven bits a byte, the lowest first; at most 2^53 - 1. */
  varint() {
    let value = 0;
    for (let factor = 1; ; factor *= 128) {
      const byte = this.u8();
      value += (byte & 127) * factor;
      if (byte < 128) return value;
      if (factor > 2 ** 39) throw new PayloadError("a number in it is too large");
    }
  }

  /**
   * Reads a count of elements that take at least `bytes` bytes each.
   * @param {number} bytes
   */
  count(bytes) {
    const count = this.varint();
    if (count * bytes > this.bytes.length - this.at) throw new PayloadError("it ends too early");
    return count;
  }

  /** Reads a byte count, then so many bytes. */
  counted() {
    return this.take(this.varint());
  }

  /**
   * Reads numbers by planes of their bytes, the lowest plane first.
   * @param {number} count
   * @param {number} byteCount of each number, 1 to 4
   */
  planes(count, byteCount) {
    const planes = this.take(count * byteCount);
    const values = new Uint32Array(count);
    for (let k = 0; k < byteCount; ++k) {
      for (let i = 0; i < count; ++i) values[i] |= planes[k * count + i] << (8 * k);
    }
    return values;
  }

  /**
   * Reads single precision numbers by planes.
   * @param {number} count
   */
  floatPlanes(count) {
    return new Float32Array(this.planes(count, 4).buffer);
  }

  /** Reads a finite number. */
  finite() {
    const value = this.f64();
    if (!Number.isFinite(value)) throw new PayloadError("a number in it is not finite");
    return value;
  }
}

/**
 * Returns 0, -1, 1, -2, … for 0, 1, 2, 3, …
 * @param {number} code
 */
export function unzigzag(code) {
  return (code >>> 1) ^ -(code & 1);
}
