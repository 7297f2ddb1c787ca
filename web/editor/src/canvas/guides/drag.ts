// Guides that are dragged: new ones from a ruler, and others where they are.
import type { Point } from "../../geometry/affine.js";
import { addGuide, moveGuide, removeGuides } from "../../model/commands/index.js";
import type { GuideAxis, Guideline } from "../../model/guidelines.js";
import * as en from "../../strings/en.js";
import type { Canvas } from "../canvas.js";
import { resizeCursor, type CursorName } from "../cursors.js";
import { shown } from "../format.js";
import { REACH } from "../hit.js";
import { gridStep } from "../snap.js";
import { AlignedMove } from "../tools/aligned.js";
import { isBeyond, type Drag, type Press } from "../tools/tool.js";
import { chooseGuide } from "./chosen.js";

/** Width of a ruler, CSS pixels. */
export const RULER = 18;

/** A guide is moved across itself. */
export const guideCursor = (axis: GuideAxis): CursorName => resizeCursor(axis === 0 ? "e" : "n");

interface Ruler {
  /** Of its guides: 1, horizontal ones, at the top. null: the corner, which has none. */
  readonly axis: GuideAxis | null;
  readonly cursor: CursorName;
}

/** Returns the ruler at a place of the stage, or null. */
export function rulerAt({ editor }: Canvas, [x, y]: Point): Ruler | null {
  if (!editor.settings.rulers.peek() || (x >= RULER && y >= RULER)) return null;
  if (x < RULER && y < RULER) return { axis: null, cursor: "default" };
  const axis = y < RULER ? 1 : 0;
  return { axis, cursor: guideCursor(axis) };
}

/** Returns the drag of a new guide; null where the press is on no ruler. */
export function rulerDrag(canvas: Canvas, p: Press): Drag | null {
  const axis = rulerAt(canvas, p.at)?.axis ?? null;
  return axis === null ? null : new GuideDrag(canvas, p, axis, null);
}

/** A guide that a drag can move. */
type Movable = Guideline & { readonly axis: GuideAxis };

/** Returns the nearest guide under the pointer that shows, is not slanted and not locked; null: there is none. */
export function guideAt(canvas: Canvas, { at, kind }: Press): Movable | null {
  const { shown: isShown, all } = canvas.guidelines.peek();
  if (!isShown || canvas.editor.hideHandles.peek()) return null;
  let best: Movable | null = null;
  let least: number = REACH[kind].curve;
  for (const guide of all) {
    if (!isMovable(guide)) continue;
    const away = Math.abs(canvas.toStage(guide.point)[guide.axis] - at[guide.axis]);
    if (away <= least) [best, least] = [guide, away];
  }
  return best;
}

const isMovable = (guide: Guideline): guide is Movable => guide.axis !== null && !guide.locked;

/** Shown above the picture while it lasts; one step of undo at its end. */
export class GuideDrag implements Drag {
  private readonly targets: AlignedMove;
  private isMoved: boolean;

  /** @param guide null: a new one */
  constructor(
    private readonly canvas: Canvas,
    private readonly start: Press,
    private readonly axis: GuideAxis,
    private readonly guide: Guideline | null,
  ) {
    this.targets = new AlignedMove(canvas, new Set());
    this.isMoved = guide === null;
  }

  get cursor(): CursorName {
    return guideCursor(this.axis);
  }

  /** Back on its ruler, or beyond the edge of the stage, a guide goes. */
  private isAway(p: Press): boolean {
    return p.at[this.axis] < (this.canvas.editor.settings.rulers.peek() ? RULER : 0);
  }

  /** Returns where the guide goes, artboard units: an edge or a middle of an object, the grid, or a round number. */
  private place(p: Press): number {
    const { canvas, axis } = this;
    const { settings, view } = canvas.editor;
    const raw = p.at[axis];
    const to = p.ctrl ? raw : this.targets.place(axis, raw);
    const at = canvas.toArtboard(axis === 0 ? [to, 0] : [0, to])[axis];
    if (to !== raw || p.ctrl) return at;
    const { zoom } = view.peek();
    const step = settings.grid.peek() ? gridStep(zoom, settings.gridUnit.peek()) : 10 ** Math.floor(-Math.log10(zoom));
    return Math.round(at / step) * step;
  }

  move(p: Press): void {
    this.isMoved ||= isBeyond(this.start.at, p.at);
    if (!this.isMoved) return;
    const { canvas, axis } = this;
    const of = this.guide?.handle ?? null;
    if (this.isAway(p)) {
      const tag = this.guide && { at: p.at, text: en.canvas.guideGoes };
      return canvas.draw({ guide: { axis, at: null, of }, tag });
    }
    const place = this.place(p);
    const at = canvas.toStage(axis === 0 ? [place, 0] : [0, place])[axis];
    canvas.draw({ guide: { axis, at, of }, tag: { at: p.at, text: en.canvas.guideTag(axis, shown(place)) } });
  }

  keys(p: Press): void {
    this.move(p);
  }

  end(p: Press): void {
    const { canvas, guide } = this;
    const { editor } = canvas;
    this.cancel();
    if (!this.isMoved) this.click(p);
    else if (!this.isAway(p)) this.put(this.place(p));
    else if (guide) editor.run(en.tools.undo.removeGuide, removeGuides(editor.drawing, [guide]));
    // A selection keeps the keys.
    if (editor.selection.peek().length > 0 || editor.tool.peek() !== "select" || this.isAway(p)) return;
    const { all } = canvas.guidelines.peek();
    const now = guide ? all.find(({ handle }) => handle === guide.handle) : all.at(-1);
    if (now) chooseGuide(canvas, now);
  }

  /** Chooses the guide; a double click shows its numbers. */
  private click({ clicks }: Press): void {
    const { editor } = this.canvas;
    editor.selection.value = [];
    if (clicks > 1) editor.dialog.value = { kind: "guides" };
  }

  private put(at: number): void {
    const { guide, axis } = this;
    const { editor } = this.canvas;
    if (guide) editor.run(en.tools.undo.moveGuide, moveGuide(editor.drawing, guide.handle, at));
    else editor.run(en.tools.undo.addGuide, addGuide(editor.drawing, axis, at));
  }

  cancel(): void {
    this.canvas.draw({ guide: null, tag: null });
  }
}
