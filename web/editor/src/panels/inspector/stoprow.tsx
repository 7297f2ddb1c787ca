// The selected colour stops, or the sides as a whole: colour, hex, and the place of a single stop. A gradient's stops
// also have an alpha.
import { useRef } from "preact/hooks";
import { remember } from "../../app/colors.js";
import { nameOfSide } from "../../app/side-names.js";
import { sidesInOrder } from "../../model/sides.js";
import type { CurveItem, Side } from "../../model/types.js";
import type { Rgb } from "../../geometry/color.js";
import * as en from "../../strings/en.js";
import { hexOf } from "../../geometry/colortext.js";
import { IconButton } from "../controls/button.js";
import { NumberField } from "../controls/field.js";
import { HexField } from "../controls/hex.js";
import { edits } from "../controls/sink.js";
import { useShell } from "../services.js";
import { keyOf } from "../picker/session.js";
import { curveOf, fractionOf, movedStop, offsetAt } from "../stops.js";
import { tinted, tintsOf, type Tints } from "../tints.js";
import type { Drawing } from "../../model/types.js";
import { chosenStops } from "./chosen.js";
import { GradientFields } from "./gradient.js";
import { sideRow } from "./rows.js";

const words = en.panels;

/** Stops of a side that the row is about; null: the whole side. */
interface Found extends Tints {
  readonly side: Side;
  readonly stops: readonly number[] | null;
}

/** Returns the selected stops, or null if none is selected. */
function selectedStops(drawing: Drawing, item: CurveItem, chosen: ReturnType<typeof chosenStops>): Found | null {
  const tints = chosen && tintsOf(drawing, item, chosen.side);
  const stops = tints && chosen.indices.filter((index) => index < tints.list.stops.length);
  return stops && stops.length > 0 ? { ...tints, side: chosen.side, stops } : null;
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

/** Names what a swatch colours. */
function nameOf(item: CurveItem, { side, stops, list }: Found): string {
  const name = nameOfSide(item, side);
  const hex = hexOf(list.stops[stops?.[0] ?? 0].value);
  if (!stops) return words.colorOfSide(name, hex);
  return stops.length > 1 ? words.colorOfStops(name, stops.length, hex) : words.colorOfStop(name, stops[0] + 1, hex);
}

function Swatch({ item, found }: { readonly item: CurveItem; readonly found: Found }) {
  const { editor } = useShell();
  const { side, stops, list } = found;
  const target = { handle: item.handle, side, stops };
  const picker = editor.picker.value;
  const isOpen = picker !== null && keyOf(picker) === keyOf(target);
  return (
    <button
      type="button"
      class="swatch"
      style={{ "--c": hexOf(list.stops[stops?.[0] ?? 0].value) }}
      aria-haspopup="dialog"
      aria-pressed={isOpen}
      aria-label={nameOf(item, found)}
      onClick={() => {
        editor.picker.value = isOpen ? null : target;
      }}
    />
  );
}

/** Recolours the stops, as one step of undo. */
function useRecolor({ side, stops, put, ...tints }: Found) {
  const { editor } = useShell();
  return (value: Rgb) => {
    editor.run(words.setColor, put(editor.drawing, side, tinted({ ...tints, put }, stops, value)));
    remember(editor.settings, value);
  };
}

/** A colour that becomes the only one of a side. */
function WholeSide({ item, found }: { readonly item: CurveItem; readonly found: Found }) {
  const name = nameOfSide(item, found.side);
  const setColor = useRecolor(found);
  const pick = usePicking(setColor);
  return (
    <div class={sideRow(item)}>
      <span class="side-name">{name}</span>
      <div class="side-color">
        <Swatch item={item} found={found} />
        <HexField name={words.hexOfSide(name)} value={found.list.stops[0].value} onChange={setColor} />
        <IconButton icon="pipette" label={words.pickForSide(name)} onClick={() => void pick()} />
      </div>
    </div>
  );
}

function Place({ item, found, index }: { readonly item: CurveItem; readonly found: Found; readonly index: number }) {
  const { editor } = useShell();
  const { list, put, side } = found;
  return (
    <NumberField
      label={words.at}
      name={words.atOf(nameOfSide(item, side), index + 1)}
      value={fractionOf(item, list.space, list.stops[index].offset) * 100}
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
  );
}

/** The colour of the selected stops, and the place of a single one. */
function Fields({ item, found, stops }: { readonly item: CurveItem; readonly found: Found; readonly stops: readonly number[] }) {
  const { editor } = useShell();
  const { list, put, side, gradient } = found;
  const shown = list.stops[stops[0]].value;
  const setColor = useRecolor(found);
  const pick = usePicking(setColor);
  return (
    <>
      <div class="stop-row">
        <Swatch item={item} found={found} />
        <HexField name={words.hex} value={shown} onChange={setColor} />
        {stops.length === 1 && <Place item={item} found={found} index={stops[0]} />}
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
          alpha={shown.alpha}
          alphaName={words.alphaOf(nameOfSide(item, side), stops[0] + 1)}
          sink={edits(editor, words.setAlpha, (percent: number, before) =>
            put(before, side, tinted(found, stops, { alpha: percent / 100 })),
          )}
        />
      )}
    </>
  );
}

/** The selected stops; if none is selected, a colour for each side as a whole. */
export function StopRow({ item }: { readonly item: CurveItem }) {
  const { editor } = useShell();
  const found = selectedStops(editor.drawing, item, chosenStops(editor, item, "color"));
  if (found?.stops) return <Fields item={item} found={found} stops={found.stops} />;
  return (
    <>
      {sidesInOrder(item).map((side) => {
        const tints = tintsOf(editor.drawing, item, side);
        return tints && <WholeSide key={side} item={item} found={{ ...tints, side, stops: null }} />;
      })}
    </>
  );
}
