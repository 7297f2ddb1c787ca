// Items put into other containers, where they stay where they are seen.
import type { ElementNode } from "../../../source/tree.js";
import type { Drawing, Handle, Item, Outcome } from "../../types.js";
import { Draft } from "./draft.js";
import { elementBefore, innerFrame, layerOf, outermost } from "../structure/items.js";
import { reframing } from "../mapping.js";
import { isContainer } from "../structure/together.js";
import { carriedOut } from "../structure/stacking.js";

/** Whether an item may stand in a container, or with null in the outermost level. */
export function mayStandIn(item: Item, parent: Item | null): boolean {
  for (let outer = parent; outer; outer = outer.parent) if (outer === item) return false;
  if (!parent) return layerOf(item.parent) === null;
  if (!isContainer(parent)) return false;
  const isOfLayer = layerOf(item.parent) !== null;
  return isOfLayer === (layerOf(parent) !== null);
}

/** The text of items as they are to stand in a frame of the artboard; null where that cannot be. */
export function reframed(
  d: Drawing,
  draft: Draft,
  items: readonly Item[],
  parent: Item | null,
): string[] | null {
  const frame = innerFrame(d, parent);
  const pieces: string[] = [];
  for (const item of items) {
    const edits = item.parent === parent ? [] : reframing(d, item, frame);
    if (!edits) return null;
    pieces.push(draft.rewritten(item.element, edits));
  }
  return pieces;
}

/** Where child `index` of a container begins: behind this element. */
function elementBelow(
  siblings: readonly Item[],
  parent: ElementNode,
  index: number,
  isMoving: (element: ElementNode) => boolean,
): ElementNode | null {
  if (index < siblings.length) return elementBefore(siblings[Math.max(0, index)].element, isMoving);
  const last = siblings.at(-1)?.element ?? parent.children.at(-1) ?? null;
  return last && isMoving(last) ? elementBefore(last, isMoving) : last;
}

/**
 * Puts items before (below) child `index` of a container, or of the outermost level (null); they
 * stay where they are seen. Within layers there are curves, their uses and groups of them, outside
 * everything else: null where something does not belong there.
 */
export function moveInto(
  d: Drawing,
  handles: readonly Handle[],
  parent: Handle | null,
  index: number,
): Outcome | null {
  const container = parent === null ? null : d.item(parent);
  const items = outermost(d, handles);
  if (container === undefined || items.some((item) => !mayStandIn(item, container))) return null;
  const draft = new Draft(d.text);
  const pieces = reframed(d, draft, items, container);
  if (!pieces) return null;
  const elements = items.map(({ element }) => element);
  const siblings = container?.children ?? d.items;
  const into = container?.element ?? d.root;
  const after = elementBelow(siblings, into, index, (element) => elements.includes(element));
  return carriedOut(d, draft, [{ parent: into, after, elements, pieces }]);
}
