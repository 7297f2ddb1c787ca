// Shared by the entry points for Node and for pages: the library of web/wasm, loaded once.
import { loadSfumato } from "../../../web/wasm/sfumato.mjs";

export * from "../../../web/wasm/sfumato.mjs";

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

  async function prepared(text, { name = "", load = null, base = undefined }) {
    if (typeof text !== "string" && !(text instanceof Uint8Array)) {
      throw new TypeError("expected a drawing: a string or a Uint8Array");
    }
    const { context } = await instance();
    const files = await prepare(context, text, base);
    return { context, given: { name, load: load ?? ((href) => files.get(href) ?? null) } };
  }

  return {
    async load(source) {
      return (await instance(source)).sfumato;
    },
    async read(text, from = {}) {
      const { context, given } = await prepared(text, from);
      return context.read(text, given);
    },
    async importSvg(text, from = {}) {
      const { context, given } = await prepared(text, from);
      return { drawing: context.importSvg(text, given), warnings: context.warnings };
    },
    async create(width, height, options = {}) {
      if (!(width > 0 && height > 0)) throw new TypeError("expected a width and a height above 0");
      const { context } = await instance();
      return context.newDocument({ artboard: `0,0,${width},${height}`, ...options });
    },
  };
}
