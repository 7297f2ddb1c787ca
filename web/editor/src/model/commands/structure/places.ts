// Where new elements go, and layers made for them.
import { sfName } from "../../../source/attributes.js";
import type { ElementNode } from "../../../source/tree.js";
import type { Drawing, Item } from "../../types.js";
import type { Draft } from "../curves/draft.js";
import { isShown, layerOf } from "./items.js";
import { childLead, deeperLead, insertion } from "./layout.js";
import { opening, svgName } from "../markup.js";
import { isContainer } from "./together.js";

/** Where new elements go: into a parent, behind one of its children; the frame is the item's. */
export interface Place {
  readonly parent: ElementNode;
  readonly after: ElementNode | null;
  readonly item: Item | null;
}

/** At the end of a layer or a group in it, or behind a curve. */
export function innerPlace(target: Item): Place {
  const item = isContainer(target) || !target.parent ? target : target.parent;
  const after = item === target ? (item.element.children.at(-1) ?? null) : target.element;
  return { parent: item.element, after, item };
}

/**
 * Where layers and groups go that are put on top of an item, or into it where it is a group;
 * on top of everything where it stands in <defs> alone. null: the outermost element is a layer.
 */
export function outerPlace(d: Drawing, target: Item | null): Place | null {
  const layer = layerOf(target);
  const item = target && isShown(d, target) ? (layer ?? target) : null;
  if (item?.kind === "group") {
    return { parent: item.element, after: item.element.children.at(-1) ?? null, item };
  }
  if (item) {
    if (!item.element.parent) return null;
    return { parent: item.element.parent, after: item.element, item: item.parent };
  }
  const top = d.items.at(-1)?.element;
  if (top === d.root) return null;
  const after = top?.parent === d.root ? top : (d.root.children.at(-1) ?? null);
  return { parent: d.root, after, item: null };
}

/** Whether an item, or something around it, is locked or hidden. */
const isOff = (item: Item | null): boolean => item !== null && (item.locked || item.hidden || isOff(item.parent));

/** Returns whether a layer is empty and can be drawn into: a shape needs no new layer then. */
export function isFreeLayer(layer: Item | null): boolean {
  return layer?.kind === "layer" && layer.children.length === 0 && !isOff(layer);
}

/** Returns the place of a new layer above another one; on top of everything if that place is locked or hidden. */
export function placeAbove(d: Drawing, layer: Item | null): Place | null {
  return outerPlace(d, layer && isOff(layer.parent) ? null : layer);
}

/** A layer of these children, which are selected. */
export function newLayer(
  d: Drawing,
  draft: Draft,
  { parent, after }: Place,
  pieces: readonly string[],
): void {
  const lead = childLead(d.text, parent);
  const inner = deeperLead(d.text, parent, lead);
  let markup = `${opening(parent, "g", [[sfName(parent, "diffuse"), "true"]])}>`;
  const starts = pieces.map((piece) => {
    markup += inner;
    const at = markup.length;
    markup += piece;
    return at;
  });
  markup += `${lead}</${svgName(parent, "g")}>`;
  const { edit, starts: [begin] } = insertion(d.text, parent, after, [markup]);
  draft.add([edit]);
  for (const at of starts) draft.selectWithin(edit, begin + at);
}
