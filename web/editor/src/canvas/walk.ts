// Keyboard navigation of the canvas: Tab goes from curve to curve, Enter into one, Escape out of it.
import type { Editor } from "../app/types.js";
import type { Handle, Item, Part, Selected } from "../model/types.js";
import * as en from "../strings/en.js";
import type { Mark } from "./marks.js";
import { selectedOf } from "./marks.js";
import { placesOf } from "./places.js";

const WHOLE: Part = { kind: "whole" };

/** A name of a mark that stays while the picture is redrawn. */
export function keyOf(mark: Mark): string {
  const { part } = mark;
  const path = "path" in mark ? mark.path : 0;
  if (part.kind === "whole") return `${mark.kind}-${"grip" in mark ? mark.grip.join("-") : ""}`;
  if (part.kind === "stop")
    return `${mark.handle}-${path}-${part.side}-${part.attribute}-${part.index}`;
  if (part.kind === "paint") return `${mark.handle}-paint-${part.side}-${part.attribute}-${part.grip}`;
  return `${mark.handle}-${part.kind}-${part.path}-${part.index}`;
}

/** Returns the items that the keyboard walks through: curves, and copies by <use>, each once. */
function owners(editor: Editor): Item[] {
  return [...new Set(placesOf(editor).map(({ owner }) => owner))];
}

/**
 * Selects the next or previous curve, or mark where a part is chosen.
 * @returns false past the last one: the focus goes on
 */
export function walk(editor: Editor, marks: readonly Mark[], step: 1 | -1): boolean {
  const primary = editor.selection.peek().at(-1);
  if (primary && primary.part.kind !== "whole") return walkMarks(editor, marks, step);
  const all = owners(editor);
  const at = primary ? all.findIndex(({ handle }) => handle === primary.handle) : -1;
  // Without a selection Tab begins with the first curve, and Shift Tab leaves.
  const next = at < 0 && step < 0 ? -1 : at + step;
  const item = all[next];
  if (!item) return false;
  editor.selection.value = [{ handle: item.handle, part: WHOLE }];
  editor.announcement.value = en.canvas.selectedCurve(item.name, next + 1, all.length);
  return true;
}

function walkMarks(editor: Editor, marks: readonly Mark[], step: 1 | -1): boolean {
  const at = marks.findIndex(({ isChosen }) => isChosen);
  const next = marks[at + step];
  if (at < 0 || !next) return false;
  editor.selection.value = [selectedOf(next)];
  return true;
}

/** Into what is selected: a layer's first curve, a curve's first node. A stop's colour is picked. */
export function goIn(editor: Editor): boolean {
  const primary = editor.selection.peek().at(-1);
  const item = primary && editor.drawing.item(primary.handle);
  if (!item) return false;
  const { part } = primary;
  if (part.kind === "stop" && part.attribute === "color") {
    editor.picker.value = { handle: primary.handle, side: part.side, stops: [part.index] };
    return true;
  }
  if (part.kind !== "whole") return false;
  const inside: Item | undefined = item.children[0];
  if (inside) {
    choose(editor, inside.handle, WHOLE);
    editor.announcement.value = inside.name;
    return true;
  }
  if (item.kind !== "curve" && item.kind !== "stroke") return false;
  editor.tool.value = "nodes";
  choose(editor, item.handle, { kind: "node", path: 0, index: 0 });
  return true;
}

/** Out of what is selected: of a part to its curve, to its group and layer, at most the isolated one, to nothing. */
export function goOut(editor: Editor): boolean {
  const primary = editor.selection.peek().at(-1);
  if (!primary) return false;
  const item = editor.drawing.item(primary.handle);
  if (primary.part.kind !== "whole") choose(editor, primary.handle, WHOLE);
  else if (item?.parent && item.handle !== editor.isolated.peek()) choose(editor, item.parent.handle, WHOLE);
  else editor.selection.value = [];
  const now = editor.selection.peek().at(-1);
  editor.announcement.value = (now && editor.drawing.item(now.handle)?.name) ?? "";
  return true;
}

/** Instead of parts what they are of. @returns whether there were parts */
export function letGoOfParts(editor: Editor): boolean {
  const selection = editor.selection.peek();
  if (selection.every(({ part }) => part.kind === "whole")) return false;
  const handles = [...new Set(selection.map(({ handle }) => handle))];
  editor.selection.value = handles.map((handle) => ({ handle, part: WHOLE }));
  return true;
}

function choose(editor: Editor, handle: Handle, part: Part): void {
  const one: Selected = { handle, part };
  editor.selection.value = [one];
}
