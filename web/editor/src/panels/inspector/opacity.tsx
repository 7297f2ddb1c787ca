// Opacity of both sides: a number each, stops on a ribbon where it varies, or a gradient.
import { nameOfSide } from "../../app/side-names.js";
import type { Rgb } from "../../geometry/color.js";
import { setBoth } from "../../model/commands/index.js";
import { sidesInOrder } from "../../model/sides.js";
import type { CurveItem, Drawing, Side } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { NumberField } from "../controls/field.js";
import { openMenu, type MenuItem } from "../controls/menu.js";
import { edits } from "../controls/sink.js";
import { decimal } from "../format.js";
import { useShell, type Shell } from "../services.js";
import {
  constant,
  fractionOf,
  mixNumbers,
  putOpacity,
  withValue,
  type Mix,
  type Put,
  type Stops,
} from "../stops.js";
import { gradientTints, type GradientTints } from "../tints.js";
import { chosenStop } from "./chosen.js";
import { GradientFields, opacityOf } from "./gradient.js";
import { documentPaints, gradientItems, textureItem, type NewStop } from "./paints.js";
import { bandOf, Ribbon } from "./ribbon.js";
import { sideRow } from "./rows.js";
import { Section } from "./sections.js";

const words = en.panels;
const WHITE = { r: 1, g: 1, b: 1 };

const css = (value: number) => `rgb(128 128 128 / ${decimal(value, 3)})`;
const describe = (value: number) => words.percent(decimal(value * 100, 1));

interface SideProps {
  readonly item: CurveItem;
  readonly side: Side;
}

const stopsOf = (item: CurveItem, side: Side): Stops<number> | null => {
  const { opacity } = item[side];
  return opacity.kind === "stops" && opacity.stops.length > 0 ? opacity : null;
};

/** Returns the side's opacities as a gradient's stops; a single opacity becomes a fade from it to nothing. */
function gradientStops(_: Drawing, item: CurveItem, side: Side): readonly NewStop[] {
  const list = stopsOf(item, side);
  const stops = (list?.stops ?? []).map(({ offset, value }) => ({
    offset: fractionOf(item, list!.space, offset),
    color: WHITE,
    opacity: value,
  }));
  if (stops.length > 1) return stops;
  return [
    { offset: 0, color: WHITE, opacity: stops[0]?.opacity || 1 },
    { offset: 1, color: WHITE, opacity: 0 },
  ];
}

function sideMenu(shell: Shell, item: CurveItem, side: Side): readonly MenuItem[] {
  const { editor } = shell;
  const { opacity } = item[side];
  const put = putOpacity(item.handle);
  return [
    {
      label: words.opacityStops,
      checked: opacity.kind === "stops",
      run: () => {
        if (opacity.kind !== "stops")
          editor.run(words.setOpacity, put(editor.drawing, side, constant(1)));
      },
    },
    {
      label: words.opacityOpen,
      checked: opacity.kind === "open",
      run: () => void editor.run(words.setOpacity, put(editor.drawing, side, { kind: "open" })),
    },
    {
      label: words.opacityBarrier,
      checked: opacity.kind === "barrier",
      run: () => void editor.run(words.setOpacity, put(editor.drawing, side, { kind: "barrier" })),
    },
    "line",
    ...gradientItems(shell, item, side, "opacity", gradientStops),
    textureItem(shell, item, side, "opacity"),
    ...documentPaints(shell, item, side, "opacity"),
  ];
}

function openKinds(shell: Shell, item: CurveItem, anchor: HTMLElement) {
  const items = sidesInOrder(item).map((side) => ({
    label: words.ribbonOf(nameOfSide(item, side)),
    items: sideMenu(shell, item, side),
  }));
  openMenu(words.kindsOfOpacity, items, anchor);
}

interface RibbonProps<Value extends Rgb | number> extends SideProps {
  readonly list: Stops<Value>;
  readonly mix: Mix<Value>;
  readonly put: Put<Value>;
  readonly opacityOf: (value: Value) => number;
  /** The ribbon's name; absent: the side's. */
  readonly label?: string;
}

/** Stops of a side, or of the gradient that it shows, by what they are as opacity. */
function OpacityRibbon<Value extends Rgb | number>({ opacityOf, ...props }: RibbonProps<Value>) {
  const { item, side, list } = props;
  const stops = list.stops.map(({ offset, value }) => ({
    at: fractionOf(item, list.space, offset),
    css: css(opacityOf(value)),
  }));
  return (
    <div class={sideRow(item)}>
      <span class="side-name">{nameOfSide(item, side)}</span>
      <Ribbon
        {...props}
        attribute="opacity"
        band={bandOf(stops, "srgb")}
        css={(value) => css(opacityOf(value))}
        describe={(value) => describe(opacityOf(value))}
      />
    </div>
  );
}

function GradientOpacity({ item, side, tints }: SideProps & { readonly tints: GradientTints }) {
  const { editor } = useShell();
  const { list, gradient, mix, put } = tints;
  const chosen = chosenStop(editor, item, "opacity");
  const at = chosen?.side === side && chosen.index < list.stops.length ? chosen.index : 0;
  const { value } = list.stops[at];
  const name = words.gradientNow[gradient.kind](gradient.id);
  return (
    <>
      <OpacityRibbon
        item={item}
        side={side}
        label={words.gradientOf(nameOfSide(item, side), name)}
        list={list}
        mix={mix}
        put={put}
        opacityOf={opacityOf}
      />
      <GradientFields
        gradient={gradient}
        alpha={value.alpha}
        alphaName={words.alphaOfOpacity(nameOfSide(item, side), at + 1)}
        sink={edits(editor, words.setAlpha, (percent: number, before) =>
          put(before, side, withValue(list, at, { ...value, alpha: percent / 100 })),
        )}
      />
    </>
  );
}

/** The state of a side without numbers. */
function OtherThanStops({ item, side }: SideProps) {
  const { editor } = useShell();
  const { opacity } = item[side];
  if (opacity.kind !== "paint" && opacity.kind !== "barrier") return null;
  const text = opacity.kind === "paint" ? words.paintNow(opacity.href.replace(/^#/, "")) : words.barrierNow;
  const give = () =>
    void editor.run(
      words.setOpacity,
      putOpacity(item.handle)(editor.drawing, side, constant(1)),
    );
  return (
    <div class={sideRow(item)}>
      <span class="side-name">{nameOfSide(item, side)}</span>
      <div class="side-state">
        <span class={opacity.kind === "paint" ? "swatch paint" : "swatch none"} aria-hidden="true" />
        <span class="grow">{text}</span>
        <button type="button" class="button quiet" aria-label={words.giveOpacityName} onClick={give}>
          {words.giveOpacity}
        </button>
      </div>
    </div>
  );
}

function SideOpacity({ item, side, varies }: SideProps & { readonly varies: boolean }) {
  const { editor } = useShell();
  const list = stopsOf(item, side);
  if (list && !varies) return null;
  if (list) {
    const put = putOpacity(item.handle);
    return <OpacityRibbon item={item} side={side} list={list} mix={mixNumbers} put={put} opacityOf={Number} />;
  }
  const tints = gradientTints(editor.drawing, item, side, "opacity");
  return tints ? (
    <GradientOpacity item={item} side={side} tints={tints} />
  ) : (
    <OtherThanStops item={item} side={side} />
  );
}

function OpacityField({ item, side }: SideProps) {
  const { editor } = useShell();
  const { opacity } = item[side];
  const list = stopsOf(item, side);
  const chosen = chosenStop(editor, item, "opacity");
  const index =
    chosen?.side === side && list && chosen.index < list.stops.length ? chosen.index : 0;
  const put = putOpacity(item.handle);
  return (
    <NumberField
      label={nameOfSide(item, side)}
      name={words.opacityOf(nameOfSide(item, side))}
      value={list ? list.stops[index].value * 100 : opacity.kind === "open" ? 100 : null}
      digits={1}
      unit="%"
      min={0}
      max={100}
      sink={edits(editor, words.setOpacity, (percent: number, before) =>
        put(before, side, list ? withValue(list, index, percent / 100) : constant(percent / 100)),
      )}
    />
  );
}

const hasNumber = (item: CurveItem, side: Side) =>
  item[side].opacity.kind === "stops" || item[side].opacity.kind === "open";

export function OpacitySection({ item }: { readonly item: CurveItem }) {
  const shell = useShell();
  const { editor } = shell;
  const sides = sidesInOrder(item);
  const varies =
    editor.attribute.value === "opacity" ||
    sides.some((side) => (stopsOf(item, side)?.stops.length ?? 0) > 1);
  const hasAny = sides.some((side) => item[side].opacity.kind !== "open");
  const numbers = sides.filter((side) => hasNumber(item, side));
  const forget = () =>
    editor.run(
      words.opaqueAgain,
      setBoth(editor.drawing, item.handle, "opacity", { kind: "open" }),
    );
  return (
    <Section
      title={words.opacity}
      actions={
        <>
          <IconButton
            small
            icon="ellipsis"
            label={words.kindsOfOpacity}
            popup="menu"
            onClick={(event) => openKinds(shell, item, event.currentTarget)}
          />
          {hasAny && <IconButton small icon="x" label={words.opaqueAgain} onClick={forget} />}
        </>
      }
    >
      {sides.map((side) => (
        <SideOpacity key={side} item={item} side={side} varies={varies} />
      ))}
      {numbers.length > 0 && (
        <div class="two">
          {numbers.map((side) => (
            <OpacityField key={side} item={item} side={side} />
          ))}
        </div>
      )}
    </Section>
  );
}
