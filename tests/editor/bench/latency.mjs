// Compares what one action costs in two builds of the editor, in turns:
//
//   node tests/editor/bench/latency.mjs [--rounds N] [--scenes FOLDER] EDITOR.html [EDITOR.html] [SCENE...]
//
// Opens each one-file editor from disk in Chromium with software graphics, and prints Markdown: CPU milliseconds of
// the page's script, of its main thread, of its process (main thread and workers), and of the graphics process,
// which a graphics card spares. Scripts and main thread include waiting for graphics. Each figure is the least of N
// rounds. The scenes are as in frame.mjs.
import { basename, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { EditorPage, launch } from "../e2e/harness.mjs";
import { circleFrom, takeNode } from "./actions.mjs";
import { sceneFile, svgOf } from "./scenes.mjs";

const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    rounds: { type: "string", default: "2" },
    scenes: { type: "string", default: process.env.SFUMATO_SCENES ?? "" },
  },
});
const editors = positionals.filter((name) => name.endsWith(".html"));
const named = positionals.filter((name) => !name.endsWith(".html"));
const scenes = named.length > 0 ? named : ["sunset", "portrait", "roses"];

const MOVES = 30;
const NOTCHES = 6;
const MIDDLE = [720, 470];

/** Reads the clocks of a page and its browser, milliseconds. */
class Clocks {
  static async of(browser, page) {
    const clocks = new Clocks();
    clocks.browser = await browser.newBrowserCDPSession();
    clocks.page = await page.context().newCDPSession(page);
    await clocks.page.send("Performance.enable");
    return clocks;
  }

  async read() {
    const { metrics } = await this.page.send("Performance.getMetrics");
    const { processInfo } = await this.browser.send("SystemInfo.getProcessInfo");
    const seconds = (wanted) => metrics.find(({ name }) => name === wanted).value;
    const cpu = (wanted) => processInfo.filter(({ type }) => type === wanted).reduce((sum, { cpuTime }) => sum + cpuTime, 0);
    return [seconds("ScriptDuration"), seconds("TaskDuration"), cpu("renderer"), cpu("GPU")].map((value) => 1000 * value);
  }

  /** Returns what a number of equal actions took, each. */
  async during(act, count = 1) {
    const before = await this.read();
    await act();
    const after = await this.read();
    return after.map((value, k) => (value - before[k]) / count);
  }
}

/** Both frames after a movement are drawn. */
const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

async function along(page, places) {
  for (const place of places) {
    await page.mouse.move(...place);
    await drawn(page);
  }
}

/** Returns the figures of one scene in one editor, by action. */
async function measure(address, text) {
  const browser = await launch();
  const editor = await EditorPage.open(browser, address, { isDrawn: true, ratio: 1 });
  const { page } = editor;
  const clocks = await Clocks.of(browser, page);
  const taken = {};
  taken["open to exact"] = await clocks.during(() => editor.load(text));
  const place = await takeNode(editor);
  await editor.settled();
  await page.mouse.move(...place);
  await page.mouse.down();
  taken["a move of a drag"] = await clocks.during(() => along(page, circleFrom(place, 15, MOVES)), MOVES);
  const release = async () => (await page.mouse.up(), await editor.settled());
  taken["from letting go to exact"] = await clocks.during(release);
  const undo = async () => (await editor.key("Control+z"), await editor.settled());
  taken["undo to exact"] = await clocks.during(undo);
  await page.keyboard.down("Space");
  await page.mouse.move(...MIDDLE);
  await page.mouse.down();
  taken["a move of a pan"] = await clocks.during(() => along(page, circleFrom(MIDDLE, 60, MOVES)), MOVES);
  await page.mouse.up();
  await page.keyboard.up("Space");
  await editor.settled();
  taken["a notch of the wheel"] = await clocks.during(() => wheel(editor), NOTCHES);
  await browser.close();
  return taken;
}

async function wheel(editor) {
  await editor.page.keyboard.down("Control");
  for (let i = 0; i < NOTCHES; i += 1) {
    await editor.page.mouse.wheel(0, i % 2 === 0 ? -100 : 100);
    await drawn(editor.page);
  }
  await editor.page.keyboard.up("Control");
  await editor.settled();
}

const least = (rounds, action, k) => Math.round(Math.min(...rounds.map((taken) => taken[action][k])));

function print(name, rounds) {
  const kinds = ["script", "main", "process", "graphics"];
  console.log(`| ${name} | ${kinds.join(" | ")} |\n|---|---|---|---|---|`);
  for (const action of Object.keys(rounds[0][0])) {
    const cells = kinds.map((_, k) => rounds.map((own) => least(own, action, k)).join(" / "));
    console.log(`| ${action} | ${cells.join(" | ")} |`);
  }
  console.log();
}

for (const name of scenes) {
  const path = sceneFile(name, options.scenes);
  if (path === null) {
    console.log(`${name}: skipped, no such scene; give --scenes FOLDER`);
    continue;
  }
  const text = await svgOf(path);
  const rounds = editors.map(() => []);
  for (let i = 0; i < Number(options.rounds); i += 1)
    for (const [k, editor] of editors.entries()) rounds[k].push(await measure(pathToFileURL(resolve(editor)).href, text));
  print(basename(path), rounds);
}
