// Fields of a gradient's stop besides colour and place, and of the gradient besides its stops.
import { setSpread } from "../../model/commands/index.js";
import { sidesWithPaint, SPREADS, type Gradient, type Tint } from "../../model/gradients.js";
import { hexOf } from "../../geometry/colortext.js";
import * as en from "../../strings/en.js";
import { NumberField } from "../controls/field.js";
import { Select } from "../controls/select.js";
import type { Sink } from "../controls/sink.js";
import { decimal } from "../format.js";
import { useShell } from "../services.js";

const words = en.panels;

/** CSS of a colour with its alpha. */
export function cssOf(tint: Tint): string {
  if (tint.alpha === 1) return hexOf(tint);
  const channels = [tint.r, tint.g, tint.b].map((channel) => decimal(255 * channel, 2));
  return `rgb(${channels.join(" ")} / ${decimal(tint.alpha, 4)})`;
}

/** Returns a tint's opacity: its alpha times its luminance, as in SVG masks. */
export const opacityOf = ({ r, g, b, alpha }: Tint) =>
  alpha * (0.2126 * r + 0.7152 * g + 0.0722 * b);

export const describeTint = (tint: Tint) =>
  tint.alpha === 1 ? hexOf(tint) : words.withAlpha(hexOf(tint), decimal(100 * tint.alpha, 0));

interface GradientFieldsProps {
  readonly gradient: Gradient;
  /** Alpha of the chosen stop, 0 to 1. */
  readonly alpha: number;
  readonly alphaName: string;
  readonly sink: Sink<number>;
}

export function GradientFields({ gradient, alpha, alphaName, sink }: GradientFieldsProps) {
  const { editor } = useShell();
  const href = `#${gradient.id}`;
  const sides = sidesWithPaint(editor.drawing, href);
  const name = words.gradientNow[gradient.kind](gradient.id);
  return (
    <>
      <div class="two">
        <NumberField
          label={words.stopAlpha}
          name={alphaName}
          value={100 * alpha}
          digits={1}
          unit="%"
          min={0}
          max={100}
          sink={sink}
        />
        <Select
          label={words.spread}
          value={gradient.spread}
          choices={SPREADS.map((value) => ({ value, label: words.spreads[value] }))}
          onChange={(spread) =>
            void editor.run(words.setSpread, setSpread(editor.drawing, href, spread))
          }
        />
      </div>
      <p class="muted">{sides > 1 ? words.onSides(name, sides) : name}</p>
    </>
  );
}
