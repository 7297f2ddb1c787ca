// Hints: the item that each is about, and the hints that one click fixes.
import type { DrawingEditor } from "../app/editor.js";
import type { PictureCanvas } from "../canvas/renderer.js";
import { itemAt } from "../canvas/stack-parts.js";
import type { Hint } from "../engine/types.js";
import { fixOf } from "../model/lint-fixes.js";
import type { Item } from "../model/types.js";
import * as en from "../strings/en.js";

/** Its curve, else what it names on the picture's stack; null: neither is there. */
export function itemOfHint(editor: DrawingEditor, { stack }: PictureCanvas, { offset, stackItem }: Hint): Item | null {
  if (offset !== null) return editor.drawing.itemAt(offset) ?? null;
  return stack && stackItem !== null ? itemAt(editor, stack, stackItem) : null;
}

export function mendOf(
  editor: DrawingEditor,
  picture: PictureCanvas,
  hint: Hint,
): { readonly label: string; readonly run: () => void } | null {
  const fix = fixOf(editor.drawing, { ...hint, handle: itemOfHint(editor, picture, hint)?.handle ?? null });
  if (!fix) return null;
  const label = en.commands.lintFixes[fix.label];
  return { label, run: () => void editor.run(label, fix.outcome) };
}
