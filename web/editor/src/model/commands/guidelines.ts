// Edits of the guides, as Inkscape writes them.
import { numberText } from "../../geometry/path.js";
import { declare, nameWithin, setAttribute, SODIPODI, valueOf } from "../../source/attributes.js";
import type { Edit } from "../../source/patch.js";
import type { ElementNode } from "../../source/tree.js";
import {
  coordinatesOf,
  GuideFrame,
  guidelinesOf,
  LOCKED,
  LOCK_GUIDES,
  SHOW_GUIDES,
  type GuideAxis,
  type Guideline,
} from "../guidelines.js";
import type { Drawing, Handle, Outcome } from "../types.js";
import { insertion, removalsOf } from "./structure/layout.js";
import { removal } from "./structure/removal.js";
import { outcomeOf } from "./structure/together.js";

const NORMALS = ["1,0", "0,1"] as const;

/** Shows the guides, where they are hidden. */
function shownEdits({ text }: Drawing, view: ElementNode, shown: boolean): Edit[] {
  return setAttribute(text, view, SHOW_GUIDES, String(shown));
}

/** Adds a guide, behind all others. Hidden guides show again. @param at its place on the artboard */
export function addGuide(d: Drawing, axis: GuideAxis, at: number): Outcome | null {
  const { view, shown } = guidelinesOf(d);
  const frame = new GuideFrame(d.root);
  const coordinate = frame.coordinate(axis, at);
  if (!Number.isFinite(coordinate)) return null;
  const written = numberText(coordinate, frame.step);
  const position = axis === 0 ? `${written},0` : `0,${written}`;
  const name = nameWithin(view ?? d.root, SODIPODI, "guide");
  const guide = `<${name} position="${position}" orientation="${NORMALS[axis]}"/>`;
  if (view) {
    const { edit } = insertion(d.text, view, view.children.at(-1) ?? null, [guide]);
    return outcomeOf([edit, ...(shown ? [] : shownEdits(d, view, true))]);
  }
  const holder = nameWithin(d.root, SODIPODI, "namedview");
  const { edit } = insertion(d.text, d.root, null, [`<${holder}>${guide}</${holder}>`]);
  return outcomeOf([...declare(d.text, d.root, SODIPODI), edit]);
}

/** Moves a guide that is not slanted. @param at its place on the artboard */
export function moveGuide(d: Drawing, handle: Handle, at: number): Outcome | null {
  const guide = guidelinesOf(d).all.find((one) => one.handle === handle);
  if (!guide || guide.axis === null) return null;
  const { axis } = guide;
  return outcomeOf(placed(d, new GuideFrame(d.root), guide, (of) => (of === axis ? at : null)));
}

/** Edits that give coordinates new places on the artboard; null: it stays as it is written. */
function placed(
  d: Drawing,
  frame: GuideFrame,
  { element, axis }: Guideline,
  place: (axis: GuideAxis) => number | null,
): Edit[] {
  const written = coordinatesOf(element);
  for (const k of [0, 1] as const) {
    const at = written.length > 1 || k === axis ? place(k) : null;
    const coordinate = at === null ? NaN : frame.coordinate(k, at);
    if (!Number.isFinite(coordinate)) continue;
    written[Math.min(k, written.length - 1)] = numberText(coordinate, frame.step);
  }
  return setAttribute(d.text, element, "position", written.join(","));
}

/**
 * Returns the edits that keep all guides where they are on the drawing when the page changes: positions count from
 * its lower left corner.
 * @param root of the document after the change
 */
export function guidesKept(d: Drawing, root: ElementNode): Edit[] {
  const [before, after] = [new GuideFrame(d.root), new GuideFrame(root)];
  return guidelinesOf(d).all.flatMap((guide) =>
    placed(d, after, guide, (axis) => {
      const at = guide.point[axis];
      const moved = after.coordinate(axis, at) - before.coordinate(axis, at);
      return Math.abs(moved) > after.step ? at : null;
    }),
  );
}

/** Removes guides, and with the last one what only held them. */
export function removeGuides(d: Drawing, guides: readonly Guideline[]): Outcome | null {
  const { view } = guidelinesOf(d);
  if (!view || guides.length === 0) return null;
  const elements = guides.map(({ element }) => element);
  const going = new Set(elements);
  const isBare = view.attributes.length === 0 && view.children.every((one) => going.has(one));
  if (isBare) return outcomeOf([removal(d.text, view)]);
  return outcomeOf(
    removalsOf(d.text, elements).map(({ start, end }) => ({
      at: start,
      removed: d.text.slice(start, end),
      inserted: "",
    })),
  );
}

export function setGuidesShown(d: Drawing, shown: boolean): Outcome | null {
  const { view } = guidelinesOf(d);
  return view && outcomeOf(shownEdits(d, view, shown));
}

/** Locks or unlocks all guides. Inkscape marks each of them, too. */
export function setGuidesLocked(d: Drawing, locked: boolean): Outcome | null {
  const { view, all } = guidelinesOf(d);
  if (!view) return null;
  const marked = all.filter(({ element }) => valueOf(element, LOCKED) !== undefined);
  return outcomeOf([
    ...setAttribute(d.text, view, LOCK_GUIDES, String(locked)),
    ...marked.flatMap(({ element }) => setAttribute(d.text, element, LOCKED, String(locked))),
  ]);
}
