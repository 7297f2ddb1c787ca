// A line between two regions: dragged, or moved by arrows.
import type { TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import { follow } from "./follow.js";

interface ResizerProps {
  readonly label: string;
  /** "column": a line that stands, moved to the sides. */
  readonly kind: "column" | "line";
  readonly value: number;
  readonly min: number;
  readonly max: number;
  /** 1 where dragging right or down makes the value larger, else -1. */
  readonly sign: 1 | -1;
  readonly class?: string;
  readonly onChange: (value: number) => void;
  readonly onReset?: () => void;
}

const STEP = 16;

export function Resizer(props: ResizerProps) {
  const { kind, sign, value } = props;
  const set = (next: number) =>
    props.onChange(Math.round(Math.min(Math.max(next, props.min), props.max)));
  const drag = (event: TargetedPointerEvent<HTMLElement>) => {
    const along = (at: { clientX: number; clientY: number }) =>
      kind === "column" ? at.clientX : at.clientY;
    const from = along(event);
    const move = (to: PointerEvent) => set(value + sign * (along(to) - from));
    follow(event.currentTarget, event, {
      slop: 0,
      onMove: move,
      onEnd: (isKept) => !isKept && set(value),
    });
  };
  const key = (event: TargetedKeyboardEvent<HTMLElement>) => {
    const [less, more] = kind === "column" ? ["ArrowLeft", "ArrowRight"] : ["ArrowUp", "ArrowDown"];
    if (event.key === more) set(value + sign * STEP);
    else if (event.key === less) set(value - sign * STEP);
    else if (event.key === "Home") set(props.min);
    else if (event.key === "End") set(props.max);
    else if (event.key === "Enter" && props.onReset) props.onReset();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div
      class={["resizer", kind, props.class ?? ""].filter(Boolean).join(" ")}
      role="separator"
      aria-orientation={kind === "column" ? "vertical" : "horizontal"}
      aria-label={props.label}
      aria-valuenow={Math.round(value)}
      aria-valuemin={props.min}
      aria-valuemax={Math.round(props.max)}
      tabIndex={0}
      onPointerDown={drag}
      onKeyDown={key}
      onDblClick={props.onReset}
    />
  );
}
