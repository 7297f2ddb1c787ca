// The guide that a click has chosen.
import type { Guideline } from "../../model/guidelines.js";
import * as en from "../../strings/en.js";
import type { Canvas } from "../canvas.js";
import { shown } from "../format.js";

export function chooseGuide(canvas: Canvas, { handle, axis, point }: Guideline): void {
  const { editor } = canvas;
  canvas.guide.value = { handle, selection: editor.selection.peek() };
  if (axis !== null) editor.announcement.value = en.canvas.guideChosen(axis, shown(point[axis]));
}

/** Returns the guide that has the keys, or null. Reading it in a component subscribes. */
export function chosenGuide(canvas: Canvas): Guideline | null {
  const { editor, guide, guidelines } = canvas;
  const { shown: isShown, all } = guidelines.value;
  const isChosen = guide.value?.selection === editor.selection.value && editor.tool.value === "select";
  if (!isShown || !isChosen) return null;
  return all.find(({ handle, locked }) => handle === guide.value?.handle && !locked) ?? null;
}
