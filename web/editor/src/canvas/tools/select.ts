// Select: click, box, move, copy, scale, rotate.
import { mapped, translation, turning, type Affine, type Box, type Point } from "../../geometry/affine.js";
import { duplicate, transform } from "../../model/commands/index.js";
import { isWithin } from "../../model/standing.js";
import type { Handle, Item, Selected } from "../../model/types.js";
import * as en from "../../strings/en.js";
import {
  drawnBox,
  gripName,
  middleOf,
  movable,
  placeBounds,
  scaling,
  selectionBox,
  toStep,
  wholes,
} from "../box.js";
import type { Canvas } from "../canvas.js";
import { resizeCursor, type CursorName } from "../cursors.js";
import { shown } from "../format.js";
import { guideAt, GuideDrag, guideCursor } from "../guides/drag.js";
import { layerAt } from "../hit.js";
import type { BoxMark } from "../marks.js";
import { loosePhotoAt } from "../photo.js";
import { placesOf } from "../places.js";
import type { Guide } from "../sketch.js";
import { AlignedMove } from "./aligned.js";
import {
  EditDrag,
  MarqueeDrag,
  toggled,
  travelled,
  type Drag,
  type Press,
  type Tool,
} from "./tool.js";

const WHOLE = { kind: "whole" } as const;

export class SelectTool implements Tool {
  constructor(private readonly canvas: Canvas) {}

  hover(p: Press): CursorName {
    const { canvas } = this;
    const mark = this.markAt(p);
    const curve = mark ? null : canvas.curveAt(p.at, p.kind);
    canvas.editor.hovered.value = curve?.place.owner.handle ?? null;
    if (mark?.kind === "scale") return resizeCursor(gripName(mark.grip));
    if (mark?.kind === "turn") return "turn";
    const guide = curve ? null : guideAt(canvas, p);
    if (guide) return guideCursor(guide.axis);
    const isOver = curve
      ? this.isSelected(curve.place.owner)
      : this.isInBox(p.at) || this.photoAt(p) !== null;
    return isOver ? "move" : "default";
  }

  press(p: Press): Drag | null {
    const { canvas } = this;
    const mark = this.markAt(p);
    if (mark) return this.reshape(mark, p);
    canvas.grips.letGo();
    canvas.guide.value = null;
    const hit = canvas.curveAt(p.at, p.kind);
    if (hit) return this.pressOn(hit.place.owner, p);
    const guide = guideAt(canvas, p);
    if (guide) return new GuideDrag(canvas, p, guide.axis, guide);
    if (this.isInBox(p.at) && !p.shift) return this.move(p, () => this.clickEmpty(p));
    const photo = this.photoAt(p);
    if (photo) return this.pressOn(photo, p);
    return new MarqueeDrag(
      canvas,
      p,
      (low, high, end) => this.take(low, high, end.shift),
      () => this.clickEmpty(p),
    );
  }

  leave(): void {
    this.canvas.grips.letGo();
  }

  /** A handle of the box; where a curve is nearer, it is the curve that is meant. */
  private markAt(p: Press): BoxMark | null {
    const { canvas } = this;
    const mark = canvas.markAt(p.at, p.kind);
    if (mark?.kind !== "scale" && mark?.kind !== "turn") return null;
    const away = Math.hypot(mark.at[0] - p.at[0], mark.at[1] - p.at[1]);
    const curve = canvas.curveAt(p.at, p.kind);
    return curve && curve.distance < away ? null : mark;
  }

  /** A photo that is not locked: one that is lies out of the way. */
  private photoAt({ at }: Press): Item | null {
    const { editor } = this.canvas;
    if (!editor.showReference.peek()) return null;
    return loosePhotoAt(editor, this.canvas.toArtboard(at));
  }

  private isSelected(item: Item): boolean {
    const chosen = new Set(wholes(this.canvas.editor.selection.peek()));
    for (let around: Item | null = item; around; around = around.parent) {
      if (chosen.has(around.handle)) return true;
    }
    return false;
  }

  private isInBox([x, y]: Point): boolean {
    const { editor } = this.canvas;
    const box = selectionBox(editor);
    if (!box || this.movedItems().length === 0) return false;
    const [x0, y0, x1, y1] = drawnBox(box, this.canvas.stageFromArtboard());
    return x >= x0 && x <= x1 && y >= y0 && y <= y1;
  }

  private pressOn(owner: Item, p: Press): Drag {
    const { editor } = this.canvas;
    const one: Selected = { handle: owner.handle, part: WHOLE };
    const wasSelected = this.isSelected(owner);
    if (p.clicks >= 2 && owner.kind !== "use" && owner.kind !== "reference") {
      editor.selection.value = [one];
      editor.tool.value = "nodes";
      return this.move(p, () => undefined);
    }
    const toggle = () => {
      editor.selection.value = toggled(editor.selection.peek(), one, isSameWhole);
    };
    if (!wasSelected) p.shift ? toggle() : (editor.selection.value = [one]);
    // A click on one of several leaves it alone, or lets go of it with Shift; a drag moves them all.
    return this.move(p, () => {
      if (!p.shift) editor.selection.value = [one];
      else if (wasSelected) toggle();
    });
  }

  private clickEmpty(p: Press): void {
    const { editor } = this.canvas;
    const layer = layerAt(placesOf(editor), this.canvas.toArtboard(p.at));
    if (!layer) {
      if (!p.shift) editor.selection.value = [];
      return;
    }
    const one: Selected = { handle: layer.handle, part: WHOLE };
    editor.selection.value = p.shift ? toggled(editor.selection.peek(), one, isSameWhole) : [one];
  }

  /** Curves, and copies by <use>, that a rectangle touches. */
  private take(low: Point, high: Point, adds: boolean): void {
    const { editor } = this.canvas;
    const [a, b] = [this.canvas.toArtboard(low), this.canvas.toArtboard(high)];
    const handles = new Set<Handle>();
    for (const place of placesOf(editor)) {
      const [x0, y0, x1, y1] = placeBounds(place);
      if (x0 >= a[0] && y0 >= a[1] && x1 <= b[0] && y1 <= b[1]) handles.add(place.owner.handle);
    }
    for (const hit of this.canvas.curves().within(low, high)) handles.add(hit.owner.handle);
    const before = adds ? editor.selection.peek().filter(({ handle }) => !handles.has(handle)) : [];
    editor.selection.value = [
      ...before,
      ...[...handles].map((handle) => ({ handle, part: WHOLE })),
    ];
  }

  private movedItems(): Item[] {
    return movable(this.canvas.editor);
  }

  private move(start: Press, click: () => void): Drag {
    const { canvas } = this;
    const { editor } = canvas;
    const grid = canvas.curves();
    const box = selectionBox(editor);
    const handles = this.movedItems().map(({ handle }) => handle);
    const ends = this.endsOf(new Set(handles));
    const aligned = new AlignedMove(canvas, new Set(handles));
    const step = editor.step(null);
    let by: Point = [0, 0];
    return new EditDrag(canvas, start, {
      label: start.alt ? en.tools.undo.copy : en.tools.undo.move,
      cursor: start.alt ? "copy" : "move",
      make: (p, before) => {
        const raw = travelled(start, p);
        const snap =
          p.ctrl || p.shift
            ? { by: raw, guides: [] }
            : (snapEnds(canvas, grid, ends, raw, new Set(handles)) ?? aligned.snap(raw));
        canvas.draw({ guides: snap.guides });
        const { zoom } = editor.view.peek();
        by = [snap.by[0] / zoom, snap.by[1] / zoom];
        if (handles.length === 0) return null;
        return p.alt
          ? duplicate(before, handles, by)
          : transform(before, handles, translation(...by), step);
      },
      click,
      kept: () => box && say(canvas, middleOf(box, translation(...by))),
    });
  }

  /** Ends of the open curves that are moved, on the stage: what snaps to others. */
  private endsOf(handles: ReadonlySet<Handle>): Point[] {
    const { canvas } = this;
    const ends = placesOf(canvas.editor)
      .filter(({ owner }) => isWithin(owner, handles))
      .flatMap(({ item, artboardFromItem }) =>
        item.paths
          .filter(({ closed }) => !closed)
          .flatMap(({ points }) =>
            [points[0], points[points.length - 1]].map((p) => mapped(artboardFromItem, p)),
          ),
      );
    return ends.length <= MOST_ENDS ? ends.map((end) => canvas.toStage(end)) : [];
  }

  private reshape(mark: BoxMark, start: Press): Drag | null {
    const { canvas } = this;
    const { editor } = canvas;
    const box = selectionBox(editor);
    const handles = this.movedItems().map(({ handle }) => handle);
    if (!box || handles.length === 0) return null;
    const isTurn = mark.kind === "turn";
    let map: Affine = translation(0, 0);
    return new EditDrag(canvas, start, {
      label: isTurn ? en.tools.undo.turn : en.tools.undo.scale,
      cursor: isTurn ? "turning" : resizeCursor(gripName(mark.grip)),
      make: (p, before) => {
        map = isTurn ? this.turn(box, start, p) : this.scale(box, mark, start, p);
        return transform(before, handles, map, editor.step(null));
      },
      // From here on it has the keys, too.
      click: () => canvas.grips.choose(mark),
      kept: () => {
        canvas.grips.choose(mark);
        say(canvas, middleOf(box, map));
      },
    });
  }

  private turn(box: Box, start: Press, p: Press): Affine {
    const { canvas } = this;
    const middle: Point = [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2];
    const [x, y] = canvas.toStage(middle);
    const angleTo = (at: Point) => Math.atan2(at[1] - y, at[0] - x);
    const raw = angleTo(p.at) - angleTo(start.at);
    const angle = p.shift ? toStep(raw) : raw;
    const degrees = Math.round((((angle * 180) / Math.PI + 540) % 360) - 180);
    canvas.draw({ tag: { at: p.at, text: en.canvas.angle(shown(degrees)) } });
    return turning(middle, angle);
  }

  private scale(box: Box, mark: BoxMark, start: Press, p: Press): Affine {
    const { canvas } = this;
    const { zoom } = canvas.editor.view.peek();
    const by: Point = [(p.at[0] - start.at[0]) / zoom, (p.at[1] - start.at[1]) / zoom];
    const map = scaling(box, mark.grip, by, p.shift, p.alt);
    const size = [Math.abs(map[0]) * (box[2] - box[0]), Math.abs(map[3]) * (box[3] - box[1])];
    canvas.draw({ tag: { at: p.at, text: en.canvas.size(shown(size[0]), shown(size[1])) } });
    return map;
  }
}

/** With more ends than this a move snaps by none: it is a whole picture that is moved. */
const MOST_ENDS = 64;

/** Returns the vector that moves one of several ends to its snap target; null: none of them snaps. */
function snapEnds(
  canvas: Canvas,
  grid: ReturnType<Canvas["curves"]>,
  ends: readonly Point[],
  by: Point,
  moved: ReadonlySet<Handle>,
): { by: Point; guides: readonly Guide[] } | null {
  for (const [x, y] of ends) {
    const at: Point = [x + by[0], y + by[1]];
    const found = canvas.snap(at, grid, moved);
    if (found.isWelded) {
      return {
        by: [by[0] + found.at[0] - at[0], by[1] + found.at[1] - at[1]],
        guides: found.guides,
      };
    }
  }
  return null;
}

export function say(canvas: Canvas, [x, y]: Point): void {
  const { editor } = canvas;
  const last = editor.selection.peek().at(-1);
  const item = last && editor.drawing.item(last.handle);
  if (item) editor.announcement.value = en.canvas.at(item.name, shown(x), shown(y));
}

function isSameWhole(a: Selected, b: Selected): boolean {
  return a.handle === b.handle;
}
