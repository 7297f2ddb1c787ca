// The page's workers, which solve drawings. A drawing near the screen comes before others, then a small one. A long
// task gives its worker to a waiting one after some time and begins again later, with twice the time.
import { SfumatoError, Status } from "../../../../web/wasm/error.mjs";
import { startWorker } from "./start-worker.js";

/** @import { Addresses } from "./start-worker.js" */

const MOST_WORKERS = 2;
/** Idle time until a worker ends, milliseconds. Ending it frees memory, which a module never shrinks. */
const PATIENCE = 10_000;
/** How long a task keeps its worker if others wait, milliseconds. */
const FIRST_TURN = 2000;
/** How long a task that nobody wants any more keeps its worker if no other waits, milliseconds. */
const GRACE = 300;

/**
 * The message to the worker, as in worker.js.
 * @typedef {object} Request
 * @property {Uint8Array<ArrayBuffer>} bytes
 * @property {string} name
 * @property {string} base
 * @property {Record<string, string>} limits
 * @property {Record<string, string>} options
 * @property {boolean} imports
 * @property {string | null} wasm
 */

/** @typedef {{payload: Uint8Array, warnings: string[]}} Solved */
/** @typedef {{code: number, reason: string, file: string, line: number, column: number}} Complaint */

/** One drawing to solve, until it is solved or no longer wanted. */
class Task {
  turn = FIRST_TURN;
  /** How often it lost its worker. */
  losses = 0;
  isWanted = true;

  /**
   * @param {Request} request
   * @param {() => boolean} isNear whether it is shown near the screen
   * @param {(solved: Solved) => void} resolve
   * @param {(error: unknown) => void} reject
   */
  constructor(request, isNear, resolve, reject) {
    this.request = request;
    this.isNear = isNear;
    this.resolve = resolve;
    this.reject = reject;
  }

  /**
   * Returns whether this task must be solved before another one: drawings near the screen first, then tasks that lost
   * their worker less often, then smaller drawings.
   * @param {Task} other
   */
  precedes(other) {
    const [near, otherNear] = [this.isNear(), other.isNear()];
    if (near !== otherNear) return near;
    if (this.losses !== other.losses) return this.losses < other.losses;
    return this.request.bytes.length < other.request.bytes.length;
  }
}

/** A worker and its present task. */
class Seat {
  /** @type {Task | null} */
  task = null;
  since = 0;
  #timer = 0;
  #id = 0;

  /** @param {Addresses} addresses */
  constructor(addresses) {
    this.worker = startWorker(addresses);
    this.worker.addEventListener("message", ({ data }) => this.#answer(data));
    for (const name of ["error", "messageerror"]) {
      this.worker.addEventListener(name, (event) => this.#break(/** @type {ErrorEvent} */ (event).message));
    }
  }

  /** @param {Task} task */
  give(task) {
    clearTimeout(this.#timer);
    this.task = task;
    this.since = performance.now();
    // A copy of the bytes stays here, in case the task loses the worker.
    this.worker.postMessage({ id: ++this.#id, ...task.request });
  }

  /** How long the present task has been at work, milliseconds. */
  get time() {
    return performance.now() - this.since;
  }

  end() {
    clearTimeout(this.#timer);
    this.worker.terminate();
    this.task = null;
    seats.delete(this);
  }

  /** The task is no longer wanted. */
  drop() {
    this.#timer = window.setTimeout(() => this.end(), GRACE);
  }

  /** @param {{id: number, payload?: Uint8Array, warnings?: string[], error?: Complaint, isSpent?: boolean}} told */
  #answer({ id, payload, warnings = [], error, isSpent }) {
    if (id !== this.#id) return;
    const task = this.task;
    this.task = null;
    if (payload) task?.resolve({ payload, warnings });
    else if (error) task?.reject(new SfumatoError(error.code, error.reason, error));
    clearTimeout(this.#timer);
    if (isSpent) this.end();
    else this.#timer = window.setTimeout(() => this.end(), PATIENCE);
    schedule();
  }

  /** @param {string | undefined} why */
  #break(why) {
    const reason = `the script that solves drawings could not be started: ${why || "it was refused, or is not there"}; docs/npm.md says how to set SfumatoPicture.workerUrl`;
    this.task?.reject(new SfumatoError(Status.unavailable, reason, { file: this.task.request.name }));
    this.end();
    schedule();
  }
}

/** @type {Set<Seat>} */
const seats = new Set();
/** @type {Task[]} */
let waiting = [];
/** @type {Addresses} */
let places = { worker: null, wasm: null };
let timer = 0;

/** Removes and returns the waiting task that comes first. */
function takeFirst() {
  const first = waiting.reduce((best, task) => (task.precedes(best) ? task : best));
  waiting = waiting.filter((task) => task !== first);
  return first;
}

/**
 * Returns after how many milliseconds a worker is due to a waiting task; 0: now.
 * @param {Seat} seat
 * @param {Task} task
 */
function delayOf({ task: present, time }, task) {
  if (!present || !present.isWanted) return 0;
  const [near, presentNear] = [task.isNear(), present.isNear()];
  if (near !== presentNear) return near ? 0 : Infinity;
  return task.losses > present.losses ? Infinity : Math.max(0, present.turn - time);
}

/** Frees a busy worker, whose task waits again if it is still wanted. @param {Seat} seat */
function free(seat) {
  const { task, time } = seat;
  if (!task) return;
  seat.end();
  if (!task.isWanted) return;
  if (time >= task.turn) {
    task.turn *= 2;
    task.losses += 1;
  }
  waiting.push(task);
}

/** Gives tasks to workers, as long as there are both. */
function schedule() {
  clearTimeout(timer);
  while (waiting.length > 0) {
    const task = takeFirst();
    const idle = [...seats].find((seat) => !seat.task);
    if (!idle && seats.size >= MOST_WORKERS) {
      const [soonest, delay] = [...seats]
        .map((seat) => /** @type {const} */ ([seat, delayOf(seat, task)]))
        .reduce((a, b) => (b[1] < a[1] ? b : a));
      if (delay > 0) {
        waiting.unshift(task);
        if (delay < Infinity) timer = window.setTimeout(schedule, delay + 1);
        return;
      }
      free(soonest);
    }
    begin(task, idle);
  }
}

/**
 * @param {Task} task
 * @param {Seat | undefined} idle
 */
function begin(task, idle) {
  try {
    const seat = idle ?? new Seat(places);
    seats.add(seat);
    seat.give(task);
  } catch (error) {
    task.reject(error);
  }
}

/**
 * Returns the data that the viewer's scripts draw.
 * @param {Request} request
 * @param {Addresses} addresses
 * @param {{signal: AbortSignal, isNear: () => boolean}} wish `signal` ends the task
 * @returns {Promise<Solved>}
 */
export function solve(request, addresses, { signal, isNear }) {
  places = addresses;
  return new Promise((resolve, reject) => {
    signal.throwIfAborted();
    const task = new Task(request, isNear, resolve, reject);
    signal.addEventListener("abort", () => {
      task.isWanted = false;
      waiting = waiting.filter((other) => other !== task);
      for (const seat of seats) if (seat.task === task) seat.drop();
      reject(signal.reason);
      schedule();
    });
    waiting.push(task);
    schedule();
  });
}
