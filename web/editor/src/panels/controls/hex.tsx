// A field for a colour: shows its six figures, and takes all notations of CSS.
import { useState } from "preact/hooks";
import type { TargetedKeyboardEvent } from "preact";
import type { Rgb } from "../../geometry/color.js";
import * as en from "../../strings/en.js";
import { hexOf } from "../../geometry/colortext.js";
import { parseTyped } from "../../source/colors.js";

const words = en.panels;

interface HexFieldProps {
  readonly name: string;
  readonly value: Rgb | null;
  /** "#" inside, at the left. */
  readonly marked?: boolean;
  readonly grow?: boolean;
  readonly onChange: (value: Rgb) => void;
}

export function HexField({ name, value, marked, grow, onChange }: HexFieldProps) {
  const [draft, setDraft] = useState<string | null>(null);
  const [isWrong, setWrong] = useState(false);
  const shown = value ? hexOf(value).slice(1) : "";
  const take = (text: string): boolean => {
    const color = parseTyped(text);
    if (text !== shown && color) onChange(color);
    return text === shown || color !== null;
  };
  const restore = () => {
    setDraft(null);
    setWrong(false);
  };
  const key = (event: TargetedKeyboardEvent<HTMLInputElement>) => {
    if (event.key === "Enter") {
      if (take(event.currentTarget.value)) {
        restore();
        event.currentTarget.select();
      } else setWrong(true);
    } else if (event.key === "Escape" && draft !== null) restore();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const names = ["field", "mono", grow ? "grow" : "", isWrong ? "invalid" : ""]
    .filter(Boolean)
    .join(" ");
  return (
    <div class={names}>
      {marked && (
        <span class="label" aria-hidden="true">
          #
        </span>
      )}
      <input
        aria-label={name}
        aria-invalid={isWrong || undefined}
        spellcheck={false}
        autocomplete="off"
        placeholder={value ? undefined : words.mixed}
        value={draft ?? shown}
        onInput={(event) => {
          setDraft(event.currentTarget.value);
          setWrong(false);
        }}
        onFocus={(event) => event.currentTarget.select()}
        onBlur={(event) => {
          take(event.currentTarget.value);
          restore();
        }}
        onKeyDown={key}
      />
      {isWrong && (
        <span class="field-why" role="alert">
          {words.notAColor}
        </span>
      )}
    </div>
  );
}
