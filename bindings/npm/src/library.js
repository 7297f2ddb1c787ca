// Shared by the entry points for Node and for pages: the library of web/wasm, loaded once.
import { loadSfumato } from "../../../web/wasm/sfumato.mjs";

export * from "../../../web/wasm/sfumato.mjs";

/** Whether a source of the module is an address. Bundlers bring a class URL of their own. @param {any} source */
export const isAddress = (source) => typeof source === "string" || typeof source?.href === "string";

/**
 * Returns a drawing as `SfumatoContext.read` takes it. Test environments have several classes Uint8Array, so the
 * result is of this one.
 * @param {any} given
 * @returns {Promise<string | Uint8Array>}
 */
async function drawingOf(given) {
  if (typeof given === "string") return given;
  if (ArrayBuffer.isView(given)) return new Uint8Array(given.buffer, given.byteOffset, given.byteLength);
  if (/^\[object (Shared)?ArrayBuffer\]$/.test(Object.prototype.toString.call(given))) return new Uint8Array(given);
  if (typeof given?.arrayBuffer === "function") return new Uint8Array(await given.arrayBuffer());
  throw new TypeError("expected a drawing: a string, a Uint8Array, an ArrayBuffer or a Blob");
}

/**
 * Returns the functions of the package. The module is loaded at the first call of one of them, and loaded again
 * after a trap has ended it.
 * @param {(source: unknown) => Promise<BufferSource | WebAssembly.Module>} bring returns the module, from its
 *   default place if no source is given
 * @param {(context: import("../../../web/wasm/sfumato.mjs").SfumatoContext, text: string | Uint8Array,
 *   base: string | URL | undefined) => Promise<Map<string, Uint8Array>>} prepare prepares the reading of a text;
 *   returns the files that the text may name
 */
export function packageOver(bring, prepare = async () => new Map()) {
  /** @type {Promise<{sfumato: import("../../../web/wasm/sfumato.mjs").Sfumato, context: any}> | null} */
  let loaded = null;

  const start = async (source) => {
    const sfumato = await loadSfumato(await bring(source));
    return { sfumato, context: sfumato.context() };
  };

  async function instance(source = undefined) {
    if (loaded && (await loaded.catch(() => null))?.sfumato.isBroken !== false) loaded = null;
    loaded ??= start(source);
    return loaded;
  }

  async function prepared(drawing, { name = drawing?.name ?? "", load = null, base = undefined }) {
    const text = await drawingOf(drawing);
    const { context } = await instance();
    const files = await prepare(context, text, base);
    return { context, text, given: { name, load: load ?? ((href) => files.get(href) ?? null) } };
  }

  return {
    async load(source) {
      return (await instance(source)).sfumato;
    },
    async read(drawing, from = {}) {
      const { context, text, given } = await prepared(drawing, from);
      return context.read(text, given);
    },
    async importSvg(drawing, from = {}) {
      const { context, text, given } = await prepared(drawing, from);
      const imported = context.importSvg(text, given);
      return { drawing: imported, warnings: imported.warnings };
    },
    async create(width, height, options = {}) {
      if (!(width > 0 && height > 0)) throw new TypeError("expected a width and a height above 0");
      const { context } = await instance();
      return context.newDocument({ artboard: `0,0,${width},${height}`, ...options });
    },
  };
}
