// The colours of one side: stops on a ribbon, or open, a barrier, a paint.
import { nameOfSide } from "../../app/side-names.js";
import { setColor } from "../../model/commands/index.js";
import { partnerOf, type Rgb } from "../../geometry/color.js";
import type { Tint } from "../../model/gradients.js";
import type { CurveItem, Drawing, Outcome, Side } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { Icon } from "../../icons.js";
import { hexOf } from "../../geometry/colortext.js";
import { cssSpaces } from "../color.js";
import { openMenu, type MenuItem } from "../controls/menu.js";
import { useShell, type Shell } from "../services.js";
import { backwards, constant, distributed, fractionOf, putColor, rounded, type Stops } from "../stops.js";
import { tinted, tintsOf, type Tints } from "../tints.js";
import { cssOf, describeTint } from "./gradient.js";
import { documentPaints, gradientItems, textureItem, type NewStop } from "./paints.js";
import { bandOf, Ribbon } from "./ribbon.js";
import { sideRow } from "./rows.js";

const words = en.panels;

interface SideProps {
  readonly item: CurveItem;
  readonly side: Side;
}

/** Returns a colour for a side that never had one: the other side's first, else a middle grey. */
function startColor(item: CurveItem, side: Side): Rgb {
  const other = item[side === "left" ? "right" : "left"].color;
  return other.kind === "stops" ? other.stops[0].value : { r: 0.5, g: 0.5, b: 0.5 };
}

/** Returns the side's colours as a gradient's stops; a single colour becomes a fade from it to its partner. */
function gradientStops(before: Drawing, item: CurveItem, side: Side): readonly NewStop[] {
  const tints = tintsOf(before, item, side);
  const stops = (tints?.list.stops ?? []).map(({ offset, value }) => ({
    offset: rounded(fractionOf(item, tints!.list.space, offset)),
    color: value as Rgb,
    opacity: value.alpha,
  }));
  if (stops.length > 1) return stops;
  const from = stops[0]?.color ?? startColor(item, side);
  return [
    { offset: 0, color: from, opacity: 1 },
    { offset: 1, color: partnerOf(from), opacity: 1 },
  ];
}

function sideMenu(shell: Shell, item: CurveItem, side: Side): readonly MenuItem[] {
  const { editor } = shell;
  const { color } = item[side];
  const run = (label: string, make: (before: Drawing) => Outcome | null) => () =>
    void editor.run(label, make(editor.drawing));
  const put = putColor(item.handle);
  const local = item.kind === "stroke";
  const tints = tintsOf(editor.drawing, item, side);
  const change = (label: string, make: (tints: Tints) => Stops<Tint>): MenuItem => ({
    label,
    disabled: !tints || tints.list.stops.length < 2,
    run: run(label, (before) => tints && tints.put(before, side, make(tints))),
  });
  return [
    change(words.oneColor, (now) => tinted(now, null, now.list.stops[0].value)),
    change(words.distributeStops, ({ list }) => distributed(item, list)),
    change(words.reverseColors, ({ list }) => backwards(item, list)),
    "line",
    {
      label: words.sideStops,
      checked: color.kind === "stops",
      run: () => {
        if (color.kind !== "stops")
          editor.run(words.giveColor, put(editor.drawing, side, constant(startColor(item, side))));
      },
    },
    {
      label: words.sideOpen,
      checked: color.kind === "open",
      run: run(words.openSide, (before) => put(before, side, { kind: "open" })),
    },
    ...(local
      ? []
      : [
          {
            label: words.sideBarrier,
            checked: color.kind === "barrier",
            run: run(words.makeBarrier, (before) =>
              setColor(before, item.handle, side, { kind: "barrier" }),
            ),
          },
          "line" as const,
          ...gradientItems(shell, item, side, "color", gradientStops),
          textureItem(shell, item, side, "color"),
          ...documentPaints(shell, item, side, "color"),
        ]),
  ];
}

function OtherThanStops({ item, side }: SideProps) {
  const { editor } = useShell();
  const { color } = item[side];
  const text =
    color.kind === "barrier"
      ? words.barrierNow
      : color.kind === "paint"
        ? words.paintNow(color.href.replace(/^#/, ""))
        : item.kind === "stroke"
          ? words.asOther
          : words.openNow;
  return (
    <div class="side-state">
      <span class={color.kind === "paint" ? "swatch paint" : "swatch none"} aria-hidden="true" />
      <span class="grow">{text}</span>
      <button
        type="button"
        class="button quiet"
        aria-label={words.giveColorName}
        onClick={() =>
          void editor.run(
            words.giveColor,
            setColor(editor.drawing, item.handle, side, constant(startColor(item, side))),
          )
        }
      >
        {words.giveColorShort}
      </button>
    </div>
  );
}

/** Stops of the side, or of its gradient. */
function SideRibbon({ item, side, tints }: SideProps & { readonly tints: Tints }) {
  const { editor } = useShell();
  const { list, gradient } = tints;
  const space = gradient ? "srgb" : cssSpaces[editor.drawing.interpolation];
  const stops = list.stops.map(({ offset, value }) => ({
    at: fractionOf(item, list.space, offset),
    css: cssOf(value),
  }));
  return (
    <Ribbon
      item={item}
      side={side}
      attribute="color"
      label={
        gradient
          ? words.gradientOf(nameOfSide(item, side), words.gradientNow[gradient.kind](gradient.id))
          : undefined
      }
      list={list}
      mix={tints.mix}
      put={tints.put}
      band={bandOf(stops, space)}
      css={hexOf}
      describe={describeTint}
      onOpen={(stop) => {
        editor.picker.value = { handle: item.handle, side, stops: [stop] };
      }}
    />
  );
}

export function ColorSide({ item, side }: SideProps) {
  const shell = useShell();
  const tints = tintsOf(shell.editor.drawing, item, side);
  return (
    <div class={sideRow(item)}>
      <button
        type="button"
        class="side-name"
        aria-haspopup="menu"
        aria-label={words.kindOfSide(nameOfSide(item, side))}
        onClick={(event) =>
          openMenu(
            words.kindOfSide(nameOfSide(item, side)),
            sideMenu(shell, item, side),
            event.currentTarget,
          )
        }
      >
        {nameOfSide(item, side)}
        <Icon name="chevron-down" small />
      </button>
      {tints ? (
        <SideRibbon item={item} side={side} tints={tints} />
      ) : (
        <OtherThanStops item={item} side={side} />
      )}
    </div>
  );
}
