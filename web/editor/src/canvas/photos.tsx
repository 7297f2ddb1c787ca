// Photos to trace over: above the picture and below the handles, or below the picture.
import { useComputed } from "@preact/signals";
import { hexOf } from "../geometry/colortext.js";
import { composed, mappedBox, type Affine } from "../geometry/affine.js";
import type { Canvas } from "./canvas.js";
import { matrix } from "./drafts.js";
import { isSeenThrough, photosOf } from "./photo.js";

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

/** Side of two squares of the chequers, CSS pixels. */
const CHEQUERS = 16;

/**
 * Chequers below the artboard. They move with the picture, and their squares keep their size. Only the part
 * on the stage is drawn: at high zooms the artboard is millions of pixels wide.
 */
function Chequers({ canvas, map }: Pick<Props, "canvas" | "map">) {
  const { artboard } = canvas.editor.drawing;
  const { width, height } = canvas.editor.stage.value;
  const [x0, y0, x1, y1] = mappedBox(map, artboard);
  const within = (value: number, most: number) => Math.min(Math.max(value, 0), most);
  const [left, top] = [within(Math.floor(x0), width), within(Math.floor(y0), height)];
  const [right, bottom] = [within(Math.ceil(x1), width), within(Math.ceil(y1), height)];
  const offset = [Math.floor(x0) - left, Math.floor(y0) - top].map((length) => `${length % CHEQUERS}px`);
  const size = `width:${right - left}px;height:${bottom - top}px`;
  return (
    <div
      class="canvas-chequers"
      style={`left:${left}px;top:${top}px;${size};background-position:${offset.join(" ")}`}
    />
  );
}

/** The ground where the picture is clear: the background or chequers, and photos on it. */
export function Ground({ canvas }: { readonly canvas: Canvas }) {
  const { editor } = canvas;
  const isUsed = useComputed(() => isSeenThrough(editor));
  if (!isUsed.value) return null;
  const map = canvas.stageFromArtboard();
  const { artboard, background } = editor.drawing;
  const [x0, y0, x1, y1] = artboard;
  return (
    <>
      {!background && <Chequers canvas={canvas} map={map} />}
      <svg class="canvas-ground" aria-hidden="true">
        {background && (
          <g transform={matrix(map)}>
            <rect x={x0} y={y0} width={x1 - x0} height={y1 - y0} fill={hexOf(background)} />
          </g>
        )}
        {editor.showReference.value && <Photos canvas={canvas} map={map} below />}
      </svg>
    </>
  );
}
