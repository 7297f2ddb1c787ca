// Options of the tools that draw filled shapes: the fill, and the sides of a polygon.
import { fillColor, remember } from "../../app/colors.js";
import { FEWEST_SIDES, MOST_SIDES } from "../../app/settings.js";
import { hexOf } from "../../geometry/colortext.js";
import { parseTyped } from "../../source/colors.js";
import * as en from "../../strings/en.js";
import { NumberField } from "../controls/field.js";
import { HexField } from "../controls/hex.js";
import { mapped, setting } from "../controls/sink.js";
import { useShell } from "../services.js";

const words = en.panels;

/** The colour of new shapes: the browser's own picker, and a field. */
export function Fill() {
  const { settings } = useShell().editor;
  const color = fillColor(settings);
  return (
    <div class="row fill-option">
      <span class="label">{words.fill}</span>
      <input
        type="color"
        class="swatch"
        aria-label={words.fillOfShapes}
        data-tip={words.fillOfShapes}
        style={{ "--c": hexOf(color) }}
        value={hexOf(color)}
        onChange={(event) => {
          const chosen = parseTyped(event.currentTarget.value);
          if (chosen) remember(settings, chosen);
        }}
      />
      <HexField marked name={words.fillHex} value={color} onChange={(value) => remember(settings, value)} />
    </div>
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
