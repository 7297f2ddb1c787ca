// What the tests put into each page before its scripts, so that no machine is too slow or too
// quick: a clock that they lead, messages that stay, and a count of what workers are asked.

/** In the page. */
export function installHooks() {
  if (window.tests) return;
  const now = performance.now.bind(performance);
  const { get: stampOf } = Object.getOwnPropertyDescriptor(Event.prototype, "timeStamp");
  /** lead: before the machine's clock; held: where the clock stands, or null. Milliseconds. */
  const clock = { lead: 0, held: null };
  performance.now = () => clock.held ?? now() + clock.lead;
  const timeStamp = {
    configurable: true,
    get() {
      return clock.held ?? stampOf.call(this) + clock.lead;
    },
  };
  Object.defineProperty(Event.prototype, "timeStamp", timeStamp);

  // A slow machine may need the time that a message stands, 5 s, to press its button.
  const { setTimeout } = window;
  const standing = [];
  window.setTimeout = (act, delay, ...more) => {
    if (delay !== 5000) return setTimeout(act, delay, ...more);
    standing.push(act);
    return 0;
  };
  const letMessagesGo = () => standing.splice(0).forEach((act) => act());

  /** names: of all calls; waiting: those without an answer, by worker. */
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
    // Others than the engine's take messages of their own.
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
 * In the page, where nobody looks at the picture: it is made and sent to the graphics as ever, which
 * draw nothing of it, and once. Software takes most of a test's time for it.
 */
export function drawNothing() {
  const { prototype } = WebGL2RenderingContext;
  const { getExtension } = prototype;
  for (const name of ["drawArrays", "drawArraysInstanced", "blitFramebuffer", "clear"]) {
    prototype[name] = () => {};
  }
  // Without these the stage adds up no pictures to a finer one.
  prototype.getExtension = function (name) {
    return /^EXT_color_buffer/.test(name) ? null : getExtension.call(this, name);
  };
}

/** The clock goes on by so many milliseconds at once. */
export const pass = (page, milliseconds) =>
  page.evaluate((time) => void (window.tests.clock.lead += time), milliseconds);

/** What is done meanwhile is done at one moment. */
export async function atOnce(page, act) {
  await page.evaluate(() => void (window.tests.clock.held = performance.now()));
  try {
    return await act();
  } finally {
    await page.evaluate(() => void (window.tests.clock.held = null));
  }
}

/** Messages have stood for their time. */
export const messagesGo = (page) => page.evaluate(() => window.tests.letMessagesGo());

/** When timers of the page that are due within so many milliseconds have run. */
export const timersHaveRun = (page, milliseconds) =>
  page.evaluate((time) => new Promise((resolve) => setTimeout(resolve, time)), milliseconds);

/** When no worker has anything to do for the page. */
export const workersRest = (page) => page.waitForFunction(() => window.tests.isIdle());

/** How often workers were asked this. */
export const callsOf = (page, name) =>
  page.evaluate((wanted) => window.tests.callsOf(wanted), name);

/** When workers have been asked this more often than `count`, and have answered. */
export const askedAgain = (page, name, count) =>
  page.waitForFunction(
    ([wanted, before]) => window.tests.callsOf(wanted) > before && window.tests.isIdle(),
    [name, count],
  );

/** When the page has had so many idle moments, in which it makes its small pictures. */
export const idleMoments = (page, count = 20) =>
  page.evaluate(async (most) => {
    const moment = () => new Promise((resolve) => requestIdleCallback(resolve, { timeout: 2000 }));
    for (let i = 0; i < most; ++i) await moment();
  }, count);
