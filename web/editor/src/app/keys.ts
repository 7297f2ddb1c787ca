// Keys as data: what each does, where it stands in the list of keys, and who has changed it.
import { signal } from "@preact/signals";

export type KeyGroup = "tools" | "view" | "edit" | "curve" | "arrange" | "file";

export interface KeyBinding {
  /** A command of commands.ts. */
  readonly command: string;
  readonly group: KeyGroup;
  /** As "Ctrl+Shift+Z": modifiers in this order, and KeyboardEvent.key; letters are upper case. */
  readonly keys: readonly string[];
}

const binding = (group: KeyGroup, command: string, ...keys: string[]): KeyBinding => ({ group, command, keys });

export const defaultKeys: readonly KeyBinding[] = [
  binding("tools", "tool-select", "V"),
  binding("tools", "tool-nodes", "A"),
  binding("tools", "tool-pen", "P"),
  binding("tools", "tool-pencil", "B"),
  binding("tools", "tool-stroke", "K"),
  binding("tools", "tool-rectangle", "R"),
  binding("tools", "tool-ellipse", "L"),
  binding("tools", "tool-polygon", "N"),
  binding("tools", "tool-sample", "I"),
  binding("tools", "tool-blur", "U"),
  binding("tools", "tool-hand", "H"),
  binding("view", "zoom-in", "+", "="),
  binding("view", "zoom-out", "-"),
  binding("view", "zoom-fit", "0"),
  binding("view", "zoom-selection", "Shift+2"),
  binding("view", "zoom-actual", "Shift+1"),
  binding("view", "exact-pixels", "E"),
  binding("view", "mesh", "M"),
  binding("view", "outlines", "O"),
  binding("view", "isolate", "Q"),
  binding("view", "reference", "Shift+R"),
  binding("view", "difference", "D"),
  binding("view", "rulers", "Alt+R"),
  binding("view", "show-guides", "Ctrl+;"),
  binding("view", "guides", "Alt+G"),
  binding("view", "keys", "?"),
  binding("view", "commands", "Ctrl+K"),
  binding("view", "hints", "F8"),
  binding("edit", "undo", "Ctrl+Z"),
  binding("edit", "redo", "Ctrl+Shift+Z", "Ctrl+Y"),
  binding("edit", "cut", "Ctrl+X"),
  binding("edit", "copy", "Ctrl+C"),
  binding("edit", "paste", "Ctrl+V"),
  binding("edit", "duplicate", "Ctrl+D"),
  binding("edit", "delete", "Delete", "Backspace"),
  binding("edit", "select-all", "Ctrl+A"),
  binding("edit", "deselect", "Ctrl+Shift+A"),
  binding("curve", "show-color", "1"),
  binding("curve", "show-opacity", "2"),
  binding("curve", "show-blur", "3"),
  binding("curve", "one-color", "Shift+C"),
  binding("curve", "own-shape", "Shift+S"),
  binding("curve", "swap-sides", "X"),
  binding("curve", "reverse", "Shift+X"),
  binding("curve", "join", "Ctrl+J"),
  binding("curve", "close-curve", "Ctrl+Shift+J"),
  binding("curve", "cut-curve", "Shift+B"),
  binding("curve", "simplify", "Shift+L"),
  binding("curve", "add-to-palette", "Shift+P"),
  binding("curve", "copy-style", "Ctrl+Alt+C"),
  binding("curve", "paste-style", "Ctrl+Alt+V"),
  binding("curve", "colors-from-photo", "Shift+I"),
  binding("curve", "blur-from-photo", "Shift+U"),
  binding("curve", "snap-to-photo", "Shift+E"),
  binding("curve", "corner", "C"),
  binding("curve", "smooth", "S"),
  binding("curve", "symmetric", "Y"),
  binding("arrange", "send-down", "["),
  binding("arrange", "bring-up", "]"),
  binding("arrange", "to-bottom", "Ctrl+["),
  binding("arrange", "to-top", "Ctrl+]"),
  binding("arrange", "group", "Ctrl+G"),
  binding("arrange", "ungroup", "Ctrl+Shift+G"),
  binding("arrange", "make-instance", "Ctrl+Alt+D"),
  binding("arrange", "shapes-unite", "Alt+Shift+U"),
  binding("arrange", "shapes-subtract", "Alt+Shift+S"),
  binding("arrange", "shapes-intersect", "Alt+Shift+I"),
  binding("arrange", "shapes-exclude", "Alt+Shift+E"),
  binding("arrange", "align-left", "Alt+A"),
  binding("arrange", "align-center", "Alt+H"),
  binding("arrange", "align-right", "Alt+D"),
  binding("arrange", "align-top", "Alt+W"),
  binding("arrange", "align-middle", "Alt+V"),
  binding("arrange", "align-bottom", "Alt+S"),
  binding("arrange", "align-to-artboard", "Alt+Shift+A"),
  binding("arrange", "distribute-horizontally", "Alt+Shift+H"),
  binding("arrange", "distribute-vertically", "Alt+Shift+V"),
  binding("arrange", "flip-horizontal", "Shift+H"),
  binding("arrange", "flip-vertical", "Shift+V"),
  binding("file", "new", "Ctrl+Alt+N", "Ctrl+N"),
  binding("file", "open", "Ctrl+O"),
  binding("file", "save", "Ctrl+S"),
  binding("file", "save-as", "Ctrl+Shift+S"),
  binding("file", "export", "Ctrl+E"),
];

const KEY = "sfumato-editor-keys";

function storedKeys(): Record<string, readonly string[]> {
  try {
    const value: unknown = JSON.parse(localStorage.getItem(KEY) ?? "{}");
    const entries = Object.entries(value as object).filter(
      ([, keys]) => Array.isArray(keys) && keys.every((key) => typeof key === "string"),
    );
    return Object.fromEntries(entries);
  } catch {
    return {};
  }
}

/** Keys that somebody chose in the place of ours, by command. */
const chosen = signal(storedKeys());

/** All keys as they are; reading it within components and effects subscribes to changes. */
export function keyBindings(): readonly KeyBinding[] {
  return defaultKeys.map((given) => ({ ...given, keys: chosen.value[given.command] ?? given.keys }));
}

export function keysOf(command: string): readonly string[] {
  return keyBindings().find((given) => given.command === command)?.keys ?? [];
}

/** @returns the command that has the key already; nothing is changed then */
export function setKeys(command: string, keys: readonly string[]): string | null {
  const taken = keyBindings().find(
    (given) => given.command !== command && given.keys.some((key) => keys.includes(key)),
  );
  if (taken) return taken.command;
  keep({ ...chosen.value, [command]: keys });
  return null;
}

/** All keys are ours again. */
export function resetKeys(): void {
  keep({});
}

function keep(keys: Record<string, readonly string[]>) {
  chosen.value = keys;
  try {
    localStorage.setItem(KEY, JSON.stringify(keys));
  } catch {
    // They last until the page is closed.
  }
}

const isMac = typeof navigator !== "undefined" && /Mac|iP(hone|ad|od)/.test(navigator.userAgent);

/** A key as keyBindings() writes it; Cmd of a Mac counts as Ctrl. */
export function keyName(event: KeyboardEvent): string {
  const key = event.key.length === 1 ? event.key.toUpperCase() : event.key;
  // With the Option key of a Mac, a letter is another sign.
  const letter = isMac && event.altKey ? /^Key([A-Z])$/.exec(event.code)?.[1] : undefined;
  // Of "?" and the like Shift is part of the sign; with a digit the sign depends on the keyboard.
  const digit = /^Digit(\d)$/.exec(event.code)?.[1];
  const isSign = letter === undefined && event.key.length === 1 && key === key.toLowerCase() && event.key !== " ";
  const name = letter ?? (digit && event.shiftKey ? digit : key);
  const isCtrl = isMac ? event.metaKey : event.ctrlKey;
  const isShift = event.shiftKey && (!isSign || digit !== undefined);
  return [isCtrl && "Ctrl", event.altKey && "Alt", isShift && "Shift", name].filter(Boolean).join("+");
}

/** As people of this machine read it. */
export function keyLabel(key: string): string {
  const named = key.replace("Delete", "Del").replace("Backspace", "⌫");
  if (!isMac) return named;
  return named.replace("Ctrl+", "⌘").replace("Alt+", "⌥").replace("Shift+", "⇧");
}

/** Whether keys go to a field that somebody types into. */
export function isTyping(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement) return true;
  return target instanceof HTMLInputElement && !["range", "checkbox", "radio", "button", "color"].includes(target.type);
}

/** Whether the clipboard's keys mean the drawing: neither a field, nor chosen words, nor a dialog. */
export function isForPage(): boolean {
  const isText = isTyping(document.activeElement) || String(getSelection() ?? "") !== "";
  return !isText && document.querySelector("dialog[open]") === null;
}

/** The command of a key, or null. */
export function commandOfKey(event: KeyboardEvent): string | null {
  const name = keyName(event);
  return keyBindings().find(({ keys }) => keys.includes(name))?.command ?? null;
}
