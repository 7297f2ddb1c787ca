// Several selected items: the fields that they share, and a replacement of a colour in all of them.
import { useSignal } from "@preact/signals";
import { curvesOf, recolor, setBoth, setNumber, together } from "../../model/commands/index.js";
import type { Rgb } from "../../geometry/color.js";
import type { CurveItem, Item, Outcome } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { hexOf } from "../../geometry/colortext.js";
import { NumberField } from "../controls/field.js";
import { HexField } from "../controls/hex.js";
import { edits } from "../controls/sink.js";
import { decimal } from "../format.js";
import { useShell } from "../services.js";
import { constant, type Stops } from "../stops.js";
import { BoxFields } from "./box.js";
import { numberOf } from "./numbers.js";
import { radiiOf } from "./profile.js";
import { Section } from "./sections.js";

const words = en.panels;
/** More colours than this are not offered for exchange. */
const MOST = 24;

/** The one value, or null where there are several. */
function alike(values: readonly number[]): number | null {
  const texts = new Set(values.map((value) => decimal(value, 6)));
  return texts.size === 1 ? Number([...texts][0]) : null;
}

/** The value that all have on both sides all along, or null. */
function shared(
  curves: readonly CurveItem[],
  lists: (curve: CurveItem) => readonly Stops<number>[],
): number | null {
  return alike(curves.flatMap(lists).flatMap((list) => list.stops.map(({ value }) => value)));
}

const opacities = (curve: CurveItem) =>
  [curve.left.opacity, curve.right.opacity].map((value) =>
    value.kind === "stops" ? value : constant(1),
  );

function colorsIn(curves: readonly CurveItem[]): readonly Rgb[] {
  const found = new Map<string, Rgb>();
  for (const { left, right } of curves) {
    for (const { color } of [left, right]) {
      if (color.kind === "stops")
        color.stops.forEach(({ value }) => found.set(hexOf(value), value));
    }
    if (found.size >= MOST) break;
  }
  return [...found.values()].slice(0, MOST);
}

function Recolor({ curves }: { readonly curves: readonly CurveItem[] }) {
  const { editor } = useShell();
  const chosen = useSignal<string | null>(null);
  const colors = colorsIn(curves);
  const from = colors.find((color) => hexOf(color) === chosen.value) ?? colors[0];
  if (!from) return null;
  const change = (to: Rgb) => {
    editor.run(
      words.recolor,
      recolor(
        editor.drawing,
        curves.map(({ handle }) => handle),
        from,
        to,
      ),
    );
    chosen.value = hexOf(to);
  };
  return (
    <Section title={words.recolorTitle}>
      <div class="swatches">
        {colors.map((color) => (
          <button
            key={hexOf(color)}
            type="button"
            class="swatch"
            style={{ "--c": hexOf(color) }}
            aria-label={hexOf(color)}
            aria-pressed={color === from}
            onClick={() => {
              chosen.value = hexOf(color);
            }}
          />
        ))}
      </div>
      <div class="row">
        <span class="nowrap">{words.recolorFrom(hexOf(from))}</span>
        <HexField name={words.recolorTo} value={from} marked grow onChange={change} />
      </div>
    </Section>
  );
}

function Shared({ curves }: { readonly curves: readonly CurveItem[] }) {
  const { editor } = useShell();
  const each = (make: (curve: CurveItem) => Outcome | null) => together(curves.map(make));
  const diffusion = curves.filter(({ kind }) => kind === "curve");
  return (
    <Section title={words.all}>
      <div class="two">
        <NumberField
          label={words.blur}
          value={shared(curves, (curve) => [radiiOf(curve.left.blur), radiiOf(curve.right.blur)])}
          digits={2}
          min={0}
          sink={edits(editor, words.setBlur, (value: number, before) =>
            each(({ handle }) => setBoth(before, handle, "blur", constant(value))),
          )}
        />
        {diffusion.length === curves.length && (
          <NumberField
            label={words.opacity}
            value={((value) => (value === null ? null : value * 100))(shared(curves, opacities))}
            digits={1}
            unit="%"
            min={0}
            max={100}
            sink={edits(editor, words.setOpacity, (percent: number, before) =>
              each(({ handle }) => setBoth(before, handle, "opacity", constant(percent / 100))),
            )}
          />
        )}
        {diffusion.length === curves.length && (
          <NumberField
            label={words.weight}
            tip={words.weightTip}
            value={alike(curves.map((curve) => numberOf(curve, "weight")))}
            digits={2}
            min={0.01}
            max={1000}
            step={0.1}
            sink={edits(editor, words.setWeight, (value: number, before) =>
              setNumber(
                before,
                curves.map(({ handle }) => handle),
                "weight",
                value,
              ),
            )}
          />
        )}
      </div>
    </Section>
  );
}

export function SeveralSections({ items }: { readonly items: readonly Item[] }) {
  const { editor } = useShell();
  const { drawing } = editor;
  const curves = curvesOf(drawing, editor.selection.value).flatMap((handle) => {
    const item = drawing.item(handle);
    return item?.kind === "curve" || item?.kind === "stroke" ? [item] : [];
  });
  const isAllCurves = items.every(({ kind }) => kind === "curve" || kind === "stroke");
  return (
    <>
      <Section
        title={isAllCurves ? words.curvesTitle(items.length) : words.thingsTitle(items.length)}
      >
        <BoxFields items={items} />
      </Section>
      {curves.length > 0 && <Shared curves={curves} />}
      {curves.length > 0 && <Recolor curves={curves} />}
    </>
  );
}
