// Hints that one click mends.
import type { DrawingEditor } from "../app/editor.js";
import type { Hint } from "../engine/types.js";
import { fixOf } from "../model/lint-fixes.js";
import { en } from "../strings/en.js";

export function mendOf(editor: DrawingEditor, hint: Hint): { readonly label: string; readonly run: () => void } | null {
  const fix = fixOf(editor.drawing, hint);
  if (!fix) return null;
  const label = en.commands.lintFixes[fix.label];
  return { label, run: () => void editor.run(label, fix.outcome) };
}
