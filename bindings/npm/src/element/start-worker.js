// Starts a worker, under the rules that a page's policies and its origin make.
import { SfumatoError, Status } from "../../../../web/wasm/error.mjs";
import { besideScript } from "../places.js";

/**
 * Addresses of the worker and of its module, if they are not beside this script. A page with Trusted Types sets a
 * TrustedScriptURL.
 * @typedef {{worker: string | URL | null, wasm: string | URL | null}} Addresses
 */

/** @type {WorkerOptions} */
const asModule = { type: "module" };

/** A document in a sandbox has the origin "null", whatever its address says. @param {string | URL} address */
const isOwn = (address) => !/^https?:/.test(String(address)) || new URL(address).origin === self.origin;

/** By the address of another site. @type {Map<string, string>} */
const importers = new Map();

/**
 * Browsers start no worker from another site, but a worker of this page may import one.
 * @param {string} address absolute
 */
function ownAddress(address) {
  if (isOwn(address)) return address;
  const text = `import ${JSON.stringify(address)};`;
  // A document without an origin may not use blob: addresses for this.
  if (self.origin === "null") return `data:text/javascript,${encodeURIComponent(text)}`;
  const made = importers.get(address) ??
    URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
  importers.set(address, made);
  return made;
}

/** The interface of Trusted Types, which TypeScript does not know. @type {any} */
const trust = globalThis;
/** @type {any} */
let policy = null;

/** @param {string} address absolute */
function startAt(address) {
  const own = ownAddress(address);
  try {
    return new Worker(own, asModule);
  } catch (cause) {
    if (!(cause instanceof TypeError) || !trust.trustedTypes) throw cause;
    try {
      policy ??= trust.trustedTypes.createPolicy("sfumato", { createScriptURL: (/** @type {string} */ text) => text });
    } catch {
      const reason = "Trusted Types refuse the script that solves drawings: set SfumatoPicture.workerUrl to a TrustedScriptURL, or allow the policy `sfumato`";
      throw new SfumatoError(Status.unavailable, reason, { file: address }, { cause });
    }
    return new Worker(policy.createScriptURL(own), asModule);
  }
}

/** Starts the worker beside this script. Bundlers look for the last line. */
function startOwn() {
  const script = import.meta.url;
  const moved = besideScript(script, "worker.js");
  if (moved) return startAt(moved);
  if (!script) {
    const reason = "this bundle does not know where worker.js is: set SfumatoPicture.workerUrl";
    throw new SfumatoError(Status.unavailable, reason);
  }
  if (!isOwn(script)) return startAt(script.replace(/[^/]*$/, "worker.js"));
  try {
    return new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
  } catch (error) {
    // Trusted Types refuse it. The name is another one in a bundle, whose page then sets workerUrl.
    if (error instanceof TypeError && trust.trustedTypes) return startAt(script.replace(/[^/]*$/, "worker.js"));
    throw error;
  }
}

/**
 * @param {Addresses} addresses
 * @returns {Worker}
 */
export function startWorker({ worker: given }) {
  if (given === null) return startOwn();
  const isTrusted = trust.TrustedScriptURL && given instanceof trust.TrustedScriptURL;
  if (isTrusted) return new Worker(given, asModule);
  return startAt(new URL(given, document.baseURI).href);
}
