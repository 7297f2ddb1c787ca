// State that stage, overlay and tools share: the marks, the objects under a point, the snapping of points.
import { computed, signal, type ReadonlySignal, type Signal } from "@preact/signals";
import { inverted, mapped, type Affine, type Point } from "../geometry/affine.js";
import type { Editor } from "../app/types.js";
import type { Lines } from "../geometry/box-snap.js";
import { guidelinesOf, type Guidelines } from "../model/guidelines.js";
import { isHidden, isWithin } from "../model/standing.js";
import type { Attribute, CurveItem, Handle, Item, Selection } from "../model/types.js";
import { boxMarks, selectionBox } from "./box.js";
import { Grips } from "./grips.js";
import { CurveGrid, markAt, REACH, type CurveHit, type PointerKind } from "./hit.js";
import { chosenParts, nodeMarks, stageFromItem, stopMarks, type Mark } from "./marks.js";
import { paintMarks } from "./paint-marks.js";
import { isCurve, isOutOfReach, placesOf, type Place } from "./places.js";
import { NO_SKETCH, type Sketch } from "./sketch.js";
import { snapped, type Snapped } from "./snap.js";
import { keyOf } from "./walk.js";
import { stageFromArtboard, type Navigation } from "../app/view.js";

/** Nodes are shown of so many selected curves at most: more would hide the picture. */
const MOST_WITH_NODES = 24;

/**
 * Coordinates that are larger no reader of ours takes (docs/limits.md, kCoordinate): half of them, artboard
 * units, but all of the artboard.
 */
const MOST = 5e6;
const held = (value: number, low: number, high: number) =>
  Math.min(Math.max(value, Math.min(low, -MOST)), Math.max(high, MOST));

export class Canvas {
  readonly sketch: Signal<Sketch> = signal(NO_SKETCH);
  readonly marks: ReadonlySignal<readonly Mark[]>;
  readonly grips = new Grips(this);
  readonly guidelines: ReadonlySignal<Guidelines>;
  /** Places of the guides that show and are not slanted, on the stage. */
  readonly guideLines: ReadonlySignal<Lines>;
  /** The guide that has the keys while this is the selection. */
  readonly guide: Signal<{ readonly handle: Handle; readonly selection: Selection } | null> = signal(null);
  private grid: { readonly key: readonly unknown[]; readonly grid: CurveGrid } | null = null;

  constructor(
    readonly editor: Editor,
    readonly navigation: Navigation,
  ) {
    this.marks = computed(() => this.collectMarks());
    this.guidelines = computed(() => guidelinesOf(editor.drawing));
    this.guideLines = computed(() => this.collectLines());
  }

  draw(part: Partial<Sketch>): void {
    this.sketch.value = { ...this.sketch.peek(), ...part };
  }

  /** Reading it in a component or an effect subscribes to the view. */
  stageFromArtboard(): Affine {
    const { width, height } = this.editor.stage.value;
    return stageFromArtboard(this.editor.view.value, width, height);
  }

  toStage(point: Point): Point {
    return mapped(this.stageFromArtboard(), point);
  }

  /** Returns the place of the pointer, limited to the largest coordinates of a file. */
  toArtboard(point: Point): Point {
    const back = inverted(this.stageFromArtboard());
    const [x, y] = back ? mapped(back, point) : point;
    const [x0, y0, x1, y1] = this.editor.drawing.artboard;
    return [held(x, x0, x1), held(y, y0, y1)];
  }

  private collectLines(): Lines {
    const { shown, all } = this.guidelines.value;
    const map = this.stageFromArtboard();
    const lines: [number[], number[]] = [[], []];
    for (const { axis, point } of shown ? all : []) {
      if (axis !== null) lines[axis].push(mapped(map, point)[axis]);
    }
    return lines;
  }

  /** A vector of the artboard in an item's coordinates. */
  toItem(item: Item, point: Point): Point {
    const back = inverted(item.artboardFromItem);
    return back ? mapped(back, point) : point;
  }

  vectorToItem(item: Item, [dx, dy]: Point): Point {
    const [x0, y0] = this.toItem(item, [0, 0]);
    const [x1, y1] = this.toItem(item, [dx, dy]);
    return [x1 - x0, y1 - y0];
  }

  /** The curves whose nodes and stops are shown: selected, seen and not locked; the primary last. */
  chosenCurves(): CurveItem[] {
    const handles = new Set(this.editor.selection.value.map(({ handle }) => handle));
    const curves = [...handles].map((handle) => this.editor.drawing.item(handle));
    return curves
      .filter(isCurve)
      .filter(
        (item) =>
          !isHidden(item) &&
          !isOutOfReach(this.editor, item) &&
          inverted(item.artboardFromItem) !== null,
      );
  }

  primaryCurve(): CurveItem | null {
    const last = this.editor.selection.value.at(-1);
    return this.chosenCurves().find((item) => item.handle === last?.handle) ?? null;
  }

  /** Which stops stand on the curve: the blur tool shows blur, whatever else is chosen. */
  attribute(): Attribute {
    return this.editor.tool.value === "blur" ? "blur" : this.editor.attribute.value;
  }

  private collectMarks(): readonly Mark[] {
    const { editor } = this;
    const map = this.stageFromArtboard();
    const tool = editor.tool.value;
    if (tool === "select") {
      const box = selectionBox(editor);
      const last = editor.selection.value.at(-1);
      const isChosen = (mark: Mark) => this.grips.isChosen(mark.handle, keyOf(mark));
      return box && last ? boxMarks(box, map, last.handle, isChosen) : [];
    }
    if (tool !== "nodes" && tool !== "blur" && tool !== "sample") return [];
    const marks: Mark[] = [];
    const primary = this.primaryCurve();
    if (tool === "nodes") {
      for (const item of this.chosenCurves().slice(-MOST_WITH_NODES)) {
        marks.push(
          ...nodeMarks(
            item,
            stageFromItem(map, item),
            chosenParts(editor.selection.value, item.handle),
          ),
        );
      }
    }
    if (primary) {
      const parts = chosenParts(editor.selection.value, primary.handle);
      const own = stageFromItem(map, primary);
      const attribute = this.attribute();
      marks.push(...stopMarks(primary, own, attribute, parts));
      if (tool === "nodes" && attribute !== "blur")
        marks.push(...paintMarks(editor.drawing, primary, own, attribute, parts));
    }
    return marks;
  }

  /** The curves on the stage, as they are now. */
  curves(): CurveGrid {
    const { drawing, isolated, view, stage } = this.editor;
    const { width, height } = stage.peek();
    const key = [drawing, drawing.revision, isolated.peek(), view.peek(), width, height];
    if (!this.grid || !this.grid.key.every((value, k) => value === key[k])) {
      const map = stageFromArtboard(view.peek(), width, height);
      this.grid = { key, grid: new CurveGrid(placesOf(this.editor), map, width, height) };
    }
    return this.grid.grid;
  }

  markAt(at: Point, kind: PointerKind): Mark | null {
    if (this.editor.hideHandles.peek()) return null;
    return markAt(this.marks.peek(), at, REACH[kind].mark);
  }

  /** Returns the object under the pointer, a mark before a curve, and highlights the curve. */
  hover(at: Point, kind: PointerKind): { readonly mark: Mark | null; readonly curve: CurveHit | null } {
    const mark = this.markAt(at, kind);
    const curve = mark ? null : this.curveAt(at, kind);
    this.editor.hovered.value = curve?.place.owner.handle ?? null;
    return { mark, curve };
  }

  curveAt(at: Point, kind: PointerKind): CurveHit | null {
    return this.curves().near(at, REACH[kind].curve)[0] ?? null;
  }

  /**
   * Where a point of the stage goes, and the guides that say why.
   * @param grid of the drawing before a gesture
   * @param moved curves that do not count
   * @param also ends of these that do
   */
  snap(
    at: Point,
    grid: CurveGrid,
    moved: ReadonlySet<Handle>,
    also: readonly Point[] = [],
  ): Snapped {
    const isWanted = ({ item, owner }: Place) => !isWithin(item, moved) && !moved.has(owner.handle);
    return snapped(grid, at, {
      snaps: this.editor.settings.snap.peek(),
      grid: this.editor.settings.grid.peek(),
      lines: this.guideLines.peek(),
      unit: this.editor.settings.gridUnit.peek(),
      zoom: this.editor.view.peek().zoom,
      origin: this.toStage([0, 0]),
      isWanted,
      also,
    });
  }
}
