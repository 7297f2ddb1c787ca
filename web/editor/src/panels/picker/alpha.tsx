// Alpha of the picked stop: of a gradient's stop its own, else the opacity of the side, where that is
// one all along. Local strokes have another.
import { hexOf } from "../../geometry/colortext.js";
import * as en from "../../strings/en.js";
import { Slider } from "../controls/slider.js";
import { decimal } from "../format.js";
import type { Session } from "./session.js";

const words = en.picker;

export function Alpha({ session }: { readonly session: Session }) {
  if (session.alpha === null) return null;
  const percent = session.alpha * 100;
  const set = (value: number) => session.show({ alpha: value / 100 });
  const chequers =
    "repeating-conic-gradient(var(--check-b) 0 25%, var(--check-a) 0 50%) 0 0 / 8px 8px";
  return (
    <Slider
      label={session.gradient ? words.stopAlpha : words.alpha}
      value={percent}
      min={0}
      max={100}
      step={1}
      reset={100}
      text={words.percent(decimal(percent, 0))}
      track={`linear-gradient(90deg, transparent, ${hexOf(session.color)}), ${chequers}`}
      sink={{
        set,
        // All of the picker's changes are one step: nothing to keep.
        begin: () => ({ show: set, keep: () => undefined, drop: () => undefined }),
      }}
    />
  );
}
