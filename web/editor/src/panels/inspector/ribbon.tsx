// The values of one side from the curve's start to its end, with its stops.
import { useLayoutEffect, useRef } from "preact/hooks";
import type { TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import type { Rgb } from "../../geometry/color.js";
import { nameOfSide } from "../../app/side-names.js";
import type { Gesture } from "../../app/types.js";
import { shownStops } from "../../model/seams.js";
import type { CurveItem, Side, Stop } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { follow } from "../controls/follow.js";
import { decimal } from "../format.js";
import { useShell } from "../services.js";
import { chosenStops, chooseStop, toggleStop } from "./chosen.js";
import {
  fractionOf,
  movedStop,
  offsetAt,
  rounded,
  settled,
  valueAt,
  withoutStop,
  withStop,
  type Mix,
  type Placed,
  type Put,
  type Stops,
} from "../stops.js";

const words = en.panels;
/** CSS pixels: pulled further away, a stop is gone; nearer, a press is no drag. */
const PULLED = 24;
const SLOP = 3;
/** The band stands this far within the ribbon. */
const INSET = 7;

export interface RibbonProps<Value extends Rgb | number> {
  readonly item: CurveItem;
  readonly side: Side;
  readonly attribute: "color" | "opacity";
  /** The ribbon's name; absent: the side's. */
  readonly label?: string;
  readonly list: Stops<Value>;
  readonly mix: Mix<Value>;
  readonly put: Put<Value>;
  /** CSS: what the band shows, and a stop's colour. */
  readonly band: string;
  readonly css: (value: Value) => string;
  readonly describe: (value: Value) => string;
  readonly onOpen?: (index: number) => void;
}

/** Where a list's stop is while it is dragged: away from the ribbon it is not in the list. */
type Dragged<Value> = (fraction: number) => Placed<Value>;

/** Neighbours at one place stand side by side, so that both can be taken. */
function sidestep<Value>(stops: readonly Stop<Value>[], index: number): number {
  const { offset } = stops[index];
  const first = stops.findIndex((stop) => stop.offset === offset);
  const count = stops.filter((stop) => stop.offset === offset).length;
  return count < 2 ? 0 : (index - first - (count - 1) / 2) * 6;
}

/** Returns the stops that are shown: all of a gradient, and all of a side but the one that closes a ring. */
function shownOf<Value extends Rgb | number>({ item, side, attribute, list }: RibbonProps<Value>) {
  const isOwn = item[side][attribute].kind === "stops";
  return isOwn ? list.stops.slice(0, shownStops(item, list)) : list.stops;
}

/** Returns a side's list as the drawing takes it; a gradient's list stays. */
function taken<Value extends Rgb | number>({ item, side, attribute, list }: RibbonProps<Value>, placed: Placed<Value>) {
  return item[side][attribute].kind === "stops" ? settled(item, list, placed) : placed;
}

/** Gestures on the stops: add, move, copy, pull away. */
function useStopDrag<Value extends Rgb | number>(props: RibbonProps<Value>, ribbon: { current: HTMLDivElement | null }) {
  const { editor } = useShell();
  const { item, side, attribute, list, put } = props;
  const choose = (index: number) => chooseStop(editor, item, attribute, { side, index });
  const fractionAt = (clientX: number) => {
    const box = ribbon.current?.getBoundingClientRect();
    if (!box) return 0;
    return Math.min(Math.max((clientX - box.left - INSET) / (box.width - 2 * INSET), 0), 1);
  };

  /**
   * @param without the list where the stop is pulled away; null: it cannot be
   * @param begins at once, without a move
   */
  const drag = (
    event: PointerEvent,
    label: string,
    dragged: Dragged<Value>,
    without: Stops<Value> | null,
    begins: boolean,
  ) => {
    const holder = ribbon.current;
    if (!holder) return;
    let gesture: Gesture | null = null;
    let isGone = false;
    const show = ({ clientX, clientY }: PointerEvent) => {
      gesture ??= editor.gesture(label);
      const box = holder.getBoundingClientRect();
      isGone = without !== null && (clientY < box.top - PULLED || clientY > box.bottom + PULLED);
      const placed = taken(props, dragged(fractionAt(clientX)));
      gesture.show((before) => put(before, side, isGone && without ? without : placed.value));
      if (isGone) editor.selection.value = [{ handle: item.handle, part: { kind: "whole" } }];
      else choose(placed.index);
    };
    const end = (isKept: boolean) => {
      if (!isKept) return gesture?.drop();
      gesture?.keep();
      if (isGone)
        editor.say(words.stopRemoved, { label: words.undoShort, run: () => editor.undo() });
    };
    if (begins) show(event);
    follow(holder, event, { slop: SLOP, onMove: show, onEnd: end });
  };

  const offsetHere = (fraction: number) => offsetAt(item, list.space, rounded(fraction));
  const pressBand = (event: TargetedPointerEvent<HTMLElement>) => {
    if (event.button !== 0) return;
    const value = valueAt(list.stops, offsetHere(fractionAt(event.clientX)), props.mix);
    drag(
      event,
      words.addStop,
      (fraction) => withStop(list, { offset: offsetHere(fraction), value }),
      null,
      true,
    );
  };
  const pressStop = (index: number) => (event: TargetedPointerEvent<HTMLElement>) => {
    if (event.button !== 0) return;
    event.stopPropagation();
    if (event.shiftKey || event.ctrlKey || event.metaKey) {
      return toggleStop(editor, item, attribute, { side, index });
    }
    choose(index);
    if (event.altKey) {
      const { value } = list.stops[index];
      return drag(
        event,
        words.copyStop,
        (f) => withStop(list, { offset: offsetHere(f), value }),
        list,
        false,
      );
    }
    const without = shownOf(props).length > 1 ? withoutStop(list, index) : null;
    drag(event, words.moveStop, (f) => movedStop(list, index, offsetHere(f)), without, false);
  };
  return { choose, pressBand, pressStop };
}

/** Where a stop behind another one is added by a key: halfway to the next, or to the end. */
function halfway<Value>({ stops, space }: Stops<Value>, index: number, item: CurveItem): number {
  const [from, to] = [stops[index], stops[index + 1]].map(
    (stop) => stop && fractionOf(item, space, stop.offset),
  );
  return rounded((from + (to ?? 1)) / 2);
}

/**
 * A key on a stop: arrows move it, Insert adds another, Delete removes it, Enter opens it, Shift and Space select it
 * beside others.
 */
function useStopKeys<Value extends Rgb | number>(
  props: RibbonProps<Value>,
  ribbon: { current: HTMLElement | null },
  chooseStop: (index: number) => void,
) {
  const { editor } = useShell();
  const focused = useRef<number | null>(null);
  // Stops change places, and go: the focus goes with the one that is chosen.
  useLayoutEffect(() => {
    if (focused.current === null) return;
    ribbon.current?.querySelectorAll<HTMLElement>(".stop")[focused.current]?.focus();
    focused.current = null;
  });
  const choose = (index: number) => {
    focused.current = index;
    chooseStop(index);
  };
  const { item, side, list, put } = props;
  const count = shownOf(props).length;
  return (index: number) => (event: TargetedKeyboardEvent<HTMLElement>) => {
    const step =
      (event.shiftKey ? 0.1 : 0.01) *
      (event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0);
    if (step !== 0) {
      const fraction = fractionOf(item, list.space, list.stops[index].offset) + step;
      const placed = taken(props, movedStop(list, index, offsetAt(item, list.space, rounded(fraction))));
      editor.run(words.moveStop, put(editor.drawing, side, placed.value), words.moveStop);
      choose(placed.index);
      editor.announcement.value = words.stopAt(
        decimal(Math.min(Math.max(fraction, 0), 1) * 100, 1),
      );
    } else if ((event.key === "Delete" || event.key === "Backspace") && count > 1) {
      editor.run(words.removeStop, put(editor.drawing, side, withoutStop(list, index)));
      choose(Math.min(index, count - 2));
    } else if (event.key === "Insert") {
      const offset = offsetAt(item, list.space, halfway(list, index, item));
      const placed = taken(props, withStop(list, { offset, value: valueAt(list.stops, offset, props.mix) }));
      editor.run(words.addStop, put(editor.drawing, side, placed.value));
      choose(placed.index);
    } else if (event.key === " " && (event.shiftKey || event.ctrlKey)) {
      toggleStop(editor, item, props.attribute, { side, index });
    } else if (event.key === "Enter" && props.onOpen) props.onOpen(index);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
}

/** A gradient of CSS with stops at shares of the length. */
export function bandOf(
  stops: readonly { at: number; css: string }[],
  space: "srgb" | "srgb-linear" | "oklab",
): string {
  const list = stops.length === 1 ? [stops[0], stops[0]] : stops;
  const parts = list.map(({ at, css }) => `${css} ${decimal(at * 100, 2)}%`);
  return `linear-gradient(90deg in ${space}, ${parts.join(", ")})`;
}

export function Ribbon<Value extends Rgb | number>(props: RibbonProps<Value>) {
  const { item, side, list, css } = props;
  const { editor } = useShell();
  const selected = chosenStops(editor, item, props.attribute);
  const chosen = selected?.side === side ? selected.indices : [];
  const stops = shownOf(props);
  const ribbon = useRef<HTMLDivElement>(null);
  const { choose, pressBand, pressStop } = useStopDrag(props, ribbon);
  const keys = useStopKeys(props, ribbon, choose);
  return (
    <div
      class={`ribbon ${props.attribute}`}
      ref={ribbon}
      role="group"
      aria-label={props.label ?? words.ribbonOf(nameOfSide(item, side))}
      aria-description={words.ribbonKeys}
      style={{ "--stops": props.band }}
    >
      <div class="band" onPointerDown={pressBand} />
      <div class="stops">
        {stops.map((stop, index) => {
          const at = fractionOf(item, list.space, stop.offset);
          return (
            <button
              key={index}
              type="button"
              class="stop"
              style={{
                "--at": at,
                "--c": css(stop.value),
                translate: `${sidestep(stops, index)}px 0`,
              }}
              aria-pressed={chosen.includes(index)}
              aria-label={words.stopName(
                nameOfSide(item, side),
                index + 1,
                stops.length,
                props.describe(stop.value),
                decimal(at * 100, 1),
              )}
              onPointerDown={pressStop(index)}
              onFocus={(event) => event.currentTarget.matches(":focus-visible") && choose(index)}
              onDblClick={() => props.onOpen?.(index)}
              onKeyDown={keys(index)}
            />
          );
        })}
      </div>
    </div>
  );
}
