// Commands of rulers and guides.
import { removeGuides, setGuidesLocked, setGuidesShown } from "../model/commands/index.js";
import { areLocked, guidelinesOf, type Guidelines } from "../model/guidelines.js";
import type { Drawing, Outcome } from "../model/types.js";
import * as en from "../strings/en.js";
import type { DrawingEditor } from "./editor.js";

type Command = (editor: DrawingEditor) => void;

const words = en.commands;

/** A command on all guides, as one step of undo. */
function onGuides(make: (guides: Guidelines, drawing: Drawing) => readonly [label: string, Outcome | null]): Command {
  return (editor) => {
    const guides = guidelinesOf(editor.drawing);
    if (guides.all.length === 0) return editor.say(words.needsGuide);
    editor.run(...make(guides, editor.drawing));
  };
}

export const guiding: readonly (readonly [string, Command])[] = [
  ["rulers", ({ settings: { rulers } }) => void (rulers.value = !rulers.value)],
  [
    "show-guides",
    onGuides(({ shown }, d) => [shown ? words.hideGuides : words.showGuides, setGuidesShown(d, !shown)]),
  ],
  [
    "lock-guides",
    onGuides(({ all }, d) => {
      const locked = areLocked(all);
      return [locked ? words.unlockGuides : words.lockGuides, setGuidesLocked(d, !locked)];
    }),
  ],
  ["remove-guides", onGuides(({ all }, d) => [words.removeGuides, removeGuides(d, all)])],
];
