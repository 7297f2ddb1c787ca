// The palette of the document.
import { currentColor, remember } from "../../app/colors.js";
import { hexOf } from "../../geometry/colortext.js";
import { addSwatches, removeSwatch } from "../../model/commands/index.js";
import { swatchesOf, type Swatch } from "../../model/swatches.js";
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { openMenu } from "../controls/menu.js";
import { useShell } from "../services.js";
import { Section } from "./sections.js";

const words = en.panels;

function SwatchButton({ swatch }: { readonly swatch: Swatch }) {
  const { editor } = useShell();
  const hex = hexOf(swatch.color);
  const remove = () => {
    editor.run(words.removeFromPalette, removeSwatch(editor.drawing, swatch));
  };
  return (
    <button
      type="button"
      class="swatch"
      style={{ "--c": hex }}
      aria-label={words.useColor(hex)}
      data-tip={swatch.name || hex}
      aria-pressed={hexOf(currentColor(editor.settings)) === hex}
      onClick={() => remember(editor.settings, swatch.color)}
      onContextMenu={(event) => {
        event.preventDefault();
        event.stopPropagation();
        openMenu(hex, [{ label: words.removeFromPalette, run: remove }], event.currentTarget);
      }}
      onKeyDown={(event) => {
        if (event.key !== "Delete" && event.key !== "Backspace") return;
        event.preventDefault();
        event.stopPropagation();
        remove();
      }}
    />
  );
}

export function PaletteSection() {
  const { editor } = useShell();
  const swatches = swatchesOf(editor.drawing);
  const add = () =>
    editor.run(words.addToPalette, addSwatches(editor.drawing, [currentColor(editor.settings)]));
  return (
    <Section
      title={words.palette}
      actions={<IconButton small icon="plus" label={words.addToPalette} onClick={add} />}
    >
      {swatches.length === 0 ? (
        <p class="muted">{words.emptyPalette}</p>
      ) : (
        <div class="swatches">
          {swatches.map((swatch) => (
            <SwatchButton key={`${swatch.element.range.start}`} swatch={swatch} />
          ))}
        </div>
      )}
    </Section>
  );
}
