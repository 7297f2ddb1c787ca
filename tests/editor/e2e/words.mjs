// Waits for messages of the page, and makes the smallest edit by hand.
import { check } from "./harness.mjs";

/** Waits until the page shows a matching message. Returns its text. */
export async function said(page, pattern, where = ".toast") {
  const find = ([selector, source, flags]) =>
    [...document.querySelectorAll(selector)].map((e) => e.textContent).find((t) => new RegExp(source, flags).test(t));
  try {
    const found = await page.waitForFunction(find, [where, pattern.source, pattern.flags]);
    return await found.jsonValue();
  } catch {
    const now = await page.locator(where).allTextContents();
    throw new Error(`nobody said ${pattern}; ${where} has ${JSON.stringify(now)}`);
  }
}

/** Waits until the text of the page's drawing has changed. */
export async function textAfter(page, before) {
  await page.waitForFunction((text) => window.sfumatoEditor.text !== text, before);
  return page.evaluate(() => window.sfumatoEditor.text);
}

/** Waits until the drawing's text is this one. */
export async function shows(page, text) {
  const isThere = (wanted) => window.sfumatoEditor.text === wanted;
  await page.waitForFunction(isThere, text).catch(() => check(false, "the text is not shown"));
}

/** Goes to the first page. */
export async function goHome(page) {
  await page.evaluate(() => document.querySelector("[aria-label=Menu]").click());
  await page.getByRole("menuitem", { name: "File" }).click();
  await page.getByRole("menuitem", { name: "Home" }).click();
  await page.locator(".welcome").waitFor();
}

/** Closes the open dialog. */
export async function closeDialog(page) {
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => !document.querySelector("dialog[open]"));
}

/** Moves the first curve, or the selection, by a key. @returns the new text */
export async function edit(editor) {
  const before = await editor.text;
  await editor.page.locator(".canvas-stage").focus();
  if ((await editor.page.evaluate(() => window.sfumatoEditor.selection.length)) === 0) await editor.key("Tab");
  await editor.key("ArrowRight");
  return textAfter(editor.page, before);
}
