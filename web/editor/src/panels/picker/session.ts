// The state of the picker: a stop's colour and alpha, as one step of undo from opening to closing.
import { useEffect, useMemo, useRef } from "preact/hooks";
import { remember } from "../../app/colors.js";
import type { Editor, Gesture, PickerTarget } from "../../app/types.js";
import type { Rgb } from "../../geometry/color.js";
import { hexOf } from "../../geometry/colortext.js";
import { setColor, setNumbers, together } from "../../model/commands/index.js";
import type { CurveItem, Drawing, Outcome } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { constant, curveOf } from "../stops.js";
import { tinted, tintsOf, type Tints } from "../tints.js";

const words = en.picker;

/** The changes since the picker was opened; absent: none. */
interface Wish {
  readonly color?: Rgb;
  readonly alpha?: number;
}

export interface Session extends Tints {
  readonly item: CurveItem;
  readonly color: Rgb;
  /** Alpha of a gradient's stop, else the opacity of the side; null: that varies, or does not exist. */
  readonly alpha: number | null;
  /** The colour when the picker was opened. */
  readonly before: Rgb;
  show(wish: Wish): void;
  /** The side is open from now on, and the picker closes. */
  open(): void;
  close(): void;
}

/** Names a target. */
export const keyOf = ({ handle, side, stops }: PickerTarget) => `${handle} ${side} ${stops ?? "all"}`;

/** Returns the picker's target in the drawing, with the stop that it shows, or null where it no longer exists. */
export function targetStop(drawing: Drawing, { handle, side, stops }: PickerTarget) {
  const item = curveOf(drawing, handle);
  const tints = item && tintsOf(drawing, item, side);
  const isThere = tints && (stops ?? [0]).every((index) => index < tints.list.stops.length);
  return isThere ? { item, ...tints, shown: tints.list.stops[stops?.[0] ?? 0] } : null;
}

type Found = NonNullable<ReturnType<typeof targetStop>>;

/** Opacity of a side diffuses separately: it is shown as alpha if it is constant along the side. */
function alphaOf({ item, gradient, shown }: Found, { side }: PickerTarget): number | null {
  if (gradient) return shown.value.alpha;
  const { opacity } = item[side];
  const isOne = opacity.kind === "stops" && opacity.stops.length === 1;
  return item.kind === "curve" && isOne ? opacity.stops[0].value : null;
}

const make =
  (target: PickerTarget, { color, alpha }: Wish) =>
  (before: Drawing): Outcome | null => {
    const found = targetStop(before, target);
    if (!found) return null;
    const { put, gradient } = found;
    const { handle, side, stops } = target;
    const change = { ...color, ...(gradient && alpha !== undefined ? { alpha } : {}) };
    const isSide = !gradient && alpha !== undefined;
    return together([
      put(before, side, tinted(found, stops, change)),
      isSide ? setNumbers(before, handle, side, "opacity", constant(alpha)) : null,
    ]);
  };

/** null: what it was opened for is gone. */
export function useSession(editor: Editor, target: PickerTarget): Session | null {
  const key = keyOf(target);
  const gesture = useRef<Gesture | null>(null);
  const wish = useRef<Wish>({});
  const found = targetStop(editor.drawing, target);
  const color = found?.shown.value ?? null;
  const before = useMemo(() => color, [key]);
  const latest = useRef<Rgb | null>(color);
  latest.current = color;
  const keep = () => {
    if (gesture.current && !gesture.current.isOver) gesture.current.keep();
    gesture.current = null;
  };
  useEffect(
    () => () => {
      keep();
      if (latest.current && before && hexOf(latest.current) !== hexOf(before))
        remember(editor.settings, latest.current);
    },
    [key],
  );
  if (!found || !color || !before) return null;
  const show = (change: Wish) => {
    const isNew = !gesture.current || gesture.current.isOver;
    if (isNew) gesture.current = editor.gesture(words.change);
    // A gesture shows what it makes of the drawing as it was before all of its changes.
    wish.current = isNew ? change : { ...wish.current, ...change };
    gesture.current?.show(make(target, wish.current));
  };
  const close = () => {
    editor.picker.value = null;
  };
  const open = () => {
    keep();
    close();
    editor.run(words.open, setColor(editor.drawing, target.handle, target.side, { kind: "open" }));
  };
  return { ...found, color, alpha: alphaOf(found, target), before, show, open, close };
}
