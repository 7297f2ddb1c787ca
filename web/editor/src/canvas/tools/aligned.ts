// The objects and guides that a moved selection is aligned with, on the stage.
import type { Box, Point } from "../../geometry/affine.js";
import { mappedBox } from "../../geometry/affine.js";
import { unionOf } from "../../geometry/cubic.js";
import { snappedBox, type Lines } from "../../geometry/box-snap.js";
import { isWithin } from "../../model/standing.js";
import type { Handle } from "../../model/types.js";
import { placeBounds } from "../box.js";
import type { Canvas } from "../canvas.js";
import { placesOf } from "../places.js";
import type { Guide } from "../sketch.js";
import { SNAP_REACH } from "../snap.js";

/** More boxes than this are not compared: the nearest one would be found everywhere. */
const MOST = 200;

function isOnStage([x0, y0, x1, y1]: Box, width: number, height: number): boolean {
  return x1 >= 0 && y1 >= 0 && x0 <= width && y0 <= height;
}

export class AlignedMove {
  private readonly box: Box | null;
  private readonly others: readonly Box[];
  private readonly lines: Lines;

  /** @param moved handles of what is moved */
  constructor(
    private readonly canvas: Canvas,
    moved: ReadonlySet<Handle>,
  ) {
    const { editor } = canvas;
    const map = canvas.stageFromArtboard();
    const { width, height } = editor.stage.peek();
    const own: Box[] = [];
    const others: Box[] = [];
    for (const place of placesOf(editor)) {
      const box = mappedBox(map, placeBounds(place));
      if (isWithin(place.owner, moved)) own.push(box);
      else if (isOnStage(box, width, height)) others.push(box);
    }
    this.box = unionOf(own);
    const isFew = others.length <= MOST;
    this.lines = canvas.guideLines.peek();
    this.others = [...(isFew ? others : []), mappedBox(map, editor.drawing.artboard)];
  }

  /** Returns where a line that stands across an axis meets an edge or a middle, stage pixels; `at`: nothing is near. */
  place(axis: 0 | 1, at: number): number {
    if (!this.canvas.editor.settings.snap.peek()) return at;
    return at + snappedBox([at, at, at, at], this.others, SNAP_REACH).by[axis];
  }

  /** Returns the movement, stage pixels, that aligns the box, and the lines that show it. */
  snap(by: Point): { by: Point; guides: readonly Guide[] } {
    if (!this.box || !this.canvas.editor.settings.snap.peek()) return { by, guides: [] };
    const [x0, y0, x1, y1] = this.box;
    const at: Box = [x0 + by[0], y0 + by[1], x1 + by[0], y1 + by[1]];
    const { by: more, lines } = snappedBox(at, this.others, SNAP_REACH, this.lines);
    return { by: [by[0] + more[0], by[1] + more[1]], guides: lines };
  }
}
