// Measures the editor in a browser, without drawing: node tests/editor/bench/page.mjs [--strict]
//     [--scenes FOLDER] [--moves N] [SCENE...]
//
// Opens build/editor.html from disk in Chromium. For each scene it measures the time until the first picture after
// a cold start; the engine's time and the transfer of its answer to the page for the frames of a drag of one node;
// the main thread's script (CPU time) for each movement of a drag, a pan and a hover, and for undo; and memory. It
// prints the limits beside the figures. The scenes are as in frame.mjs; Orzan's scenes are opened as they are.
// --strict: exit with 1 if a figure is more than 20 % above the limit.
import { loadavg } from "node:os";
import { basename } from "node:path";
import { parseArgs } from "node:util";
import { MESA } from "../../chromium.mjs";
import { EditorPage, launch, pathOf } from "../e2e/harness.mjs";
import { circleFrom, takeNode } from "./actions.mjs";
import { manyCurves, sceneFile, svgOf } from "./scenes.mjs";
import { tabMegabytes } from "./tab-memory.mjs";
import { watchWorkers } from "./watch-workers.mjs";

const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    moves: { type: "string", default: "40" },
    strict: { type: "boolean", default: false },
    scenes: { type: "string", default: process.env.SFUMATO_SCENES ?? "" },
  },
});
const MOVES = Number(options.moves);
const TOLERANCE = 1.2;
const SCRIPT = 8;
/** One of these frames prepares the drag; the first may move nothing yet. */
const BEGIN = 3;

/** Limits: milliseconds, and megabytes. */
const REQUIRED = {
  lady_bug: { engine: 5, begin: 15, way: 0.5, settle: 100 },
  portrait: { first: 1000, engine: 3, way: 0.5, memory: 150 },
  fish: { engine: 3, way: 0.5 },
  dolphin: { engine: 8, begin: 60, way: 0.5 },
  roses: { engine: 8, way: 0.5 },
};

function percentile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? NaN;
}

// Script time of the main thread, from Chromium's trace.

const CATEGORIES = ["devtools.timeline", "disabled-by-default-devtools.timeline", "v8"];
/** The browser runs scripts in these events. Animation frames are counted separately: WebGL draws in them. */
const CALLS = new Set(["EventDispatch", "RunMicrotasks", "FunctionCall", "TimerFire", "v8.callFunction", "HandlePostMessage"]);

/** Returns script runs of the page's main thread, without nested ones: start and CPU time; microseconds. */
function scriptOf(events) {
  const main = events.find(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain");
  const own = events
    .filter(({ ph, pid, tid, dur }) => ph === "X" && dur > 0 && pid === main?.pid && tid === main.tid)
    .sort((a, b) => a.ts - b.ts || b.dur - a.dur);
  const calls = [];
  let end = -Infinity;
  for (const { name, ts, dur, tdur } of own) {
    if (ts < end) continue;
    if (name === "FireAnimationFrame") end = ts + dur;
    if (!CALLS.has(name)) continue;
    calls.push({ ts, cpu: tdur ?? dur });
    end = ts + dur;
  }
  return calls;
}

/** Returns, for each step, the CPU milliseconds of script from its start to the start of the next step. */
async function scriptOfSteps(editor, browser, steps) {
  await browser.startTracing(editor.page, { categories: CATEGORIES });
  for (const [i, step] of steps.entries()) {
    await editor.page.evaluate((name) => console.timeStamp(name), `step ${i}`);
    await step();
    // All effects of the step are done within two frames.
    await editor.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }
  const trace = JSON.parse((await browser.stopTracing()).toString());
  const events = trace.traceEvents ?? trace;
  const stamps = events.filter(({ name, args }) => name === "TimeStamp" && /^step /.test(args?.data?.message ?? ""));
  const times = stamps.map(({ ts }) => ts).sort((a, b) => a - b);
  const sums = times.map(() => 0);
  for (const { ts, cpu } of scriptOf(events)) {
    const step = times.findLastIndex((time) => time <= ts);
    if (step >= 0) sums[step] += cpu / 1000;
  }
  return sums;
}

// User actions.

const moves = (editor, from, radius) =>
  circleFrom(from, radius, MOVES).map((place) => () => editor.page.mouse.move(...place));

async function dragNode(editor, browser) {
  const place = await takeNode(editor);
  await editor.settled();
  const watch = () => editor.page.evaluate(() => window.watchedWorkers.splice(0));
  // By the time a user has found a node, the engine has prepared the drag.
  await editor.page.waitForFunction(() => {
    const begun = window.watchedWorkers.findLast(({ name }) => name === "expect");
    return begun && performance.now() - begun.end > 400;
  });
  const before = (await watch()).findLast(({ name }) => name === "expect");
  await editor.page.mouse.move(...place);
  await editor.page.mouse.down();
  const script = await scriptOfSteps(editor, browser, moves(editor, place, 15));
  await editor.page.mouse.up();
  const frames = await watch();
  await editor.settled();
  return { script, frames, rest: await watch(), before: before.end - before.begin };
}

async function pan(editor, browser) {
  const { page } = editor;
  const [width, height] = [700, 450];
  await page.keyboard.down("Space");
  await page.mouse.move(width, height);
  await page.mouse.down();
  const script = await scriptOfSteps(editor, browser, moves(editor, [width, height], 60));
  await page.mouse.up();
  await page.keyboard.up("Space");
  return script;
}

async function hover(editor, browser) {
  await editor.key("v", "Escape");
  return scriptOfSteps(editor, browser, moves(editor, [700, 450], 200));
}

async function undo(editor, browser) {
  const keys = ["Control+z", "Control+Shift+z", "Control+z"];
  return scriptOfSteps(editor, browser, keys.map((key) => () => editor.key(key)));
}

// Measures one scene.

/** Returns milliseconds from the start of navigation until a scene's first picture is given to the graphics. */
async function start(editor, text) {
  await editor.page.addInitScript(watchWorkers);
  await editor.go(`file://${pathOf("build/editor.html")}`);
  const opened = await editor.page.evaluate(
    async (given) => {
      await window.sfumatoEditor.open(given, "scene.svg");
      return performance.now();
    },
    text,
  );
  await editor.page.waitForFunction(() => window.watchedWorkers.some(({ name }) => name === "solve"));
  const first = await editor.page.evaluate(() => window.watchedWorkers.find(({ name }) => name === "solve").end);
  return { first, opened };
}

async function measure(browser, text) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
  const editor = new EditorPage(await context.newPage());
  editor.context = context;
  const { first, opened } = await start(editor, text);
  await editor.settled();
  const exact = await editor.page.evaluate(() => window.watchedWorkers.filter(({ name }) => name === "solve").at(-1).end);
  const { heap, whole } = await tabMegabytes(browser, editor.page);
  const drag = await dragNode(editor, browser);
  const panned = await pan(editor, browser);
  const hovered = await hover(editor, browser);
  const undone = await undo(editor, browser);
  await editor.close();
  const solved = drag.frames.filter(({ name }) => name === "solve");
  const own = solved.map(({ milliseconds }) => milliseconds);
  const way = solved.map(({ begin, end, milliseconds }) => Math.max(0, end - begin - milliseconds));
  // The exact picture may already be made while the pointer rests within the drag.
  const settle = [...drag.frames, ...drag.rest].filter(({ name, way }) => name === "solve" && way === "exact");
  return {
    first, opened, exact, heap, whole, way,
    begin: Math.max(...own.slice(0, BEGIN)), engine: own.slice(BEGIN), take: solved.map(({ taken }) => taken),
    before: drag.before,
    settle: settle.map(({ milliseconds }) => milliseconds), drag: drag.script, panned, hovered, undone,
  };
}

const ROWS = [
  ["first", "first picture after a cold start, ms", (t) => t.first],
  ["", "of it until the text is open, ms", (t) => t.opened],
  ["", "exact picture after a cold start, ms", (t) => t.exact],
  ["", "beginning of a drag before it, ms", (t) => t.before],
  ["begin", "first frame of a drag, engine, ms", (t) => t.begin],
  ["engine", "drag frame, engine, p95 ms", (t) => percentile(t.engine, 0.95)],
  ["", "drag frame, engine, p50 ms", (t) => percentile(t.engine, 0.5)],
  ["way", "way of its answer to the page, p50 ms", (t) => percentile(t.way, 0.5)],
  ["", "taking it: tables and upload, p50 ms", (t) => percentile(t.take, 0.5)],
  ["settle", "exact again, engine, ms", (t) => t.settle.at(-1) ?? NaN],
  ["script", "script of a drag's movement, p95 ms", (t) => percentile(t.drag, 0.95)],
  ["", "script of a drag's movement, p50 ms", (t) => percentile(t.drag, 0.5)],
  ["script", "script of a pan's movement, p95 ms", (t) => percentile(t.panned, 0.95)],
  ["script", "script of a hover's movement, p95 ms", (t) => percentile(t.hovered, 0.95)],
  ["script", "script of undo, most, ms", (t) => Math.max(...t.undone)],
  ["memory", "memory of the tab, MB", (t) => t.whole],
  ["", "of it the page's heap, MB", (t) => t.heap],
];

/** Prints one scene. Returns how many figures exceed their limits. */
function print(name, times) {
  let missed = 0;
  for (const [key, label, value] of ROWS) {
    const figure = value(times);
    const required = key === "script" ? SCRIPT : REQUIRED[name]?.[key];
    const isMissed = required !== undefined && !(figure <= required * TOLERANCE);
    if (isMissed) missed += 1;
    const shown = figure >= 100 ? figure.toFixed(0) : figure.toFixed(2);
    const beside = required === undefined ? "" : `<= ${required}${isMissed ? "  MISSED" : ""}`;
    console.log(`${name.padEnd(10)}${label.padEnd(40)}${shown.padStart(10)}  ${beside}`);
  }
  return missed;
}

/** Returns the text of a scene; null if it is missing. "many" is generated. */
async function textOf(name) {
  if (name === "many") return manyCurves(4000);
  const path = sceneFile(name, options.scenes);
  return path && svgOf(path);
}

let missed = 0;
for (const name of positionals.length > 0 ? positionals : [...Object.keys(REQUIRED), "many"]) {
  const text = await textOf(name);
  if (text === null) {
    console.log(`${name.padEnd(10)}is not there`);
    continue;
  }
  const browser = await launch(MESA);
  missed += print(basename(name).replace(/\.\w+$/, ""), await measure(browser, text));
  await browser.close();
}
console.log(`load average ${loadavg()[0].toFixed(1)}; ${missed} figures are more than 20 % above what is required`);
process.exitCode = options.strict && missed > 0 ? 1 : 0;
