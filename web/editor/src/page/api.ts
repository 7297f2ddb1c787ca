// The page's interface for scripts and tests: window.sfumatoEditor (docs/editor.md).
import { mapped } from "../geometry/affine.js";
import type { DrawingEditor } from "../app/editor.js";
import type { Documents } from "./documents.js";

export function publish(editor: DrawingEditor, documents: Documents, drawn: () => Promise<void>): void {
  const api = {
    /** The SVG as it is. */
    get text(): string {
      return editor.drawing.text;
    },
    /** Opens a text in the place of the drawing. */
    open: (text: string, name: string) => documents.begin(text, name),
    /** Resolves when the exact picture of the text is drawn as fine as it gets, or cannot be. */
    settled: drawn,
    /** Where a point of the artboard is in the window, CSS pixels. */
    place(x: number, y: number): readonly [number, number] {
      const box = document.querySelector(".canvas-stage")!.getBoundingClientRect();
      const [px, py] = mapped(editor.stageFromArtboard(), [x, y]);
      return [px + box.left, py + box.top];
    },
    /** The selection: names and parts. */
    get selection() {
      return editor.selection.value.map(({ handle, part }) => ({ name: editor.drawing.item(handle)?.name, part }));
    },
    get status() {
      return editor.status.value;
    },
    /** How it stands with exact pixels. */
    get exactPixels() {
      return editor.exactState.value;
    },
  };
  Object.defineProperty(window, "sfumatoEditor", { value: Object.freeze(api) });
}
