// The page's only worker: turns drawings into data for the viewer's scripts, so that the page stays responsive.
import { loadSfumato, Status } from "../../../web/wasm/sfumato.mjs";
import { compiledFrom } from "./fetch-module.js";
import { addImages } from "./images.js";

/** @type {Promise<import("../../../web/wasm/sfumato.mjs").Sfumato> | null} */
let loaded = null;

/**
 * @typedef {object} Task
 * @property {number} id
 * @property {Uint8Array<ArrayBuffer>} bytes SVG or Orzan's XML
 * @property {string} name for messages
 * @property {string} base address that pictures in it are relative to
 * @property {Record<string, string>} options of sfumato_solve
 * @property {string | null} wasm address of the module; null: beside this script
 */

/** @param {Task} task */
async function payloadOf({ bytes, name, base, options, wasm }) {
  loaded ??= compiledFrom(wasm ?? new URL("./sfumato-solver.wasm", import.meta.url)).then(loadSfumato);
  loaded.catch(() => (loaded = null));
  const context = (await loaded).context();
  try {
    const files = await addImages(context, bytes, base);
    const document = context.read(bytes, { name, load: (href) => files.get(href) ?? null });
    const picture = document.solve(options);
    document.free();
    const payload = picture.viewerPayload();
    picture.free();
    return payload;
  } finally {
    if (!(await loaded).isBroken) context.free();
  }
}

addEventListener("message", async ({ data: task }) => {
  try {
    const payload = await payloadOf(task);
    postMessage({ id: task.id, payload }, { transfer: [payload.buffer] });
  } catch (error) {
    const { message, code = 0, reason = message, file = "", line = 0, column = 0 } = error;
    // A module's memory only grows. After it runs out of memory, a new worker works better.
    const isSpent = code === Status.outOfMemory;
    postMessage({ id: task.id, error: { message, code, reason, file, line, column }, isSpent });
  }
});
