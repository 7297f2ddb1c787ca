// Commands of files, which the page adds to the editor's.
import type { DrawingEditor } from "../app/editor.js";
import { askToTrace } from "./tracing.js";
import type { Documents } from "./documents.js";

export function fileCommands(documents: () => Documents) {
  return [
    ["open", () => void documents().choose()],
    ["place-photo", () => void documents().choosePhoto()],
    ["trace-photo", (editor) => askToTrace(editor)],
    ["save", () => void documents().save()],
    ["save-as", () => void documents().saveAs()],
  ] as const satisfies readonly (readonly [string, (editor: DrawingEditor) => void])[];
}
