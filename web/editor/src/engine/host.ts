// Where the page finds its workers and the module: beside itself. host.file.ts stands in for this in
// the editor that is one file.
import moduleUrl from "sfumato-module?url";

/** Whether the page is one file, which no service worker serves. */
export const isOneFile = false;

/** The worker of worker.ts. */
export function createWorker(): Worker {
  return new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name: "sfumato" });
}

/** The worker of png.worker.ts. */
export function createPngWorker(): Worker {
  return new Worker(new URL("./png.worker.ts", import.meta.url), { type: "module", name: "png" });
}

let module: Promise<WebAssembly.Module> | null = null;

/** sfumato.wasm, compiled once; it can be posted to workers. @throws Error */
export function getModule(): Promise<WebAssembly.Module> {
  return (module ??= compile().catch((error: unknown) => {
    module = null;
    throw error;
  }));
}

async function compile(): Promise<WebAssembly.Module> {
  const answer = await fetch(moduleUrl);
  if (!answer.ok) throw new Error(`sfumato.wasm: ${answer.status}`);
  // Some plain servers do not send the type, which streaming needs.
  const isTyped = answer.headers.get("Content-Type")?.startsWith("application/wasm") ?? false;
  return isTyped ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}
