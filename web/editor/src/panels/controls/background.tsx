// The background of a drawing: a colour, or none.
import type { Rgb } from "../../geometry/color.js";
import * as en from "../../strings/en.js";
import { HexField } from "./hex.js";

const words = en.panels;
const WHITE: Rgb = { r: 1, g: 1, b: 1 };

interface BackgroundProps {
  /** null: transparent. */
  readonly value: Rgb | null;
  readonly onChange: (value: Rgb | null) => void;
}

export function Background({ value, onChange }: BackgroundProps) {
  return (
    <div class="background-row">
      <label class="check" data-tip={words.backgroundTip}>
        <input
          type="checkbox"
          checked={value !== null}
          onChange={() => onChange(value ? null : WHITE)}
        />
        <span>{words.background}</span>
      </label>
      {value ? (
        <HexField name={words.backgroundColor} value={value} marked onChange={onChange} />
      ) : (
        <span class="transparent">{words.transparent}</span>
      )}
    </div>
  );
}
