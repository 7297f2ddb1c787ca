// Numbers beside what is dragged or chosen.
import type { Affine, Point } from "../geometry/affine.js";
import * as en from "../strings/en.js";
import { drawnBox, selectionBox } from "./box.js";
import type { Canvas } from "./canvas.js";
import { shown } from "./format.js";
import type { Sketch } from "./sketch.js";

/** The number of what is dragged; at rest that of the chosen bracket, or the size of the box. */
export function Tags({
  canvas,
  map,
  sketch,
}: {
  readonly canvas: Canvas;
  readonly map: Affine;
  readonly sketch: Sketch;
}) {
  if (sketch.tag) return <Tag at={sketch.tag.at} text={sketch.tag.text} />;
  if (canvas.editor.hideHandles.value || sketch.isFaded) return null;
  for (const mark of canvas.marks.value) {
    if (mark.kind !== "bracket" || !mark.isChosen) continue;
    const value = shown(Number(mark.value));
    const text =
      mark.attribute === "radius" ? en.canvas.radiusTag(value) : en.canvas.blurTag(value);
    return <Tag at={mark.at} text={text} />;
  }
  return <BoxTag canvas={canvas} map={map} />;
}

function Tag({ at, text }: { readonly at: Point; readonly text: string }) {
  return (
    <span class="canvas-tag-line" style={`--x:${at[0] + 16}px;--y:${at[1] + 16}px`}>
      <span class="tag">{text}</span>
    </span>
  );
}

function BoxTag({ canvas, map }: { readonly canvas: Canvas; readonly map: Affine }) {
  const { editor } = canvas;
  if (editor.tool.value !== "select") return null;
  const box = selectionBox(editor);
  if (!box) return null;
  const [x0, , x1, y1] = drawnBox(box, map);
  return (
    <span class="tag canvas-tag below" style={`left:${(x0 + x1) / 2}px;top:${y1 + 10}px`}>
      {en.canvas.size(shown(box[2] - box[0]), shown(box[3] - box[1]))}
    </span>
  );
}
