// Traces of photos: the dialog, its rounds, ways to leave it, and its result.
import { readFileSync } from "node:fs";
import { drop } from "./disk.mjs";
import { check, checkEqual, EditorPage, pathOf, until } from "./harness.mjs";
import { small } from "./texts.mjs";
import { closeDialog, said, shows, textAfter } from "./words.mjs";

const dialog = "dialog.trace";
/** The editor's own workers: for frames, and for exact pictures. */
const MOST_WORKERS = 2;

/** Returns a picture of a disc on a ramp as a PNG; with noise a trace takes long. */
async function picture(page, width, height, noise = 0) {
  const bytes = await page.evaluate(async ([w, h, amount]) => {
    const canvas = new OffscreenCanvas(w, h);
    const context = canvas.getContext("2d");
    const ramp = context.createLinearGradient(0, 0, w, h);
    ramp.addColorStop(0, "#20409c");
    ramp.addColorStop(1, "#3cb46c");
    context.fillStyle = ramp;
    context.fillRect(0, 0, w, h);
    context.fillStyle = "#d83020";
    context.beginPath();
    context.arc(w / 2, h / 2, h / 3, 0, 7);
    context.fill();
    // A small generator, so that each run has the same noise.
    let state = 1;
    const next = () => (state = (state * 16807) % 2147483647) / 2147483647;
    for (let i = 0; i < amount; ++i) {
      context.fillStyle = `hsl(${360 * next()} 70% 50%)`;
      context.fillRect(w * next(), h * next(), 20 * next(), 20 * next());
    }
    const blob = await canvas.convertToBlob();
    return [...new Uint8Array(await blob.arrayBuffer())];
  }, [width, height, noise]);
  return { name: "disc.png", type: "image/png", bytes: Buffer.from(bytes) };
}

async function openDialog(page) {
  await page.getByRole("button", { name: "Menu", exact: true }).click();
  await page.getByRole("menuitem", { name: "File" }).click();
  await page.getByRole("menuitem", { name: "Trace photo…" }).click();
  await page.waitForSelector(`${dialog}[open]`);
}

const press = (page, name) => page.locator(dialog).getByRole("button", { name }).click();
const pathsIn = (text) => (text.match(/<path/g) ?? []).length;

async function testNew(editor) {
  const { page } = editor;
  await editor.load(small);
  await openDialog(page);
  await said(page, /Choose a photo, or drop one here/, dialog);
  check(await page.getByRole("button", { name: "Open as new drawing" }).isDisabled(), "there is something to open");
  await drop(page, [await picture(page, 96, 64)], dialog);
  await said(page, /Round \d of \d|Traced/, `${dialog} [role=status]`);
  await page.waitForFunction(() => document.querySelector("dialog.trace canvas")?.ariaLabel?.startsWith("The drawing"));
  const words = await said(page, /Traced \d+(\.\d)? dB/, `${dialog} [role=status]`);
  check(Number(/[\d.]+/.exec(words)[0]) > 25, `a disc is traced at ${words}`);
  checkEqual(await page.locator(`${dialog} progress`).getAttribute("value"), "1", "the progress at the end");
  await press(page, "Open as new drawing");
  await page.waitForFunction(() => window.sfumatoEditor.text.includes('viewBox="0 0 96 64"'));
  await said(page, /The photo was traced with \d+ curves/);
  const text = await editor.text;
  check(pathsIn(text) >= 2, `${pathsIn(text)} curves`);
  check(/<image[^>]*sf:reference="true"/.test(text), "the photo is not kept");
  check(/<g [^>]*id="disc"/.test(text), "the layer has no name");
  checkEqual((text.match(/<g /g) ?? []).length, 1, "layers");
  await editor.key("Control+z");
  await textAfter(page, text);
  checkEqual(pathsIn(await editor.text), 0, "curves after undo");
  await editor.key("Control+Shift+z");
  await shows(page, text);
  checkEqual(await page.locator(".file-name").textContent(), "disc, traced.svg", "the file's name");
  await editor.settled();
  checkEqual((await page.evaluate(() => window.sfumatoEditor.status)).kind, "exact", "the picture of the drawing");
}

async function testInsert(editor) {
  const { page } = editor;
  await editor.load(small);
  await openDialog(page);
  await drop(page, [await picture(page, 96, 64)], dialog);
  await said(page, /Traced/, `${dialog} [role=status]`);
  await page.getByText("Keep the photo as reference").click();
  await press(page, "Insert as layer");
  const text = await textAfter(page, small);
  checkEqual((text.match(/sf:diffuse="true"/g) ?? []).length, 2, "layers");
  check(!text.includes("<image"), "the photo is kept against the wish");
  check(text.includes("a stranger's words"), "the rest of the text is lost");
  // 96 by 64 fit into 100 by 80 at 100/96.
  const [scale] = /matrix\(([^)]*)\)|scale\(([^)]*)\)/.exec(text).slice(1).filter(Boolean);
  check(Math.abs(Number(scale.split(/[ ,]/)[0]) - 100 / 96) < 1e-4, `scaled by ${scale}`);
  await editor.settled();
  checkEqual((await page.evaluate(() => window.sfumatoEditor.status)).kind, "exact", "the picture");
  await editor.key("Control+z");
  await shows(page, small);
}

async function testCancel({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await editor.load(small);
  await openDialog(page);
  await drop(page, [await picture(page, 900, 700, 4000)], dialog);
  await page.locator(dialog).getByRole("button", { name: "Cancel" }).waitFor();
  // The page reacts while the worker is busy.
  await page.locator(dialog).getByRole("radio", { name: "Photo" }).click();
  await press(page, "Cancel");
  await said(page, /Stopped/, `${dialog} [role=status]`);
  // The trace can be started again with other options, and cancelled as a whole.
  await page.getByRole("slider", { name: "Detail" }).fill("0.1");
  await said(page, /379 control points/, dialog);
  await page.locator(dialog).getByRole("button", { name: "Cancel" }).waitFor();
  await closeDialog(page);
  await shows(page, small);
  await until("no worker is left", () => page.workers().length <= MOST_WORKERS);
  editor.checkQuiet();
  await editor.close();
}

async function testOffer(editor) {
  const { page } = editor;
  await editor.load(small);
  await drop(page, [await picture(page, 96, 64)]);
  await said(page, /Photo placed over the drawing/);
  await page.getByRole("button", { name: "Trace…" }).click();
  await said(page, /Traced/, `${dialog} [role=status]`);
  checkEqual(await page.getByText("Keep the photo as reference").count(), 0, "wishes to keep what is there");
  const before = await editor.text;
  await press(page, "Insert as layer");
  const text = await textAfter(page, before);
  checkEqual((text.match(/<image/g) ?? []).length, 1, "photos");
  await editor.key("Control+z");
  await shows(page, before);
}

async function testRefusals(editor) {
  const { page } = editor;
  await editor.load(small);
  await openDialog(page);
  const cut = readFileSync(pathOf("examples/wood.png")).subarray(0, 200);
  await drop(page, [{ name: "cut.png", bytes: cut }], dialog);
  await said(page, /cannot show.*cut\.png/, "dialog");
  await closeDialog(page);
  await openDialog(page);
  await drop(page, [await picture(page, 1, 1)], dialog);
  await said(page, /Traced/, `${dialog} [role=status]`);
  await closeDialog(page);
  await shows(page, small);
}

/** With the keyboard only: the focus goes into the dialog, through it, and back. */
async function testKeys(editor) {
  const { page } = editor;
  await editor.load(small);
  await openDialog(page);
  await drop(page, [await picture(page, 96, 64)], dialog);
  await said(page, /Traced/, `${dialog} [role=status]`);
  const slider = page.getByRole("slider", { name: "Detail" });
  await slider.focus();
  await editor.key("Home");
  await said(page, /250 control points/, dialog);
  checkEqual(await slider.getAttribute("aria-valuetext"), "250 control points", "what is read for the slider");
  await said(page, /Traced/, `${dialog} [role=status]`);
  await page.locator(dialog).getByRole("button", { name: "Insert as layer" }).focus();
  await editor.key("Enter");
  await textAfter(page, small);
  checkEqual(await page.locator("dialog[open]").count(), 0, "dialogs");
}

export async function testTrace(tap, { browser, address }) {
  const editor = await EditorPage.open(browser, address);
  await tap.test("trace: a photo becomes a new drawing, round by round", () => testNew(editor));
  await tap.test("trace: a photo becomes a layer, in one step of undo", () => testInsert(editor));
  await tap.test("trace: it is stopped at any time, and nothing stays", () => testCancel({ browser, address }));
  await tap.test("trace: a photo that was dropped is offered to be traced", () => testOffer(editor));
  await tap.test("trace: what is no photo is refused in words", () => testRefusals(editor));
  await tap.test("trace: by keys alone", () => testKeys(editor));
  await tap.test("trace: nothing was complained of", () => editor.checkQuiet());
  await editor.close();
}
