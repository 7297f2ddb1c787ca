// Commands of files and photos, which the page adds to the editor's.
import type { DrawingEditor } from "../app/editor.js";
import { askToTrace } from "./tracing.js";
import type { Documents } from "./documents.js";
import { colorsFromPhoto, blurFromPhoto, snapToPhoto, toggleDifference } from "./photo-work.js";

export function fileCommands(documents: () => Documents) {
  return [
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
