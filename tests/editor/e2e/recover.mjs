// Drawings in the browser's storage: after a crash of the page, with another tab, and without storage.
import { check, checkEqual, EditorPage, newContext, until } from "./harness.mjs";
import { small } from "./texts.mjs";
import { edit, goHome, said, shows } from "./words.mjs";

const size = [900, 600];

const state = (page, pattern) =>
  page.waitForFunction((source) => new RegExp(source).test(document.querySelector(".saved")?.textContent), pattern.source);

/** Waits until the browser's storage holds a drawing, by its text or its name. */
export async function isKept(page, wanted) {
  const look = async (what) => {
    // Opening a missing database would create an empty one.
    const known = await indexedDB.databases();
    if (!known.some(({ name }) => name === "sfumato-editor")) return false;
    return new Promise((resolve) => {
      const ask = indexedDB.open("sfumato-editor");
      ask.onsuccess = () => {
        const all = ask.result.transaction("drawings").objectStore("drawings").getAll();
        all.onsuccess = () => {
          ask.result.close();
          resolve(all.result.some(({ text, name }) => text === what || name === what));
        };
      };
    });
  };
  await until("the browser keeps it", () => page.evaluate(look, wanted));
}

/** A killed page loses only the last second, and undo still works. */
async function testKilled(browser, address) {
  const context = await newContext(browser, { size });
  const editor = await EditorPage.within(context, address);
  await editor.load(small, "killed.svg");
  await edit(editor);
  const edited = await edit(editor);
  await isKept(editor.page, edited);
  const session = await context.newCDPSession(editor.page);
  // The answer never comes.
  void session.send("Page.crash").catch(() => {});
  await editor.page.waitForEvent("crash");
  const next = await EditorPage.within(context, address);
  await next.page.locator(".recent-list button", { hasText: "killed.svg" }).click();
  await shows(next.page, edited);
  await next.page.locator(".canvas-stage").focus();
  await next.key("Control+z", "Control+z");
  await shows(next.page, small);
  await next.key("Control+y", "Control+y");
  await shows(next.page, edited);
  next.checkQuiet();
  await context.close();
}

/** An edit of the last second is kept even if another drawing is opened at once; each keeps its own text. */
async function testSwitched(browser, address) {
  const editor = await EditorPage.open(browser, address, { size: [900, 600] });
  const { page } = editor;
  await editor.load(small, "first.svg");
  const edited = await edit(editor);
  const other = small.replace("#d04020", "#20d040");
  await editor.load(other, "second.svg");
  await editor.key("Control+n");
  await page.getByRole("button", { name: "Create" }).click();
  await goHome(page);
  await page.reload();
  await page.locator(".recent-list button", { hasText: "first.svg" }).click();
  await shows(page, edited);
  // The open drawing is recovered again, because no other tab has it.
  await page.locator(".canvas-stage").focus();
  await page.evaluate(() => document.querySelector("[aria-label=Menu]").click());
  await page.getByRole("menuitem", { name: "File" }).click();
  await page.getByRole("menuitem", { name: "Recover" }).click();
  await page.locator(".kept-list li", { hasText: "first.svg" }).getByRole("button", { name: "Open" }).click();
  await page.waitForFunction(() => !document.querySelector("dialog[open]"));
  checkEqual(await page.locator(".toast").allTextContents(), [], "toasts after one's own drawing was recovered");
  editor.checkQuiet();
  await editor.close();
}

async function testRefused(browser, address, script, pattern, words = /Not saved: storage is blocked in this browser/) {
  const context = await newContext(browser, { size });
  await context.addInitScript(script);
  const editor = await EditorPage.within(context, address);
  const { page } = editor;
  await editor.load(small, "mine.svg");
  await edit(editor);
  await said(page, pattern);
  await state(page, words);
  check(await page.getByRole("button", { name: "Save elsewhere" }).isVisible(), "nobody offers to save elsewhere");
  // Leaving asks first.
  const asked = new Promise((resolve) => page.on("dialog", (dialog) => resolve(dialog.accept().then(() => dialog.type()))));
  await page.close({ runBeforeUnload: true });
  checkEqual(await asked, "beforeunload", "what leaving asks");
  checkEqual(editor.errors, [], "errors on the console");
  await context.close();
}

const throwing = () => {
  indexedDB.open = () => {
    throw new DOMException("denied", "SecurityError");
  };
};
const missing = () => Object.defineProperty(window, "indexedDB", { value: undefined });
const full = () => {
  IDBObjectStore.prototype.put = function () {
    throw new DOMException("full", "QuotaExceededError");
  };
};

/** Two tabs with one drawing: the second is warned and may take it over; the first then stops writing. */
async function testTabs(browser, address) {
  const context = await newContext(browser, { size });
  const first = await EditorPage.within(context, address);
  await first.load(small, "shared.svg");
  const once = await edit(first);
  await isKept(first.page, once);
  const second = await EditorPage.within(context, address);
  await second.page.locator(".recent-list button").first().click();
  await shows(second.page, once);
  await said(second.page, /This drawing is open in another tab of this browser/);
  await state(second.page, /Not saved/);
  await second.page.getByRole("button", { name: "Edit here" }).click();
  await said(first.page, /now edited in another tab/);
  await state(second.page, /Saved on this device/);
  await first.page.bringToFront();
  await edit(first);
  await second.page.bringToFront();
  const last = await edit(second);
  await state(first.page, /Not saved/);
  const third = await EditorPage.within(context, address);
  await third.page.waitForFunction(() => document.querySelector(".recent-list button"));
  await isKept(third.page, last);
  await third.page.locator(".recent-list button").first().click();
  await third.page.waitForFunction(() => !document.querySelector(".welcome"));
  checkEqual(await third.text, last, "what is kept after the second tab took the drawing");
  for (const editor of [first, second, third]) editor.checkQuiet();
  await context.close();
}

/** Beyond twenty drawings the oldest are removed. */
async function testPruned(browser, address) {
  const editor = await EditorPage.open(browser, address, { size: [900, 600] });
  const { page } = editor;
  for (let i = 0; i < 23; ++i) {
    await page.evaluate(([t, n]) => window.sfumatoEditor.open(t, n), [small, `${i}.svg`]);
    await edit(editor);
    await page.evaluate(() => dispatchEvent(new Event("pagehide")));
  }
  await isKept(page, "22.svg");
  await goHome(page);
  checkEqual(await page.locator(".recent-list li").count(), 6, "drawings on the first page");
  await page.getByRole("button", { name: "All 20 drawings" }).click();
  await page.locator(".kept-list li").first().waitFor();
  const names = await page.locator(".kept-list b").allTextContents();
  checkEqual(names, Array.from({ length: 20 }, (_, i) => `${22 - i}.svg`), "what is kept");
  editor.checkQuiet();
  await editor.close();
}

export async function testRecover(tap, { browser, address }) {
  await tap.test("recover: a page that is killed loses nothing", () => testKilled(browser, address));
  await tap.test("recover: every drawing is kept as itself", () => testSwitched(browser, address));
  const refusals = { throws: throwing, "is missing": missing };
  for (const [name, script] of Object.entries(refusals)) {
    await tap.test(`recover: a message says that storage ${name}`, () => testRefused(browser, address, script, /does not let this page store anything/));
  }
  await tap.test("recover: a message says that storage is full", () => testRefused(browser, address, full, /no room to keep/, /Not saved: no room in this browser/));
  await tap.test("recover: two tabs do not write over each other", () => testTabs(browser, address));
  await tap.test("recover: twenty drawings are kept", () => testPruned(browser, address));
}
