// The element's worker: turns drawings into data for the viewer's scripts, so that the page stays responsive. The
// page gives it one task at a time.
import { loadSfumato, Status } from "../../../web/wasm/sfumato.mjs";
import { compiledFrom } from "./fetch-module.js";
import { addImages } from "./images.js";

/** @import { Sfumato, SfumatoContext } from "../../../web/wasm/sfumato.mjs" */

/** By address. @type {Map<string, Promise<Sfumato>>} */
const loaded = new Map();

/**
 * @typedef {object} Task
 * @property {number} id
 * @property {Uint8Array<ArrayBuffer>} bytes SVG or Orzan's XML
 * @property {string} name for messages
 * @property {string} base address that pictures in it are relative to
 * @property {Record<string, string>} limits of sfumato_context_new
 * @property {Record<string, string>} options of sfumato_solve
 * @property {boolean} imports whether to convert an ordinary SVG
 * @property {string | null} wasm address of the module; null: beside this script
 */

/** Returns the module that reads drawings, or the larger one that also converts ordinary SVG. @param {Task} task */
function moduleFor({ imports, wasm }) {
  const address = wasm ?? (imports
    ? new URL("./sfumato.wasm", import.meta.url)
    : new URL("./sfumato-solver.wasm", import.meta.url)).href;
  let module = loaded.get(address);
  if (!module) {
    module = compiledFrom(address).then(loadSfumato);
    module.catch(() => loaded.delete(address));
    loaded.set(address, module);
  }
  return module;
}

/**
 * @param {SfumatoContext} context
 * @param {Task} task
 */
async function payloadOf(context, { bytes, name, base, options, imports }) {
  /** @type {string[]} */
  const missing = [];
  const files = await addImages(context, bytes, base, (href) => {
    missing.push(`${name}: the image ${JSON.stringify(href.slice(0, 200))} is missing or unreadable, and is left out`);
  });
  const from = { name, load: (/** @type {string} */ href) => files.get(href) ?? null };
  const document = imports ? context.importSvg(bytes, from) : context.read(bytes, from);
  const warnings = [...missing, ...document.warnings];
  const picture = document.solve(options);
  document.free();
  const payload = picture.viewerPayload();
  picture.free();
  return { payload, warnings };
}

/** @param {Task} task */
async function answerOf(task) {
  const sfumato = await moduleFor(task);
  const context = sfumato.context(task.limits);
  try {
    return await payloadOf(context, task);
  } finally {
    if (!sfumato.isBroken) context.free();
  }
}

addEventListener("message", async ({ data: task }) => {
  try {
    const { payload, warnings } = await answerOf(task);
    postMessage({ id: task.id, payload, warnings }, { transfer: [payload.buffer] });
  } catch (error) {
    const { message, code = Status.internal, reason = message, line = 0, column = 0 } = error;
    const file = error.file || task.name;
    // A module's memory only grows. After it runs out of memory, a new worker works better.
    const isSpent = code === Status.outOfMemory;
    postMessage({ id: task.id, error: { code, reason, file, line, column }, isSpent });
  }
});
