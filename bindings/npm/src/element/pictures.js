// Pictures by address: fetched, solved if they are drawings, and shared by all elements that show them.
import { PictureReader } from "../../../../web/viewer/payload.js";
import { solve } from "./solver.js";

/** @import { Picture } from "../../../../web/viewer/payload.js" */
/** @import { Addresses } from "./solver.js" */

/** @type {Map<string, {picture: Promise<Picture>, users: number}>} */
const held = new Map();

/**
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {"gzip" | "deflate"} format
 */
async function unpacked(bytes, format) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(format));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const startsWith = (/** @type {Uint8Array} */ bytes, /** @type {number[]} */ ...start) =>
  start.every((byte, i) => bytes[i] === byte);
const textOf = (/** @type {Uint8Array} */ bytes) => new TextDecoder().decode(bytes.subarray(0, 512)).trimStart();

/** @param {string} address */
async function fetched(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.status} ${answer.statusText}`.trim());
  const bytes = new Uint8Array(await answer.arrayBuffer());
  if (startsWith(bytes, 0x1f, 0x8b)) return unpacked(bytes, "gzip");
  if (startsWith(bytes, 0x78)) return unpacked(bytes, "deflate");
  return bytes;
}

/**
 * @param {string} address
 * @param {Record<string, string>} options of sfumato_solve
 * @param {Addresses} addresses
 */
async function made(address, options, addresses) {
  const bytes = await fetched(address);
  const start = textOf(bytes);
  if (/^<(!doctype html|html)/i.test(start)) {
    throw new Error(`${address}: the server has answered with a web page, expected a drawing`);
  }
  const payload = start.startsWith("SFUMATO") ? bytes : await solve(bytes, address, options, addresses);
  return new PictureReader(payload).run();
}

/** A picture that an element shows, until it is released. */
export class SharedPicture {
  /**
   * @param {string} address
   * @param {string | null} maxError
   * @param {Addresses} addresses
   */
  constructor(address, maxError, addresses) {
    this.key = `${maxError} ${address}`;
    let entry = held.get(this.key);
    if (!entry) {
      /** @type {Record<string, string>} */
      const options = maxError === null ? {} : { "max-error": maxError };
      entry = { picture: made(address, options, addresses), users: 0 };
      entry.picture.catch(() => {});
      held.set(this.key, entry);
    }
    entry.users += 1;
    this.entry = entry;
  }

  /** @returns {Promise<Picture>} */
  get picture() {
    return this.entry.picture;
  }

  release() {
    this.entry.users -= 1;
    if (this.entry.users === 0 && held.get(this.key) === this.entry) held.delete(this.key);
  }
}
