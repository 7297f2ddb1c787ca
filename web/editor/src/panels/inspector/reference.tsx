// The photo that is traced over, and how colours are taken from it.
import { restack, setHidden, setLocked, setOpacity } from "../../model/commands/index.js";
import { isLowest } from "../../model/commands/structure/items.js";
import type { ReferenceItem } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { NumberField } from "../controls/field.js";
import { Segments } from "../controls/segments.js";
import { edits, mapped, setting } from "../controls/sink.js";
import { Slider } from "../controls/slider.js";
import { decimal } from "../format.js";
import { useShell } from "../services.js";
import { SampleBlur } from "../shell/options.js";
import { AngleField, BoxFields } from "./box.js";
import { Section } from "./sections.js";

const words = en.panels;

export function ReferenceSections({ item }: { readonly item: ReferenceItem }) {
  const { editor } = useShell();
  const { sampleDistance, sampleTolerance } = editor.settings;
  const percent = item.opacity * 100;
  const sink = mapped(
    edits(editor, words.setOpacity, (value: number, before) =>
      setOpacity(before, item.handle, value),
    ),
    (value: number) => value / 100,
  );
  return (
    <>
      <Section title={words.referenceTitle(item.name)}>
        <div class="row">
          <span class="side-name wide-name" aria-hidden="true">
            {words.opacity}
          </span>
          <Slider
            class="grow"
            label={words.opacity}
            value={percent}
            min={0}
            max={100}
            step={1}
            reset={100}
            text={words.percent(decimal(percent, 0))}
            sink={sink}
          />
          <NumberField
            class="narrow"
            name={words.opacityPercent}
            value={percent}
            digits={1}
            unit="%"
            min={0}
            max={100}
            sink={sink}
          />
        </div>
        <Segments
          label={words.photoLies}
          full
          value={isLowest(editor.drawing, item) ? "below" : "above"}
          onChange={(side) =>
            void editor.run(
              words.restackPhoto,
              restack(editor.drawing, [item.handle], side === "below" ? -Infinity : Infinity),
            )
          }
          choices={[
            { value: "above", label: words.photoAbove },
            { value: "below", label: words.photoBelow },
          ]}
        />
        <label class="check">
          <input
            type="checkbox"
            checked={!item.hidden}
            onChange={() =>
              void editor.run(
                words.showOrHide,
                setHidden(editor.drawing, [item.handle], !item.hidden),
              )
            }
          />
          <span>{words.visible}</span>
        </label>
        <label class="check">
          <input
            type="checkbox"
            checked={item.locked}
            onChange={() =>
              void editor.run(
                words.lockOrUnlock,
                setLocked(editor.drawing, [item.handle], !item.locked),
              )
            }
          />
          <span>{words.locked}</span>
        </label>
        <p class="muted">{words.neverExported}</p>
      </Section>
      {!item.locked && (
        <Section title={words.placeOfPhoto}>
          <BoxFields items={[item]} />
          <AngleField item={item} />
        </Section>
      )}
      <Section title={words.sampling}>
        <div class="two">
          <NumberField
            label={words.sampleDistance}
            value={sampleDistance.value}
            digits={0}
            unit="px"
            min={1}
            max={12}
            sink={setting(sampleDistance)}
          />
          <NumberField
            label={words.sampleTolerance}
            value={sampleTolerance.value}
            digits={3}
            min={0.002}
            max={0.2}
            step={0.005}
            sink={setting(sampleTolerance)}
          />
        </div>
        <SampleBlur />
      </Section>
    </>
  );
}
