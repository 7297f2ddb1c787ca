// Settings of the document, whatever is selected.
import * as en from "../../strings/en.js";
import { ArtboardFields, BackgroundField, InterpolationField } from "../inspector/document.js";
import { Frame } from "./frame.js";

const words = en.panels;

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
      </div>
    </Frame>
  );
}
