// All guides by numbers: added, moved and removed without a pointer.
import { addGuide, moveGuide, removeGuides } from "../../model/commands/index.js";
import { guidelinesOf, type GuideAxis, type Guideline } from "../../model/guidelines.js";
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { NumberField } from "../controls/field.js";
import { edits } from "../controls/sink.js";
import { useShell } from "../services.js";
import { Frame } from "./frame.js";

const words = en.panels;

const LABELS = ["X", "Y"] as const;
/** A file may have thousands; so many have a row. */
const MOST_ROWS = 200;

function Row({ guide, axis }: { readonly guide: Guideline; readonly axis: GuideAxis }) {
  const { editor } = useShell();
  const { handle, point, locked } = guide;
  return (
    <li class="row">
      <NumberField
        class="grow"
        label={LABELS[axis]}
        name={words.guideAt[axis]}
        value={point[axis]}
        digits={3}
        min={-1e7}
        max={1e7}
        disabled={locked}
        sink={edits(editor, words.moveGuide, (at, before) => moveGuide(before, handle, at))}
      />
      <IconButton
        icon="trash-2"
        label={words.removeGuide}
        disabled={locked}
        onClick={() => editor.run(words.removeGuide, removeGuides(editor.drawing, [guide]))}
      />
    </li>
  );
}

export function GuidesDialog() {
  const { editor } = useShell();
  const { all } = guidelinesOf(editor.drawing);
  const [x0, y0, x1, y1] = editor.drawing.artboard;
  const middle = [(x0 + x1) / 2, (y0 + y1) / 2];
  const isNone = all.length === 0;
  const rows = all.flatMap((guide) => (guide.axis === null ? [] : [{ guide, axis: guide.axis }]));
  return (
    <Frame
      title={words.guides}
      class="small"
      foot={
        <button type="button" class="button" disabled={isNone} onClick={() => editor.command("remove-guides")}>
          {words.removeGuides}
        </button>
      }
    >
      <div class="dialog-body form">
        <div class="row">
          {([0, 1] as const).map((axis) => (
            <button
              key={axis}
              type="button"
              class="button grow"
              onClick={() => editor.run(words.addGuide, addGuide(editor.drawing, axis, middle[axis]))}
            >
              {words.addGuides[axis]}
            </button>
          ))}
        </div>
        {isNone && <p class="muted">{words.noGuides}</p>}
        {rows.length > 0 && (
          <ul class="guide-list" aria-label={words.guides}>
            {rows.slice(0, MOST_ROWS).map(({ guide, axis }) => (
              <Row key={guide.handle} guide={guide} axis={axis} />
            ))}
          </ul>
        )}
      </div>
    </Frame>
  );
}
