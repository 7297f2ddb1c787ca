// Measures the engine during a drag: the first frame, later ones, the exact picture after them, and frames after a
// colour change. Prints CPU time of the process in node beside the required time.
//
//   node tests/editor/bench/frame.mjs [--strict] [--curves N] [--module sfumato.wasm]
//       [--scenes FOLDER] [SCENE...]
//
// Scenes of examples/ always exist; lady_bug, dolphin and roses are Orzan's and are in FOLDER (or in the folder
// that SFUMATO_SCENES names); missing ones are skipped. N evenly spread curves of the layer with the most curves
// are dragged and coloured.
// --strict: exit with 1 if a figure is more than 20 % above the required one.
import { readFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { parseArgs } from "node:util";
import v8 from "node:v8";
import { Attribute, Kind, loadSfumato, Side, Table } from "../../../web/wasm/sfumato.mjs";
import { modulePath, sceneFile } from "./scenes.mjs";

const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    curves: { type: "string", default: "12" },
    strict: { type: "boolean", default: false },
    module: { type: "string", default: modulePath },
    scenes: { type: "string", default: process.env.SFUMATO_SCENES ?? "" },
  },
});

/** Limits in milliseconds: the editor's acceptance on one idle core. */
const REQUIRED = {
  lady_bug: { frame: 5, begin: 15, color: 1, settle: 100, copy: 0.5 },
  portrait: { frame: 3, color: 1, settle: 60, copy: 0.5 },
  fish: { frame: 3, color: 1, copy: 0.5 },
  dolphin: { frame: 8, begin: 60, color: 1, copy: 0.5 },
  roses: { frame: 8, color: 1, copy: 0.5 },
};
const TOLERANCE = 1.2;
const CURVES = Number(options.curves);
const FRAMES = 12;
/** Time for a frame in the editor's engine. */
const SECONDS = 0.004;
const STAND_IN = { width: 2, height: 2, data: new Uint8Array(16).fill(180) };

function cpu(body) {
  const before = process.cpuUsage();
  body();
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1000;
}

function percentile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? NaN;
}

function read(context, path) {
  const load = (href) => {
    const bytes = new Uint8Array(readFileSync(join(dirname(path), href)));
    context.addImage(bytes, STAND_IN);
    return bytes;
  };
  return context.read(readFileSync(path), { name: basename(path), load });
}

/** Returns the layer with the most curves, where a drag costs most. */
function largestLayer(document) {
  const layers = Array.from({ length: document.layerCount }, (_, layer) => layer);
  return layers.reduce((a, b) => (document.curveCount(b) > document.curveCount(a) ? b : a));
}

/** Copies the changes of a frame, as the worker does for the page. Returns the number of bytes. */
function copyChanges(picture, layer) {
  let bytes = 0;
  for (const table of Object.values(Table)) {
    for (const [from, to] of picture.changes(layer, table)) {
      const { columns, data } = picture.tableView(layer, table);
      bytes += data.slice(from * columns, to * columns).byteLength;
    }
  }
  return bytes;
}

function dragCurve(scene, curve, times) {
  const { context, document, picture, layer } = scene;
  const start = document.points(layer, curve);
  for (let frame = 0; frame <= FRAMES; frame += 1) {
    const by = [1 + (frame % 6), 2 - (frame % 7)];
    document.setPoints(layer, curve, start.map((x, i) => x + by[i % 2]));
    const spent = cpu(() => context.solveAgain(document, picture, { seconds: SECONDS }));
    (frame > 0 ? times.frame : times.first.length > 0 ? times.begin : times.first).push(spent);
    times.waiting.push(picture.statistics.waitingNodes);
    times.copy.push(cpu(() => times.bytes.push(copyChanges(picture, layer))));
  }
  document.setPoints(layer, curve, start);
  times.settle.push(cpu(() => context.solveAgain(document, picture)));
}

/** Returns the first side of a curve with colour stops, or null. */
function coloredSide(document, layer, curve) {
  for (const side of Object.values(Side)) {
    const stops = document.stops(layer, curve, side, Attribute.color);
    if (stops.kind === Kind.stops) return { side, stops };
  }
  return null;
}

function colorCurve({ context, document, picture, layer }, curve, times) {
  const found = coloredSide(document, layer, curve);
  if (!found) return;
  const { side, stops } = found;
  const set = (rows) => document.setStops(layer, curve, side, Attribute.color, { ...stops, rows });
  for (let frame = 0; frame <= FRAMES; frame += 1) {
    const [[offset], ...rest] = stops.rows;
    set([[offset, frame / FRAMES, 0.5, 0.25], ...rest]);
    const spent = cpu(() => context.solveAgain(document, picture, { seconds: SECONDS }));
    (frame === 0 ? times.colorBegin : times.color).push(spent);
  }
  set(stops.rows);
  context.solveAgain(document, picture);
}

function measure(sfumato, path) {
  const context = sfumato.context("max-time=600");
  const document = read(context, path);
  let picture;
  const solve = cpu(() => (picture = context.solve(document, { drags: true })));
  const layer = largestLayer(document);
  const scene = { context, document, picture, layer };
  const count = document.curveCount(layer);
  const times = {
    solve: [solve], first: [], begin: [], frame: [], waiting: [], copy: [], bytes: [], settle: [],
    colorBegin: [], color: [],
  };
  const step = Math.max(1, Math.floor(count / CURVES));
  for (let curve = 0; curve < count && curve < CURVES * step; curve += step) {
    dragCurve(scene, curve, times);
    colorCurve(scene, curve, times);
  }
  context.free();
  return times;
}

const ROWS = [
  ["frame", "drag frame, p95 ms", (t) => percentile(t.frame, 0.95)],
  ["", "drag frame, p50 ms", (t) => percentile(t.frame, 0.5)],
  ["", "nodes that wait, p95", (t) => percentile(t.waiting, 0.95)],
  ["begin", "first frame of a drag, p95 ms", (t) => percentile(t.begin, 0.95)],
  ["", "first frame of a drag, p50 ms", (t) => percentile(t.begin, 0.5)],
  ["", "first frame of all, ms", (t) => t.first[0]],
  ["color", "colour frame, p95 ms", (t) => percentile(t.color, 0.95)],
  ["", "first colour frame, p95 ms", (t) => percentile(t.colorBegin, 0.95)],
  ["settle", "exact again, p50 ms", (t) => percentile(t.settle, 0.5)],
  ["copy", "copy of what changed, p95 ms", (t) => percentile(t.copy, 0.95)],
  ["", "bytes of what changed, p50", (t) => percentile(t.bytes, 0.5)],
  ["", "first solution, ms", (t) => t.solve[0]],
];

/** Prints one scene. Returns how many figures exceed their limits. */
function print(name, times) {
  let missed = 0;
  for (const [key, label, value] of ROWS) {
    const figure = value(times);
    const required = REQUIRED[name]?.[key];
    const isMissed = required !== undefined && !(figure <= required * TOLERANCE);
    if (isMissed) missed += 1;
    const shown = figure >= 100 ? figure.toFixed(0) : figure.toFixed(2);
    const beside = required === undefined ? "" : `<= ${required}${isMissed ? "  MISSED" : ""}`;
    console.log(`${name.padEnd(10)}${label.padEnd(32)}${shown.padStart(10)}  ${beside}`);
  }
  return missed;
}

// Compile with optimisation from the start, as in a page after some seconds; otherwise the compiler's work would
// count.
v8.setFlagsFromString("--no-liftoff");
v8.setFlagsFromString("--no-wasm-lazy-compilation");
const module = new WebAssembly.Module(readFileSync(options.module));
let missed = 0;
for (const name of positionals.length > 0 ? positionals : Object.keys(REQUIRED)) {
  const path = sceneFile(name, options.scenes);
  if (path) missed += print(name, measure(await loadSfumato(module), path));
  else console.log(`${name.padEnd(10)}is not there`);
}
console.log(`${missed} figures are more than 20 % above what is required`);
process.exitCode = options.strict && missed > 0 ? 1 : 0;
