// What the tests in JavaScript share: they run one after another, are timed, and print TAP.
//
//   # 12.3 s NAME
//   # CPU 4.5 s
//   ok - NAME
//
// The slowest tests of a run: grep -E '^# [0-9.]+ s ' | sort -rn -k 2
import { readdirSync, readFileSync } from "node:fs";

/** What has not happened after this never happens, on the slowest machine. Milliseconds. */
export const PATIENCE = Number(process.env.SFUMATO_WAIT ?? 180_000);

/** A test that waits for what does not come is a failure, not a run without end. */
const LONGEST_MS = 1_800_000;

/** Of /proc, which Linux gives every program in these units. */
const TICKS_PER_SECOND = 100;

export class Skip extends Error {}

/** Numbers of a process in /proc; null: it has ended. */
function statOf(id) {
  try {
    const text = readFileSync(`/proc/${id}/stat`, "utf8");
    const [, parent, ...more] = text.slice(text.lastIndexOf(")") + 2).split(" ");
    // Its own time of user and system, and those of the children that it has waited for.
    const ticks = more.slice(9, 13).reduce((sum, count) => sum + Number(count), 0);
    return { id, parent: Number(parent), ticks };
  } catch {
    return null;
  }
}

/** CPU time of this process and all below it, seconds; null where the system has no /proc. */
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
  // Parents may come behind their children: until no more are found.
  for (let count = 0; count !== own.size; ) {
    count = own.size;
    for (const { id, parent } of all) if (own.has(parent)) own.add(id);
  }
  const ticks = all.filter(({ id }) => own.has(id)).reduce((sum, one) => sum + one.ticks, 0);
  return ticks / TICKS_PER_SECOND;
}

/** @returns what `body` does, unless it takes too long */
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

/** An error as lines of comment, but for the first one's sign. */
const commented = (error) => String(error?.stack ?? error).replaceAll("\n", "\n# ");

/** Runs tests one after another and prints TAP. */
export class Tap {
  failures = 0;

  /** only: tests whose names hold this; prefix: of each name that is printed */
  constructor({ only = "", prefix = "" } = {}) {
    Object.assign(this, { only, prefix });
  }

  async test(name, body) {
    if (name.includes(this.only)) await this.#run(this.prefix + name, () => inTime(body));
  }

  /** A test of many tests, each of which has its own limit and tells its own time. */
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

/** @returns what prints how much time has gone by since then */
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
