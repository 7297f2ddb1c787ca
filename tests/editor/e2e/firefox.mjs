// The editor's tests in Firefox, printed as TAP.
//
//   node tests/editor/e2e/firefox.mjs BUILD_FOLDER [ONLY]
//
// As for run.mjs. SFUMATO names the command whose pixels an export must equal.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { FirefoxPage, launchFirefox, missing } from "./gecko.mjs";
import { check, checkEqual, EditorPage, launch, serve, Skip, Tap, until } from "./harness.mjs";
import { atOnce } from "./hooks.mjs";
import { testFiles, testLostContext, testOffline, testPen, testServed, testTools, testTouch } from "./firefox-tools.mjs";
import { countColors, largestDifference } from "./pixels.mjs";
import { isKept } from "./recover.mjs";
import { small } from "./texts.mjs";

const focusStage = (editor) => editor.page.focus(".canvas-stage");

const checkShown = async (editor) => {
  const count = countColors(await editor.picture());
  check(count > 200, `the picture has ${count} colours`);
};

/** The first page with its pictures, and one of its drawings. */
async function testOpens(editor) {
  const hasWebGl = () => document.createElement("canvas").getContext("webgl2") !== null;
  check(await editor.page.evaluate(hasWebGl), "there is no WebGL 2");
  await editor.until("there are pictures to begin from", () => {
    const pictures = [...document.images];
    return pictures.length > 5 && pictures.every(({ complete, naturalWidth }) => complete && naturalWidth > 0);
  });
  await editor.press(/^Sunset/);
  await editor.until("its picture is exact", () => window.sfumatoEditor.status.kind === "exact");
  await checkShown(editor);
}

/** Returns a complete file that arrives in the folder of downloads. */
async function downloaded(folder, act) {
  await act();
  let file = null;
  await until("a file comes", () => {
    const names = readdirSync(folder);
    const [name] = names;
    if (names.length !== 1 || name.endsWith(".part")) return false;
    file = { name, bytes: readFileSync(join(folder, name)) };
    return file.bytes.length > 0;
  });
  rmSync(join(folder, file.name));
  return file;
}

async function drawAll(editor) {
  await editor.key("p");
  await editor.click(120, 400);
  await editor.drag([[400, 150], [520, 210]]);
  await editor.click(600, 420);
  await editor.changing("the pen", () => editor.key("Enter"));
  await editor.press(/stop 1/, ".inspector [role=group] .stop");
  check(/sf:left="#e04030/.test(await editor.fill("Colour, hex", "e04030")), "the left side is not coloured");
  await focusStage(editor);
  await editor.key("u");
  const soft = await editor.changing("the blur tool", () => editor.drag([[215, 252], [180, 225]]));
  check(/blur(-left|-right)?="[^"]*[1-9]/.test(soft), `no blur was written: ${soft}`);
  await editor.changing("New layer", () => editor.press(/^New layer/));
  await editor.key("b");
  await editor.changing("the pencil", () => editor.drag([[80, 440], [320, 460], [560, 450]], { steps: 6 }));
}

/** Presses a key until its button is disabled. @returns how often */
async function every(editor, key, name) {
  await focusStage(editor);
  const isOver = (start) => document.querySelector(`button[aria-label^=${start}]`).disabled;
  let times = 0;
  for (; !(await editor.page.evaluate(isOver, name)); times += 1) {
    check(times < 20, `${key} never ends`);
    await editor.changing(key, () => editor.key(key));
  }
  return times;
}

async function testDraw(editor, folder, { address, browser }) {
  await editor.press(/^Start blank/);
  await editor.press(/^Create/, "dialog button");
  await editor.matches(".canvas-stage");
  const start = await editor.text;
  await drawAll(editor);
  const end = await editor.text;
  await editor.key("v", "Control+Shift+a");
  const picture = await editor.picture();
  const back = await every(editor, "Control+z", "Undo");
  checkEqual(await editor.text, start, "the text after undoing all");
  checkEqual(await every(editor, "Control+Shift+z", "Redo"), back, "steps forth");
  checkEqual(await editor.text, end, "the text after redoing all");
  const file = await downloaded(folder, () => editor.key("Control+s"));
  checkEqual(file.bytes.toString(), end, "the file");
  await testExport(editor, folder, end);
  const other = await FirefoxPage.open(browser, address);
  await other.load(end);
  checkEqual(largestDifference(picture, await other.picture()), 0, "the picture of the saved file");
  other.checkQuiet();
  await other.close();
  return { text: end, picture };
}

/** An exported PNG has the pixels that the command draws of a solved picture. */
async function testExport(editor, folder, text) {
  await editor.key("Control+e");
  await editor.press(/^PNG/, "dialog.export label");
  const file = await downloaded(folder, () => editor.press(/^Export PNG/, "dialog.export button"));
  await editor.until("the dialog goes", () => !document.querySelector("dialog[open]"));
  const command = process.env.SFUMATO;
  if (!command) return console.log("# SFUMATO names no command to compare the export with");
  const [svg, solved, png] = ["drawing.svg", "drawing.sfp", "drawing.png"].map((name) => join(folder, name));
  writeFileSync(svg, text);
  const width = String(file.bytes.readUInt32BE(16)); // in the header of the PNG
  execFileSync(command, ["solve", svg, "-o", solved, "--width", width], { stdio: "ignore" });
  execFileSync(command, ["render", solved, "-o", png, "--width", width], { stdio: "ignore" });
  checkEqual(largestDifference(file.bytes, readFileSync(png)), 0, "the export beside the command's pixels");
}

/** The stage shows the same picture as in Chromium. */
async function testSame({ address }, drawn) {
  const chromium = process.env.CHROMIUM ?? "/usr/bin/chromium";
  if (!existsSync(chromium)) throw new Skip("there is no Chromium");
  check(drawn, "nothing was drawn");
  const browser = await launch();
  try {
    const editor = await EditorPage.open(browser, address, { size: FirefoxPage.size, ratio: 1, isDrawn: true });
    await editor.load(drawn.text);
    const most = largestDifference(drawn.picture, await editor.picture());
    console.log(`# Firefox and Chromium differ by ${most} code values`);
    check(most <= 2, `they differ by ${most} code values`);
  } finally {
    await browser.close();
  }
}

async function testOneFile(editor) {
  await editor.press(/^Textures/);
  await editor.until("its picture is exact", () => window.sfumatoEditor.status.kind === "exact");
  await checkShown(editor);
}

const selected = (editor) => editor.page.evaluate(() => window.sfumatoEditor.selection.map(({ name }) => name).join());

/** Presses Tab until an element with these words has the focus. */
async function tabTo(editor, words) {
  const isThere = (start) => document.activeElement.textContent.trim().startsWith(start);
  for (let tries = 0; !(await editor.page.evaluate(isThere, words)); tries += 1) {
    check(tries < 20, `Tab does not reach ${words}`);
    await editor.key("Tab");
  }
}

/** From the first page to an edit and back without a pointer. */
async function testKeys(editor) {
  await tabTo(editor, "Start blank");
  await editor.key("Enter");
  await editor.matches("dialog[open]");
  await tabTo(editor, "Create");
  await editor.key("Enter");
  await editor.matches(".canvas-stage");
  await editor.load(small);
  await focusStage(editor);
  for (const [key, tool] of [["a", "nodes"], ["p", "pen"], ["v", "select"]]) {
    await editor.key(key);
    await editor.matches(`[data-tool=${tool}][aria-checked=true]`);
  }
  await editor.key("Tab");
  checkEqual(await selected(editor), "one", "what Tab selects");
  // Arrow keys in quick succession are one step.
  const moved = await atOnce(editor.page, async () => {
    await editor.changing("an arrow", () => editor.key("ArrowRight"));
    return editor.changing("an arrow with Shift", () => editor.key("Shift+ArrowDown"));
  });
  checkEqual(await editor.changing("Ctrl Z", () => editor.key("Control+z")), small, "the text after Ctrl Z");
  checkEqual(await editor.changing("Ctrl Y", () => editor.key("Control+y")), moved, "the text after Ctrl Y");
  await testOwnKeys(editor);
}

/** Firefox's own shortcuts go to the page, except one that leaves the canvas. */
async function testOwnKeys(editor) {
  await editor.page.evaluate(() => {
    window.heard = [];
    addEventListener("keydown", (event) => window.heard.push([event.key, event.defaultPrevented]));
  });
  const keys = ["Control+d", "Control+Shift+a", "Control+a", "Control+g", "Control+Shift+g", "Control+j", "F6"];
  for (const key of keys) {
    await focusStage(editor);
    await editor.key(key);
    const [name, isTaken] = await editor.page.evaluate(() => window.heard.at(-1) ?? []);
    check(isTaken, `${key} is Firefox's: ${name} was heard last`);
  }
  const isAway = () => document.hasFocus() && !document.activeElement.matches(".canvas-stage, body");
  await editor.until("F6 goes to another part of the window", isAway);
}

/** Peculiar to Firefox: it pastes with the middle button, and fills columns to the available height. */
async function testPeculiar(editor) {
  const { page } = editor;
  await editor.load(small);
  const before = await editor.at(0, 0);
  const way = [[300, 300], [340, 320]];
  await page.mouse.move(...way[0]);
  await page.mouse.down({ button: "middle" });
  await page.mouse.move(...way[1], { steps: 4 });
  await page.mouse.up({ button: "middle" });
  const isMoved = ([x, y]) => {
    const [a, b] = window.sfumatoEditor.place(0, 0);
    return Math.abs(a - x - 40) < 1 && Math.abs(b - y - 20) < 1;
  };
  await editor.until("the middle button moves the picture", isMoved, before);
  // An action that comes later than any paste.
  await focusStage(editor);
  await editor.key("?");
  await editor.matches("dialog.keys[open]");
  const said = () => [...document.querySelectorAll(".toast")].map(({ textContent }) => textContent);
  checkEqual(await page.evaluate(said), [], "what the middle button brought");
  checkEqual(await editor.text, small, "the text after the middle button");
  const beyond = () => [...document.querySelectorAll("dialog.keys, dialog.keys *")].filter((e) => e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 200).length;
  checkEqual(await page.evaluate(beyond), 0, "parts of the list of keys that are wider than their place");
}

/** A drawing exists after a reload, with its undo. */
async function testReload(editor) {
  const { page } = editor;
  await editor.load(small, "kept.svg");
  await focusStage(editor);
  await editor.key("Tab");
  const edited = await editor.changing("an arrow", () => editor.key("ArrowRight"));
  await isKept(page, edited);
  await page.reload();
  const isShown = (text) => window.sfumatoEditor?.text === text;
  await editor.until("the edited text is there", isShown, edited);
  await focusStage(editor);
  await editor.key("Control+z");
  await editor.until("the text before the edit is there", isShown, small);
}

async function testAll(tap, given) {
  const test = (name, address, body) =>
    tap.test(`firefox: ${name}`, async () => {
      const folder = mkdtempSync(join(tmpdir(), "sfumato-firefox-"));
      const editor = await FirefoxPage.open(given.browser, address, { downloads: folder });
      try {
        await body(editor, folder);
        editor.checkQuiet();
      } finally {
        await editor.close();
        rmSync(folder, { recursive: true });
      }
    });
  let drawn = null;
  await test("the site opens without complaints", given.address, testOpens);
  await test("a drawing is made, undone, redone, saved and opened", given.address, async (editor, folder) => {
    drawn = await testDraw(editor, folder, given);
  });
  await tap.test("firefox: its pixels are Chromium's", () => testSame(given, drawn));
  await test("one file from the disk works", given.oneFile, testOneFile);
  await test("keys alone do", given.address, testKeys);
  await test("it pastes nothing by the middle button, and lists all keys", given.address, testPeculiar);
  await test("a reload loses nothing", given.address, testReload);
  await test("every tool does its gesture", given.address, testTools);
  await test("one finger draws, two move and zoom", given.address, testTouch);
  await test("a pen draws with its pressure", given.address, testPen);
  await test("files of all kinds are dropped", given.address, testFiles);
  await test("graphics that are taken away come back", given.address, testLostContext);
  await tap.test("firefox: after one visit it needs no network", () => testOffline(given));
  await tap.test("firefox: the command's drawing is edited and saved", () => testServed(given));
}

const [built = "build", only = ""] = process.argv.slice(2);
const lacks = missing();
if (lacks) {
  console.log(`ok - editor: firefox: the editor works there # SKIP there is no ${lacks}`);
} else {
  const tap = new Tap({ only, prefix: "editor: " });
  const server = await serve(resolve(built, "editor"));
  const { browser, close } = await launchFirefox();
  const oneFile = pathToFileURL(join(resolve(built), "editor.html")).href;
  try {
    await testAll(tap, { browser, address: server.address, oneFile, built: resolve(built) });
  } finally {
    await close();
    server.close();
  }
  process.exitCode = tap.failures > 0 ? 1 : 0;
}
