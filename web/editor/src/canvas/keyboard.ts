// The stage's own keys. Other keys go on to the editor.
import type { Point } from "../geometry/affine.js";
import type { Canvas } from "./canvas.js";
import { deleteParts, nudge } from "./edits.js";
import { guideKey } from "./guides/keys.js";
import type { Pointers } from "./pointers.js";
import type { KeyPress, Tool } from "./tools/tool.js";
import { goIn, goOut, walk } from "./walk.js";

const ARROWS: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
/** The step of Shift and an arrow, CSS pixels. */
const LARGE_STEP = 10;

/** @returns whether the key was the stage's */
export function pressKey(canvas: Canvas, pointers: Pointers, tool: Tool, key: KeyPress): boolean {
  pointers.modifiers(key);
  tool.modifiers?.(key);
  if (key.key === "Escape" && pointers.cancel()) return true;
  if (!pointers.isDragging && tool.key?.(key)) return true;
  if (key.key === " ") {
    pointers.space(true);
    return true;
  }
  return pointers.isDragging ? pointers.key(key) : pressPlainKey(canvas, key);
}

export function releaseKey(pointers: Pointers, tool: Tool, key: KeyPress): void {
  pointers.modifiers(key);
  tool.modifiers?.(key);
  if (key.key === " ") pointers.space(false);
}

function pressPlainKey(canvas: Canvas, { key, shift, alt, ctrl }: KeyPress): boolean {
  const { editor, grips } = canvas;
  const arrow = ARROWS[key];
  const pixels = shift ? LARGE_STEP : 1;
  if (!ctrl && !alt && guideKey(canvas, key, arrow && [arrow[0] * pixels, arrow[1] * pixels])) return true;
  if (arrow && grips.arrow(arrow, { shift, alt, ctrl })) return true;
  if (ctrl || alt) return false;
  if (arrow) return nudge(editor, [arrow[0] * pixels, arrow[1] * pixels]);
  switch (key) {
    case "Tab":
      return step(canvas, shift ? -1 : 1);
    case "Enter":
      return shift ? grips.enter() : goIn(editor);
    case "Escape":
      return grips.letGo() || goOut(editor);
    case "Delete":
    case "Backspace":
      return deleteParts(editor);
    default:
      return false;
  }
}

/** From a handle of the box to the next, else from curve to curve or from part to part. */
function step({ editor, grips, marks }: Canvas, by: 1 | -1): boolean {
  return grips.isIn ? grips.walk(by) : walk(editor, marks.peek(), by);
}
