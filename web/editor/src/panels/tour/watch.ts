// The event that each step of the tour waits for: a state that did not hold when the step began.
import type { Editor } from "../../app/types.js";
import type { CurveItem, Drawing, SideValue } from "../../model/types.js";

const curvesOf = (drawing: Drawing): readonly CurveItem[] =>
  [...drawing.all()].flatMap((item) =>
    item.kind === "curve" || item.kind === "stroke" ? [item] : [],
  );

const layersOf = (drawing: Drawing) =>
  [...drawing.all()].filter(({ kind }) => kind === "layer").length;

const blurOf = (value: SideValue<number>) =>
  value.kind === "stops" ? value.stops.reduce((sum, stop) => sum + stop.value, 0) : 0;

/** Each side's colours of each curve, as text. */
const colors = (drawing: Drawing) =>
  new Map(
    curvesOf(drawing).map(({ handle, left, right }) => [
      handle,
      [left, right].map((side) => JSON.stringify(side.color)),
    ]),
  );

const blurs = (drawing: Drawing) =>
  curvesOf(drawing).reduce(
    (sum, { left, right }) => sum + blurOf(left.blur) + blurOf(right.blur),
    0,
  );

/** Called when a step begins; returns a function that tests whether the step is done. */
type Watch = (editor: Editor) => () => boolean;

export const watches: readonly Watch[] = [
  (editor) => {
    const before = curvesOf(editor.drawing).length;
    return () => curvesOf(editor.drawing).length > before;
  },
  (editor) => {
    const before = colors(editor.drawing);
    return () =>
      [...colors(editor.drawing)].some(([handle, sides]) => {
        const old = before.get(handle);
        return sides.every((side, k) => side !== old?.[k]);
      });
  },
  (editor) => {
    const before = blurs(editor.drawing);
    return () => blurs(editor.drawing) > before;
  },
  (editor) => {
    const before = layersOf(editor.drawing);
    return () => layersOf(editor.drawing) > before;
  },
  (editor) => () => editor.dialog.value?.kind === "export",
];

/** Prepares a step: selects the tool, and the last curve. */
export function prepare(editor: Editor, step: number) {
  if (step === 0) editor.tool.value = "pencil";
  if (step === 1) editor.tool.value = "nodes";
  if (step === 2) editor.tool.value = "blur";
  if (step !== 1 && step !== 2) return;
  const curve = curvesOf(editor.drawing).at(-1);
  const isChosen = editor.selection
    .peek()
    .some(({ handle }) => editor.drawing.item(handle)?.kind === "curve");
  if (curve && !isChosen)
    editor.selection.value = [{ handle: curve.handle, part: { kind: "whole" } }];
  editor.attribute.value = step === 1 ? "color" : "blur";
}
