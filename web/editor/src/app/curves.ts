// Commands on the shape and the look of curves.
import {
  addSwatches,
  curvesOf,
  cutCurve,
  pasteStyle,
  simplifyCurve,
  styleOf,
  together,
} from "../model/commands/index.js";
import * as en from "../strings/en.js";
import type { DrawingEditor } from "./editor.js";
import { chosenCurves, chosenNodes, primaryCurve } from "./selected.js";

const words = en.commands;

/** Cuts the primary curve at its selected nodes. */
export function cutAtNodes(editor: DrawingEditor): void {
  const curve = primaryCurve(editor);
  if (!curve) return;
  const nodes = chosenNodes(editor);
  const made = cutCurve(editor.drawing, curve.handle, nodes, editor.step(curve));
  if (!made) return editor.say(words.cutWantsNode);
  editor.run(words.cutCurve, made);
}

/** Steps in a CSS pixel. */
const STEPS_IN_PIXEL = 1000;

/** Takes away the nodes of the selected curves without which they stay within a pixel of the screen. */
export function simplify(editor: DrawingEditor): void {
  const made = chosenCurves(editor).map((curve) => {
    const step = editor.step(curve);
    return simplifyCurve(editor.drawing, curve.handle, STEPS_IN_PIXEL * step, step);
  });
  if (made.length === 0) return;
  if (!editor.run(words.simplify, together(made))) editor.say(words.nothingToSimplify);
}

/** Adds the colours of the selected curves to the palette of the document. */
export function addToPalette(editor: DrawingEditor): void {
  const colors = chosenCurves(editor).flatMap(({ left, right }) =>
    [left, right].flatMap(({ color }) => (color.kind === "stops" ? color.stops.map(({ value }) => value) : [])),
  );
  if (colors.length === 0) return;
  if (!editor.run(words.addToPalette, addSwatches(editor.drawing, colors))) editor.say(words.paletteHasAll);
}

export function copyStyle(editor: DrawingEditor): void {
  const curve = primaryCurve(editor);
  if (!curve) return editor.say(words.copyStyleWantsCurve);
  editor.copiedStyle.value = styleOf(editor.drawing, curve.handle);
  editor.say(words.styleCopied);
}

export function pasteCopiedStyle(editor: DrawingEditor): void {
  const style = editor.copiedStyle.value;
  if (!style) return editor.say(words.copyStyleWantsCurve);
  const handles = curvesOf(editor.drawing, editor.selection.value);
  editor.run(words.pasteStyle, pasteStyle(editor.drawing, handles, style));
}
