// Selects the item of a hint and zooms to it.
import type { Editor } from "../../app/types.js";
import type { Hint } from "../../engine/types.js";
import { composed, inverted, mapped, type Point } from "../../geometry/affine.js";
import { curvesThrough } from "../../model/lint-fixes.js";
import type { Item } from "../../model/types.js";
import type { Shell } from "../services.js";

/** Half of what is shown around a hint's place, artboard units. */
const AROUND = 40;

/** Returns a hint's place on the artboard: the engine gives it in the layer's coordinates. */
export function placeOf({ drawing }: Pick<Editor, "drawing">, { at, offset }: Pick<Hint, "at" | "offset">): Point | null {
  const item = offset === null ? undefined : drawing.itemAt(offset);
  if (!at || item?.kind !== "curve") return at;
  const itemFromLayer = inverted(item.layerFromItem);
  return itemFromLayer && mapped(composed(item.artboardFromItem, itemFromLayer), at);
}

/** The curve or whatever else it is about, else its layer; of a crossing both curves. */
export function itemsOf({ editor, services }: Shell, hint: Hint): readonly Item[] {
  const { drawing } = editor;
  const item = services.itemOf(hint);
  const at = hint.rule === "crossing" ? placeOf(editor, hint) : null;
  if (item) return at ? [...curvesThrough(drawing, item, at), item] : [item];
  if (hint.layer === null) return [];
  return [...drawing.all()].filter((one) => one.kind === "layer" && editor.engineLayer(one) === hint.layer);
}

export function showHint(shell: Shell, hint: Hint): void {
  const { editor } = shell;
  const items = itemsOf(shell, hint);
  if (items.length > 0) editor.selection.value = items.map(({ handle }) => ({ handle, part: { kind: "whole" } }));
  const at = placeOf(editor, hint);
  if (at) {
    const [x, y] = at;
    editor.fit([x - AROUND, y - AROUND, x + AROUND, y + AROUND]);
  } else if (items.length > 0) editor.command("zoom-selection");
}
