// The module for tests in node. `make editor` builds it; SFUMATO_WASM may name another one.
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Host } from "../../../web/editor/src/engine/seat.js";
import type { MessageEndpoint } from "../../../web/editor/src/engine/rpc.js";
import { serve } from "../../../web/editor/src/engine/serve.js";

export const root = fileURLToPath(new URL("../../..", import.meta.url));
const path = process.env.SFUMATO_WASM ?? `${root}build-wasm/sfumato.wasm`;

/** Whether the module was built; tests that need it are skipped otherwise. */
export const hasModule = existsSync(path);

let compiled: Promise<WebAssembly.Module> | undefined;
export function module(): Promise<WebAssembly.Module> {
  compiled ??= WebAssembly.compile(readFileSync(path));
  return compiled;
}

/** Returns a text file of the project. */
export const textOf = (file: string) => readFileSync(root + file, "utf8");

/** A worker in this thread: messages are copied, and arrive later. */
class LocalWorker {
  onmessage: ((event: MessageEvent) => void) | null = null;
  onerror = null;
  #isEnded = false;
  readonly #onEnd: () => void;
  #scope: MessageEndpoint = {
    onmessage: null,
    postMessage: (data, transfer) => this.#later(data, transfer, () => this.onmessage),
  };

  constructor(onEnd: () => void) {
    this.#onEnd = onEnd;
    serve(this.#scope);
  }

  postMessage(data: unknown, transfer: Transferable[] = []) {
    this.#later(data, transfer, () => this.#scope.onmessage);
  }

  terminate() {
    if (!this.#isEnded) this.#onEnd();
    this.#isEnded = true;
  }

  #later(data: unknown, transfer: Transferable[], hearer: () => LocalWorker["onmessage"]) {
    const copy = structuredClone(data, { transfer });
    setTimeout(() => {
      if (!this.#isEnded) hearer()?.({ data: copy } as MessageEvent);
    });
  }
}

/** Returns a host that counts the workers that were started, and the live ones. */
export function localHost(): Host & { workers: number; living: number } {
  return {
    workers: 0,
    living: 0,
    module,
    worker() {
      this.workers += 1;
      this.living += 1;
      return new LocalWorker(() => (this.living -= 1)) as unknown as Worker;
    },
  };
}
