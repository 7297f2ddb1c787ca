// Alpha of the picked stop. It means opacity of the side, which diffuses by itself: the slider is
// there where the side has one opacity all along, and not on local strokes, whose alpha is another.
import { hexOf } from "../../geometry/colortext.js";
import { setNumbers } from "../../model/commands/index.js";
import { en } from "../../strings/en.js";
import { edits } from "../controls/sink.js";
import { Slider } from "../controls/slider.js";
import { decimal } from "../format.js";
import { useShell } from "../services.js";
import { constant } from "../stops.js";
import type { Session } from "./session.js";

const words = en.picker;

export function Alpha({ session }: { readonly session: Session }) {
  const { editor } = useShell();
  const target = editor.picker.value;
  if (!target || session.item.kind !== "curve") return null;
  const { opacity } = session.item[target.side];
  if (opacity.kind !== "stops" || opacity.stops.length !== 1) return null;
  const percent = opacity.stops[0].value * 100;
  const sink = edits(editor, en.panels.setOpacity, (value: number, before) =>
    setNumbers(before, target.handle, target.side, "opacity", constant(value / 100)),
  );
  const chequers =
    "repeating-conic-gradient(var(--check-b) 0 25%, var(--check-a) 0 50%) 0 0 / 8px 8px";
  return (
    <Slider
      label={words.alpha}
      value={percent}
      min={0}
      max={100}
      step={1}
      reset={100}
      text={words.percent(decimal(percent, 0))}
      track={`linear-gradient(90deg, transparent, ${hexOf(session.color)}), ${chequers}`}
      sink={sink}
    />
  );
}
