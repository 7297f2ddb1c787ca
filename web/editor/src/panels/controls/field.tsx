// A field for a number: scrubbed by its label, stepped by arrows, typed as a sum.
import { useId, useRef, useState } from "preact/hooks";
import type { TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import * as en from "../../strings/en.js";
import { decimal } from "../format.js";
import { follow } from "./follow.js";
import { evaluate } from "./expression.js";
import type { Movement, Sink } from "./sink.js";

const words = en.panels;

interface NumberFieldProps {
  /** Stands in the field, at the left. */
  readonly label?: string;
  /** The name, where the label alone would say too little. */
  readonly name?: string;
  readonly tip?: string;
  /** null: several values, or none. */
  readonly value: number | null;
  readonly digits: number;
  readonly unit?: string;
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
  readonly class?: string;
  readonly disabled?: boolean;
  readonly sink: Sink<number>;
}

const factor = (event: { shiftKey: boolean; altKey: boolean }) =>
  event.shiftKey ? 10 : event.altKey ? 0.1 : 1;

/** Why a text is no value for the field, or the value. */
function read(
  text: string,
  { min = -Infinity, max = Infinity }: NumberFieldProps,
): number | string {
  const value = evaluate(text);
  if (value === null) return words.notANumber;
  if (value < min) return words.atLeast(decimal(min, 3));
  if (value > max) return words.atMost(decimal(max, 3));
  return value;
}

/** Dragging a label to the sides: pixels times the step; Shift ×10, Alt ÷10. */
function scrub(event: TargetedPointerEvent<HTMLElement>, props: NumberFieldProps) {
  const { value, step = 1, min = -Infinity, max = Infinity } = props;
  if (event.button !== 0 || value === null || props.disabled) return;
  const label = event.currentTarget;
  let now = value;
  let movement: Movement<number> | null = null;
  let last = event.clientX;
  const move = (to: PointerEvent) => {
    movement ??= props.sink.begin();
    now = Math.min(Math.max(now + (to.clientX - last) * step * factor(to), min), max);
    last = to.clientX;
    movement.show(Number(now.toFixed(props.digits)));
  };
  const end = (isKept: boolean) => (isKept ? movement?.keep() : movement?.drop());
  follow(label, event, { slop: 2, onMove: move, onEnd: end });
}

export function NumberField(props: NumberFieldProps) {
  const { label, value, digits, unit, step = 1, min = -Infinity, max = Infinity } = props;
  const id = useId();
  const input = useRef<HTMLInputElement>(null);
  const [draft, setDraft] = useState<string | null>(null);
  const [reason, setReason] = useState<string | null>(null);
  const shown = value === null ? "" : decimal(value, digits);
  const restore = () => {
    setDraft(null);
    setReason(null);
  };
  const take = (): boolean => {
    const text = input.current?.value ?? "";
    if (text === shown) {
      restore();
      return true;
    }
    const found = read(text, props);
    if (typeof found === "string") {
      setReason(found);
      return false;
    }
    restore();
    props.sink.set(found);
    return true;
  };
  const nudge = (by: number) => {
    const found = read(input.current?.value ?? "", props);
    const from = typeof found === "number" ? found : value;
    if (from === null) return;
    restore();
    props.sink.set(Math.round(Math.min(Math.max(from + by, min), max) * 1e6) / 1e6, true);
  };
  const key = (event: TargetedKeyboardEvent<HTMLInputElement>) => {
    if (event.key === "ArrowUp") nudge(step * factor(event));
    else if (event.key === "ArrowDown") nudge(-step * factor(event));
    else if (event.key === "Enter") take() && input.current?.select();
    else if (event.key === "Escape" && draft !== null) restore();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const blur = () => {
    if (!take()) restore();
  };
  const names = ["field", props.class ?? "", reason ? "invalid" : ""].filter(Boolean).join(" ");
  return (
    <div class={names} data-tip={props.tip}>
      {label && (
        <label for={id} onPointerDown={(event) => scrub(event, props)}>
          {label}
        </label>
      )}
      <input
        id={id}
        ref={input}
        inputMode="decimal"
        autocomplete="off"
        spellcheck={false}
        aria-label={props.name ?? (label ? undefined : words.value)}
        aria-invalid={reason !== null || undefined}
        aria-describedby={reason ? `${id}-why` : undefined}
        placeholder={value === null ? words.mixed : undefined}
        disabled={props.disabled}
        value={draft ?? shown}
        onInput={(event) => {
          setDraft(event.currentTarget.value);
          setReason(null);
        }}
        onFocus={(event) => event.currentTarget.select()}
        onBlur={blur}
        onKeyDown={key}
      />
      {unit && value !== null && <span class="unit">{unit}</span>}
      {reason && (
        <span class="field-why" id={`${id}-why`} role="alert">
          {reason}
        </span>
      )}
    </div>
  );
}
