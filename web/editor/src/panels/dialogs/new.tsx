// A new drawing: its size and background.
import { useSignal } from "@preact/signals";
import { blankText } from "../../model/drawing.js";
import type { Rgb } from "../../geometry/color.js";
import { hexOf } from "../../geometry/colortext.js";
import * as en from "../../strings/en.js";
import { Background } from "../controls/background.js";
import { NumberField } from "../controls/field.js";
import { Segments } from "../controls/segments.js";
import { setting } from "../controls/sink.js";
import { useShell } from "../services.js";
import { Frame } from "./frame.js";

const words = en.dialogs;
const MOST = 100000;
const WHITE: Rgb = { r: 1, g: 1, b: 1 };
const presets = {
  "640×480": [640, 480],
  "1080×1080": [1080, 1080],
  "1920×1080": [1920, 1080],
  A4: [794, 1123],
} as const;
type Preset = keyof typeof presets;

export function NewDialog() {
  const { editor } = useShell();
  const width = useSignal(640);
  const height = useSignal(480);
  const background = useSignal<Rgb | null>(WHITE);
  const names = Object.keys(presets) as Preset[];
  const preset =
    names.find((name) => presets[name][0] === width.value && presets[name][1] === height.value) ??
    null;
  const create = () => {
    const color = background.value;
    editor.dialog.value = null;
    editor.open(blankText(width.value, height.value, color ? hexOf(color) : null), en.page.untitled);
  };
  const foot = (
    <>
      <span class="spacer" />
      <button type="button" class="button primary large" onClick={create}>
        {words.create}
      </button>
    </>
  );
  return (
    <Frame title={words.new} class="small" foot={foot}>
      <div class="dialog-body form">
        <Segments
          full
          label={words.sizes}
          value={preset}
          choices={names.map((value) => ({ value, label: value }))}
          onChange={(name) => {
            [width.value, height.value] = presets[name];
          }}
        />
        <div class="two">
          <NumberField
            label="W"
            name={en.panels.width}
            value={width.value}
            digits={2}
            min={1}
            max={MOST}
            sink={setting(width)}
          />
          <NumberField
            label="H"
            name={en.panels.height}
            value={height.value}
            digits={2}
            min={1}
            max={MOST}
            sink={setting(height)}
          />
        </div>
        <Background
          value={background.value}
          onChange={(color) => {
            background.value = color;
          }}
        />
      </div>
    </Frame>
  );
}
