// Takes hold of where a gradient or a texture lies.
import { nameOfSide } from "../../app/side-names.js";
import { inverted, mapped, type Point } from "../../geometry/affine.js";
import { atAngle } from "../../geometry/snap.js";
import { subtract } from "../../geometry/vector.js";
import { movePaint } from "../../model/commands/index.js";
import { gripPlace } from "../../model/paint-frames.js";
import type { PaintGrip, Selected } from "../../model/types.js";
import * as en from "../../strings/en.js";
import type { Canvas } from "../canvas.js";
import { plus } from "../edits.js";
import { shown } from "../format.js";
import { stageFromItem, type PaintMark } from "../marks.js";
import { isCurve } from "../places.js";
import { EditDrag, travelled, type Drag, type Press } from "./tool.js";

/**
 * With Shift the other end or radius stays at a multiple of 15°, and what moves all of it goes across or
 * down. Alt pulls the focus out of the middle of a circle.
 */
export function dragPaint(canvas: Canvas, mark: PaintMark, start: Press): Drag {
  const { editor } = canvas;
  const { side, attribute } = mark.part;
  const isFocus = start.alt && mark.paint === "radial" && mark.part.grip === "start";
  const grip: PaintGrip = isFocus ? "focus" : mark.part.grip;
  const fixed = fixedPoint(canvas, mark, grip);
  return new EditDrag(canvas, start, {
    label: en.tools.undo.movePaint,
    dragged: { handle: mark.handle, part: mark.part },
    cursor: "move",
    make: (p, before) => {
      const item = before.item(mark.handle);
      if (!isCurve(item)) return null;
      const raw = plus(mark.at, fixed ? subtract(p.at, start.at) : travelled(start, p));
      const at = fixed && p.shift ? atAngle(fixed, raw) : raw;
      const back = inverted(stageFromItem(canvas.stageFromArtboard(), item));
      const to = back && mapped(back, at);
      return to && movePaint(before, item.handle, side, attribute, grip, to, editor.step(item));
    },
    kept: () => tell(canvas, { ...mark, part: { ...mark.part, grip } }),
  });
}

/** Returns the point about which a grip rotates, on the stage; null: the grip moves the whole paint. */
function fixedPoint(canvas: Canvas, mark: PaintMark, grip: PaintGrip): Point | null {
  if (grip !== "start") return mark.foot;
  const isOther = ({ kind, part }: { kind: string; part: Selected["part"] }) =>
    kind === "paint" && part.kind === "paint" && part.side === mark.part.side && part.grip !== "start";
  const others = canvas.marks.peek().filter(isOther);
  // A line has one other end; what has more grips is moved by its first.
  return others.length === 1 ? others[0].at : null;
}

/** Says where the grip has come to. */
function tell(canvas: Canvas, { handle, part, paint }: PaintMark): void {
  const { editor } = canvas;
  const item = editor.drawing.item(handle);
  if (!isCurve(item)) return;
  const place = gripPlace(editor.drawing, item, part.side, part.attribute, part.grip);
  if (!place) return;
  const [x, y] = mapped(item.artboardFromItem, place);
  const label = en.canvas.paint(paint, part.grip, nameOfSide(item, part.side));
  editor.announcement.value = en.canvas.at(label, shown(x), shown(y));
}
