// One attempt to load a `src`, with the promise that `ready` returns.

/** @typedef {"waiting" | "loading" | "open" | "failed" | "ended"} State */

export class Load {
  /** @type {State} */
  state = "waiting";
  /** Resolves when loading has ended, in whatever way. @type {Promise<void> | null} */
  work = null;
  /** Releases what the attempt has acquired. @type {() => void} */
  release = () => {};
  /** @type {() => void} */
  #resolve = () => {};
  /** @type {(error: unknown) => void} */
  #reject = () => {};
  /** @type {Promise<void>} */
  ready = new Promise((resolve, reject) => {
    this.#resolve = resolve;
    this.#reject = reject;
  });

  constructor() {
    // Callers may ignore the promise, because errors are also reported by the event.
    this.ready.catch(() => {});
  }

  /** Whether the attempt goes on or has succeeded. */
  get isLive() {
    return this.state !== "failed" && this.state !== "ended";
  }

  /** A frame is shown, or no frame is due. */
  shown() {
    this.#resolve();
  }

  /** @param {unknown} error */
  fail(error) {
    this.#finish("failed");
    this.#reject(error);
  }

  /** Ends the attempt, whose result nobody wants any more. @param {string} why */
  end(why) {
    this.#finish("ended");
    this.#reject(new DOMException(why, "AbortError"));
  }

  /** @param {State} state */
  #finish(state) {
    this.state = state;
    this.release();
    this.release = () => {};
  }
}

/** Returns a promise that is rejected, and that callers may ignore. @param {unknown} error @returns {Promise<void>} */
export function refused(error) {
  const promise = Promise.reject(error);
  promise.catch(() => {});
  return promise;
}
