// The errors of the library. The npm package holds this file once, so that all its parts throw the same class.

/** Error codes, as in `enum sfumato_status_code` of sfumato.h. */
export const Status = Object.freeze({
  ok: 0,
  badInput: 1,
  limit: 2,
  cancelled: 3,
  io: 4,
  outOfMemory: 5,
  unavailable: 6,
  internal: 7,
  badUsage: 8,
});

/** Explains why a call failed. `message` is the full text; `reason` is the library's text without the place. */
export class SfumatoError extends Error {
  /**
   * @param {number} code of Status
   * @param {string} reason
   * @param {{file?: string, line?: number, column?: number}} place line and column from 1, column
   *   in bytes; 0 where unknown
   * @param {ErrorOptions} [options]
   */
  constructor(code, reason, { file = "", line = 0, column = 0 } = {}, options) {
    const numbers = line > 0 ? [line, ...(column > 0 ? [column] : [])] : [];
    const place = [...(file || line > 0 ? [file] : []), ...numbers].join(":");
    super(place ? `${place}: ${reason}` : reason, options);
    this.name = "SfumatoError";
    Object.assign(this, { code, reason, file, line, column });
  }
}
