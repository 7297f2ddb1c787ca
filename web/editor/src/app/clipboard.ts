// Copy and paste as SVG text: by the browser's own events, which need no permission, and by menus.
import { copyItems, deleteItems, paste } from "../model/commands/index.js";
import type { Handle } from "../model/types.js";
import { SourceError } from "../source/tree.js";
import * as en from "../strings/en.js";
import type { DrawingEditor } from "./editor.js";
import { chosen } from "./selected.js";
import { isForPage } from "./keys.js";

/** The text that was copied last, where the system's clipboard is refused. */
let own = "";

export function copySelection(editor: DrawingEditor): string {
  const handles = chosen(editor);
  if (handles.length === 0) return "";
  own = copyItems(editor.drawing, handles);
  return own;
}

export function cutSelection(editor: DrawingEditor): string {
  const text = copySelection(editor);
  if (text) editor.run(en.commands.cut, deleteItems(editor.drawing, chosen(editor)));
  return text;
}

export function pasteText(editor: DrawingEditor, text: string): void {
  try {
    if (!pasteInto(editor, text, editor.activeLayer?.handle ?? null)) editor.say(en.commands.nothingToPaste);
  } catch (error) {
    if (!(error instanceof SourceError)) throw error;
    editor.say(en.commands.nothingToPaste);
  }
}

/**
 * Pastes into the layer; markup that cannot stand there, such as an instance inside what it copies, goes on
 * top of everything. Returns whether there was anything to paste.
 */
function pasteInto(editor: DrawingEditor, text: string, layer: Handle | null): boolean {
  const outcome = paste(editor.drawing, text, layer);
  if (!outcome) return false;
  if (editor.run(en.commands.paste, outcome) || layer === null) return true;
  if (editor.run(en.commands.paste, paste(editor.drawing, text, null))) editor.toast.value = null;
  return true;
}

/** For menus and keys: the browser may ask the user about the clipboard, or refuse it. */
export async function copyByMenu(editor: DrawingEditor, cut: boolean): Promise<void> {
  const text = cut ? cutSelection(editor) : copySelection(editor);
  try {
    if (text) await navigator.clipboard.writeText(text);
  } catch {
    // Pasting within this page works all the same.
  }
}

/** Returns the text of the clipboard, for menus. The browser may ask the user for permission, or refuse. */
export async function clipboardText(): Promise<string> {
  try {
    return (await navigator.clipboard.readText()) || own;
  } catch {
    // The text that was copied here last.
    return own;
  }
}

/** Handles the browser's copy and cut events; page/pasted.ts handles paste. */
export function listenToCopying(editor: DrawingEditor): void {
  const on = (name: "copy" | "cut", act: () => string) =>
    document.addEventListener(name, (event) => {
      if (!isForPage() || editor.welcome.value) return;
      give(event, act());
    });
  on("copy", () => copySelection(editor));
  on("cut", () => cutSelection(editor));
}

function give(event: ClipboardEvent, text: string) {
  if (!text) return;
  event.clipboardData?.setData("text/plain", text);
  event.clipboardData?.setData("image/svg+xml", text);
  event.preventDefault();
}
