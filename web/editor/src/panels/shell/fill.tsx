// Options of the tools that draw: the current colour, and the sides of a polygon.
import { currentColor, remember } from "../../app/colors.js";
import { FEWEST_SIDES, MOST_SIDES } from "../../app/settings.js";
import { hexOf } from "../../geometry/colortext.js";
import { parseTyped } from "../../source/colors.js";
import * as en from "../../strings/en.js";
import { NumberField } from "../controls/field.js";
import { HexField } from "../controls/hex.js";
import { mapped, setting } from "../controls/sink.js";
import { useShell } from "../services.js";

const words = en.panels;

/** The current colour: the browser's own picker, and a field. */
function ColorOption({ label, name }: { readonly label?: string; readonly name: string }) {
  const { settings } = useShell().editor;
  const color = currentColor(settings);
  return (
    <div class="row fill-option">
      {label && <span class="label">{label}</span>}
      <input
        type="color"
        class="swatch"
        aria-label={name}
        data-tip={name}
        style={{ "--c": hexOf(color) }}
        value={hexOf(color)}
        onChange={(event) => {
          const chosen = parseTyped(event.currentTarget.value);
          if (chosen) remember(settings, chosen);
        }}
      />
      <HexField marked name={words.hexOf(name)} value={color} onChange={(value) => remember(settings, value)} />
    </div>
  );
}

export const Fill = () => <ColorOption label={words.fill} name={words.fillOfShapes} />;

export const StrokeColor = () => <ColorOption label={words.color} name={words.colorOfStrokes} />;

/** Whether new curves have the current colour on both sides, and that colour. */
export function CurveColor() {
  const { ownColor } = useShell().editor.settings;
  return (
    <>
      <label class="check option" data-tip={words.ownColorTip}>
        <input
          type="checkbox"
          checked={ownColor.value}
          onChange={() => {
            ownColor.value = !ownColor.value;
          }}
        />
        <span>{words.ownColor}</span>
      </label>
      {ownColor.value && <ColorOption name={words.colorOfCurves} />}
    </>
  );
}

export function PolygonOptions() {
  const { polygonSides } = useShell().editor.settings;
  return (
    <>
      <NumberField
        class="option"
        label={words.polygonSides}
        value={polygonSides.value}
        min={FEWEST_SIDES}
        max={MOST_SIDES}
        step={1}
        digits={0}
        sink={mapped(setting(polygonSides), Math.round)}
      />
      <Fill />
    </>
  );
}
