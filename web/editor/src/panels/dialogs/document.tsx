// Settings of the document, whatever is selected.
import * as en from "../../strings/en.js";
import { ArtboardFields, BackgroundField, InterpolationField } from "../inspector/document.js";
import { NumberField } from "../controls/field.js";
import { setting } from "../controls/sink.js";
import { useShell } from "../services.js";
import { Check } from "./check.js";
import { Frame } from "./frame.js";

const words = en.panels;

/** The grid of this browser: whether it shows, and its step. */
function GridField() {
  const { grid, gridUnit } = useShell().editor.settings;
  return (
    <div>
      <div class="form-label">
        <span>{words.grid}</span>
      </div>
      <div class="row">
        <Check label={words.showGrid} checked={grid.value} onChange={(on) => (grid.value = on)} />
        <NumberField
          label={words.gridStep}
          tip={words.gridStepTip}
          value={gridUnit.value}
          digits={3}
          min={0}
          max={1e6}
          sink={setting(gridUnit)}
        />
      </div>
    </div>
  );
}

export function DocumentDialog() {
  return (
    <Frame title={words.document} class="small">
      <div class="dialog-body form">
        <div>
          <div class="form-label">
            <span>{words.artboard}</span>
          </div>
          <ArtboardFields />
        </div>
        <div>
          <div class="form-label">
            <span>{words.backgroundTitle}</span>
          </div>
          <BackgroundField />
        </div>
        <div>
          <div class="form-label">
            <span>{words.interpolation}</span>
          </div>
          <InterpolationField />
        </div>
        <GridField />
      </div>
    </Frame>
  );
}
