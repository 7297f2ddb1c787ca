// What the picker edits: a stop's colour, as one step of undo from opening to closing.
import { useEffect, useMemo, useRef } from "preact/hooks";
import type { Editor, Gesture, PickerTarget } from "../../app/types.js";
import type { Rgb } from "../../geometry/color.js";
import { hexOf } from "../../geometry/colortext.js";
import { setColor } from "../../model/commands/index.js";
import type { CurveItem, Drawing, Outcome } from "../../model/types.js";
import { en } from "../../strings/en.js";
import { curveOf, withValue, type Stops } from "../stops.js";

const words = en.picker;
const RECENT = 8;

export interface Session {
  readonly item: CurveItem;
  readonly list: Stops<Rgb>;
  readonly color: Rgb;
  /** The colour when the picker was opened. */
  readonly before: Rgb;
  show(color: Rgb): void;
  /** The side is open from now on, and the picker closes. */
  open(): void;
  close(): void;
}

const keyOf = ({ handle, side, stop }: PickerTarget) => `${handle} ${side} ${stop}`;

/** The picker's target as the drawing has it, or null where it is no more. */
export function targetStop(drawing: Drawing, { handle, side, stop }: PickerTarget) {
  const item = curveOf(drawing, handle);
  const list = item?.[side].color;
  return item && list?.kind === "stops" && stop < list.stops.length ? { item, list } : null;
}

const make =
  ({ handle, side, stop }: PickerTarget, color: Rgb) =>
  (before: Drawing): Outcome | null => {
    const found = targetStop(before, { handle, side, stop });
    return found && setColor(before, handle, side, withValue(found.list, stop, color));
  };

export function remember({ settings: { recent } }: Editor, color: Rgb) {
  const others = recent.peek().filter((other) => hexOf(other) !== hexOf(color));
  recent.value = [color, ...others].slice(0, RECENT);
}

/** null: what it was opened for is gone. */
export function useSession(editor: Editor, target: PickerTarget): Session | null {
  const key = keyOf(target);
  const gesture = useRef<Gesture | null>(null);
  const found = targetStop(editor.drawing, target);
  const color = found?.list.stops[target.stop].value ?? null;
  const before = useMemo(() => color, [key]);
  const latest = useRef(color);
  latest.current = color;
  useEffect(
    () => () => {
      if (gesture.current && !gesture.current.isOver) gesture.current.keep();
      gesture.current = null;
      if (latest.current && before && hexOf(latest.current) !== hexOf(before))
        remember(editor, latest.current);
    },
    [key],
  );
  if (!found || !color || !before) return null;
  const show = (to: Rgb) => {
    if (!gesture.current || gesture.current.isOver) gesture.current = editor.gesture(words.change);
    gesture.current.show(make(target, to));
  };
  const close = () => {
    editor.picker.value = null;
  };
  const open = () => {
    if (gesture.current && !gesture.current.isOver) gesture.current.keep();
    close();
    editor.run(words.open, setColor(editor.drawing, target.handle, target.side, { kind: "open" }));
  };
  return { ...found, color, before, show, open, close };
}
