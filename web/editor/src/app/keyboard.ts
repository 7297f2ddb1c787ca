// Keys of the whole page. What a field, a menu or the stage has taken (preventDefault) is not heard.
import type { DrawingEditor } from "./editor.js";
import { commandOfKey, isTyping } from "./keys.js";

/** Clipboard keys are left to the browser, which then tells of copy, cut and paste. */
const BROWSERS = new Set(["copy", "cut", "paste"]);
/** These work while somebody types, too. */
const ALWAYS = new Set(["save", "save-as", "open", "export", "new"]);
const HIDE_KEY = "`";

export function listenToKeys(editor: DrawingEditor): void {
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.isComposing) return;
    if (event.key === HIDE_KEY && !isTyping(event.target)) editor.hideHandles.value = true;
    const command = commandOfKey(event);
    if (!command || BROWSERS.has(command)) return;
    const isBlocked = isTyping(event.target) || document.querySelector("dialog[open]") !== null;
    if (isBlocked && !ALWAYS.has(command)) return;
    event.preventDefault();
    editor.command(command);
  });
  const show = (event: Event) => {
    const isKey = event instanceof KeyboardEvent && event.key !== HIDE_KEY;
    if (!isKey) editor.hideHandles.value = false;
  };
  document.addEventListener("keyup", show);
  window.addEventListener("blur", show);
}
