// The module of the page that is one file: a worker unpacks and compiles it while the page unpacks its script.
import ModuleWorker from "./module.worker.ts?worker&inline";
import { takePacked } from "./packed.js";

declare global {
  var sfumatoModule: Promise<WebAssembly.Module>;
}

/** The element is written by tools/one-file.mjs. */
function compile(): Promise<WebAssembly.Module> {
  let worker: Worker | undefined;
  return new Promise<WebAssembly.Module>((resolve, reject) => {
    worker = new ModuleWorker({ name: "module" });
    worker.onmessage = ({ data }: MessageEvent<WebAssembly.Module | string>) =>
      typeof data === "string" ? reject(new Error(data)) : resolve(data);
    worker.onmessageerror = () => reject(new Error("The module cannot be handed over."));
    worker.onerror = (event) => reject(new Error(event.message));
    worker.postMessage(takePacked("sfumato-module"));
  }).finally(() => worker?.terminate());
}

/** For host.file.ts, which comes with the script. */
export function beginModule(): void {
  globalThis.sfumatoModule = compile();
  // The requests report the failure.
  globalThis.sfumatoModule.catch(() => undefined);
}
