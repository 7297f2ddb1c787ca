// Photos to trace over: above the picture and below the handles, or below the picture.
import { useComputed } from "@preact/signals";
import { hexOf } from "../geometry/colortext.js";
import { composed, type Affine } from "../geometry/affine.js";
import type { Canvas } from "./canvas.js";
import { matrix } from "./drafts.js";
import { photosOf } from "./photo.js";

interface Props {
  readonly canvas: Canvas;
  readonly map: Affine;
  readonly below: boolean;
}

export function Photos({ canvas, map, below }: Props) {
  const { editor } = canvas;
  const photos = useComputed(() => photosOf(editor.drawing, below));
  return (
    <>
      {photos.value.map(({ handle, href, box, opacity, artboardFromItem }) => (
        <image
          key={handle}
          href={href}
          x={box[0]}
          y={box[1]}
          width={box[2] - box[0]}
          height={box[3] - box[1]}
          opacity={opacity}
          preserveAspectRatio="none"
          transform={matrix(composed(map, artboardFromItem))}
          aria-hidden="true"
        />
      ))}
    </>
  );
}

/** The ground where the picture is clear: the background, and photos on it. */
export function Ground({ canvas }: { readonly canvas: Canvas }) {
  const { editor } = canvas;
  const isUsed = useComputed(() => editor.showReference.value && photosOf(editor.drawing, true).length > 0);
  if (!isUsed.value) return null;
  const map = canvas.stageFromArtboard();
  const { artboard, background } = editor.drawing;
  const [x0, y0, x1, y1] = artboard;
  return (
    <svg class="canvas-ground" aria-hidden="true">
      <g transform={matrix(map)}>
        <rect x={x0} y={y0} width={x1 - x0} height={y1 - y0} fill={background ? hexOf(background) : "#fff"} />
      </g>
      <Photos canvas={canvas} map={map} below />
    </svg>
  );
}
