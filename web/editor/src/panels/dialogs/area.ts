// The parts of a drawing that can be exported, and their sizes in pixels.
import type { Editor } from "../../app/types.js";
import { mapped, type Box } from "../../geometry/affine.js";
import { boxOf } from "../../model/item-boxes.js";

export type Area = "artboard" | "selection" | "view";

/** Artboard units; null: there is nothing. */
export function viewportOf(editor: Editor, area: Area): Box | null {
  if (area === "artboard") return editor.drawing.artboard;
  if (area === "selection") {
    const box = boxOf(
      editor.selection.value.flatMap(({ handle }) => editor.drawing.item(handle) ?? []),
    );
    return box && box[2] > box[0] && box[3] > box[1] ? box : null;
  }
  const { width, height } = editor.stage.value;
  const map = editor.artboardFromStage();
  const [a, b] = [mapped(map, [0, 0]), mapped(map, [width, height])];
  return [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[0], b[0]), Math.max(a[1], b[1])];
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Whole pixels, at least one. */
export function sizeAt([left, top, right, bottom]: Box, scale: number): Size {
  const pixels = (length: number) => Math.max(1, Math.round(length * scale));
  return { width: pixels(right - left), height: pixels(bottom - top) };
}
