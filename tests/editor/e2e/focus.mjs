// An element keeps the focus while the page is redrawn, and no typed text is lost. Frames are delayed where delays
// caused faults, because a busy machine draws them late.
import { check, checkEqual, EditorPage } from "./harness.mjs";
import { changing, openWithoutPickers } from "./draw.mjs";
import { timersHaveRun } from "./hooks.mjs";

const drawing = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:background="#fff">
  <g id="back" sf:diffuse="true">
    <path id="low" d="M100 300L400 300" sf:left="#e33" sf:right="#36c" sf:left-opacity=".5" sf:right-opacity="1"/>
    <path id="high" d="M100 120L500 140" sf:left="#fe8" sf:right="#284"/>
  </g>
</svg>
`;

/** Delays all frames from now on, until they are released. */
const holdFrames = (page) =>
  page.evaluate(() => {
    const held = [];
    const { requestAnimationFrame } = window;
    window.requestAnimationFrame = (act) => held.push(act);
    window.letFramesGo = () => {
      window.requestAnimationFrame = requestAnimationFrame;
      held.forEach((act) => requestAnimationFrame(act));
      return new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve(held.length))));
    };
  });
const letFramesGo = (page) => page.evaluate(() => window.letFramesGo());

const opacity = (page) => page.locator(".inspector").getByRole("textbox", { name: /^Opacity, left/ });
const hasFocus = (field) => field.evaluate((input) => input === document.activeElement);

/** A curve is selected on the stage, whose marks are drawn a frame later; by then the user is in a field. */
async function testLateMarks({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await editor.load(drawing);
  await page.locator(".canvas-stage").focus();
  await editor.key("a");
  await holdFrames(page);
  await editor.click(250, 300);
  const field = opacity(page);
  await field.fill("51");
  check((await letFramesGo(page)) > 0, "no frame was asked for");
  check(await hasFocus(field), "the stage took the focus");
  const text = await changing(editor, "Enter", () => page.keyboard.press("Enter"));
  check(text.includes('sf:left-opacity=".51"'), `not the opacity: ${text}`);
  editor.checkQuiet();
  await editor.close();
}

/** A press on another curve removes the field, and the typed text counts. Ctrl S does the same. */
async function testTyped({ browser, address }) {
  const editor = await openWithoutPickers(browser, address);
  const { page } = editor;
  await editor.load(drawing);
  await editor.click(250, 300);
  await opacity(page).fill("40");
  const left = await changing(editor, "a press elsewhere", () => editor.click(300, 130));
  check(left.includes('sf:left-opacity=".4"'), `not the opacity: ${left}`);
  checkEqual(await page.evaluate(() => window.sfumatoEditor.selection[0]?.name), "high", "what is selected");
  await editor.click(250, 300);
  const field = opacity(page);
  await field.fill("30");
  const download = page.waitForEvent("download");
  const saved = await changing(editor, "Ctrl S", () => page.keyboard.press("Control+s"));
  await download;
  check(saved.includes('sf:left-opacity=".3"'), `not the opacity: ${saved}`);
  check(await hasFocus(field), "Ctrl S took the focus");
  editor.checkQuiet();
  await editor.close();
}

/** A layer is renamed; a click into a field ends that, and the field has the focus. */
async function testRenaming({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await editor.load(drawing);
  await page.getByRole("treeitem").first().click();
  await editor.key("F2");
  await page.locator(".rename").fill("ground");
  const field = page.locator(".inspector input[inputmode=decimal]").first();
  const text = await changing(editor, "a click elsewhere", () => field.click());
  check(text.includes("ground"), "the name is lost");
  check(await hasFocus(field), "the row took the focus");
  await editor.close();
}

/** Dialogs and menus receive the very next key, before any frame. */
async function testDialogs({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await editor.load(drawing);
  await page.locator(".canvas-stage").focus();
  const isOpen = await page.evaluate(async () => {
    window.requestAnimationFrame = () => 0;
    const { activeElement } = document;
    activeElement.dispatchEvent(new KeyboardEvent("keydown", { key: "?", bubbles: true, cancelable: true }));
    for (let turn = 0; turn < 20; turn += 1) await Promise.resolve();
    return document.querySelector("dialog")?.open ?? null;
  });
  checkEqual(isOpen, true, "the dialog is open as soon as it is there");
  await editor.key("Escape");
  await page.waitForFunction(() => !document.querySelector("dialog"));
  // The browser may close a dialog without asking; the page must then treat it as closed.
  await editor.key("?");
  await page.locator("dialog[open]").evaluate((dialog) => dialog.close());
  await page.waitForFunction(() => !document.querySelector("dialog"));
  const opener = page.getByRole("button", { name: /^Menu/ });
  const inMenu = await opener.evaluate(async (button) => {
    button.click();
    for (let turn = 0; turn < 20; turn += 1) await Promise.resolve();
    return document.activeElement.closest("[role=menu]") !== null;
  });
  check(inMenu, "the menu has the focus as soon as it is there");
  editor.checkQuiet();
  await editor.close();
}

/** A tool is chosen by its key and used before the next frame is drawn. */
async function testLateTools({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await editor.load(drawing);
  await page.locator(".canvas-stage").focus();
  await holdFrames(page);
  await editor.key("p");
  for (const [x, y] of [[150, 200], [350, 220]]) {
    await page.mouse.move(...(await editor.at(x, y)));
    await page.mouse.down();
    // Work that waits for a frame runs after a tenth of a second without one.
    await timersHaveRun(page, 250);
    await page.mouse.up();
  }
  const drawn = await changing(editor, "the pen", () => page.keyboard.press("Enter"));
  check(/d="M150 200 ?L ?350 220"/.test(drawn), `a node was lost: ${drawn}`);
  await letFramesGo(page);
  editor.checkQuiet();
  await editor.close();
}

export async function testFocus(tap, given) {
  await tap.test("focus: a field keeps it when marks are drawn late", () => testLateMarks(given));
  await tap.test("focus: what was typed counts, however the field is left", () => testTyped(given));
  await tap.test("focus: a click ends renaming and goes where it was meant", () => testRenaming(given));
  await tap.test("focus: a tool is ready as soon as its key is heard", () => testLateTools(given));
  await tap.test("focus: dialogs and menus hear the next key", () => testDialogs(given));
}
