// From the empty page to a drawing with every feature, back by undo, forward by redo, saved and opened.
import { readFile } from "node:fs/promises";
import { check, checkEqual, EditorPage, newContext } from "./harness.mjs";
import { largestDifference } from "./pixels.mjs";

/** Opens the editor with downloads and inputs for files, because no test can answer the system's dialogs. */
export async function openWithoutPickers(browser, address, options = {}) {
  const context = await newContext(browser, options);
  await context.addInitScript(() => {
    delete window.showSaveFilePicker;
    delete window.showOpenFilePicker;
  });
  return EditorPage.within(context, address);
}

/** Presses Start blank and accepts the dialog's proposal. */
export async function startBlank(editor) {
  const { page } = editor;
  await page.getByRole("button", { name: /^Start blank/ }).click();
  await page.getByRole("dialog").getByRole("button", { name: "Create" }).click();
  await page.locator(".canvas-stage").waitFor();
  await editor.settled();
}

/** Does something and waits until the text has changed. @returns the new text */
export async function changing(editor, what, act) {
  const before = await editor.text;
  await act();
  await editor.page
    .waitForFunction((text) => window.sfumatoEditor.text !== text, before)
    .catch(() => check(false, `${what} changes nothing${editor.errors.map((error) => `; ${error}`).join("")}`));
  return editor.text;
}

export const count = (text, pattern) => text.match(pattern)?.length ?? 0;

/** Numbers may differ by rounding between machines; everything else must be equal. */
export function checkAlike(actual, expected, what) {
  const number = /-?\d*\.?\d+(?:e-?\d+)?/g;
  const frame = (text) => text.replace(number, "0");
  checkEqual(frame(actual), frame(expected), `${what}, with all numbers removed`);
  const [a, b] = [actual, expected].map((text) => (text.match(number) ?? []).map(Number));
  const far = a.findIndex((value, k) => Math.abs(value - b[k]) > 0.5);
  check(far < 0, `${what}: ${a[far]}, expected ${b[far]}`);
}

async function drawPen(editor) {
  await editor.key("p");
  await editor.click(90, 330);
  await editor.click(230, 130);
  await editor.drag([[430, 150], [520, 210]]);
  const text = await changing(editor, "Enter", () => editor.key("Enter"));
  checkEqual(count(text, /<path /g), 1, "curves after the pen");
}

async function drawPencil(editor) {
  await editor.key("b");
  const way = Array.from({ length: 12 }, (_, k) => [80 + 40 * k, 390 + 25 * Math.sin(k / 2)]);
  const text = await changing(editor, "the pencil", () => editor.drag(way, { steps: 3 }));
  checkEqual(count(text, /<path /g), 2, "curves after the pencil");
}

/** Returns the distance of a pixel from the selected curve, in steps of 8 px, at most 3. */
async function fromCurve(editor) {
  const points = await editor.page.evaluate(() => {
    const stage = document.querySelector(".canvas-stage").getBoundingClientRect();
    const lines = [...document.querySelectorAll(".canvas-overlay .handles path")];
    return lines.flatMap((line) => {
      const length = line.getTotalLength();
      const map = line.getScreenCTM();
      return Array.from({ length: Math.ceil(length / 2) + 1 }, (_, k) => {
        const { x, y } = line.getPointAtLength(Math.min(2 * k, length)).matrixTransform(map);
        return [x - stage.left, y - stage.top];
      });
    });
  });
  check(points.length > 20, "no curve is shown");
  const cells = new Map();
  for (const [x, y] of points) {
    for (let i = -2; i <= 2; i += 1) {
      for (let j = -2; j <= 2; j += 1) {
        const key = `${(x >> 3) + i},${(y >> 3) + j}`;
        cells.set(key, Math.min(cells.get(key) ?? 3, Math.max(Math.abs(i), Math.abs(j))));
      }
    }
  }
  return (x, y) => cells.get(`${x >> 3},${y >> 3}`) ?? 3;
}

const field = (editor, name) => editor.page.locator(".inspector").getByLabel(name, { exact: true });

async function fill(editor, name, value) {
  const input = field(editor, name);
  await input.fill(value);
  await changing(editor, name, () => input.press("Enter"));
}

const stops = (editor, side) => editor.page.getByRole("group", { name: `${side} side` }).first().locator(".stop");

/** Gives colours: a stop by its field, a new stop on the band, one by the picker, one by keys. */
async function colour(editor) {
  const { page } = editor;
  await stops(editor, "Left").first().click();
  await fill(editor, "Colour, hex", "e04030");
  const band = page.getByRole("group", { name: "Left side" }).locator(".band");
  const { width } = await band.boundingBox();
  const isMore = () => changing(editor, "a click on the band", () => band.click({ position: { x: 0.75 * width, y: 6 } }));
  check(/sf:left="#e04030, #e04030 7\d/.test(await isMore()), "the band's new stop has another colour");
  await fill(editor, "Colour, hex", "#20a0f0");
  await stops(editor, "Right").first().dblclick();
  const picker = page.getByRole("dialog", { name: "Colour of right stop 1" });
  await picker.waitFor();
  await changing(editor, "the picker's plane", () => picker.locator(".plane").click({ position: { x: 150, y: 60 } }));
  const hue = picker.getByRole("slider", { name: "Hue" });
  await changing(editor, "the hue by keys", () => hue.press("PageUp"));
  await page.keyboard.press("Escape");
  await picker.waitFor({ state: "detached" });
  await stops(editor, "Left").nth(1).focus();
  await changing(editor, "an arrow on a stop", () => page.keyboard.press("ArrowLeft"));
}

async function blur(editor) {
  await fill(editor, "Blur, radius of point 1", "6");
  await editor.key("Escape");
  await editor.key("u");
  const text = await changing(editor, "the blur tool", () => editor.drag([[330, 112], [330, 60]]));
  check(/blur(-left|-right)?="[^"]*[1-9]/.test(text), "no blur was written");
}

async function steps(editor) {
  const { page } = editor;
  const panel = page.getByRole("region", { name: "Layers" });
  await drawPen(editor);
  await colour(editor);
  await fill(editor, "Opacity, left", "60");
  await blur(editor);
  await editor.settled();
  const before = await editor.picture();
  await drawPencil(editor);
  const away = await fromCurve(editor);
  const after = await editor.picture();
  // The new curve takes its colours from the picture below it. The picture beside it hardly changes.
  const change = largestDifference(before, after, (x, y) => away(x, y) === 0);
  check(change <= 6, `beside a new curve the picture changes by ${change}`);
  await fill(editor, "Colour of the whole left side, hex", "ffe080");
  await changing(editor, "New layer", () => panel.getByRole("button", { name: "New layer" }).click());
  const empty = await editor.picture();
  await changing(editor, "the pencil", async () => {
    await editor.key("b");
    await editor.drag([[200, 200], [330, 260], [450, 240]], { steps: 6 });
  });
  const second = largestDifference(empty, await editor.picture());
  check(second === 0, `the first curve of a layer changes the picture by ${second}`);
  const give = page.locator(".inspector").getByRole("button", { name: "Add colour to this side" });
  await changing(editor, "Add colour to this side", () => give.first().click());
  await fill(editor, "Opacity, left", "50");
  await panel.getByRole("treeitem").first().click();
  await changing(editor, "an instance", () => page.keyboard.press("Control+Alt+d"));
  await editor.key("k");
  await changing(editor, "a stroke", () => editor.drag([[100, 60], [250, 40], [400, 70]], { steps: 5 }));
  await changing(editor, "a second stroke", () => editor.drag([[120, 90], [260, 80]], { steps: 5 }));
  await editor.key("v", "Control+Shift+a");
  const rows = panel.getByRole("treeitem");
  await rows.nth(0).click();
  await rows.nth(1).click({ modifiers: ["Shift"] });
  await changing(editor, "a group", () => page.keyboard.press("Control+g"));
}

async function every(editor, key, name) {
  const { page } = editor;
  await page.locator(".canvas-stage").focus();
  const button = page.getByRole("button", { name });
  let times = 0;
  for (; await button.isEnabled(); times += 1) {
    check(times < 100, `${key} never ends`);
    await changing(editor, key, () => page.keyboard.press(key));
  }
  return times;
}

async function testAll({ browser, address }) {
  // At the size that people see.
  const editor = await openWithoutPickers(browser, address, { ratio: 1, isDrawn: true });
  const { page } = editor;
  await startBlank(editor);
  const start = await editor.text;
  await steps(editor);
  const end = await editor.text;
  const picture = await editor.picture();
  await editor.shot("draw");
  const back = await every(editor, "Control+z", /^Undo/);
  checkEqual(await editor.text, start, "the text after undoing all");
  checkEqual(await every(editor, "Control+Shift+z", /^Redo/), back, "steps forth");
  checkEqual(await editor.text, end, "the text after redoing all");
  await editor.key("Control+Shift+a");
  const again = await editor.picture();
  checkEqual(largestDifference(picture, again), 0, "the picture after redoing all");
  const saved = page.waitForEvent("download");
  await page.keyboard.press("Control+s");
  const file = await readFile(await (await saved).path(), "utf8");
  checkEqual(file, end, "the file");
  const other = await EditorPage.within(editor.context, address);
  await other.load(file);
  checkEqual(largestDifference(picture, await other.picture()), 0, "the picture of the saved file");
  editor.checkQuiet();
  other.checkQuiet();
  await editor.close();
}

export async function testDraw(tap, given) {
  await tap.test("a drawing is made, undone, redone, saved and opened", () => testAll(given));
}
