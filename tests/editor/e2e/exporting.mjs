// Exports and copies: the engine's pixels, the text, a page; and pasting into another page.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { downloaded, giveDisk, Disk } from "./disk.mjs";
import { check, checkEqual, EditorPage, newContext, packageOf, pathOf, PATIENCE, until } from "./harness.mjs";
import { workersRest } from "./hooks.mjs";
import { example, small } from "./texts.mjs";
import { closeDialog, said, shows, textAfter } from "./words.mjs";

const { decode } = packageOf("fast-png");
const command = process.env.SFUMATO ?? pathOf("build/sfumato");

/** Returns a context of the site's own module, in this process. */
async function contextOf(folder) {
  const assets = join(folder, "editor/assets");
  const name = readdirSync(assets).find((file) => file.endsWith(".wasm"));
  const { loadSfumato } = await import(pathToFileURL(pathOf("web/wasm/sfumato.mjs")).href);
  return (await loadSfumato(readFileSync(join(assets, name)))).context({});
}

/** Returns RGBA of the engine, as from `sfumato render`. */
function rasterOf(context, text, { width, height, format, background }) {
  const fine = format === "rgba16" ? { "max-error": 0.25 } : {};
  const picture = context.solve(context.read(text), { width, height, ...fine });
  return context.raster(picture, { width, height, format }, { dither: format === "rgba8", background });
}

/** Opens the dialog, makes choices, and exports. Returns the file. */
async function exported({ page }, format, { checks = [], scale = null } = {}) {
  await page.keyboard.press("Control+e");
  const dialog = page.locator("dialog.export");
  await dialog.getByRole("radio", { name: new RegExp(`^${format}`) }).check();
  if (scale) await dialog.getByText(scale, { exact: true }).click();
  for (const name of checks) await dialog.getByRole("checkbox", { name }).check();
  const file = await downloaded(page, () => dialog.getByRole("button", { name: `Export ${format}` }).click());
  await page.waitForFunction(() => !document.querySelector("dialog[open]"));
  return file;
}

/** Returns the RGBA channels that a PNG has. */
function withAlpha({ data, channels, width, height, depth }) {
  if (channels === 4) return data;
  const rgba = new data.constructor(4 * width * height).fill(2 ** depth - 1);
  for (let i = 0; i < width * height; ++i) for (let c = 0; c < 3; ++c) rgba[4 * i + c] = data[3 * i + c];
  return rgba;
}

async function testPng(editor, context) {
  const text = example("fish.svg");
  await editor.load(text, "fish.svg");
  const { name, bytes } = await exported(editor, "PNG", { scale: "1×" });
  checkEqual(name, "fish.png", "the name of the PNG");
  const png = decode(bytes);
  const size = { width: png.width, height: png.height };
  checkEqual(size, { width: 840, height: 560 }, "the size of the PNG at 1×");
  const wanted = rasterOf(context, text, { ...size, format: "rgba8" });
  check(Buffer.from(withAlpha(png)).equals(Buffer.from(wanted)), "the PNG's pixels are not the engine's");
}

async function testDeepPng(editor, context) {
  const background = small.replace("<g ", '<rect width="100" height="80" fill="#fff"/>\n  <g ');
  await editor.load(background, "small.svg");
  const checks = ["16 bits per channel", "Transparent background"];
  const png = decode((await exported(editor, "PNG", { checks })).bytes);
  checkEqual(png.depth, 16, "bits of a channel");
  const size = { width: png.width, height: png.height };
  const wanted = rasterOf(context, background, { ...size, format: "rgba16", background: "none" });
  check(Buffer.from(withAlpha(png).buffer).equals(Buffer.from(wanted.buffer, wanted.byteOffset, wanted.byteLength)), "16 bits differ from the engine's");
}

/** Without its texture the drawing cannot be drawn; the dialog says so, and where. */
async function testUndrawable(editor) {
  const { page } = editor;
  await editor.load(example("apple.svg"), "apple.svg");
  await page.keyboard.press("Control+e");
  await page.getByRole("button", { name: "Export PNG" }).click();
  await said(page, /^Line \d+, column \d+: .*wood\.png/, "dialog [role=alert]");
  await closeDialog(page);
}

/** Returns the file that the command writes of a text. */
function written(text, name, options) {
  const folder = mkdtempSync(join(tmpdir(), "sfumato-export-"));
  try {
    const drawing = join(folder, "drawing.svg");
    writeFileSync(drawing, text);
    execFileSync(command, ["render", drawing, "-o", join(folder, name), "--quiet", ...options]);
    return readFileSync(join(folder, name));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** PDF and plain SVG have the bytes of the command. */
async function testVectors(editor) {
  const { page } = editor;
  await editor.load(small, "small.svg");
  const pdf = await exported(editor, "PDF");
  checkEqual([pdf.name, String(pdf.bytes.subarray(0, 5))], ["small.pdf", "%PDF-"], "the PDF");
  check(pdf.bytes.equals(written(small, "a.pdf", ["--title", "small"])), "the PDF is not the command's");
  const plain = await exported(editor, "Plain SVG");
  checkEqual(plain.name, "small-plain.svg", "the name of the plain SVG");
  check(plain.bytes.equals(written(small, "a.svg", ["--svg", "vector"])), "the plain SVG is not the command's");
  check(/^<svg [^]*<\/svg>\s*$/.test(String(plain.bytes)), "the plain SVG is not complete");
  await page.keyboard.press("Control+e");
  await page.locator("dialog.export").getByRole("radio", { name: "Image", exact: true }).click();
  const image = await downloaded(page, () => page.getByRole("button", { name: "Export Plain SVG" }).click());
  check(image.bytes.equals(written(small, "a.svg", ["--svg", "image"])), "the SVG of pixels is not the command's");
}

/** An empty drawing is exported too; one of too many triangles says what to do. */
async function testVectorsOfLittleAndMuch(editor) {
  const { page } = editor;
  const empty = small.replace(/<path[^]*?\/>/, "");
  await editor.load(empty, "empty.svg");
  const { bytes } = await exported(editor, "PDF");
  check(bytes.equals(written(empty, "a.pdf", ["--title", "empty"])), "the empty PDF is not the command's");
  await editor.load(example("fish.svg"), "fish.svg");
  await page.keyboard.press("Control+e");
  await page.locator("dialog.export").getByRole("radio", { name: /^Plain SVG/ }).check();
  await page.getByRole("button", { name: "Export Plain SVG" }).click();
  await said(page, /40000 triangles/, "dialog [role=alert]");
  await closeDialog(page);
}

/** Two sizes are two files, with the suffixes of their scales. */
async function testSizes(browser, address) {
  const context = await newContext(browser, { size: [1000, 700] });
  await context.addInitScript(() => delete window.showOpenFilePicker);
  const editor = await EditorPage.within(context, address);
  const { page } = editor;
  await editor.load(small, "small.svg");
  await page.keyboard.press("Control+e");
  const dialog = page.locator("dialog.export");
  await dialog.getByRole("checkbox", { name: "@1x" }).check();
  await dialog.getByRole("checkbox", { name: "@3x" }).check();
  const files = [];
  page.on("download", (download) => files.push(download));
  await dialog.getByRole("button", { name: "Export 3 PNG files" }).click();
  await until("three files are downloaded", () => files.length === 3);
  const sizes = [];
  for (const file of files) {
    const { width, height } = decode(readFileSync(await file.path()));
    sizes.push([file.suggestedFilename(), width, height]);
  }
  const wanted = [["small.png", 100, 80], ["small@2x.png", 200, 160], ["small@3x.png", 300, 240]];
  checkEqual(sizes, wanted, "the files");
  await page.waitForFunction(() => !document.querySelector("dialog[open]"));
  editor.checkQuiet();
  await editor.close();
}

/** The selected layer alone is drawn as if the other ones were definitions. */
async function testSelectionOnly(editor, context) {
  const { page } = editor;
  const over = '<g id="over" sf:diffuse="true"><path d="M20 20H60V60H20Z" sf:right="#2a6" sf:left="#2a6" sf:left-opacity="0"/></g>';
  const both = small.replace("\n</svg>", `\n  ${over}\n</svg>`);
  await editor.load(both, "both.svg");
  await page.getByRole("treeitem", { name: "over" }).click();
  const png = decode((await exported(editor, "PNG", { scale: "1×", checks: ["Selected layers only"] })).bytes);
  const alone = both.replace(/(<g (?!id="over")[^]*?<\/g>)/, "<defs>$1</defs>");
  const size = { width: png.width, height: png.height };
  const wanted = rasterOf(context, alone, { ...size, format: "rgba8" });
  check(Buffer.from(withAlpha(png)).equals(Buffer.from(wanted)), "the PNG shows something else");
  const all = rasterOf(context, both, { ...size, format: "rgba8" });
  check(!Buffer.from(wanted).equals(Buffer.from(all)), "the test's layers look the same");
}

async function testSvg(editor) {
  const photo = '\n  <image sf:reference="true" href="data:image/png;base64,iVBORw0KGgo=" width="9" height="9"/>';
  const traced = small.replace("\n</svg>", `${photo}\n</svg>`);
  await editor.load(traced, "traced.svg");
  const { name, bytes } = await exported(editor, "SVG");
  checkEqual([name, String(bytes)], ["traced.svg", small], "the SVG without its photo");
}

/** The viewer's exported page shows the same as the editor's canvas. */
async function testHtml(editor, browser) {
  await editor.load(small, "small.svg");
  const { name, bytes } = await exported(editor, "HTML");
  checkEqual(name, "small.html", "the page's name");
  const folder = mkdtempSync(join(tmpdir(), "sfumato-html-"));
  const page = await browser.newPage({ viewport: { width: 160, height: 160 } });
  page.setDefaultTimeout(PATIENCE);
  try {
    const errors = [];
    page.on("pageerror", (error) => errors.push(String(error)));
    writeFileSync(join(folder, name), bytes);
    await page.goto(pathToFileURL(join(folder, name)).href);
    await page.waitForFunction(() => document.querySelector("canvas")?.width === 160);
    const colors = async () => new Set(decode(await page.screenshot()).data).size;
    await until("the exported page shows a picture", async () => (await colors()) >= 64);
    await page.evaluate(() => void (window.sfumatoViewer.exact = true));
    await page.waitForFunction(() => /^exact/.test(window.sfumatoViewer.exactState));
    checkEqual([errors, await page.title()], [[], "small"], "the exported page");
  } finally {
    await page.close();
    rmSync(folder, { recursive: true });
  }
}

/** A failure is reported, a cancelled dialog is silent, and neither leaves an empty file behind. */
async function testFailure(browser, address) {
  const context = await newContext(browser, { size: [1000, 700] });
  await giveDisk(context);
  const editor = await EditorPage.within(context, address);
  const { page } = editor;
  const disk = new Disk(page);
  await editor.load(small, "small.svg");
  const go = async () => {
    await page.keyboard.press("Control+e");
    await page.getByRole("button", { name: "Export PNG" }).click();
  };
  await disk.set({ chosen: "a.png", failure: "QuotaExceededError" });
  await go();
  await said(page, /disk is full/, "dialog");
  checkEqual(await disk.has("a.png"), false, "an empty file after a failed export");
  await closeDialog(page);
  await disk.set({ chosen: "", failure: "" });
  await go();
  const again = page.getByRole("button", { name: "Export PNG" });
  await again.waitFor();
  // By then the picture that was in progress when the dialog was cancelled is done.
  await workersRest(page);
  check((await again.isVisible()) && (await again.isEnabled()), "the work that was left goes on");
  checkEqual(await page.locator("dialog [role=alert]").count(), 0, "complaints after the browser's dialog was left");
  await closeDialog(page);
  await disk.set({ chosen: "b.png" });
  await go();
  await page.waitForFunction(() => !document.querySelector("dialog[open]"));
  check(decode(await disk.read("b.png")).width > 0, "no PNG was written");
  editor.checkQuiet();
  await editor.close();
}

async function testClipboard(browser, address) {
  const context = await newContext(browser, { size: [1000, 700], permissions: ["clipboard-read", "clipboard-write"] });
  const from = await EditorPage.within(context, address);
  await from.load(small);
  await from.key("Control+a", "Control+c");
  const to = await EditorPage.within(context, address);
  const blank = small.replace(/<path[^]*?\/>/, "");
  await to.load(blank);
  await to.page.locator(".canvas-stage").focus();
  await to.key("Control+v");
  const pasted = await textAfter(to.page, blank);
  check(/sf:left="#d04020"/.test(pasted) && /sf:right="#2040d0"/.test(pasted), "the curve did not arrive");
  await to.key("Control+z");
  await shows(to.page, blank);
  await to.page.evaluate(() => navigator.clipboard.writeText('<svg xmlns="http://www.w3.org/2000/svg"><path stroke="red" d="M10,10 L50,60"/></svg>'));
  await to.key("Control+v");
  check(/sf:right="#ff0000/.test(await textAfter(to.page, blank)), "plain SVG was not pasted");
  await to.key("Control+z");
  await shows(to.page, blank);
  await to.page.evaluate(() => navigator.clipboard.writeText("Dear Sir,"));
  await to.key("Control+v");
  await said(to.page, /no drawing on the clipboard/);
  checkEqual(await to.text, blank, "the text after words were pasted");
  for (const editor of [from, to]) editor.checkQuiet();
  await context.close();
}

export async function testExporting(tap, { browser, address, folder }) {
  const context = await newContext(browser, { size: [1000, 700] });
  await context.addInitScript(() => delete window.showOpenFilePicker);
  const editor = await EditorPage.within(context, address);
  const engine = await contextOf(folder);
  await tap.test("exporting: a PNG has the engine's pixels", () => testPng(editor, engine));
  await tap.test("exporting: 16 bits and transparency are the engine's", () => testDeepPng(editor, engine));
  await tap.test("exporting: an SVG leaves the photo out", () => testSvg(editor));
  await tap.test("exporting: the HTML shows the picture by itself", () => testHtml(editor, browser));
  await tap.test("exporting: the message about a faulty drawing has its line", () => testUndrawable(editor));
  await tap.test("exporting: PDF and plain SVG are the command's", () => testVectors(editor));
  await tap.test("exporting: PDF of nothing, and too much for plain SVG", () => testVectorsOfLittleAndMuch(editor));
  await tap.test("exporting: the selected layer alone", () => testSelectionOnly(editor, engine));
  await tap.test("exporting: several sizes are several files", () => testSizes(browser, address));
  await tap.test("exporting: nothing was complained of", () => editor.checkQuiet());
  await editor.close();
  await tap.test("exporting: the dialog shows failures", () => testFailure(browser, address));
  await tap.test("exporting: copies are pasted into another page", () => testClipboard(browser, address));
}
