// Tests of reloads, of the list of recent drawings, of transparency, and of taps that undo and redo.
import { check, checkEqual, EditorPage, newContext, packageOf, until } from "./harness.mjs";
import { isKept } from "./recover.mjs";
import { small } from "./texts.mjs";
import { edit, goHome, said, shows } from "./words.mjs";

const { decode } = packageOf("fast-png");
const size = [900, 600];

/** A white disc on a transparent ground; the artboard has 100 by 80 units. */
const disc = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 100 80" sf:version="1">
  <g sf:diffuse="true">
    <circle cx="50" cy="40" r="25" sf:left="#fff" sf:right="#fff" sf:left-opacity="0" sf:right-opacity="1"/>
  </g>
</svg>
`;

const isOpen = (page) => page.waitForFunction(() => window.sfumatoEditor && !document.querySelector(".welcome"));

async function reload(editor) {
  await editor.page.reload();
  await editor.page.waitForFunction(() => window.sfumatoEditor !== undefined);
}

/** An edited drawing is open again, with its undo; after Home the first page is, as in a new tab. */
async function testReload(browser, address) {
  const context = await newContext(browser, { size });
  const editor = await EditorPage.within(context, address);
  const { page } = editor;
  await editor.load(small, "mine.svg");
  const edited = await edit(editor);
  await isKept(page, edited);
  await reload(editor);
  await isOpen(page);
  await shows(page, edited);
  checkEqual(await page.locator(".toast").count(), 0, "messages after a reload");
  await page.locator(".canvas-stage").focus();
  await editor.key("Control+z");
  await shows(page, small);
  const other = await EditorPage.within(context, address);
  await other.page.locator(".recent-list button").waitFor();
  checkEqual(await other.page.locator(".welcome").count(), 1, "the first page in a new tab");
  await goHome(page);
  await reload(editor);
  await page.locator(".recent-list button").waitFor();
  for (const one of [editor, other]) one.checkQuiet();
  await context.close();
}

/** A drawing that was not edited returns too, with the pictures that a drawing of the gallery names. */
async function testUnchanged(browser, address) {
  const editor = await EditorPage.open(browser, address, { size });
  const { page } = editor;
  await page.getByRole("button", { name: /^Apple/ }).click();
  await isOpen(page);
  const text = await editor.text;
  await isKept(page, text);
  await reload(editor);
  await isOpen(page);
  await shows(page, text);
  await editor.settled();
  checkEqual(await page.evaluate(() => window.sfumatoEditor.status.kind), "exact", "the picture of the apple");
  await goHome(page);
  checkEqual(await page.locator(".recent-list button").count(), 0, "unchanged drawings among the recent ones");
  editor.checkQuiet();
  await editor.close();
}

/** Damages all records of one kind in the browser's storage. */
const damage = ([kind, value]) =>
  new Promise((resolve) => {
    const ask = indexedDB.open("sfumato-editor");
    ask.onsuccess = () => {
      const store = ask.result.transaction("drawings", "readwrite").objectStore("drawings");
      const keys = store.getAllKeys();
      keys.onsuccess = () => {
        for (const key of keys.result) if (key.startsWith(kind)) store.put(value, key);
        store.transaction.oncomplete = () => resolve(ask.result.close());
      };
    };
  });

async function testDamaged(browser, address) {
  const editor = await EditorPage.open(browser, address, { size });
  const { page } = editor;
  const begin = async () => {
    await editor.load(small, "mine.svg");
    await isKept(page, await edit(editor));
  };
  await begin();
  await page.evaluate(damage, ["body:", { text: 7 }]);
  await reload(editor);
  await page.locator(".welcome").waitFor();
  await begin();
  const edited = await editor.text;
  await page.evaluate(damage, ["body:", { text: edited, undo: { done: [{ patch: 3 }] }, place: null }]);
  await reload(editor);
  await isOpen(page);
  await shows(page, edited);
  check(await page.getByRole("button", { name: /^Undo/ }).isDisabled(), "undo of a damaged history is offered");
  editor.checkQuiet();
  await editor.close();
}

/** Where the browser stores nothing, a reload shows the first page, and nothing is complained of. */
async function testRefused(browser, address) {
  const context = await newContext(browser, { size });
  await context.addInitScript(() => {
    const refuse = () => {
      throw new DOMException("denied", "SecurityError");
    };
    indexedDB.open = refuse;
    for (const name of ["sessionStorage", "localStorage"]) Object.defineProperty(window, name, { get: refuse });
  });
  const editor = await EditorPage.within(context, address);
  await editor.load(small, "mine.svg");
  checkEqual(await editor.page.locator(".toast").count(), 0, "messages about storage before an edit");
  await reload(editor);
  await editor.page.locator(".welcome").waitFor();
  editor.checkQuiet();
  await context.close();
}

const pictures = (page) => page.locator(".recent-list img").count();

/** Recent and Recover show pictures; a drawing without one has a neutral sign. */
async function testPictures(browser, address) {
  const editor = await EditorPage.open(browser, address, { size, isDrawn: true, ratio: 1 });
  const { page } = editor;
  await editor.load(small, "mine.svg");
  await edit(editor);
  const kept = () => page.evaluate(keptPicture);
  await until("a picture is stored", async () => (await kept()) !== null);
  const picture = await kept();
  check(picture.size <= 20_000, `the picture has ${picture.size} bytes`);
  checkEqual([picture.width, picture.height], [240, 192], "the picture's size");
  await editor.load(small.replace("M20,40", "M20,41"), "second.svg");
  await isKept(page, await edit(editor));
  await goHome(page);
  await until("a picture is shown", async () => (await pictures(page)) > 0);
  const [first] = await page.locator(".recent-list small").allTextContents();
  checkEqual(first, "edited just now", "the words about the newest drawing");
  await page.locator(".recent-list button", { hasText: "mine.svg" }).click();
  await isOpen(page);
  await openRecover(editor);
  const row = page.locator(".kept-list li", { hasText: "mine.svg" });
  await row.locator("img").waitFor();
  await row.getByRole("button", { name: "Forget" }).click();
  await row.waitFor({ state: "detached" });
  check((await page.evaluate(keysKept)).filter((key) => key.startsWith("picture:")).length <= 1, "a picture without a drawing");
  editor.checkQuiet();
  await editor.close();
}

async function openRecover({ page }) {
  await page.evaluate(() => document.querySelector("[aria-label=Menu]").click());
  await page.getByRole("menuitem", { name: "File" }).click();
  await page.getByRole("menuitem", { name: "Recover" }).click();
}

/** Runs in the page: the first stored picture; null: none. */
const keptPicture = () =>
  new Promise((resolve) => {
    const ask = indexedDB.open("sfumato-editor");
    ask.onsuccess = () => {
      const all = ask.result.transaction("drawings").objectStore("drawings").getAll(IDBKeyRange.bound("picture:", "picture;"));
      all.onsuccess = async () => {
        ask.result.close();
        const [blob] = all.result;
        if (!blob) return resolve(null);
        const { width, height } = await createImageBitmap(blob);
        resolve({ size: blob.size, width, height });
      };
    };
  });

/** Runs in the page: the keys of all that is stored. */
const keysKept = () =>
  new Promise((resolve) => {
    const ask = indexedDB.open("sfumato-editor");
    ask.onsuccess = () => {
      const all = ask.result.transaction("drawings").objectStore("drawings").getAllKeys();
      all.onsuccess = () => resolve((ask.result.close(), all.result));
    };
  });

/** Returns the colours of the stage in a square of 16 pixels around a point of the artboard, as "r,g,b" with counts. */
async function colorsAt(editor, x, y) {
  const [left, top] = (await editor.at(x, y)).map((place) => Math.round(place) - 8);
  const { data, channels } = decode(await editor.page.screenshot({ clip: { x: left, y: top, width: 16, height: 16 }, caret: "initial" }));
  const counts = new Map();
  for (let i = 0; i < data.length; i += channels) {
    const color = data.slice(i, i + 3).join();
    counts.set(color, (counts.get(color) ?? 0) + 1);
  }
  return Object.fromEntries(counts);
}

const WHITE = { "255,255,255": 256 };
/** Squares of 8 by 8 pixels: as many of each grey in any square of 16 by 16. */
const CHEQUERS = {
  light: { "212,212,212": 128, "232,232,232": 128 },
  dark: { "74,74,74": 128, "100,100,100": 128 },
};

async function testChequers(browser, address) {
  for (const theme of ["light", "dark"]) {
    const editor = await EditorPage.open(browser, address, { size: [800, 480], isDrawn: true, ratio: 1, colorScheme: theme });
    const { page } = editor;
    const sorted = (counts) => Object.fromEntries(Object.entries(counts).sort());
    const at = async (x, y) => sorted(await colorsAt(editor, x, y));
    await editor.load(disc, "disc.svg");
    await editor.picture();
    checkEqual(await at(10, 10), sorted(CHEQUERS[theme]), `where nothing is painted, ${theme}`);
    checkEqual(await at(50, 40), WHITE, `the white disc, ${theme}`);
    // Exact pixels take long where software draws: fewer of them.
    await editor.key("-", "-", "e");
    await page.waitForFunction(() => window.sfumatoEditor.exactPixels.kind === "exact");
    checkEqual(await at(10, 10), sorted(CHEQUERS[theme]), `exact pixels where nothing is painted, ${theme}`);
    checkEqual(await at(50, 40), WHITE, `exact pixels of the white disc, ${theme}`);
    await editor.load(disc.replace("<g ", '<rect width="100" height="80" fill="#fff"/>\n  <g '), "white.svg");
    await editor.picture();
    checkEqual(await at(10, 10), WHITE, `a white background, ${theme}`);
    editor.checkQuiet();
    await editor.close();
  }
}

/** New has the word Transparent, and such a drawing shows chequers. */
async function testNew(browser, address) {
  const editor = await EditorPage.open(browser, address, { size, isDrawn: true, ratio: 1 });
  const { page } = editor;
  await page.getByRole("button", { name: "Start blank" }).click();
  const dialog = page.getByRole("dialog");
  await dialog.getByRole("checkbox", { name: "Background colour" }).uncheck();
  check(await dialog.getByText("Transparent", { exact: true }).isVisible(), "the word Transparent is missing");
  await dialog.getByRole("button", { name: "Create" }).click();
  await editor.settled();
  checkEqual(Object.keys(await colorsAt(editor, 100, 100)).length, 2, "colours of a new transparent drawing");
  editor.checkQuiet();
  await editor.close();
}

/** A tap of two fingers undoes, one of three redoes; neither leaves a stroke. */
async function testTaps(browser, address) {
  const editor = await EditorPage.open(browser, address, { size, hasTouch: true });
  const { page } = editor;
  await editor.load(small, "mine.svg");
  const edited = await edit(editor);
  await editor.key("b");
  const session = await editor.context.newCDPSession(page);
  const [x, y] = await editor.at(50, 60);
  const tap = async (count) => {
    const touchPoints = Array.from({ length: count }, (_, id) => ({ x: x + 50 * id, y, id }));
    await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints });
    await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  };
  await tap(2);
  await shows(page, small);
  await said(page, /^Undone: /);
  await tap(3);
  await shows(page, edited);
  await said(page, /^Redone: /);
  editor.checkQuiet();
  await editor.close();
}

export async function testReturns(tap, { browser, address }) {
  await tap.test("returns: a reload shows the drawing, a new tab and Home the first page", () => testReload(browser, address));
  await tap.test("returns: an unchanged drawing of the gallery, with its pictures", () => testUnchanged(browser, address));
  await tap.test("returns: damaged records lose no more than they must", () => testDamaged(browser, address));
  await tap.test("returns: without storage the first page", () => testRefused(browser, address));
  await tap.test("returns: recent drawings have pictures", () => testPictures(browser, address));
  await tap.test("returns: chequers show where a drawing is transparent", () => testChequers(browser, address));
  await tap.test("returns: two fingers undo, three redo", () => testTaps(browser, address));
  await tap.test("returns: a new drawing can be transparent", () => testNew(browser, address));
}
