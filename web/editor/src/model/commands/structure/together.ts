// Patches of one text as one, and what selections mean.
import { patchOf } from "../../../source/attributes.js";
import type { Edit, Patch } from "../../../source/patch.js";
import type { Drawing, Handle, Item, Outcome, Selection } from "../../types.js";

/** Edits as what a command makes; null: there are none. @throws RangeError where they overlap */
export function outcomeOf(edits: readonly Edit[]): Outcome | null {
  return edits.length === 0 ? null : { patch: patchOf(edits) };
}

/** Where a place of the text after `own` is after `all`, which has those edits among others. */
function placeAfter(at: number, own: Patch, all: Patch): number {
  let ownShift = 0;
  let before = at;
  for (const edit of own) {
    const start = edit.at + ownShift;
    if (at < start) break;
    if (at < start + edit.inserted.length) return placeWithin(edit, at - start, all);
    ownShift += edit.inserted.length - edit.removed.length;
    before = at - ownShift;
  }
  let shift = 0;
  for (const edit of all) {
    if (edit.at + edit.removed.length > before) break;
    shift += edit.inserted.length - edit.removed.length;
  }
  return before + shift;
}

/** Where character `offset` of what an edit inserts is after `all`. */
function placeWithin(own: Edit, offset: number, all: Patch): number {
  const isOwn = (edit: Edit) => edit === own;
  const isSame = (edit: Edit) => edit.at === own.at && edit.inserted === own.inserted;
  const found = all.find(isOwn) ?? all.find(isSame);
  let shift = 0;
  for (const edit of all) {
    if (edit === found) break;
    shift += edit.inserted.length - edit.removed.length;
  }
  return own.at + shift + offset;
}

/** Patches of one text, side by side, as one. @throws RangeError where they overlap */
export function together(outcomes: readonly (Outcome | null)[]): Outcome | null {
  const some = outcomes.filter((outcome) => outcome !== null);
  if (some.length < 2) return some[0] ?? null;
  const patch = patchOf(some.flatMap((outcome) => outcome.patch));
  const select = some.flatMap((outcome) =>
    (outcome.select ?? []).map((one) => ({
      ...one,
      at: placeAfter(one.at, outcome.patch, patch),
    })),
  );
  return select.length > 0 ? { patch, select } : { patch };
}

export function isContainer(item: Item): boolean {
  return item.kind === "layer" || item.kind === "group";
}

/** Handles of curves that a selection means, each once: of containers all within. */
export function curvesOf(d: Drawing, selection: Selection): readonly Handle[] {
  const found = new Set<Handle>();
  const add = (item: Item) => {
    if (item.kind === "curve" || item.kind === "stroke") found.add(item.handle);
    item.children.forEach(add);
  };
  for (const { handle } of selection) {
    const item = d.item(handle);
    if (item) add(item);
  }
  return [...found];
}
