// Pictures by address: fetched, solved if they are drawings, and shared by all elements that show them.
import { PictureReader } from "../../../../web/viewer/payload.js";
import { SfumatoError, Status } from "../../../../web/wasm/error.mjs";
import { fetched, isWebPage, shortAddress } from "../places.js";
import { solve } from "./pool.js";

/** @import { Picture } from "../../../../web/viewer/payload.js" */
/** @import { Addresses } from "./start-worker.js" */

/**
 * @typedef {object} Wish
 * @property {string} address
 * @property {string | null} maxError as the attribute has it
 * @property {string | null} maxTime as the attribute has it
 * @property {boolean} imports whether to convert an ordinary SVG
 */

/** @typedef {{picture: Picture, warnings: readonly string[]}} Shown */
/** @typedef {{isNear: boolean}} User */

/** Number of warnings that a message lists. */
const MOST_LINES = 10;

/** Matches the warning that the reader gives if nothing in a drawing is visible. */
const empty = /the picture is empty/;

/**
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {"gzip" | "deflate"} format
 * @param {string} file
 */
async function unpacked(bytes, format, file) {
  try {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(format));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch (cause) {
    throw new SfumatoError(Status.badInput, `the ${format} data is damaged`, { file }, { cause });
  }
}

const startsWith = (/** @type {Uint8Array} */ bytes, /** @type {number[]} */ ...start) =>
  start.every((byte, i) => bytes[i] === byte);

/**
 * @param {string} address
 * @param {AbortSignal} signal
 */
async function bytesAt(address, signal) {
  const answer = await fetched(address, { signal });
  const bytes = new Uint8Array(await answer.arrayBuffer());
  if (startsWith(bytes, 0x1f, 0x8b)) return unpacked(bytes, "gzip", shortAddress(address));
  if (startsWith(bytes, 0x78)) return unpacked(bytes, "deflate", shortAddress(address));
  return bytes;
}

/** Returns the name of a file, for messages. @param {string} address */
function nameOf(address) {
  const { protocol, pathname } = new URL(address);
  if (!/^(https?|file):$/.test(protocol)) return shortAddress(address);
  const name = pathname.split("/").pop() || address;
  try {
    return decodeURIComponent(name);
  } catch {
    return name; // it has a bare per cent sign
  }
}

/**
 * @param {Uint8Array} payload
 * @param {string} file
 * @returns {Promise<Picture>}
 */
async function pictureIn(payload, file) {
  try {
    return await new PictureReader(payload).run();
  } catch (cause) {
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new SfumatoError(Status.badInput, reason, { file }, { cause });
  }
}

/**
 * @param {Wish} wish
 * @param {Addresses} addresses
 * @param {{signal: AbortSignal, isNear: () => boolean}} how
 * @returns {Promise<Shown>}
 */
async function made({ address, maxError, maxTime, imports }, addresses, how) {
  const file = shortAddress(address);
  const bytes = await bytesAt(address, how.signal);
  if (isWebPage(bytes)) {
    const reason = "the server has answered with a web page, expected a drawing";
    throw new SfumatoError(Status.badInput, reason, { file });
  }
  if (new TextDecoder().decode(bytes.subarray(0, 7)) === "SFUMATO") {
    return { picture: await pictureIn(bytes, file), warnings: [] };
  }
  const request = {
    bytes,
    name: nameOf(address),
    base: address,
    limits: /** @type {Record<string, string>} */ (maxTime === null ? {} : { "max-time": maxTime }),
    options: /** @type {Record<string, string>} */ (maxError === null ? {} : { "max-error": maxError }),
    wasm: addresses.wasm && new URL(addresses.wasm, document.baseURI).href,
  };
  const ways = imports ? [false, true] : [false];
  /** @type {string[]} */
  let warnings = [];
  for (const way of ways) {
    const solved = await solve({ ...request, imports: way }, addresses, how);
    const picture = await pictureIn(solved.payload, file);
    ({ warnings } = solved);
    if (picture.stack.length > 0 && !warnings.some((words) => empty.test(words))) return { picture, warnings };
  }
  throw new SfumatoError(Status.badInput, reasonOf(warnings, imports), { file });
}

/**
 * Says why a picture is empty: the main reason first, then others.
 * @param {string[]} warnings
 * @param {boolean} imports
 */
function reasonOf(warnings, imports) {
  const lines = [...warnings.filter((words) => empty.test(words)), ...warnings.filter((words) => !empty.test(words))];
  const said = lines.length > 0 ? listed(lines) : "the picture is empty";
  return imports ? said : `${said}\nTo show an ordinary SVG, use <img>, or the attribute \`import\`.`;
}

/** @param {readonly string[]} lines */
const listed = (lines) =>
  [...lines.slice(0, MOST_LINES), ...(lines.length > MOST_LINES ? [`… and ${lines.length - MOST_LINES} more`] : [])].join("\n");

/** A picture that elements load or show. */
class Entry {
  /** @type {Set<User>} */
  users = new Set();
  #controller = new AbortController();

  /**
   * @param {string} key
   * @param {Wish} wish
   * @param {Addresses} addresses
   */
  constructor(key, wish, addresses) {
    this.key = key;
    const isNear = () => [...this.users].some((user) => user.isNear);
    this.shown = made(wish, addresses, { signal: this.#controller.signal, isNear });
    this.shown.then(({ warnings }) => {
      if (warnings.length > 0) console.warn(`<sfumato-picture>: ${listed(warnings)}`);
    }, () => this.#forget());
  }

  /** @param {User} user */
  release(user) {
    if (!this.users.delete(user) || this.users.size > 0) return;
    this.#forget();
    this.#controller.abort();
  }

  #forget() {
    if (entries.get(this.key) === this) entries.delete(this.key);
  }
}

/** @type {Map<string, Entry>} */
const entries = new Map();

/**
 * Returns the entry of a picture, which the user releases later. Without users a load is cancelled.
 * @param {Wish} wish
 * @param {Addresses} addresses
 * @param {User} user
 */
export function shared(wish, addresses, user) {
  const key = JSON.stringify(wish);
  const entry = entries.get(key) ?? new Entry(key, wish, addresses);
  entries.set(key, entry);
  entry.users.add(user);
  return entry;
}
