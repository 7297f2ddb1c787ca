// Keys pressed on the canvas with the select tool.
import type { Canvas } from "../../../../web/editor/src/canvas/canvas.js";
import { pressKey } from "../../../../web/editor/src/canvas/keyboard.js";
import { Pointers } from "../../../../web/editor/src/canvas/pointers.js";
import { SelectTool } from "../../../../web/editor/src/canvas/tools/select.js";
import type { CurveItem } from "../../../../web/editor/src/model/types.js";
import { layer } from "./drawing.js";
import { canvasOf, fakeEditor, type FakeEditor } from "./editor.js";

export interface Keyboard {
  readonly editor: FakeEditor;
  readonly canvas: Canvas;
  readonly tool: SelectTool;
  press(key: string, more?: object): boolean;
}

/** Returns an editor with a layer of curves. */
export function keyboardOn(...curves: readonly CurveItem[]): Keyboard {
  const editor = fakeEditor([layer("layer", [...curves])]);
  const canvas = canvasOf(editor);
  const tool = new SelectTool(canvas);
  const pointers = new Pointers(canvas, () => tool);
  const press = (key: string, more = {}) =>
    pressKey(canvas, pointers, tool, { key, shift: false, alt: false, ctrl: false, ...more });
  return { editor, canvas, tool, press };
}
