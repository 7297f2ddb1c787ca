// Saving files: the opened bytes with only the edit changed, and obstacles to saving.
import { gunzipSync, gzipSync } from "node:zlib";
import { downloaded, giveDisk, Disk } from "./disk.mjs";
import { check, checkEqual, EditorPage, newContext } from "./harness.mjs";
import { corpus, entities, example, exampleNames, small, strangers } from "./texts.mjs";
import { edit, said } from "./words.mjs";

const bytesOfExamples = () => exampleNames.map((name) => [name, Buffer.from(example(name))]);

/** Opens a file of the page's disk through the dialog. */
async function open({ page }, disk, name, bytes) {
  await disk.write(name, bytes);
  await disk.set({ chosen: name });
  await page.keyboard.press("Control+o");
  // An SVG of another program is opened as it is.
  await page.waitForFunction((n) => {
    [...document.querySelectorAll("dialog button")].find((b) => b.textContent === "Open as it is")?.click();
    return document.querySelector(".file-name")?.textContent === n;
  }, name);
}

/** Saves, and waits until the file is written. */
async function save({ page }) {
  const writes = await page.evaluate(() => window.disk.writes);
  await page.keyboard.press("Control+s");
  await page.waitForFunction((before) => window.disk.writes > before, writes);
  await said(page, /saved/);
}

/** Tries to save although something forbids it. @returns the message of the page */
async function saveInVain({ page }, pattern) {
  await page.keyboard.press("Control+s");
  return said(page, pattern);
}

async function testSame(editor, disk) {
  for (const [name, bytes] of [...bytesOfExamples(), ...Object.entries(strangers), ["entities.svg", Buffer.from(entities)]]) {
    await open(editor, disk, name, bytes);
    await save(editor);
    check((await disk.read(name)).equals(bytes), `${name} changes where nothing was edited`);
  }
}

/** A gzipped file is gzipped again, perhaps to other bytes. */
async function testPacked(editor, disk) {
  await open(editor, disk, "packed.svgz", gzipSync(small));
  await save(editor);
  checkEqual(String(gunzipSync(await disk.read("packed.svgz"))), small, "the text in the packed file");
}

/** Opens and saves hundreds of files within the page. @returns names of files that changed, and a count */
function saveMany(files) {
  class MemoryHandle {
    kind = "file";
    written = null;
    constructor(name, bytes) {
      Object.assign(this, { name, file: new File([bytes], name, { lastModified: 1 }) });
    }
    getFile = async () => this.file;
    createWritable = async () => {
      const parts = [];
      const close = async () => void (this.written = new Uint8Array(await new Blob(parts).arrayBuffer()));
      return new WritableStream({ write: (part) => void parts.push(part), close });
    };
  }
  const press = (key) => document.dispatchEvent(new KeyboardEvent("keydown", { key, ctrlKey: true, bubbles: true }));
  // Dialogs appear at any time: the engine may complain of a drawing after it was saved.
  let isRefused = false;
  const answerDialog = () => {
    const dialog = document.querySelector("dialog.small");
    if (!dialog) return;
    const buttons = [...dialog.querySelectorAll(".dialog-foot button")];
    const asItIs = buttons.find((button) => button.textContent === "Open as it is");
    isRefused ||= !asItIs && dialog.querySelector("h2").textContent !== "This drawing cannot be shown";
    (asItIs ?? buttons.at(-1)).click();
  };
  const until = async (reached, what) => {
    const end = performance.now() + 60_000;
    while (!reached()) {
      if (performance.now() > end) throw new Error(`waited a minute for ${what}`);
      answerDialog();
      await new Promise((resolve) => setTimeout(resolve, 1));
    }
  };
  // A key is lost if a dialog is about to appear; it is pressed again.
  const pressUntil = async (key, reached, what) => {
    let next = 0;
    const isReached = () => {
      if (reached()) return true;
      if (performance.now() > next) {
        press(key);
        next = performance.now() + 500;
      }
      return reached();
    };
    await until(isReached, what);
  };
  return (async () => {
    const changed = [];
    let count = 0;
    for (const [i, { name, text }] of files.entries()) {
      const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      const handle = new MemoryHandle(`${i}.svg`, bytes);
      let isPicked = false;
      window.showOpenFilePicker = async () => {
        isPicked = true;
        return [handle];
      };
      // Orzan's XML has become another drawing, which has no file yet.
      let isAsked = false;
      window.showSaveFilePicker = async () => {
        isAsked = true;
        throw new DOMException("left", "AbortError");
      };
      isRefused = false;
      await pressUntil("o", () => isPicked, `${name} to be picked`);
      const isOpen = () => document.querySelector(".file-name")?.textContent === handle.name;
      await until(() => isOpen() || isRefused, `${name} to open`);
      if (isRefused) continue;
      await pressUntil("s", () => handle.written || isAsked, `${name} to be saved`);
      if (isAsked) continue;
      count += 1;
      const isSame = handle.written.length === bytes.length && handle.written.every((byte, k) => byte === bytes[k]);
      if (!isSame) changed.push(name);
    }
    return { changed, count };
  })();
}

async function testCorpus({ page }) {
  const every = Number(process.env.SFUMATO_EVERY ?? 1);
  const plain = ["svg", "round_trip", "import"].flatMap(corpus).filter(({ bytes }) => bytes[0] !== 0x1f);
  const files = plain.filter((_, i) => i % every === 0);
  const given = files.map(({ name, bytes }) => ({ name, text: bytes.toString("base64") }));
  const { changed, count } = await page.evaluate(saveMany, given);
  console.log(`# ${count} of ${files.length} parse`);
  checkEqual(changed, [], "files that change where nothing was edited");
  check(count > files.length / 10, "hardly any file was opened");
}

/** Returns where two files differ: [from, to of the first, to of the second]. */
function difference(a, b) {
  let from = 0;
  while (from < a.length && a[from] === b[from]) from += 1;
  let end = 0;
  while (end < a.length - from && end < b.length - from && a[a.length - 1 - end] === b[b.length - 1 - end]) end += 1;
  return [from, a.length - end, b.length - end];
}

/** Moves the first curve by a key: only one attribute of the file changes. */
async function testEdited(editor, disk) {
  const { page } = editor;
  for (const [name, bytes] of Object.entries(strangers)) {
    await open(editor, disk, name, bytes);
    const before = await editor.text;
    await page.locator(".canvas-stage").focus();
    await editor.key("Tab", "ArrowRight");
    await page.waitForFunction((text) => window.sfumatoEditor.text !== text, before);
    await save(editor);
    const after = await disk.read(name);
    const [from, was, is] = difference(bytes, after);
    const parts = [bytes.subarray(from, was), after.subarray(from, is)].map(String);
    check(parts.every((part) => !/["<>=\n\r]/.test(part)), `${name} differs in more than an attribute: ${parts}`);
    check(/\sd="[^"]*$/.test(String(bytes.subarray(0, from))), `${name} differs elsewhere than in d: ${parts}`);
    await editor.key("Control+z");
    await save(editor);
    check((await disk.read(name)).equals(bytes), `${name} is not as before after undo`);
  }
}

/** Entities that a file defines could mean anything: it is shown, and saved unchanged. */
async function testReadOnly(editor, disk) {
  await open(editor, disk, "entities.svg", Buffer.from(entities));
  await editor.page.locator(".canvas-stage").focus();
  await editor.key("Tab", "ArrowRight");
  await said(editor.page, /entit/i);
  checkEqual(await editor.text, entities, "the text of a file with entities of its own");
}

async function testRefused(editor, disk) {
  const { page } = editor;
  await open(editor, disk, "mine.svg", Buffer.from(small));
  await edit(editor);
  await page.waitForFunction(() => /Saved on this device/.test(document.querySelector(".saved").textContent));
  const kept = / Your drawing is stored in this browser\./;
  await disk.set({ permission: "denied" });
  check(kept.test(await saveInVain(editor, /not allowed to write/)), "nobody says that the drawing is kept");
  await disk.set({ permission: "granted", failure: "QuotaExceededError" });
  check(kept.test(await saveInVain(editor, /disk is full/)), "nobody says that the drawing is kept");
  await disk.set({ failure: "InvalidStateError" });
  await saveInVain(editor, /could not be written to the disk/);
  await disk.set({ failure: "" });
  checkEqual(String(await disk.read("mine.svg")), small, "the file after refusals");
  await disk.remove("mine.svg");
  await saveInVain(editor, /was moved or removed/);
  await disk.set({ chosen: "elsewhere.svg" });
  await page.getByRole("button", { name: "Save elsewhere" }).click();
  await said(page, /elsewhere\.svg.* saved/);
  checkEqual(String(await disk.read("elsewhere.svg")), await editor.text, "the file elsewhere");
}

async function testForeign(editor, disk) {
  const { page } = editor;
  await open(editor, disk, "shared.svg", Buffer.from(small));
  await edit(editor);
  await disk.write("shared.svg", Buffer.from("<svg/>"));
  await saveInVain(editor, /changed or removed/);
  checkEqual(String(await disk.read("shared.svg")), "<svg/>", "what somebody else wrote");
  await page.getByRole("button", { name: "Save anyway" }).click();
  await said(page, /saved/);
  checkEqual(String(await disk.read("shared.svg")), await editor.text, "the file that was saved anyway");
  // Two saves in a row: the second sees the result of the first.
  const writes = await disk.get("writes");
  await page.keyboard.press("Control+s");
  await page.keyboard.press("Control+s");
  await page.waitForFunction((before) => window.disk.writes === before + 2, writes);
}

/** A new drawing, or an example, has no file: saving asks, and never overwrites the previous drawing's file. */
async function testNewPlace(editor, disk) {
  const { page } = editor;
  await open(editor, disk, "old.svg", Buffer.from(small));
  await disk.set({ chosen: "" });
  await editor.key("Control+n");
  await page.getByRole("button", { name: "Create" }).click();
  await page.waitForFunction(() => document.querySelector(".file-name").textContent === "untitled.svg");
  await page.keyboard.press("Control+s");
  await page.waitForFunction(() => window.disk.asked?.suggestedName === "untitled.svg");
  checkEqual(String(await disk.read("old.svg")), small, "the file that was open before");
  await disk.set({ chosen: "new.svg" });
  await page.keyboard.press("Control+s");
  await said(page, /new\.svg.* saved/);
  checkEqual(String(await disk.read("new.svg")), await editor.text, "the new file");
}

async function testDownload(editor) {
  const { page } = editor;
  await editor.load(small, "fresh.svg");
  const { name, bytes } = await downloaded(page, () => page.keyboard.press("Control+s"));
  checkEqual([name, String(bytes)], ["fresh.svg", small], "the download");
  await said(page, /downloaded/);
}

/** The nodes of a curve that is not finished are in the file. */
async function testDraft(editor) {
  const { page } = editor;
  await editor.load(small, "draft.svg");
  await page.locator(".canvas-stage").focus();
  await editor.key("p");
  for (const [x, y] of [[20, 30], [40, 30], [60, 40]]) await editor.click(x, y);
  const { bytes } = await downloaded(page, () => page.keyboard.press("Control+s"));
  checkEqual(String(bytes), await editor.text, "the file and the drawing");
  checkEqual(String(bytes).match(/<path/g).length, small.match(/<path/g).length + 1, "curves of the file");
}

/** Opens a page with a disk, or one in a browser that only has downloads. */
async function pageOf(browser, address, hasDisk) {
  const context = await newContext(browser, { size: [900, 500] });
  if (hasDisk) await giveDisk(context);
  else await context.addInitScript(() => delete window.showOpenFilePicker);
  return EditorPage.within(context, address);
}

export async function testSaving(tap, { browser, address }) {
  const editor = await pageOf(browser, address, true);
  const disk = new Disk(editor.page);
  await tap.test("saving: what was not edited has the same bytes", () => testSame(editor, disk));
  await tap.test("saving: svgz stays svgz", () => testPacked(editor, disk));
  await tap.test("saving: an edit differs in its attribute alone", () => testEdited(editor, disk));
  await tap.test("saving: a message says that a file with entities is read only", () => testReadOnly(editor, disk));
  await tap.test("saving: messages explain refusals of disk and browser", () => testRefused(editor, disk));
  await tap.test("saving: what somebody else wrote is not replaced unasked", () => testForeign(editor, disk));
  await tap.test("saving: a new drawing has a place of its own", () => testNewPlace(editor, disk));
  await tap.test("saving: nothing was complained of", () => editor.checkQuiet());
  await editor.close();
  const legacy = await pageOf(browser, address, false);
  await tap.test("saving: a browser without dialogs downloads", () => testDownload(legacy));
  await tap.test("saving: a curve that the pen draws is in the file", () => testDraft(legacy));
  await legacy.close();
  const many = await newContext(browser, { size: [900, 300] });
  await many.addInitScript(() => delete window.BroadcastChannel);
  const bulk = await EditorPage.within(many, address);
  await tap.test("saving: the fuzzers' finds have the same bytes", () => testCorpus(bulk));
  await bulk.close();
}
