// Runs in the page before its own scripts: records the requests to its workers and the times of the answers.

/** Fills `watchedWorkers`: {name, way, begin, end, taken, milliseconds}, times of performance.now(). */
export function watchWorkers() {
  const log = (window.watchedWorkers = []);
  const workers = new Set();
  const Plain = window.Worker;
  window.Worker = class extends Plain {
    #asked = new Map();

    constructor(...given) {
      super(...given);
      workers.add(this);
    }

    postMessage(message, ...rest) {
      const { id, name, given } = message ?? {};
      if (name) this.#asked.set(id, { name, way: given[0]?.way?.kind, begin: performance.now() });
      super.postMessage(message, ...rest);
    }

    set onmessage(hear) {
      super.onmessage = (event) => {
        const end = performance.now();
        hear.call(this, event);
        const asked = this.#asked.get(event.data?.id);
        this.#asked.delete(event.data?.id);
        if (!asked) return;
        const entry = { ...asked, end, taken: 0, milliseconds: event.data.value?.milliseconds ?? 0 };
        log.push(entry);
        // The promises that wait for the answer run before this one.
        Promise.resolve().then(() => Promise.resolve()).then(() => (entry.taken = performance.now() - end));
      };
    }
  };
}
