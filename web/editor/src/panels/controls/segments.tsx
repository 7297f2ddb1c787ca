// One of few, side by side.
import { Icon, type IconName } from "../../icons.js";
import { useTip } from "./button.js";
import { radioKeys } from "./radio.js";

export interface Choice<Value> {
  readonly value: Value;
  readonly label: string;
  readonly icon?: IconName;
  /** The icon alone, always ("icon"), or in narrow windows ("narrow"). */
  readonly shows?: "icon" | "narrow";
  readonly command?: string;
}

interface SegmentsProps<Value> {
  readonly label: string;
  readonly choices: readonly Choice<Value>[];
  /** null: several, or none of them. */
  readonly value: Value | null;
  readonly full?: boolean;
  readonly onChange: (value: Value) => void;
}

function Segment<Value extends string>(props: {
  choice: Choice<Value>;
  on: boolean;
  stops: boolean;
  onChange: (value: Value) => void;
}) {
  const { choice, on } = props;
  const tip = useTip(choice.label, choice.command);
  const needsTip = choice.shows !== undefined || choice.command !== undefined;
  return (
    <button
      type="button"
      role="radio"
      class={choice.shows === "icon" ? "segment icon-only" : "segment"}
      aria-checked={on}
      tabIndex={props.stops ? 0 : -1}
      {...(needsTip ? tip : {})}
      onClick={() => props.onChange(choice.value)}
    >
      {choice.icon && <Icon name={choice.icon} small={choice.shows !== "icon"} />}
      {choice.shows !== "icon" && (
        <span class={choice.shows === "narrow" ? "wide" : undefined}>{choice.label}</span>
      )}
    </button>
  );
}

export function Segments<Value extends string>({
  label,
  choices,
  value,
  full,
  onChange,
}: SegmentsProps<Value>) {
  const chosen = choices.findIndex((choice) => choice.value === value);
  return (
    <div
      class={full ? "segments full" : "segments"}
      role="radiogroup"
      aria-label={label}
      onKeyDown={radioKeys()}
    >
      {choices.map((choice, index) => (
        <Segment
          key={String(choice.value)}
          choice={choice}
          on={index === chosen}
          stops={index === Math.max(chosen, 0)}
          onChange={onChange}
        />
      ))}
    </div>
  );
}
