// Copies of items beside themselves.
import { translation } from "../../../geometry/affine.js";
import type { Point } from "../../../geometry/affine.js";
import type { ElementNode } from "../../../source/tree.js";
import type { Drawing, Handle, Item, Outcome } from "../../types.js";
import { Draft } from "../curves/draft.js";
import { isShown, outermost } from "./items.js";
import { insertion } from "./layout.js";
import { artboardMapping, finestStep } from "../mapping.js";
import { freshNames, renaming } from "./references.js";

/** Copies on top of the items, moved by a vector of the artboard; not of what <defs> alone holds. */
export function duplicate(d: Drawing, handles: readonly Handle[], by: Point): Outcome | null {
  const items = outermost(d, handles).filter((item) => isShown(d, item));
  const map = translation(by[0], by[1]);
  const taken = new Set(d.ids.keys());
  const names = new Map(items.flatMap(({ element }) => [...freshNames(element, taken)]));
  const draft = new Draft(d.text);
  for (const run of familiesOf(items)) {
    const pieces: string[] = [];
    for (const item of run) {
      const moved = artboardMapping(d, item, map, finestStep(d));
      if (!moved) return null;
      pieces.push(draft.rewritten(item.element, [...renaming(d.text, item.element, names), ...moved]));
    }
    const last = run[run.length - 1].element;
    const { edit, starts } = insertion(d.text, last.parent as ElementNode, last, pieces);
    draft.add([edit]);
    for (const start of starts) draft.selectWithin(edit, start);
  }
  return draft.outcome();
}

/** Items by their parents. */
function familiesOf(items: readonly Item[]): Item[][] {
  const families = new Map<ElementNode | null, Item[]>();
  for (const item of items) {
    const { parent } = item.element;
    families.set(parent, [...(families.get(parent) ?? []), item]);
  }
  return [...families.values()];
}

