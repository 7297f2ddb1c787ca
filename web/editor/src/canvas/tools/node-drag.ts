// Nodes moved by the pointer: they snap, and an end that reaches its curve's other end closes it.
import { mapped, type Point } from "../../geometry/affine.js";
import { nodePath } from "../../geometry/natural.js";
import { closeByEnd } from "../../model/commands/index.js";
import type { CurveItem } from "../../model/types.js";
import * as en from "../../strings/en.js";
import type { Canvas } from "../canvas.js";
import { movedNodes, plus } from "../edits.js";
import { stageFromItem, type NodeMark } from "../marks.js";
import { otherEnd } from "../nodes.js";
import { isCurve } from "../places.js";
import { SAME_PX, WELD_FINER } from "../snap.js";
import { EditDrag, isBeyond, travelled, type Drag, type Press } from "./tool.js";

export function dragNodes(
  canvas: Canvas,
  mark: NodeMark,
  start: Press,
  { click, kept }: { readonly click: () => void; readonly kept: () => void },
): Drag {
  const { editor } = canvas;
  const grid = canvas.curves();
  const selection = editor.selection.peek().filter(({ part }) => part.kind === "node");
  const moved = new Set(selection.map(({ handle }) => handle));
  const own = selection.length === 1 ? ownEnd(canvas, mark) : [];
  return new EditDrag(canvas, start, {
    label: selection.length > 1 ? en.tools.undo.moveNodes : en.tools.undo.moveNode,
    dragged: { handle: mark.handle, part: mark.part },
    cursor: "move",
    make: (p, before) => {
      const wanted = plus(mark.at, travelled(start, p));
      const isFree = p.shift || p.ctrl;
      const to = isFree ? { at: wanted, guides: [], isWelded: false } : canvas.snap(wanted, grid, moved, own);
      canvas.draw({ guides: to.guides });
      const step = (item: CurveItem) => editor.step(item) / (to.isWelded ? WELD_FINER : 1);
      const { handle, part } = mark;
      const item = before.item(handle);
      const closes = to.isWelded && own.some((end) => !isBeyond(end, to.at, SAME_PX));
      if (closes && part.kind === "node" && isCurve(item))
        return closeByEnd(before, handle, part.path, part.index, step(item));
      const { zoom } = editor.view.peek();
      const vector: Point = [(to.at[0] - mark.at[0]) / zoom, (to.at[1] - mark.at[1]) / zoom];
      return movedNodes({ drawing: before, isolated: editor.isolated }, selection, vector, step);
    },
    click,
    kept,
  });
}

/** The other end of the curve that a node is an end of, on the stage; none: it is no end. */
function ownEnd(canvas: Canvas, { handle, part }: NodeMark): Point[] {
  const item = canvas.editor.drawing.item(handle);
  if (!isCurve(item) || part.kind !== "node") return [];
  const end = otherEnd(nodePath(item.paths[part.path]), part.index);
  return end ? [mapped(stageFromItem(canvas.stageFromArtboard(), item), end)] : [];
}
