// The document, while nothing is selected: artboard, background, interpolation.
import { setArtboard, setBackground, setInterpolation } from "../../model/commands/index.js";
import type { Drawing } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { Background } from "../controls/background.js";
import { NumberField } from "../controls/field.js";
import { Segments } from "../controls/segments.js";
import { edits } from "../controls/sink.js";
import { useShell } from "../services.js";
import { PaletteSection } from "./palette.js";
import { Section } from "./sections.js";

const words = en.panels;
/** Artboard units: larger, and a picture cannot be made of it. */
const MOST = 100000;

export function ArtboardFields() {
  const { editor } = useShell();
  const [x, y, right, bottom] = editor.drawing.artboard;
  const sink = (make: (value: number) => readonly [number, number, number, number]) =>
    edits(editor, words.setArtboard, (value: number, before: Drawing) =>
      setArtboard(before, make(value)),
    );
  return (
    <div class="two">
      <NumberField
        label="W"
        name={words.width}
        value={right - x}
        digits={2}
        min={1}
        max={MOST}
        sink={sink((to) => [x, y, x + to, bottom])}
      />
      <NumberField
        label="H"
        name={words.height}
        value={bottom - y}
        digits={2}
        min={1}
        max={MOST}
        sink={sink((to) => [x, y, right, y + to])}
      />
      <NumberField
        label="X"
        name={words.left}
        value={x}
        digits={2}
        min={-MOST}
        max={MOST}
        sink={sink((to) => [to, y, to + right - x, bottom])}
      />
      <NumberField
        label="Y"
        name={words.top}
        value={y}
        digits={2}
        min={-MOST}
        max={MOST}
        sink={sink((to) => [x, to, right, to + bottom - y])}
      />
    </div>
  );
}

export function BackgroundField() {
  const { editor } = useShell();
  return (
    <Background
      value={editor.drawing.background}
      onChange={(color) =>
        void editor.run(words.setBackground, setBackground(editor.drawing, color))
      }
    />
  );
}

export function InterpolationField() {
  const { editor } = useShell();
  return (
    <Segments
      full
      label={words.interpolation}
      value={editor.drawing.interpolation}
      choices={[
        { value: "srgb", label: "sRGB" },
        { value: "linear", label: words.linearLight },
        { value: "oklab", label: "OKLab" },
      ]}
      onChange={(to) =>
        void editor.run(words.setInterpolation, setInterpolation(editor.drawing, to))
      }
    />
  );
}

export function DocumentSections() {
  return (
    <>
      <Section title={words.artboard}>
        <ArtboardFields />
      </Section>
      <Section title={words.backgroundTitle}>
        <BackgroundField />
      </Section>
      <Section title={words.interpolation}>
        <InterpolationField />
      </Section>
      <PaletteSection />
    </>
  );
}
