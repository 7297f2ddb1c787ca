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
  const element = document.getElementById("sfumato-module");
  if (!element?.textContent) throw new Error("sfumato.wasm is missing in the page");
  const { body } = await fetch(`data:application/gzip;base64,${element.textContent}`);
  const bytes = body!.pipeThrough(new DecompressionStream("gzip"));
  const headers = { "Content-Type": "application/wasm" };
  const compiled = await WebAssembly.compileStreaming(new Response(bytes, { headers }));
  // A megabyte of text that nobody reads again.
  element.remove();
  return compiled;
}
