// Opacity of both sides: a number each, or stops on a ribbon where it varies.
import { setBoth } from "../../model/commands/index.js";
import type { CurveItem, Side } from "../../model/types.js";
import { en } from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { NumberField } from "../controls/field.js";
import { edits } from "../controls/sink.js";
import { decimal } from "../format.js";
import { useShell } from "../services.js";
import { constant, fractionOf, mixNumbers, putOpacity, withValue, type Stops } from "../stops.js";
import { chosenStop } from "./chosen.js";
import { bandOf, Ribbon } from "./ribbon.js";
import { Section } from "./sections.js";

const words = en.panels;

const css = (value: number) => `rgb(128 128 128 / ${decimal(value, 3)})`;
const describe = (value: number) => words.percent(decimal(value * 100, 1));

const stopsOf = (item: CurveItem, side: Side): Stops<number> | null => {
  const { opacity } = item[side];
  return opacity.kind === "stops" && opacity.stops.length > 0 ? opacity : null;
};

function OpacityRibbon({
  item,
  side,
  list,
}: {
  readonly item: CurveItem;
  readonly side: Side;
  readonly list: Stops<number>;
}) {
  const { editor } = useShell();
  const chosen = chosenStop(editor, item, "opacity");
  const stops = list.stops.map(({ offset, value }) => ({
    at: fractionOf(item, list.space, offset),
    css: css(value),
  }));
  return (
    <div class="side-row">
      <span class="side-name">{words.sides[side]}</span>
      <Ribbon
        item={item}
        side={side}
        attribute="opacity"
        list={list}
        mix={mixNumbers}
        put={putOpacity(item.handle)}
        band={bandOf(stops, "srgb")}
        css={css}
        describe={describe}
        chosen={chosen?.side === side ? chosen.index : null}
      />
    </div>
  );
}

function OpacityField({ item, side }: { readonly item: CurveItem; readonly side: Side }) {
  const { editor } = useShell();
  const { opacity } = item[side];
  const list = stopsOf(item, side);
  const chosen = chosenStop(editor, item, "opacity");
  const index =
    chosen?.side === side && list && chosen.index < list.stops.length ? chosen.index : 0;
  const put = putOpacity(item.handle);
  return (
    <NumberField
      label={words.sides[side]}
      name={words.opacityOf(words.sides[side])}
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

export function OpacitySection({ item }: { readonly item: CurveItem }) {
  const { editor } = useShell();
  const lists = { left: stopsOf(item, "left"), right: stopsOf(item, "right") };
  const varies =
    editor.attribute.value === "opacity" ||
    [lists.left, lists.right].some((list) => list && list.stops.length > 1);
  const hasAny = item.left.opacity.kind !== "open" || item.right.opacity.kind !== "open";
  const forget = () =>
    editor.run(
      words.opaqueAgain,
      setBoth(editor.drawing, item.handle, "opacity", { kind: "open" }),
    );
  return (
    <Section
      title={words.opacity}
      actions={
        hasAny ? (
          <IconButton small icon="x" label={words.opaqueAgain} onClick={forget} />
        ) : undefined
      }
    >
      {varies && lists.left && <OpacityRibbon item={item} side="left" list={lists.left} />}
      {varies && lists.right && <OpacityRibbon item={item} side="right" list={lists.right} />}
      <div class="two">
        <OpacityField item={item} side="left" />
        <OpacityField item={item} side="right" />
      </div>
    </Section>
  );
}
