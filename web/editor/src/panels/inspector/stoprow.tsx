// The chosen colour stop: its colour, its figures, its place; of a gradient's also its alpha.
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
import { curveOf, fractionOf, movedStop, offsetAt, withValue } from "../stops.js";
import { tintsOf, type Tints } from "../tints.js";
import type { Drawing } from "../../model/types.js";
import { chooseStop, chosenStop, type ChosenStop } from "./chosen.js";
import { GradientFields } from "./gradient.js";

const words = en.panels;

interface Found extends Tints {
  readonly at: ChosenStop;
}

/** The stop that the row is about: the chosen one, else the first that there is. */
function stopOfRow(drawing: Drawing, item: CurveItem, chosen: ChosenStop | null): Found | null {
  const sides: readonly Side[] = chosen ? [chosen.side] : ["left", "right"];
  for (const side of sides) {
    const tints = tintsOf(drawing, item, side);
    const index = chosen?.index ?? 0;
    if (tints && index < tints.list.stops.length) return { ...tints, at: { side, index } };
  }
  return null;
}

/** Asks for a colour of the picture; a second time, the first one is forgotten. */
function usePicking(setColor: (value: Rgb) => void) {
  const { services } = useShell();
  const abort = useRef<AbortController | null>(null);
  return async () => {
    abort.current?.abort();
    abort.current = new AbortController();
    const color = await services.pickColor(abort.current.signal);
    if (color) setColor(color);
  };
}

function Swatch({ item, found }: { readonly item: CurveItem; readonly found: Found }) {
  const { editor } = useShell();
  const { side, index } = found.at;
  const { value } = found.list.stops[index];
  const picker = editor.picker.value;
  const isOpen = picker?.handle === item.handle && picker.side === side && picker.stop === index;
  return (
    <button
      type="button"
      class="swatch"
      style={{ "--c": hexOf(value) }}
      aria-haspopup="dialog"
      aria-pressed={isOpen}
      aria-label={words.colorOfStop(words.sides[side], index + 1, hexOf(value))}
      onClick={() => {
        if (!isOpen) chooseStop(editor, item, "color", found.at);
        editor.picker.value = isOpen ? null : { handle: item.handle, side, stop: index };
      }}
    />
  );
}

function Fields({ item, found }: { readonly item: CurveItem; readonly found: Found }) {
  const { editor } = useShell();
  const { list, put, gradient } = found;
  const { side, index } = found.at;
  const stop = list.stops[index];
  const setColor = (value: Rgb) =>
    void editor.run(
      words.setColor,
      put(editor.drawing, side, withValue(list, index, { ...stop.value, ...value })),
    );
  const pick = usePicking(setColor);
  return (
    <>
      <div class="stop-row">
        <Swatch item={item} found={found} />
        <HexField name={words.hex} value={stop.value} onChange={setColor} />
        <NumberField
          label={words.at}
          name={words.atOf(words.sides[side], index + 1)}
          value={fractionOf(item, list.space, stop.offset) * 100}
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
      {gradient && (
        <GradientFields
          gradient={gradient}
          alpha={stop.value.alpha}
          alphaName={words.alphaOf(words.sides[side], index + 1)}
          sink={edits(editor, words.setAlpha, (percent: number, before) =>
            put(before, side, withValue(list, index, { ...stop.value, alpha: percent / 100 })),
          )}
        />
      )}
    </>
  );
}

export function StopRow({ item }: { readonly item: CurveItem }) {
  const { editor } = useShell();
  const found = stopOfRow(editor.drawing, item, chosenStop(editor, item, "color"));
  return found && <Fields item={item} found={found} />;
}
