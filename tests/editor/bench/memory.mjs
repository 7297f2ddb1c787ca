// Checks that the editor's memory stays flat while curves are dragged, one after another.
//
//   node tests/editor/bench/memory.mjs [--seconds 60] [--curves 100]
//
// Opens build/editor.html from disk in Chromium and prints, every few seconds, the page's heap and the total memory
// of the tab with modules and their workers. Exit 1 if either grows by more than a tenth from a third of the time
// to the end.
import { parseArgs } from "node:util";
import { MESA } from "../../chromium.mjs";
import { EditorPage, launch, pathOf } from "../e2e/harness.mjs";
import { manyCurves } from "./scenes.mjs";
import { tabMegabytes } from "./tab-memory.mjs";

const { values: options } = parseArgs({
  options: { seconds: { type: "string", default: "60" }, curves: { type: "string", default: "100" } },
});
const SECONDS = Number(options.seconds);
const CURVES = Number(options.curves);
const ACROSS = Math.ceil(Math.sqrt(CURVES));
const GROWTH = 1.1;
/** Seconds between samples. */
const PAUSE = 2;

/** Returns the start of a curve, and its middle, on the artboard. */
const middleOf = (i) => [10 * (i % ACROSS) + 5, 10 * Math.floor(i / ACROSS) + 4.875];

async function dragCurve(editor, i, round) {
  const [x, y] = middleOf(i);
  // There and back, so that the next round finds the curve again.
  const by = round % 2 === 0 ? 1 : -1;
  const from = round % 2 === 0 ? [x, y] : [x + 1, y + 1];
  await editor.drag([from, [from[0] + by / 2, from[1] + by], [from[0] + by, from[1] + by]], { steps: 3 });
}

async function series(browser, editor) {
  const samples = [];
  const began = Date.now();
  const seconds = () => (Date.now() - began) / 1000;
  let drags = 0;
  for (; seconds() < SECONDS; drags += 1) {
    await dragCurve(editor, drags % CURVES, Math.floor(drags / CURVES));
    if (seconds() < PAUSE * samples.length) continue;
    const { heap, whole } = await tabMegabytes(browser, editor.page);
    samples.push({ at: seconds(), heap, whole });
    console.log(`${seconds().toFixed(0).padStart(4)} s  heap ${heap.toFixed(1)} MB  tab ${whole.toFixed(0)} MB  drags ${drags + 1}`);
  }
  return samples;
}

const mean = (numbers) => numbers.reduce((sum, number) => sum + number, 0) / numbers.length;

/** Returns the growth of a figure: means of three samples, a third of the way and at the end. */
function growth(samples, name) {
  const values = samples.map((sample) => sample[name]);
  const third = samples.findIndex(({ at }) => at >= SECONDS / 3);
  return mean(values.slice(-3)) / mean(values.slice(third, third + 3));
}

const browser = await launch(MESA);
// Small, because drawing is done by software here and is not measured.
const editor = await EditorPage.open(browser, `file://${pathOf("build/editor.html")}`, { size: [800, 480], ratio: 1, isDrawn: true });
const text = manyCurves(CURVES, ACROSS);
await editor.load(text);
const samples = await series(browser, editor);
if ((await editor.text) === text) throw new Error("no curve was dragged");
await browser.close();
for (const name of ["heap", "whole"]) {
  const grown = growth(samples, name);
  const isFlat = grown <= GROWTH;
  console.log(`${name.padEnd(6)} ${((grown - 1) * 100).toFixed(1)} % more at the end  ${isFlat ? "" : "GROWS"}`);
  if (!isFlat) process.exitCode = 1;
}
