// Radii along the curve, drawn: the left side's above the axis, the right side's below.
import { useRef } from "preact/hooks";
import type { TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import { nameOfSide } from "../../app/side-names.js";
import type { Gesture } from "../../app/types.js";
import { shownStops } from "../../model/seams.js";
import type { CurveItem, Drawing, Outcome, Side, SideValue } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { follow } from "../controls/follow.js";
import { decimal } from "../format.js";
import { useShell } from "../services.js";
import {
  constant,
  fractionOf,
  mixNumbers,
  movedStop,
  offsetAt,
  rounded,
  settled,
  valueAt,
  withoutStop,
  withStop,
  withValue,
  type Placed,
  type Stops,
} from "../stops.js";

const words = en.panels;
/** The profile's own units. */
const WIDTH = 256;
const HEIGHT = 64;
/** The share of its height that the largest radius takes on one side of the axis. */
const FULL = 0.42;
const SLOP = 3;

export interface ProfileProps {
  readonly item: CurveItem;
  readonly attribute: "blur" | "radius";
  readonly left: SideValue<number>;
  readonly right: SideValue<number>;
  readonly linked: boolean;
  readonly label: string;
  readonly chosen: { readonly side: Side; readonly index: number } | null;
  readonly put: (before: Drawing, side: Side, value: SideValue<number>) => Outcome | null;
}

/** Returns the radii; without a value, a radius of 0 all along. */
export const radiiOf = (value: SideValue<number>): Stops<number> =>
  value.kind === "stops" && value.stops.length > 0 ? value : constant(0);

export const largestOf = (list: Stops<number>) => Math.max(...list.stops.map(({ value }) => value));

/** Points of the edge, ends included, as (share of length, radius). */
function edge(item: CurveItem, list: Stops<number>): readonly (readonly [number, number])[] {
  const points = list.stops.map(
    ({ offset, value }) => [fractionOf(item, list.space, offset), value] as const,
  );
  return [[0, points[0][1]], ...points, [1, points[points.length - 1][1]]];
}

const drawn = (points: readonly (readonly [number, number])[], scale: number, sign: number) =>
  points.map(
    ([at, radius]) =>
      `${decimal(at * WIDTH, 2)} ${decimal(HEIGHT / 2 - sign * radius * scale * HEIGHT, 2)}`,
  );

function useProfileDrag(
  props: ProfileProps,
  box: { current: HTMLDivElement | null },
  scale: number,
  freeze: (on: boolean) => void,
) {
  const { editor } = useShell();
  const { item, attribute, put } = props;
  const lists = { left: radiiOf(props.left), right: radiiOf(props.right) };
  const choose = (side: Side, index: number) => {
    editor.selection.value = [
      { handle: item.handle, part: { kind: "stop", side, attribute, index } },
    ];
  };
  /** Share of the length, and radius, of a place of the window. */
  const placeAt = (holder: HTMLElement, side: Side, { clientX, clientY }: PointerEvent) => {
    const rect = holder.getBoundingClientRect();
    const up = 0.5 - (clientY - rect.top) / rect.height;
    return {
      at: Math.min(Math.max((clientX - rect.left) / rect.width, 0), 1),
      radius: Math.max((side === "left" ? up : -up) / scale, 0),
    };
  };
  /**
   * @param start the point that is moved; null: one is added where the pointer is, at the radius
   * there
   */
  const drag = (event: TargetedPointerEvent<HTMLElement>, side: Side, start: number | null) => {
    const holder = box.current;
    if (event.button !== 0 || !holder) return;
    event.stopPropagation();
    const list = lists[side];
    const grip = placeAt(holder, side, event);
    const place = (fraction: number) => offsetAt(item, list.space, rounded(fraction));
    const index = start ?? withStop(list, { offset: place(grip.at), value: 0 }).index;
    const base =
      start === null
        ? withStop(list, {
            offset: place(grip.at),
            value: valueAt(list.stops, place(grip.at), mixNumbers),
          }).value
        : list;
    const first = base.stops[index];
    let gesture: Gesture | null = null;
    const show = (placed: Placed<number>) => {
      const { value, index: chosen } = settled(item, list, placed);
      gesture ??= editor.gesture(start === null ? words.addRadius : words.moveRadius);
      gesture.show((before) => put(before, side, value));
      choose(side, chosen);
    };
    const move = (to: PointerEvent) => {
      const now = placeAt(holder, side, to);
      const radius = Number(Math.max(first.value + now.radius - grip.radius, 0).toPrecision(3));
      const offset = place(fractionOf(item, list.space, first.offset) + now.at - grip.at);
      show(movedStop(withValue(base, index, radius), index, offset));
    };
    const end = (isKept: boolean) => {
      freeze(false);
      if (isKept) gesture?.keep();
      else gesture?.drop();
    };
    freeze(true);
    if (start === null) show({ value: base, index });
    else choose(side, index);
    follow(holder, event, { slop: SLOP, onMove: move, onEnd: end });
  };
  return { drag, choose, lists };
}

/** Arrows: up and down the radius, to the sides the place; Delete takes the point away. */
function useProfileKeys(props: ProfileProps, choose: (side: Side, index: number) => void) {
  const { editor } = useShell();
  const { item, put } = props;
  return (side: Side, list: Stops<number>, index: number) =>
    (event: TargetedKeyboardEvent<HTMLElement>) => {
      const by = event.shiftKey ? 10 : 1;
      const radius = by * (event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0);
      const along =
        (by / 100) * (event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0);
      if (radius !== 0) {
        const value = Math.max(list.stops[index].value + radius, 0);
        editor.run(
          words.moveRadius,
          put(editor.drawing, side, withValue(list, index, value)),
          words.moveRadius,
        );
      } else if (along !== 0) {
        const fraction = fractionOf(item, list.space, list.stops[index].offset) + along;
        const moved = movedStop(list, index, offsetAt(item, list.space, rounded(fraction)));
        const placed = settled(item, list, moved);
        editor.run(words.moveRadius, put(editor.drawing, side, placed.value), words.moveRadius);
        choose(side, placed.index);
      } else if ((event.key === "Delete" || event.key === "Backspace") && shownStops(item, list) > 1) {
        editor.run(words.removeRadius, put(editor.drawing, side, withoutStop(list, index)));
        choose(side, Math.min(index, shownStops(item, list) - 2));
      } else return;
      event.preventDefault();
      event.stopPropagation();
    };
}

export function Profile(props: ProfileProps) {
  const { item, linked, chosen } = props;
  const box = useRef<HTMLDivElement>(null);
  const frozen = useRef<number | null>(null);
  const most = Math.max(largestOf(radiiOf(props.left)), largestOf(radiiOf(props.right)), 1e-9);
  const scale = frozen.current ?? FULL / (most < 1e-6 ? 10 : most);
  const freeze = (on: boolean) => {
    frozen.current = on ? scale : null;
  };
  const { drag, choose, lists } = useProfileDrag(props, box, scale, freeze);
  const keys = useProfileKeys(props, choose);
  const above = edge(item, lists.left);
  const below = edge(item, lists.right);
  const upper = drawn(above, scale, 1);
  const lower = drawn(below, scale, -1);
  const sides: readonly Side[] = linked ? ["left"] : ["left", "right"];
  const press = (event: TargetedPointerEvent<HTMLDivElement>) => {
    const rect = event.currentTarget.getBoundingClientRect();
    drag(event, linked || event.clientY - rect.top < rect.height / 2 ? "left" : "right", null);
  };
  return (
    <div class="profile-box" ref={box} onPointerDown={press}>
      <svg
        class="profile"
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        preserveAspectRatio="none"
        role="img"
        aria-label={props.label}
      >
        <path class="area" d={`M${upper.join("L")}L${[...lower].reverse().join("L")}Z`} />
        <path class="edge" d={`M${upper.join("L")}M${lower.join("L")}`} />
        <path class="axis" d={`M0 ${HEIGHT / 2}H${WIDTH}`} />
      </svg>
      {sides.map((side) =>
        lists[side].stops.slice(0, shownStops(item, lists[side])).map((stop, index) => {
          const at = fractionOf(item, lists[side].space, stop.offset);
          const height = Math.min(stop.value * scale, 0.5) * (side === "left" ? 1 : -1);
          const isOn = chosen?.index === index && (linked || chosen.side === side);
          return (
            <button
              key={`${side}${index}`}
              type="button"
              class={isOn ? "profile-point on" : "profile-point"}
              style={{ "--at": at, "--r": height }}
              aria-pressed={isOn}
              aria-label={words.radiusName(
                linked ? words.bothSides : nameOfSide(item, side),
                decimal(stop.value, 2),
                decimal(at * 100, 1),
              )}
              onPointerDown={(event) => drag(event, side, index)}
              onFocus={(event) =>
                event.currentTarget.matches(":focus-visible") && choose(side, index)
              }
              onKeyDown={keys(side, lists[side], index)}
            />
          );
        }),
      )}
    </div>
  );
}
