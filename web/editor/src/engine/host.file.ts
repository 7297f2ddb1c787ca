// host.ts for the editor as one file: workers are text within it, and so is the module, packed.
import PngWorker from "./png.worker.ts?worker&inline";
import EngineWorker from "./worker.ts?worker&inline";

export const isOneFile = true;

export const createWorker = (): Worker => new EngineWorker({ name: "sfumato" });
export const createPngWorker = (): Worker => new PngWorker({ name: "png" });

let module: Promise<WebAssembly.Module> | null = null;

export const getModule = (): Promise<WebAssembly.Module> => (module ??= compile());

/** The element is written by tools/one-file.mjs: base64 of gzip. */
async function compile(): Promise<WebAssembly.Module> {
  const text = document.getElementById("sfumato-module")?.textContent;
  if (!text) throw new Error("sfumato.wasm is missing in the page");
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}
