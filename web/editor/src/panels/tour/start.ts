// What the tour needs before its card is there.
import { effect, untracked } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { blankText } from "../../model/drawing.js";
import { en } from "../../strings/en.js";
import { useShell } from "../services.js";

const SIZE = { width: 640, height: 480, background: "#ffffff" } as const;

/** Begun on the start page, the tour has a blank drawing to work on. */
export function useTourStart() {
  const { editor } = useShell();
  useEffect(
    () =>
      effect(() => {
        if (editor.tour.value === null || !editor.welcome.value) return;
        untracked(() =>
          editor.open(blankText(SIZE.width, SIZE.height, SIZE.background), en.dialogs.untitled),
        );
      }),
    [],
  );
}
