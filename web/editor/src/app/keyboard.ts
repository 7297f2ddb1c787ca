// Keys of the whole page. What a field, a menu or the stage has taken (preventDefault) is not heard.
import type { DrawingEditor } from "./editor.js";
import { commandOfKey, isTyping } from "./keys.js";

/** Clipboard keys are left to the browser, which then tells of copy, cut and paste. */
const BROWSERS = new Set(["copy", "cut", "paste"]);
/** These work while somebody types, too. */
const ALWAYS = new Set(["save", "save-as", "open", "export", "new"]);
const HIDE_KEY = "`";

/** Out of a field, so that keys are heard again. @returns whether one had the focus */
function leaveField({ key, target }: KeyboardEvent): boolean {
  const stage = document.querySelector<HTMLElement>(".canvas-stage");
  if (key !== "Escape" || !isTyping(target) || !stage) return false;
  stage.focus({ preventScroll: true });
  return true;
}

export function listenToKeys(editor: DrawingEditor): void {
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.isComposing) return;
    const isInDialog = document.querySelector("dialog[open]") !== null;
    if (!isInDialog && leaveField(event)) return event.preventDefault();
    if (event.key === HIDE_KEY && !isTyping(event.target)) editor.hideHandles.value = true;
    const command = commandOfKey(event);
    if (!command || BROWSERS.has(command)) return;
    const isBlocked = isTyping(event.target) || isInDialog;
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
