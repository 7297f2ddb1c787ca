// The runner of the tests in JavaScript: runs tests one after another, measures times, prints TAP.
//
//   # 12.3 s NAME
//   # CPU 4.5 s
//   ok - NAME
//
// The slowest tests of a run: grep -E '^# [0-9.]+ s ' | sort -rn -k 2
import { readdirSync, readFileSync } from "node:fs";

/** Limit for the wait for a state, milliseconds; the slowest machine needs less. */
export const PATIENCE = Number(process.env.SFUMATO_WAIT ?? 180_000);

/** Limit for a test, so that an endless wait is a failure. */
const LONGEST_MS = 1_800_000;

/** Clock ticks per second of /proc/PID/stat, the same on every Linux. */
const TICKS_PER_SECOND = 100;

export class Skip extends Error {}

/** Returns the numbers of a process in /proc; null: it has ended. */
function statOf(id) {
  try {
    const text = readFileSync(`/proc/${id}/stat`, "utf8");
    const [, parent, ...more] = text.slice(text.lastIndexOf(")") + 2).split(" ");
    // The user and system time of the process and of the children that it has waited for.
    const ticks = more.slice(9, 13).reduce((sum, count) => sum + Number(count), 0);
    return { id, parent: Number(parent), ticks };
  } catch {
    return null;
  }
}

/** Returns the CPU time of this process and all its descendants, seconds; null if the system has no /proc. */
export function cpuSeconds() {
  let names;
  try {
    names = readdirSync("/proc");
  } catch {
    return null;
  }
  const ids = names.filter((name) => /^\d+$/.test(name)).map(Number);
  const all = ids.map(statOf).filter(Boolean);
  const own = new Set([process.pid]);
  // Parents may come after their children: repeat until no more are found.
  for (let count = 0; count !== own.size; ) {
    count = own.size;
    for (const { id, parent } of all) if (own.has(parent)) own.add(id);
  }
  const ticks = all.filter(({ id }) => own.has(id)).reduce((sum, one) => sum + one.ticks, 0);
  return ticks / TICKS_PER_SECOND;
}

/** Runs a body with a time limit. @returns the result of `body` */
async function inTime(body) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`no end after ${LONGEST_MS / 1000} s`)), LONGEST_MS);
  });
  try {
    return await Promise.race([body(), late]);
  } finally {
    clearTimeout(timer);
  }
}

/** Returns an error as lines of comment, without the sign of the first line. */
const commented = (error) => String(error?.stack ?? error).replaceAll("\n", "\n# ");

/** Runs tests one after another and prints TAP. */
export class Tap {
  failures = 0;

  /** only: run tests whose names contain this; prefix: of each printed name */
  constructor({ only = "", prefix = "" } = {}) {
    Object.assign(this, { only, prefix });
  }

  async test(name, body) {
    if (name.includes(this.only)) await this.#run(this.prefix + name, () => inTime(body));
  }

  /** Runs a test that contains tests. Each has its own time limit and prints its own time. */
  whole(name, body) {
    return this.#run(this.prefix + name, body, () => {});
  }

  async #run(name, body, tellTime = timer(name)) {
    try {
      await body();
      tellTime();
      console.log(`ok - ${name}`);
    } catch (error) {
      if (error instanceof Skip) {
        console.log(`ok - ${name} # SKIP ${error.message}`);
        return;
      }
      this.failures += 1;
      tellTime();
      console.log(`not ok - ${name}\n# ${commented(error)}`);
    }
  }
}

/** @returns a function that prints the time since then */
function timer(name) {
  const [start, startCpu] = [performance.now(), cpuSeconds()];
  return () => {
    console.log(`# ${((performance.now() - start) / 1000).toFixed(1)} s ${name}`);
    if (startCpu !== null) console.log(`# CPU ${(cpuSeconds() - startCpu).toFixed(1)} s`);
  };
}

export function check(condition, message) {
  if (!condition) throw new Error(message);
}

export function checkEqual(actual, expected, what) {
  const [a, b] = [actual, expected].map((value) => JSON.stringify(value));
  if (a !== b) throw new Error(`${what}: ${a?.slice(0, 800)}, expected ${b?.slice(0, 800)}`);
}

export function checkNear(actual, expected, tolerance, what) {
  check(Math.abs(actual - expected) <= tolerance, `${what}: ${actual}, expected ${expected}`);
}
