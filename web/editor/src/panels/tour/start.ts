// Preparations of the tour before its card appears.
import { effect, untracked } from "@preact/signals";
import type { Editor } from "../../app/types.js";
import { blankText } from "../../model/drawing.js";
import * as en from "../../strings/en.js";

const SIZE = { width: 640, height: 480, background: "#ffffff" } as const;

/** Begun on the first page, the tour has a blank drawing to work on. */
export function prepareTour(editor: Editor): void {
  effect(() => {
    if (editor.tour.value === null || !editor.welcome.value) return;
    const text = blankText(SIZE.width, SIZE.height, SIZE.background);
    untracked(() => editor.open(text, en.page.untitled));
  });
}
