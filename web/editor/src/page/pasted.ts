// Handles pasted data: opens files, and on the first page text too; otherwise text goes into the drawing.
import { pasteText } from "../app/clipboard.js";
import type { DrawingEditor } from "../app/editor.js";
import { isForeign } from "../files/foreign.js";
import * as en from "../strings/en.js";
import type { Documents } from "./documents.js";
import type { Pasted } from "./pastes.js";

export function takePasted(editor: DrawingEditor, documents: Documents, { files, text }: Pasted): void {
  if (files.length > 0) void documents.drop(files);
  else if (editor.welcome.peek()) openText(editor, documents, text);
  else if (isForeign(text)) void documents.pasteForeign(text);
  else pasteText(editor, text);
}

function openText(editor: DrawingEditor, documents: Documents, text: string) {
  if (!text.includes("<")) return editor.say(en.commands.nothingToPaste);
  void documents.drop([new File([text], en.page.pastedName, { type: "image/svg+xml" })]);
}
