// Commands of files, photos and pasting, which the page adds to the editor's.
import { clipboardText } from "../app/clipboard.js";
import type { DrawingEditor } from "../app/editor.js";
import { askToTrace } from "./tracing.js";
import type { Documents } from "./documents.js";
import { takePasted } from "./pasted.js";
import { colorsFromPhoto, blurFromPhoto, snapToPhoto, toggleDifference } from "./photo-work.js";

export function fileCommands(documents: () => Documents) {
  return [
    ["paste", (editor) => void clipboardText().then((text) => takePasted(editor, documents(), { files: [], text }))],
    ["open", () => void documents().choose()],
    ["place-photo", () => void documents().choosePhoto()],
    ["trace-photo", (editor) => askToTrace(editor)],
    ["colors-from-photo", (editor) => void colorsFromPhoto(editor)],
    ["blur-from-photo", (editor) => void blurFromPhoto(editor)],
    ["snap-to-photo", (editor) => void snapToPhoto(editor)],
    ["difference", toggleDifference],
    ["save", () => void documents().save()],
    ["save-as", () => void documents().saveAs()],
  ] as const satisfies readonly (readonly [string, (editor: DrawingEditor) => void])[];
}
