// host.ts for the editor as one file: workers are text within it, and the module has begun (module.file.ts).
import PngWorker from "./png.worker.ts?worker&inline";
import EngineWorker from "./worker.ts?worker&inline";

export const isOneFile = true;

export const createWorker = (): Worker => new EngineWorker({ name: "sfumato" });
export const createPngWorker = (): Worker => new PngWorker({ name: "png" });

export const getModule = (): Promise<WebAssembly.Module> => globalThis.sfumatoModule;
