// Keys of the chosen guide: arrows move it, Delete removes it, Escape lets go of it.
import type { Point } from "../../geometry/affine.js";
import { moveGuide, removeGuides } from "../../model/commands/index.js";
import * as en from "../../strings/en.js";
import type { Canvas } from "../canvas.js";
import { chooseGuide, chosenGuide } from "./chosen.js";

/** @param by the way of an arrow, CSS pixels. @returns whether a guide is chosen and the key is its own */
export function guideKey(canvas: Canvas, key: string, by: Point | undefined): boolean {
  const { editor } = canvas;
  const guide = chosenGuide(canvas);
  if (!guide || guide.axis === null) return false;
  const { axis, handle, point } = guide;
  if (by) {
    const to = point[axis] + by[axis] / editor.view.peek().zoom;
    // Steps that follow each other quickly are one step of undo.
    editor.run(en.tools.undo.moveGuide, moveGuide(editor.drawing, handle, to), "nudge");
    const now = canvas.guidelines.peek().all.find((one) => one.handle === handle);
    if (now) chooseGuide(canvas, now);
    return true;
  }
  if (key !== "Delete" && key !== "Backspace" && key !== "Escape") return false;
  canvas.guide.value = null;
  if (key !== "Escape") editor.run(en.tools.undo.removeGuide, removeGuides(editor.drawing, [guide]));
  return true;
}
