// An editor without a page: signals, gestures on a FakeDrawing, and a log of undoable steps.
import { signal } from "@preact/signals";
import type { Editor, Gesture, Settings } from "../../../../web/editor/src/app/types.js";
import type { Box, Point } from "../../../../web/editor/src/geometry/affine.js";
import type { Engine } from "../../../../web/editor/src/engine/types.js";
import type { Drawing, Handle, Item, Outcome } from "../../../../web/editor/src/model/types.js";
import { Canvas } from "../../../../web/editor/src/canvas/canvas.js";
import { placesOf, type Place } from "../../../../web/editor/src/canvas/places.js";
import {
  Navigation,
  artboardFromStage,
  stageFromArtboard,
} from "../../../../web/editor/src/app/view.js";
import { FakeDrawing, type FakeOutcome } from "./drawing.js";

export interface FakeEditor extends Editor {
  readonly drawing: FakeDrawing;
  /** Labels of undo steps, and of cancelled gestures. */
  readonly steps: string[];
  readonly dropped: string[];
  /** The merge key of each step; steps of one key in quick succession become one. */
  readonly merges: string[];
  /** The answer of `colors`: red, green, blue, opacity at a point. */
  paint: (x: number, y: number) => readonly [number, number, number, number];
  layers: { layer: number; offset: number }[];
}

function settings(): Settings {
  return {
    theme: signal("system"),
    surround: signal("mid"),
    smoothing: signal(2),
    exactPixels: signal("auto"),
    alignToArtboard: signal(false),
    ownColor: signal(false),
    snap: signal(true),
    grid: signal(false),
    gridUnit: signal(0),
    rulers: signal(false),
    colorModel: signal("oklch"),
    recent: signal([]),
    panelWidth: signal(288),
    sampleDistance: signal(3),
    sampleTolerance: signal(0.02),
    sampleBlur: signal(false),
    strokeRadius: signal(6),
    polygonSides: signal(6),
    tourDone: signal(true),
  };
}

/** @param width of the stage in CSS pixels; the view shows the artboard at 1:1, its corner at 0, 0 */
export function fakeEditor(items: readonly Item[], width = 400, height = 300): FakeEditor {
  const drawing = new FakeDrawing(items);
  const revision = signal(0);
  const steps: string[] = [];
  const dropped: string[] = [];
  const merges: string[] = [];
  const selection: Editor["selection"] = signal([]);
  const set = (next: readonly Item[], made: Outcome | null) => {
    drawing.items = next;
    drawing.revision += 1;
    revision.value = drawing.revision;
    const select = made?.select;
    if (select)
      selection.value = select.map(({ at, part }) => ({
        handle: at,
        part: part ?? { kind: "whole" },
      }));
  };
  const gesture = (label: string): Gesture => {
    const before = new FakeDrawing(drawing.items);
    const selected = selection.peek();
    let last: Outcome | null = null;
    let isOver = false;
    return {
      get isOver() {
        return isOver;
      },
      show(make: (from: Drawing) => Outcome | null) {
        if (isOver) throw new Error("the gesture is over");
        last = make(before);
        set(last ? (last as FakeOutcome).items : before.items, null);
      },
      keep() {
        if (isOver) throw new Error("the gesture is over");
        isOver = true;
        if (!last) return;
        steps.push(label);
        set(drawing.items, last);
      },
      drop() {
        if (isOver) throw new Error("the gesture is over");
        isOver = true;
        dropped.push(label);
        set(before.items, null);
        selection.value = selected;
      },
    };
  };
  const view = signal({ x: width / 2, y: height / 2, zoom: 1 });
  const stage = signal({ width, height });
  const editor = {
    get drawing() {
      void revision.value;
      return drawing;
    },
    steps,
    dropped,
    merges,
    selection,
    view,
    stage,
    paint: (_x: number, _y: number): readonly number[] => [0.5, 0.5, 0.5, 1],
    layers: [] as { layer: number; offset: number }[],
    tool: signal("select"),
    attribute: signal("color"),
    hovered: signal(null),
    isolated: signal(null),
    pointer: signal(null),
    settings: settings(),
    picker: signal(null),
    hideHandles: signal(false),
    showReference: signal(true),
    showOutlines: signal(false),
    announcement: signal(""),
    toast: signal(null),
    draft: signal(null),
    opened: signal(0),
    awaitEdit: () => undefined,
    get activeLayer() {
      return drawing.items.find((item) => item.kind === "layer" && !item.locked) ?? null;
    },
    gesture,
    run(label: string, made: Outcome | null, merge = "") {
      if (!made) return false;
      steps.push(label);
      merges.push(merge);
      set((made as FakeOutcome).items, made);
      return true;
    },
    step: () => 0.001,
    say: () => undefined,
    artboardFromStage: () =>
      artboardFromStage(view.peek(), stage.peek().width, stage.peek().height),
    stageFromArtboard: () =>
      stageFromArtboard(view.peek(), stage.peek().width, stage.peek().height),
    engineLayer({ element: { range } }: Item): number | null {
      const within = (offset: number) => offset >= range.start && offset < range.end;
      return editor.layers.find(({ offset }) => within(offset))?.layer ?? null;
    },
    engine: {
      colors: async (_layer: number, xy: Float64Array) => {
        const out = new Float32Array(xy.length * 2);
        for (let k = 0; 2 * k < xy.length; k += 1)
          out.set(editor.paint(xy[2 * k], xy[2 * k + 1]), 4 * k);
        return out;
      },
    } as Partial<Engine> as Engine,
  };
  return editor as unknown as FakeEditor;
}

/** The places of a drawing that the tools can reach. */
export const placesIn = (drawing: Drawing, isolated: Handle | null = null): readonly Place[] =>
  placesOf({ drawing, isolated: signal(isolated) });

/** Motions of the view are jumps, because tests draw no frames. */
export function canvasOf(editor: Editor): Canvas {
  return new Canvas(editor, navigationOf(editor));
}

export function navigationOf(
  editor: Pick<Editor, "view" | "stage"> & { readonly drawing: { readonly artboard: Box } },
): Navigation {
  const page = globalThis as { window?: unknown };
  page.window ??= { matchMedia: () => ({ matches: true }) };
  return new Navigation(editor, () => 1);
}

export function near(a: Point, b: Point, slack = 1e-6): boolean {
  return Math.hypot(a[0] - b[0], a[1] - b[1]) <= slack;
}
