// host.ts for the editor as one file: workers are text within it, and so is the module, packed.
import ModuleWorker from "./module.worker.ts?worker&inline";
import { takePacked } from "./packed.js";
import PngWorker from "./png.worker.ts?worker&inline";
import EngineWorker from "./worker.ts?worker&inline";

export const isOneFile = true;

export const createWorker = (): Worker => new EngineWorker({ name: "sfumato" });
export const createPngWorker = (): Worker => new PngWorker({ name: "png" });

let module: Promise<WebAssembly.Module> | null = null;

export const getModule = (): Promise<WebAssembly.Module> => (module ??= compile());

/** The element is written by tools/one-file.mjs. */
function compile(): Promise<WebAssembly.Module> {
  const worker = new ModuleWorker({ name: "module" });
  return new Promise<WebAssembly.Module>((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<WebAssembly.Module | string>) =>
      typeof data === "string" ? reject(new Error(data)) : resolve(data);
    worker.onerror = (event) => reject(new Error(event.message));
    worker.postMessage(takePacked("sfumato-module"));
  }).finally(() => worker.terminate());
}
