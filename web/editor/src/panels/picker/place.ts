// Where the picker stands: beside what it colours, or where it was left.
import { useLayoutEffect } from "preact/hooks";
import type { Editor, PickerTarget } from "../../app/types.js";
import { mapped, type Point } from "../../geometry/affine.js";
import { pathPointAt, placeOfOffset } from "../../geometry/length.js";
import { signal } from "@preact/signals";
import { keyOf, targetStop } from "./session.js";

const EDGE = 12;
/** The place that the user dragged it to, kept until the page closes. */
export const left = signal<Point | null>(null);

/** The stop's place in the window, or null. */
function stopAt(editor: Editor, target: PickerTarget, stage: DOMRect): Point | null {
  const found = targetStop(editor.drawing, target);
  const path = found?.item.paths[0];
  // A gradient's stops do not stand on the curve.
  if (!found || !path || found.gradient) return null;
  const { list, item, shown } = found;
  const local = pathPointAt(path, placeOfOffset(path, list.space, shown.offset));
  const [x, y] = mapped(editor.stageFromArtboard(), mapped(item.artboardFromItem, local));
  return [stage.left + x, stage.top + y];
}

function beside(editor: Editor, target: PickerTarget, width: number): Point {
  const stage = document.querySelector(".stage")?.getBoundingClientRect();
  if (!stage) return [EDGE, EDGE];
  const right = stage.right - width - EDGE;
  const stop = stopAt(editor, target, stage);
  const covers = stop !== null && stop[0] > right - EDGE && stop[0] < stage.right;
  return [covers ? stage.left + EDGE : right, stage.top + EDGE];
}

/** Puts it where it belongs when it opens, and back into the window when that shrinks. */
export function usePlace(
  editor: Editor,
  target: PickerTarget,
  popover: { current: HTMLElement | null },
  isPhone: boolean,
) {
  useLayoutEffect(() => {
    const put = () => {
      const element = popover.current;
      if (!element || isPhone) return;
      const { offsetWidth: width, offsetHeight: height } = element;
      const [x, y] = left.peek() ?? beside(editor, target, width);
      element.style.left = `${Math.max(EDGE, Math.min(x, innerWidth - width - EDGE))}px`;
      element.style.top = `${Math.max(EDGE, Math.min(y, innerHeight - height - EDGE))}px`;
    };
    put();
    window.addEventListener("resize", put);
    return () => window.removeEventListener("resize", put);
  }, [keyOf(target), isPhone]);
}
