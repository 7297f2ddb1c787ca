// Opening files: accepted kinds, errors, and messages.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { drop, dropPaths, giveDisk, Disk } from "./disk.mjs";
import { check, checkEqual, EditorPage, newContext, pathOf } from "./harness.mjs";
import { messagesGo } from "./hooks.mjs";
import { example, small, utf16 } from "./texts.mjs";
import { closeDialog, said, shows } from "./words.mjs";

const text = (bytes) => Buffer.from(bytes);

/** Expects a refusal; the drawing that was open before stays. */
async function refuses(editor, files, pattern) {
  const before = await editor.text;
  await drop(editor.page, files);
  await said(editor.page, pattern, "dialog");
  checkEqual(await editor.text, before, "the text after a refused file");
  await closeDialog(editor.page);
}

async function testKinds(editor) {
  const { page } = editor;
  await drop(page, [{ name: "a.svg", bytes: text(small) }], ".welcome");
  await shows(page, small);
  await drop(page, [{ name: "b.svgz", bytes: gzipSync(example("apple.svg")) }], ".canvas-stage");
  await shows(page, example("apple.svg"));
  await drop(page, [{ name: "c.svg", bytes: utf16(small, true) }]);
  await shows(page, small);
  await drop(page, [{ name: "d.svg", bytes: utf16(example("blur.svg"), false) }]);
  await shows(page, example("blur.svg"));
  await drop(page, [{ name: "evening.xml", bytes: readFileSync(pathOf("examples/evening.xml")) }]);
  await page.waitForFunction(() => document.querySelector(".file-name")?.textContent === "evening.svg");
  check((await editor.text).includes("urn:sfumato:1"), "Orzan's XML became no SVG");
  await editor.settled();
  checkEqual((await page.evaluate(() => window.sfumatoEditor.status)).kind, "exact", "the picture of Orzan's XML");
}

/** A declared encoding applies to the file, not to the text that the engine reads. */
async function testDeclaredEncoding(editor) {
  const declared = `<?xml version="1.0" encoding="UTF-16"?>\n${small}`;
  await drop(editor.page, [{ name: "declared.svg", bytes: utf16(declared, true) }]);
  await shows(editor.page, declared);
  await editor.settled();
  checkEqual((await editor.page.evaluate(() => window.sfumatoEditor.status)).kind, "exact", "the picture");
}

async function testPhoto(editor) {
  const { page } = editor;
  await editor.load(small);
  await drop(page, [{ name: "hemp.png", bytes: readFileSync(pathOf("examples/hemp.png")), type: "image/png" }]);
  await page.waitForFunction(() => /<image[^>]*sf:reference="true"/.test(window.sfumatoEditor.text));
  check((await editor.text).includes("data:image/png;base64,"), "the photo is not in the drawing");
  await editor.key("Control+z");
  await shows(page, small);
}

async function testRefusals(editor) {
  await editor.load(small);
  const png = readFileSync(pathOf("examples/wood.png"));
  await refuses(editor, [{ name: "empty.svg", bytes: text("") }], /empty\.svg.*is empty/);
  await refuses(editor, [{ name: "huge.svg", size: 200 * 2 ** 20 }], /larger than 64 MB/);
  await refuses(editor, [{ name: "packed.svgz", bytes: gzipSync(small).subarray(0, 60) }], /damaged gzip file/);
  await refuses(editor, [{ name: "bomb.svgz", bytes: gzipSync(Buffer.alloc(70 * 2 ** 20, 32)) }], /unpacks to more than 64 MB/);
  await refuses(editor, [{ name: "cut.png", bytes: png.subarray(0, 200) }], /cannot show.*cut\.png/);
  await refuses(editor, [{ name: "photo.heic", bytes: text("\0\0\0\x18ftypheic\0\0\0\0mif1heic") }], /cannot show/);
  await refuses(editor, [{ name: "bytes.svg", bytes: Buffer.from([0x3c, 0xff, 0xfe, 0x80]) }], /neither a picture nor text/);
  await refuses(editor, [{ name: "words.svg", bytes: text("Dear Sir,") }], /is not a drawing/);
  await refuses(editor, [{ name: "page.html", bytes: text("<!doctype html><html></html>") }], /.+/);
  const two = ["a.svg", "b.svg"].map((name) => ({ name, bytes: text(small) }));
  await refuses(editor, two, /one drawing or one photo at a time/);
  const photos = ["a.png", "b.png"].map((name) => ({ name, bytes: png, type: "image/png" }));
  await refuses(editor, photos, /one drawing or one photo at a time/);
}

async function testBroken(editor) {
  const { page } = editor;
  await editor.load(small);
  const broken = small.replace('sf:left="#d04020"', "sf:left=#d04020");
  await refuses(editor, [{ name: "broken.svg", bytes: text(broken) }], /broken\.svg.*cannot be opened.*Line 4, column \d+/s);
  await drop(page, [{ name: "broken.svg", bytes: text(broken) }]);
  await said(page, /Line 4/, "dialog");
  await page.getByRole("button", { name: "Show line" }).click();
  await said(page, /sf:left=#d04020/, ".problem-line");
  await closeDialog(page);
  // A fault of the next file only is reported next time.
  await refuses(editor, [{ name: "empty.svg", bytes: text("") }], /empty\.svg/);
}

/** The page reads the text and the engine does not: picture and text stay. */
async function testUndrawable(editor) {
  const { page } = editor;
  await drop(page, [{ name: "wrong.svg", bytes: text(small.replace("#d04020", "salmonish")) }]);
  await page.waitForFunction(() => window.sfumatoEditor.status.kind === "problem");
  // The reason is shown at once, and again by the button.
  await said(page, /Line 4, column \d+/, "dialog");
  await closeDialog(page);
  await page.getByRole("button", { name: /Cannot be shown/ }).click();
  await said(page, /Line 4, column \d+/, "dialog");
  await closeDialog(page);
  await editor.load(small);
  checkEqual((await page.evaluate(() => window.sfumatoEditor.status)).kind, "exact", "the next picture");
}

/** Folders, and textures beside the drawing, dropped through the system. */
async function testPaths(editor) {
  const { page } = editor;
  const folder = mkdtempSync(join(tmpdir(), "sfumato-drop-"));
  try {
    await editor.load(small);
    await dropPaths(editor, [folder]);
    await said(page, /This is a folder/, "dialog");
    await closeDialog(page);
    await messagesGo(page);
    const files = ["textures.svg", "wood.png", "waves.png", "hemp.png"];
    await dropPaths(editor, files.map((name) => pathOf(`examples/${name}`)));
    await shows(page, example("textures.svg"));
    await editor.settled();
    checkEqual((await page.evaluate(() => window.sfumatoEditor.status)).kind, "exact", "with its textures");
    checkEqual(await page.locator(".toast").count(), 0, "toasts after a drawing with its textures");
    const big = join(folder, "big.svg");
    writeFileSync(big, Buffer.alloc(65 * 2 ** 20, 32));
    await dropPaths(editor, [big]);
    await said(page, /larger than 64 MB/, "dialog");
    await closeDialog(page);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Missing pictures are requested once; a folder provides them. */
async function testMissing(editor) {
  const { page } = editor;
  const disk = new Disk(page);
  await drop(page, [{ name: "textures.svg", bytes: text(example("textures.svg")) }]);
  await said(page, /is missing|are missing/);
  for (const name of ["wood.png", "waves.png", "hemp.png"]) {
    await disk.write(name, readFileSync(pathOf(`examples/${name}`)));
  }
  await page.getByRole("button", { name: "Choose folder" }).click();
  await page.waitForFunction(() => window.sfumatoEditor.status.kind === "exact");
  const broken = example("textures.svg").replace(/href="[^"]*\.png"/, 'href="data:image/png;base64,iVBORw0KGgo="');
  await drop(page, [{ name: "undecodable.svg", bytes: text(broken) }, ...["wood.png", "waves.png", "hemp.png"].map((name) => ({ name, bytes: readFileSync(pathOf(`examples/${name}`)) }))]);
  await said(page, /cannot read a picture/);
}

/** The last of several openings wins, even if the first one's photo takes longer. */
async function testRace(editor) {
  const photo = readFileSync(pathOf("examples/wood.png")).toString("base64");
  const image = `<image sf:reference="true" width="9" height="9" href="data:image/png;base64,${photo}"/></svg>`;
  const opened = [small.replace("</svg>", image), example("apple.svg")];
  await editor.page.evaluate((texts) => Promise.all(texts.map((t, i) => window.sfumatoEditor.open(t, `${i}.svg`))), opened);
  checkEqual(await editor.text, opened[1], "the text that was opened last");
  checkEqual(await editor.page.locator(".file-name").textContent(), "1.svg", "its name");
}

export async function testFiles(tap, { browser, address }) {
  const context = await newContext(browser);
  await giveDisk(context);
  const editor = await EditorPage.within(context, address);
  await tap.test("files: SVG, svgz, UTF-16 and Orzan's XML are dropped anywhere", () => testKinds(editor));
  await tap.test("files: UTF-16 that says so is drawn", () => testDeclaredEncoding(editor));
  await tap.test("files: a photo is traced over", () => testPhoto(editor));
  await tap.test("files: what is no drawing is refused in words, and nothing is lost", () => testRefusals(editor));
  await tap.test("files: a broken SVG says its line, and shows it", () => testBroken(editor));
  await tap.test("files: a text that cannot be drawn is kept", () => testUndrawable(editor));
  await tap.test("files: folders, textures and large files of the real disk", () => testPaths(editor));
  await tap.test("files: missing pictures are asked for, broken ones told", () => testMissing(editor));
  await tap.test("files: two openings at once end in a drawing", () => testRace(editor));
  await tap.test("files: nothing was complained of", () => editor.checkQuiet());
  await editor.close();
}
