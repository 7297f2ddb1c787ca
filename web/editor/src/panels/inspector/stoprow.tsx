// The chosen colour stop: its colour, its figures, its place.
import { useRef } from "preact/hooks";
import type { CurveItem, Side } from "../../model/types.js";
import type { Rgb } from "../../geometry/color.js";
import { en } from "../../strings/en.js";
import { hexOf } from "../../geometry/colortext.js";
import { IconButton } from "../controls/button.js";
import { NumberField } from "../controls/field.js";
import { HexField } from "../controls/hex.js";
import { edits } from "../controls/sink.js";
import { useShell } from "../services.js";
import {
  curveOf,
  fractionOf,
  movedStop,
  offsetAt,
  putColor,
  withValue,
  type Stops,
} from "../stops.js";
import { chooseStop, chosenStop, type ChosenStop } from "./chosen.js";

const words = en.panels;

/** The stop that the row is about: the chosen one, else the first that there is. */
function stopOfRow(
  item: CurveItem,
  chosen: ChosenStop | null,
): { list: Stops<Rgb>; at: ChosenStop } | null {
  const sides: readonly Side[] = chosen ? [chosen.side] : ["left", "right"];
  for (const side of sides) {
    const { color } = item[side];
    const index = chosen?.index ?? 0;
    if (color.kind === "stops" && index < color.stops.length)
      return { list: color, at: { side, index } };
  }
  return null;
}

export function StopRow({ item }: { readonly item: CurveItem }) {
  const { editor, services } = useShell();
  const abort = useRef<AbortController | null>(null);
  const found = stopOfRow(item, chosenStop(editor, item, "color"));
  if (!found) return null;
  const { list, at } = found;
  const { side, index } = at;
  const stop = list.stops[index];
  const put = putColor(item.handle);
  const setColor = (value: Rgb) =>
    editor.run(words.setColor, put(editor.drawing, side, withValue(list, index, value)));
  const pick = async () => {
    abort.current?.abort();
    abort.current = new AbortController();
    const color = await services.pickColor(abort.current.signal);
    if (color) setColor(color);
  };
  const fraction = fractionOf(item, list.space, stop.offset);
  const picker = editor.picker.value;
  const isOpen = picker?.handle === item.handle && picker.side === side && picker.stop === index;
  return (
    <div class="stop-row">
      <button
        type="button"
        class="swatch"
        style={{ "--c": hexOf(stop.value) }}
        aria-haspopup="dialog"
        aria-pressed={isOpen}
        aria-label={words.colorOfStop(words.sides[side], index + 1, hexOf(stop.value))}
        onClick={() => {
          if (!isOpen) chooseStop(editor, item, "color", at);
          editor.picker.value = isOpen ? null : { handle: item.handle, side, stop: index };
        }}
      />
      <HexField name={words.hex} value={stop.value} onChange={setColor} />
      <NumberField
        label={words.at}
        name={words.atOf(words.sides[side], index + 1)}
        value={fraction * 100}
        digits={1}
        unit="%"
        min={0}
        max={100}
        sink={edits(editor, words.moveStop, (percent: number, before) => {
          const curve = curveOf(before, item.handle);
          if (!curve) return null;
          const placed = movedStop(list, index, offsetAt(curve, list.space, percent / 100));
          return put(before, side, placed.value);
        })}
      />
      <IconButton
        icon="pipette"
        label={words.pickFromPicture}
        command="tool-sample"
        onClick={() => void pick()}
      />
    </div>
  );
}
