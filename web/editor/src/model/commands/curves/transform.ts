// Items moved, scaled, turned and mirrored.
import { composed, inverted, translation } from "../../../geometry/affine.js";
import type { Affine } from "../../../geometry/affine.js";
import type { Edit } from "../../../source/patch.js";
import { ownTransform } from "../../building.js";
import type { Drawing, Handle, Item, Outcome } from "../../types.js";
import { Draft } from "./draft.js";
import { outerFrame, outermost, usePlace } from "../structure/items.js";
import { artboardMapping, conjugate, setTransform } from "../mapping.js";

/**
 * Maps items by a map of the artboard: curves' points, or the transform of layers, groups, uses.
 * Uses show what they copy as it is then; null: something is flattened by what is around it.
 */
export function transform(
  d: Drawing,
  handles: readonly Handle[],
  map: Affine,
  step: number,
): Outcome | null {
  const draft = new Draft(d.text);
  const items = new Set(outermost(d, handles));
  for (const item of items) {
    const target = item.kind === "use" && item.target && items.has(item.target) ? item.target : null;
    const edits = target
      ? besidesItsTarget(d, item, target, map, step)
      : artboardMapping(d, item, map, step);
    if (!edits) return null;
    draft.add(edits);
  }
  return draft.outcome();
}

/**
 * Returns the edits of a <use> whose target is mapped too: it shows the mapped target, and must not map it
 * twice.
 */
function besidesItsTarget(
  d: Drawing,
  use: Item,
  target: Item,
  map: Affine,
  step: number,
): Edit[] | null {
  const [outer, around] = [outerFrame(use), outerFrame(target)];
  const [back, aroundBack, mapBack] = [inverted(outer), inverted(around), inverted(map)];
  if (!back || !aroundBack || !mapBack) return null;
  const [x, y] = usePlace(use.element);
  const unmapped = conjugate(aroundBack, mapBack, around);
  const shown = conjugate(translation(x, y), unmapped, translation(-x, -y));
  const mapped = composed(conjugate(back, map, outer), composed(ownTransform(use.element), shown));
  return setTransform(d, use.element, mapped, step);
}
