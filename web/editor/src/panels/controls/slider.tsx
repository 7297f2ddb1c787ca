// A native range, filled; double click resets it.
import { useRef } from "preact/hooks";
import type { Movement, Sink } from "./sink.js";

interface SliderProps {
  readonly label: string;
  readonly value: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  /** The text that a screen reader says for the value. */
  readonly text?: string;
  readonly class?: string;
  /** CSS for a track of its own. */
  readonly track?: string;
  readonly reset?: number;
  readonly sink: Sink<number>;
}

export function Slider(props: SliderProps) {
  const { value, min, max, sink } = props;
  const movement = useRef<Movement<number> | null>(null);
  const isHeld = useRef(false);
  const end = () => {
    isHeld.current = false;
    movement.current?.keep();
    movement.current = null;
  };
  const style = {
    "--value": (value - min) / (max - min),
    ...(props.track ? { "--track": props.track } : {}),
  };
  return (
    <input
      type="range"
      class={["slider", props.track ? "track" : "", props.class ?? ""].filter(Boolean).join(" ")}
      aria-label={props.label}
      aria-valuetext={props.text}
      min={min}
      max={max}
      step={props.step}
      value={value}
      style={style}
      onPointerDown={() => {
        isHeld.current = true;
      }}
      onInput={(event) => {
        const next = Number(event.currentTarget.value);
        if (!isHeld.current) return sink.set(next, true);
        movement.current ??= sink.begin();
        movement.current.show(next);
      }}
      onKeyDown={(event) => /^(Arrow|Home|End|Page)/.test(event.key) && event.stopPropagation()}
      onChange={end}
      onPointerUp={end}
      onPointerCancel={end}
      onDblClick={() => props.reset !== undefined && sink.set(props.reset)}
    />
  );
}
