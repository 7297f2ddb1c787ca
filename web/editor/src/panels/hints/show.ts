// What a hint is about, chosen and as large as it fits.
import type { Editor } from "../../app/types.js";
import type { Hint } from "../../engine/types.js";
import { curvesThrough } from "../../model/lint-fixes.js";
import type { Item } from "../../model/types.js";

/** Half of what is shown around a hint's place, artboard units. */
const AROUND = 40;

/** The curve, else the layer; of a crossing both curves. */
export function itemsOf(editor: Editor, hint: Hint): readonly Item[] {
  const { drawing } = editor;
  const item = hint.offset === null ? undefined : drawing.itemAt(hint.offset);
  if (item) return hint.at && hint.rule === "crossing" ? [...curvesThrough(drawing, item, hint.at), item] : [item];
  if (hint.layer === null) return [];
  return [...drawing.all()].filter((one) => one.kind === "layer" && editor.engineLayer(one) === hint.layer);
}

export function showHint(editor: Editor, hint: Hint): void {
  const items = itemsOf(editor, hint);
  if (items.length > 0) editor.selection.value = items.map(({ handle }) => ({ handle, part: { kind: "whole" } }));
  const { at } = hint;
  if (at) {
    const [x, y] = at;
    editor.fit([x - AROUND, y - AROUND, x + AROUND, y + AROUND]);
  } else if (items.length > 0) editor.command("zoom-selection");
}
