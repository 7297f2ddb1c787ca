// Where the drawing is unlike the photo: a picture in its place, and what its colours mean.
import type { Editor } from "../app/types.js";
import type { Affine } from "../geometry/affine.js";
import { differenceColors, MOST_DIFFERENCE } from "../geometry/difference.js";
import * as en from "../strings/en.js";
import type { Canvas } from "./canvas.js";
import { matrix } from "./drafts.js";

const words = en.photo;

export function DifferenceImage({ canvas, map }: { readonly canvas: Canvas; readonly map: Affine }) {
  const { drawing, difference } = canvas.editor;
  const shown = difference.value;
  if (!shown) return null;
  const [x0, y0, x1, y1] = drawing.artboard;
  return (
    <image
      class={shown.revision === drawing.revision ? "difference" : "difference old"}
      href={shown.href}
      x={x0}
      y={y0}
      width={x1 - x0}
      height={y1 - y0}
      preserveAspectRatio="none"
      transform={matrix(map)}
      aria-hidden="true"
    />
  );
}

function nearness({ difference, drawing, status }: Editor): string {
  const shown = difference.value;
  if (status.value.kind === "problem" || status.value.kind === "failed") return words.differenceFails;
  if (shown?.revision !== drawing.revision) return words.looking;
  const { psnr } = shown;
  if (psnr === null) return words.differenceNone;
  return psnr === Infinity ? words.differenceSame : words.differenceOf(psnr.toFixed(1));
}

export function DifferenceLegend({ editor }: { readonly editor: Editor }) {
  if (!editor.showDifference.value) return null;
  return (
    <div class="difference-legend" role="group" aria-label={words.difference}>
      <p>
        <span>{words.difference}</span>
        <b title={words.differenceTip}>{nearness(editor)}</b>
      </p>
      <div class="difference-ramp" style={`background:linear-gradient(to right, ${differenceColors.join(", ")})`} />
      <p class="muted">
        <span>{words.least}</span>
        <span>{words.most(MOST_DIFFERENCE)}</span>
      </p>
    </div>
  );
}
