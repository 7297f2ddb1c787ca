// Tools, touch, files and the page's surroundings in Firefox; firefox.mjs runs them.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { drop as dropFiles } from "./disk.mjs";
import { FirefoxPage } from "./gecko.mjs";
import { check, checkEqual, pathOf, serve, Skip } from "./harness.mjs";
import { atOnce, messagesGo } from "./hooks.mjs";
import { largestDifference } from "./pixels.mjs";
import { endEdit, startEdit } from "./served.mjs";
import { example, small } from "./texts.mjs";
import { one } from "./tools.mjs";

const focusStage = (editor) => editor.page.focus(".canvas-stage");

/** Reloads the drawing, selects a curve and takes a tool. */
async function fresh(editor, key, at) {
  await editor.load(one);
  await focusStage(editor);
  await editor.key("v");
  if (at) await editor.click(...at);
  await editor.key(key);
}

/** Returns the text after a drag. */
const dragged = (editor, what, points, keys = []) =>
  editor.changing(what, () => editor.drag(points, { steps: 6, keys }));

const numbers = (text, id = "c") =>
  new RegExp(`id="${id}"[^>]*? d="([^"]*)"`).exec(text)[1].match(/-?[\d.]+/g).map(Number);

export async function testTools(editor) {
  await fresh(editor, "v");
  const moved = numbers(await dragged(editor, "select", [[200, 300], [230, 340]], ["Control"]));
  check(Math.abs(moved[0] - 130) < 2 && Math.abs(moved[1] - 340) < 2, `moved to ${moved}`);
  await fresh(editor, "a", [200, 300]);
  const node = numbers(await dragged(editor, "nodes", [[300, 300], [310, 250]], ["Control"]));
  check(node[0] === 100 && Math.abs(node[2] - 310) < 2 && Math.abs(node[3] - 250) < 2, `the node: ${node}`);
  const bent = await dragged(editor, "the curve itself", [[400, 275], [400, 330]]);
  check(/C/.test(/id="c"[^>]*? d="([^"]*)"/.exec(bent)[1]), `not bent: ${bent}`);
  await fresh(editor, "p");
  for (const at of [[150, 380], [250, 420], [350, 380]]) await editor.click(...at);
  const drawn = await editor.changing("the pen", () => editor.key("Enter"));
  checkEqual(drawn.match(/<path /g).length, 3, "curves after the pen");
  await fresh(editor, "b");
  const free = await dragged(editor, "the pencil", [[150, 400], [250, 430], [350, 390]]);
  checkEqual(free.match(/<path /g).length, 3, "curves after the pencil");
  await fresh(editor, "k");
  check((await dragged(editor, "the stroke", [[150, 400], [350, 390]])).includes("sf:radius="), "there is no stroke");
  await fresh(editor, "u", [200, 300]);
  check(/sf:(left-)?blur="/.test(await dragged(editor, "blur", [[300, 300], [300, 270]])), "there is no blur");
  await fresh(editor, "h");
  const before = await editor.at(0, 0);
  await editor.drag([[200, 200], [260, 220]]);
  await editor.until("the hand moves the picture", ([x]) => window.sfumatoEditor.place(0, 0)[0] > x + 20, before);
  checkEqual(await editor.text, one, "the text after the hand");
}

export async function testTouch(editor) {
  await fresh(editor, "b");
  const touch = editor.page.touchscreen;
  const finger = await touch.touchStart(...(await editor.at(150, 400)));
  for (const to of [[200, 420], [280, 430], [350, 390]]) await finger.move(...(await editor.at(...to)));
  const drawn = await editor.changing("a finger", () => finger.end());
  checkEqual(drawn.match(/<path /g).length, 3, "curves after a finger");
  const width = async () => (await editor.at(100, 0))[0] - (await editor.at(0, 0))[0];
  const before = await width();
  const [x, y] = await editor.at(320, 240);
  const left = await touch.touchStart(x - 50, y);
  const right = await touch.touchStart(x + 50, y);
  for (const apart of [60, 80, 100]) {
    await left.move(x - apart, y);
    await right.move(x + apart, y);
  }
  await left.end();
  await right.end();
  check((await width()) > 1.5 * before, "two fingers do not zoom");
  checkEqual(await editor.text, drawn, "the text after two fingers");
}

/** A pen draws with its pressure, and the palm beside it draws nothing. */
export async function testPen(editor) {
  await fresh(editor, "k");
  const touch = async () => {
    const palm = await editor.page.touchscreen.touchStart(...(await editor.at(300, 200)));
    for (const to of [[320, 210], [380, 220]]) await palm.move(...(await editor.at(...to)));
    await palm.end();
  };
  const places = [];
  for (let k = 0; k <= 8; k += 1) places.push([...(await editor.at(150 + 25 * k, 400 + 4 * k)), 0.2 + 0.09 * k]);
  const [drawn, after] = await atOnce(editor.page, async () => {
    const text = await editor.changing("a pen", () => editor.pen(places));
    await touch();
    return [text, await editor.text];
  });
  checkEqual(drawn.match(/<path /g).length, 3, "curves after a pen");
  const radii = /sf:radius="([^"]*)"/.exec(drawn)?.[1].match(/[\d.]+(?!\d*%)(?=[ ,]|$)/g)?.map(Number) ?? [];
  check(radii.length > 1 && radii.at(-1) > 2 * radii[0], `pressure is not the radius: ${drawn}`);
  checkEqual(after, drawn, "the text after a palm beside the pen");
}

const drop = (editor, files) => dropFiles(editor.page, files);

const holds = (editor, part) =>
  editor.until(`the text holds ${part}`, (wanted) => window.sfumatoEditor.text.includes(wanted), part);

export async function testFiles(editor) {
  await drop(editor, [{ name: "a.svg", bytes: Buffer.from(small) }]);
  await holds(editor, "a stranger's words");
  await drop(editor, [{ name: "b.svgz", bytes: gzipSync(example("apple.svg")) }]);
  await editor.until("the packed drawing is there", (text) => window.sfumatoEditor.text === text, example("apple.svg"));
  await drop(editor, [{ name: "evening.xml", bytes: readFileSync(pathOf("examples/evening.xml")) }]);
  await holds(editor, "sf:diffuse");
  const textures = ["wood.png", "waves.png", "hemp.png"].map((name) => ({ name, bytes: readFileSync(pathOf(`examples/${name}`)), type: "image/png" }));
  await drop(editor, [{ name: "textures.svg", bytes: Buffer.from(example("textures.svg")) }, ...textures]);
  await editor.until("its picture is exact", () => window.sfumatoEditor.status.kind === "exact" && window.sfumatoEditor.text.includes("pattern"));
  await editor.load(small);
  await drop(editor, [textures[0]]);
  await holds(editor, "sf:reference");
}

export async function testLostContext(editor) {
  await editor.load(small);
  await editor.key("Control+Shift+a");
  const before = await editor.picture();
  await editor.page.evaluate(() => {
    window.taken = document.querySelector("canvas.picture").getContext("webgl2").getExtension("WEBGL_lose_context");
    window.taken.loseContext();
  });
  await editor.until("a message names the driver", () => /graphics driver was reset/.test(document.body.textContent));
  await editor.page.evaluate(() => window.taken.restoreContext());
  await editor.until("it comes back", () => !document.querySelector("canvas.picture").getContext("webgl2").isContextLost());
  await messagesGo(editor.page);
  await editor.until("the words go", () => !document.querySelector(".toast"));
  checkEqual(largestDifference(before, await editor.picture()), 0, "the picture after the graphics came back");
}

export async function testOffline({ browser, built }) {
  const server = await serve(join(built, "editor"));
  const editor = await FirefoxPage.open(browser, server.address.replace("127.0.0.1", "localhost"));
  try {
    await editor.page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
    await editor.page.reload();
    await editor.until("the worker serves the page", () => navigator.serviceWorker.controller !== null);
    server.close();
    await editor.page.reload();
    await editor.press(/^Sunset/);
    await editor.until("its picture is exact", () => window.sfumatoEditor.status.kind === "exact");
  } finally {
    await editor.close();
  }
}

export async function testServed({ browser, built }) {
  const command = process.env.SFUMATO;
  if (!command) throw new Skip("SFUMATO names no command");
  const folder = mkdtempSync(join(tmpdir(), "sfumato-firefox-"));
  const drawing = join(folder, "mine.svg");
  writeFileSync(drawing, small);
  const { child, address } = await startEdit(drawing, { command, page: join(built, "editor.html"), folder });
  const editor = await FirefoxPage.open(browser, address);
  try {
    await editor.until("the drawing is there", (text) => window.sfumatoEditor.text === text, small);
    await focusStage(editor);
    await editor.key("Tab");
    const edited = await editor.changing("an arrow", () => editor.key("ArrowRight"));
    await editor.key("Control+s");
    await editor.until("it is saved", () => document.querySelector(".saved")?.textContent === "Saved");
    checkEqual(readFileSync(drawing, "utf8"), edited, "the file");
  } finally {
    await endEdit(child);
    await editor.close();
    rmSync(folder, { recursive: true });
  }
}
