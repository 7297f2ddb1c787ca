// Keys of the whole page. A key that a field, a menu or the stage has handled (preventDefault) is ignored.
import type { DrawingEditor } from "./editor.js";
import { commandOfKey, isTyping } from "./keys.js";

/** The browser handles clipboard keys, and then sends copy, cut and paste events. */
const BROWSERS = new Set(["copy", "cut", "paste"]);
/** These work while somebody types, too. */
const ALWAYS = new Set(["save", "save-as", "open", "export", "new"]);
const HIDE_KEY = "`";

/** Leaves a field, so that the page's keys work again. @returns whether one had the focus */
function leaveField({ key, target }: KeyboardEvent): boolean {
  const stage = document.querySelector<HTMLElement>(".canvas-stage");
  if (key !== "Escape" || !isTyping(target) || !stage) return false;
  stage.focus({ preventScroll: true });
  return true;
}

/** Ends the isolation, because no part of the page had another use for Escape. @returns whether there was one */
function leaveIsolation(editor: DrawingEditor, { key }: KeyboardEvent): boolean {
  if (key !== "Escape" || editor.isolated.peek() === null) return false;
  editor.isolate(null);
  return true;
}

/** The field that somebody types into, or null. */
function fieldNow(): HTMLElement | null {
  const { activeElement } = document;
  return isTyping(activeElement) ? (activeElement as HTMLElement) : null;
}

/** Commits typed text before the next action, which may remove the field. */
function keepTyped(): void {
  const field = fieldNow();
  field?.blur();
  field?.focus();
}

/** A press elsewhere ends the typing before it does anything: it may select something else. */
function listenToLeaving(): void {
  const press = ({ target }: Event) => {
    const field = fieldNow();
    if (field && !field.contains(target as Node)) field.blur();
  };
  document.addEventListener("pointerdown", press, true);
}

export function listenToKeys(editor: DrawingEditor): void {
  listenToLeaving();
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.isComposing) return;
    const isInDialog = document.querySelector("dialog[open]") !== null;
    if (!isInDialog && leaveField(event)) return event.preventDefault();
    if (!isInDialog && leaveIsolation(editor, event)) return event.preventDefault();
    if (event.key === HIDE_KEY && !isTyping(event.target)) editor.hideHandles.value = true;
    const command = commandOfKey(event);
    if (!command || BROWSERS.has(command)) return;
    const isBlocked = isTyping(event.target) || isInDialog;
    if (isBlocked && !ALWAYS.has(command)) return;
    event.preventDefault();
    keepTyped();
    editor.command(command);
  });
  const show = (event: Event) => {
    const isKey = event instanceof KeyboardEvent && event.key !== HIDE_KEY;
    if (!isKey) editor.hideHandles.value = false;
  };
  document.addEventListener("keyup", show);
  window.addEventListener("blur", show);
}
