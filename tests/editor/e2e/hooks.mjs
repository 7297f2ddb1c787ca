// Code that runs in each page before its scripts, so that the speed of the machine does not matter: a clock under
// the tests' control, messages that stay, and a count of requests to workers.

/** Runs in the page. */
export function installHooks() {
  if (window.tests) return;
  const now = performance.now.bind(performance);
  const { get: stampOf } = Object.getOwnPropertyDescriptor(Event.prototype, "timeStamp");
  /** lead: offset to the machine's clock; held: the time of the stopped clock, or null. Milliseconds. */
  const clock = { lead: 0, held: null };
  performance.now = () => clock.held ?? now() + clock.lead;
  const timeStamp = {
    configurable: true,
    get() {
      return clock.held ?? stampOf.call(this) + clock.lead;
    },
  };
  Object.defineProperty(Event.prototype, "timeStamp", timeStamp);

  // A slow machine may need the 5 s of a message's display to press its button.
  const { setTimeout } = window;
  const standing = [];
  window.setTimeout = (act, delay, ...more) => {
    if (delay !== 5000) return setTimeout(act, delay, ...more);
    standing.push(act);
    return 0;
  };
  const letMessagesGo = () => standing.splice(0).forEach((act) => act());

  /** names: of all calls; waiting: unanswered calls, by worker. */
  const calls = { names: [], waiting: new Map() };
  const count = (worker, by) => calls.waiting.set(worker, calls.waiting.get(worker) + by);
  const hear = (worker) => {
    if (calls.waiting.has(worker)) return;
    calls.waiting.set(worker, 0);
    worker.addEventListener("message", ({ data }) => {
      // A worker that was ended may have answered before.
      if ("id" in data && calls.waiting.has(worker)) count(worker, -1);
    });
  };
  const { postMessage, terminate } = Worker.prototype;
  Worker.prototype.postMessage = function (message, ...more) {
    // Workers other than the engine's have their own messages.
    if (typeof message?.name === "string" && "given" in message) {
      hear(this);
      count(this, 1);
      calls.names.push(message.name);
    }
    return postMessage.call(this, message, ...more);
  };
  Worker.prototype.terminate = function () {
    calls.waiting.delete(this);
    return terminate.call(this);
  };
  const isIdle = () => [...calls.waiting.values()].every((waiting) => waiting === 0);
  const callsOf = (wanted) => calls.names.filter((name) => name === wanted).length;
  window.tests = { clock, letMessagesGo, isIdle, callsOf };
}

/**
 * Runs in the page, for tests that do not look at the picture. The picture is made and sent to the graphics as
 * usual, which draw nothing and receive it once. Software rendering takes most of a test's time otherwise.
 */
export function drawNothing() {
  const { prototype } = WebGL2RenderingContext;
  const { getExtension } = prototype;
  for (const name of ["drawArrays", "drawArraysInstanced", "blitFramebuffer", "clear"]) {
    prototype[name] = () => {};
  }
  // Without these extensions the stage does not average pictures to a finer one.
  prototype.getExtension = function (name) {
    return /^EXT_color_buffer/.test(name) ? null : getExtension.call(this, name);
  };
}

/** Advances the clock by so many milliseconds at once. */
export const pass = (page, milliseconds) =>
  page.evaluate((time) => void (window.tests.clock.lead += time), milliseconds);

/** Stops the clock while `act` runs. */
export async function atOnce(page, act) {
  await page.evaluate(() => void (window.tests.clock.held = performance.now()));
  try {
    return await act();
  } finally {
    await page.evaluate(() => void (window.tests.clock.held = null));
  }
}

/** Ends the display of messages. */
export const messagesGo = (page) => page.evaluate(() => window.tests.letMessagesGo());

/** Resolves when the page's timers of the next so many milliseconds have run. */
export const timersHaveRun = (page, milliseconds) =>
  page.evaluate((time) => new Promise((resolve) => setTimeout(resolve, time)), milliseconds);

/** Resolves when no worker has work for the page. */
export const workersRest = (page) => page.waitForFunction(() => window.tests.isIdle());

/** Returns how often the page sent this request to its workers. */
export const callsOf = (page, name) =>
  page.evaluate((wanted) => window.tests.callsOf(wanted), name);

/** Resolves when workers have answered more than `count` such requests. */
export const askedAgain = (page, name, count) =>
  page.waitForFunction(
    ([wanted, before]) => window.tests.callsOf(wanted) > before && window.tests.isIdle(),
    [name, count],
  );

/** Resolves after `count` idle moments of the page, which are used for its small pictures. */
export const idleMoments = (page, count = 20) =>
  page.evaluate(async (most) => {
    const moment = () => new Promise((resolve) => requestIdleCallback(resolve, { timeout: 2000 }));
    for (let i = 0; i < most; ++i) await moment();
  }, count);
