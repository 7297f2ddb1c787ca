// Commands that go by the photo on the drawing: colours, blur and edges are taken from it, by workers.
import { effect } from "@preact/signals";
import type { DrawingEditor } from "../app/editor.js";
import { chosenCurves } from "../app/selected.js";
import { isOutOfReach } from "../canvas/places.js";
import { isHidden } from "../model/standing.js";
import { complaintOf } from "../engine/complaint.js";
import { pageHost } from "../engine/page-host.js";
import { fitToPhoto, snapToPhoto as movedToEdges } from "../engine/photo-trace.js";
import type { FitWish } from "../engine/types.js";
import { composed, inverted, lengthScale } from "../geometry/affine.js";
import { mappedPath } from "../geometry/cubic.js";
import { nodePath } from "../geometry/natural.js";
import { setFittedBlur, setFittedColors, setPoints, together } from "../model/commands/index.js";
import type { CurveItem, Outcome } from "../model/types.js";
import * as en from "../strings/en.js";
import { beginningsOf, fittedRadii, rowsOf, type Beginnings } from "./blur-work.js";
import { hasPhoto, laidPhoto, type LaidPhoto } from "./laid-photo.js";

const words = en.photo;
/** Pixels of the longer side: the library uses no more, and edges are found well at this size. */
const MOST_FITTED = 1024;
const MOST_SNAPPED = 1600;
/** How far curves go to an edge, CSS pixels at the present zoom; and at least, and at most, photo pixels. */
const REACH = 16;
const LEAST_REACH = 3;
const MOST_REACH = 24;

const free = (editor: DrawingEditor, items: readonly CurveItem[]) =>
  items.filter((item) => !isOutOfReach(editor, item) && !isHidden(item));

/** The curves of layers that are chosen, or all where nothing is. */
function curvesToFit(editor: DrawingEditor): CurveItem[] {
  const all = [...editor.drawing.all()].filter((item) => item.kind === "curve");
  const chosen = editor.selection.peek().length > 0 ? chosenCurves(editor) : all;
  return free(editor, chosen as readonly CurveItem[]).filter(({ kind }) => kind === "curve");
}

/** The error for a user who edits meanwhile. */
class Changed extends Error {
  constructor() {
    super(words.changed);
  }
}

/** Runs it with a way to stop it; an edit stops it too. One at a time. */
async function withTask(
  editor: DrawingEditor,
  text: string,
  work: (signal: AbortSignal) => Promise<void>,
): Promise<void> {
  editor.task.peek()?.stop();
  const own = new AbortController();
  const task = { text, stop: () => own.abort(new Error(words.stopped)) };
  const { revision } = editor.drawing;
  const unwatch = effect(() => {
    if (editor.drawing.revision !== revision) own.abort(new Changed());
  });
  editor.task.value = task;
  editor.announcement.value = text;
  try {
    await work(own.signal);
  } catch (error) {
    editor.say(complaintOf(error));
  } finally {
    unwatch();
    if (editor.task.peek() === task) editor.task.value = null;
  }
}

/** The photo, or words that there is none. */
async function photoFor(editor: DrawingEditor, most: number, signal: AbortSignal): Promise<LaidPhoto> {
  const photo = await laidPhoto(editor.drawing, most);
  signal.throwIfAborted();
  if (!photo) throw new Error(en.tools.photoUnread);
  return photo;
}

const offsetOf = ({ element }: CurveItem) => element.range.start;

/** One step of undo, and what was done in words. */
function keep(
  editor: DrawingEditor,
  label: string,
  made: readonly (Outcome | null)[],
  done: (curves: number) => string,
  same: string,
): void {
  const some = made.filter((one) => one !== null);
  editor.task.value = null;
  if (some.length === 0) return editor.say(same);
  if (editor.run(label, together(some))) {
    editor.say(done(some.length), { label: en.commands.undo, run: () => editor.undo() });
  }
}

/** Whether there is a photo, and curves to be changed by it; else says what is missing. */
function isReady(editor: DrawingEditor, items: readonly CurveItem[], none: string): boolean {
  const { readOnly } = editor.drawing;
  const missing = readOnly ?? (!hasPhoto(editor.drawing) ? words.noPhoto : items.length === 0 ? none : null);
  if (missing !== null) editor.say(missing);
  return missing === null;
}

function wishOf(editor: DrawingEditor, items: readonly CurveItem[], photo: LaidPhoto): Omit<FitWish, "fits" | "radii"> {
  return { text: editor.drawing.text, photo: photo.pixels, offsets: items.map(offsetOf) };
}

/** The stops of the chosen curves, or of all, take the colours with which the drawing looks most like the photo. */
export async function colorsFromPhoto(editor: DrawingEditor): Promise<void> {
  const items = curvesToFit(editor);
  if (!isReady(editor, items, words.noCurves)) return;
  await withTask(editor, words.fittingColors, async (signal) => {
    const photo = await photoFor(editor, MOST_FITTED, signal);
    const wish: FitWish = { ...wishOf(editor, items, photo), fits: "colors", radii: [] };
    const fitted = await fitToPhoto(pageHost, wish, editor.engine.images, signal);
    const byOffset = new Map(fitted.map((one) => [one.offset, one.colors]));
    const made = items.map((item) => {
      const colors = byOffset.get(offsetOf(item));
      return colors ? setFittedColors(editor.drawing, item, colors) : null;
    });
    keep(editor, words.colors, made, words.colorsDone, words.colorsSame);
  });
}

/** The chosen curves, or all, take the blur with which the drawing looks most like the photo. */
export async function blurFromPhoto(editor: DrawingEditor): Promise<void> {
  const items = curvesToFit(editor);
  if (!isReady(editor, items, words.noCurves)) return;
  await withTask(editor, words.fittingBlur, async (signal) => {
    const photo = await photoFor(editor, MOST_FITTED, signal);
    const back = inverted(photo.pixelFromArtboard);
    if (!back) return;
    const placed = { ...photo.pixels, artboardFromPixel: back };
    const begins: Beginnings = new Map(
      items.map((item) => [offsetOf(item), beginningsOf(editor.drawing, item, placed)]),
    );
    const radii = items.flatMap((item) => rowsOf(item, begins.get(offsetOf(item)) ?? null));
    const wish: FitWish = { ...wishOf(editor, items, photo), fits: "blur", radii };
    const fitted = await fitToPhoto(pageHost, wish, editor.engine.images, signal);
    const byOffset = new Map(fitted.map((one) => [one.offset, one]));
    const made = items.map((item) => {
      const begun = begins.get(offsetOf(item));
      const found = byOffset.get(offsetOf(item));
      const perUnit = lengthScale(composed(photo.pixelFromArtboard, item.artboardFromItem));
      return begun && found ? setFittedBlur(editor.drawing, item, fittedRadii(begun, found.factor, perUnit)) : null;
    });
    keep(editor, words.blur, made, words.blurDone, words.blurSame);
  });
}

/** The nodes of the chosen curves go to the photo's edges. */
export async function snapToPhoto(editor: DrawingEditor): Promise<void> {
  const items = free(editor, chosenCurves(editor));
  if (!isReady(editor, items, words.chooseCurves)) return;
  await withTask(editor, words.snapping, async (signal) => {
    const photo = await photoFor(editor, MOST_SNAPPED, signal);
    const perUnit = lengthScale(photo.pixelFromArtboard);
    const wished = (REACH / editor.view.peek().zoom) * perUnit;
    const reach = Math.min(Math.max(wished, LEAST_REACH), MOST_REACH);
    const places = items.flatMap((item) => {
      const pixelFromItem = composed(photo.pixelFromArtboard, item.artboardFromItem);
      const back = inverted(pixelFromItem);
      return back ? item.paths.map((path, index) => ({ item, index, path: mappedPath(pixelFromItem, nodePath(path)), back })) : [];
    });
    const wish = { photo: photo.pixels, paths: places.map(({ path }) => path), reach };
    const moved = await movedToEdges(pageHost, wish, signal);
    const made = items.map((item) => {
      const own = places.flatMap(({ item: of, index, back }, i) => {
        const path = of === item ? moved[i] : null;
        return path ? [[index, mappedPath(back, path)] as const] : [];
      });
      return setPoints(editor.drawing, item.handle, new Map(own), editor.step(item));
    });
    keep(editor, words.snap, made, words.snapDone, words.noEdges);
  });
}

export function toggleDifference(editor: DrawingEditor): void {
  const { showDifference, drawing } = editor;
  if (!showDifference.peek() && !hasPhoto(drawing)) return editor.say(words.noPhoto);
  showDifference.value = !showDifference.peek();
}
