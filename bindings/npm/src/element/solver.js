// The page's only worker. It solves drawings one after another, and ends after some idle time.
import { SfumatoError } from "../../../../web/wasm/library.mjs";

/** Idle time until the worker ends, milliseconds. Ending it frees memory, which a module never shrinks. */
const PATIENCE = 10_000;

/**
 * Addresses of the worker and of its module, if they are not beside this script.
 * @typedef {{worker: string | URL | null, wasm: string | URL | null}} Addresses
 */

/** @typedef {{message: string, code: number, reason: string, file: string, line: number, column: number}} Complaint */

/** @type {Worker | null} */
let worker = null;
let count = 0;
/** @type {Map<number, {resolve: (payload: Uint8Array) => void, reject: (error: Error) => void}>} */
const waiting = new Map();
let bored = 0;

function end() {
  worker?.terminate();
  worker = null;
  for (const { reject } of waiting.values()) reject(new Error("The solver has ended."));
  waiting.clear();
}

/**
 * Browsers start no worker from another site, but a worker of this page may import one.
 * @param {string | URL} address
 */
function ownAddress(address) {
  const url = new URL(address, document.baseURI);
  if (url.origin === location.origin || url.protocol === "blob:") return url;
  const script = new Blob([`import ${JSON.stringify(url.href)};`], { type: "text/javascript" });
  return URL.createObjectURL(script);
}

/** @param {Addresses} addresses */
function start(addresses) {
  // Bundlers look for the second form.
  const made = addresses.worker
    ? new Worker(ownAddress(addresses.worker), { type: "module" })
    : isOwn(import.meta.url)
      ? new Worker(new URL("./worker.js", import.meta.url), { type: "module" })
      : new Worker(ownAddress(import.meta.url.replace(/[^/]*$/, "worker.js")), { type: "module" });
  made.addEventListener("message", ({ data }) => answer(data));
  made.addEventListener("error", (event) => {
    const reason = event.message || "it was refused, or is not there";
    for (const { reject } of waiting.values()) {
      reject(new Error(`The script that solves drawings could not be started: ${reason}.`));
    }
    waiting.clear();
    end();
  });
  return made;
}

const isOwn = (/** @type {string} */ address) => !/^https?:/.test(address) || new URL(address).origin === location.origin;

/** @param {{id: number, payload?: Uint8Array, error?: Complaint, isSpent?: boolean}} told */
function answer({ id, payload, error, isSpent }) {
  const who = waiting.get(id);
  waiting.delete(id);
  if (error) {
    const { code, reason } = error;
    who?.reject(code > 0 ? new SfumatoError(code, reason, error) : new Error(error.message));
  } else if (payload) {
    who?.resolve(payload);
  }
  if (isSpent && waiting.size === 0) end();
  clearTimeout(bored);
  bored = setTimeout(() => waiting.size === 0 && end(), PATIENCE);
}

/**
 * Returns the data that the viewer's scripts draw.
 * @param {Uint8Array<ArrayBuffer>} bytes SVG or Orzan's XML, which goes to the worker
 * @param {string} address address of the drawing, for messages and for pictures beside it
 * @param {Record<string, string>} options of sfumato_solve
 * @param {Addresses} addresses
 * @returns {Promise<Uint8Array>}
 */
export function solve(bytes, address, options, addresses) {
  return new Promise((resolve, reject) => {
    worker ??= start(addresses);
    const id = ++count;
    waiting.set(id, { resolve, reject });
    const { pathname } = new URL(address, location.href);
    const name = decodeURIComponent(pathname.split("/").pop() || "the drawing");
    const wasm = addresses.wasm && new URL(addresses.wasm, document.baseURI).href;
    worker.postMessage({ id, bytes, name, base: address, options, wasm }, [bytes.buffer]);
  });
}
