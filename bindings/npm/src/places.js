// Where the package's files are, and how they are fetched. An error names the address.
import { SfumatoError, Status } from "../../../web/wasm/error.mjs";

/** Longest address in a message; a data: address can have megabytes. */
const MOST_LETTERS = 200;

/** A folder within node_modules that begins with a dot is the cache of a tool, such as .vite/deps. */
const cache = /^([^?#]*\/node_modules\/)\.(?!pnpm\/)[^?#]*\/deps[^/?#]*\/[^/]*$/;

/**
 * Returns the address of a file of the package whose script a development server has moved. Vite 5 to 7 put
 * scripts into a cache and leave other files behind.
 * @param {string | undefined} script the script's own address
 * @param {string} name
 * @returns {string | null} null: the script is where the package is
 */
export function besideScript(script, name) {
  const root = cache.exec(script ?? "")?.[1];
  return root === undefined ? null : `${root}sfumato/${name}`;
}

/** @param {string | URL} address */
export const shortAddress = (address) => {
  const text = String(address);
  return text.length > MOST_LETTERS ? `${text.slice(0, MOST_LETTERS)}…` : text;
};

/**
 * @param {string | URL} address
 * @param {RequestInit} [how]
 * @returns {Promise<Response>} an answer that is ok
 */
export async function fetched(address, how = {}) {
  const file = shortAddress(address);
  let answer;
  try {
    answer = await fetch(address, how);
  } catch (cause) {
    if (how.signal?.aborted) throw cause;
    const why = cause instanceof Error ? cause.message : String(cause);
    const reason = `the browser could not fetch it (${why}): the server is unreachable, or does not allow other sites (CORS)`;
    throw new SfumatoError(Status.io, reason, { file }, { cause });
  }
  if (answer.ok) return answer;
  throw new SfumatoError(Status.io, `${answer.status} ${answer.statusText}`.trim(), { file });
}

/** Whether bytes are a web page, which many servers send instead of a missing file. @param {Uint8Array} bytes */
export const isWebPage = (bytes) =>
  /^\s*<(!doctype html|html)/i.test(new TextDecoder().decode(bytes.subarray(0, 512)));
