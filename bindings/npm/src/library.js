// What the entries for node and for pages share: the library of web/wasm, loaded once.
import { loadSfumato } from "../../../web/wasm/sfumato.mjs";

export * from "../../../web/wasm/sfumato.mjs";

/**
 * The functions of the package over a module that is loaded when one of them is first called, and anew
 * where a trap has ended it.
 * @param {(source: unknown) => Promise<BufferSource | WebAssembly.Module>} bring the module, from where
 *   it lies if nobody has said
 * @param {(context: import("../../../web/wasm/sfumato.mjs").SfumatoContext, text: string | Uint8Array,
 *   base: string | URL | undefined) => Promise<Map<string, Uint8Array>>} prepare what a text needs before it is read:
 *   files that come back are those that it may name
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

  return {
    async load(source) {
      return (await instance(source)).sfumato;
    },
    async read(text, { name = "", load = null, base = undefined } = {}) {
      if (typeof text !== "string" && !(text instanceof Uint8Array)) {
        throw new TypeError("expected a drawing: a string or a Uint8Array");
      }
      const { context } = await instance();
      const files = await prepare(context, text, base);
      return context.read(text, { name, load: load ?? ((href) => files.get(href) ?? null) });
    },
    async create(width, height, options = {}) {
      if (!(width > 0 && height > 0)) throw new TypeError("expected a width and a height above 0");
      const { context } = await instance();
      return context.newDocument({ artboard: `0,0,${width},${height}`, ...options });
    },
  };
}
