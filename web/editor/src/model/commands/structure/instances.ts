// Instances of items, and copies of their own.
import { composed, inverted, mappedVector, translation } from "../../../geometry/affine.js";
import type { Affine, Point } from "../../../geometry/affine.js";
import { prefixOf, setAttribute, valueOf, XLINK } from "../../../source/attributes.js";
import type { Edit } from "../../../source/patch.js";
import type { ElementNode } from "../../../source/tree.js";
import { ownTransform } from "../../building.js";
import type { Drawing, Handle, Item, Outcome, UseItem } from "../../types.js";
import { duplicate } from "./duplicate.js";
import { Draft } from "../curves/draft.js";
import { innerFrame, isShown, usePlace } from "./items.js";
import { insertion } from "./layout.js";
import { finestStep, setTransform, transformText } from "../mapping.js";
import { opening, svgName } from "../markup.js";
import { outerPlace } from "./places.js";
import type { Place } from "./places.js";
import { freeId, freshNames, renaming } from "./references.js";

/**
 * Makes a <use> of an item, on top of it and moved by a vector of the artboard; from a <use>, a second one.
 * For an item that stands only in <defs>, the <use> goes on top of everything.
 */
export function makeInstance(d: Drawing, h: Handle, by: Point): Outcome | null {
  const item = d.item(h);
  if (!item || item.kind === "reference") return null;
  if (item.kind === "use") return duplicate(d, [h], by);
  const { element } = item;
  const place = isShown(d, item) ? besides(item) : item.kind === "curve" ? null : outerPlace(d, null);
  const back = place && inverted(innerFrame(d, place.item));
  if (!back) return null;
  const draft = new Draft(d.text);
  const given = valueOf(element, "id");
  const id = given ?? freeId(item.kind, new Set(d.ids.keys()));
  if (given === undefined) draft.add(setAttribute(d.text, element, "id", id));
  const xlink = prefixOf(place.parent, XLINK);
  const [x, y] = mappedVector(back, by);
  const markup = opening(place.parent, "use", [
    [xlink === null ? "href" : `${xlink}:href`, `#${id}`],
    ["transform", transformText(translation(x, y), 1, finestStep(d))],
  ]);
  const { edit, starts } = insertion(d.text, place.parent, place.after, [`${markup}/>`]);
  draft.add([edit]);
  draft.selectWithin(edit, starts[0]);
  return draft.outcome();
}

function besides({ element, parent }: Item): Place | null {
  return element.parent && { parent: element.parent, after: element, item: parent };
}

/** A <use> becomes a copy of its own. null: it shows nothing that could be copied. */
export function makeUnique(d: Drawing, h: Handle): Outcome | null {
  const item = d.item(h);
  const target = item?.kind === "use" ? item.target : null;
  if (!item || item.kind !== "use" || !target || isWithin(item.element, target.element)) return null;
  if (target.element.local !== "g" && target.kind !== "curve" && target.kind !== "stroke") {
    if (target.kind !== "use") return null;
  }
  const { element } = item;
  const place = composed(ownTransform(element), translation(...usePlace(element)));
  const draft = new Draft(d.text);
  const markup = copyOf(d, draft, item, target, place);
  const edit = draft.replace(element.range, markup);
  draft.selectWithin(edit, 0);
  return draft.outcome();
}

function isWithin(element: ElementNode, outer: ElementNode): boolean {
  for (let it: ElementNode | null = element; it; it = it.parent) if (it === outer) return true;
  return false;
}

/** Attributes of a <use> that place it or say what it shows. */
const OF_USE = new Set(["x", "y", "width", "height", "transform", "href", "id"]);

function copyOf(d: Drawing, draft: Draft, use: UseItem, target: Item, place: Affine): string {
  const { element } = use;
  const id = valueOf(element, "id");
  const rest = element.attributes.filter(({ local }) => !OF_USE.has(local));
  const taken = new Set(d.ids.keys());
  if (rest.length === 0) {
    return draft.rewritten(target.element, placedEdits(d, target, place, id, taken));
  }
  const names = freshNames(target.element, taken);
  const copy = draft.rewritten(target.element, renaming(d.text, target.element, names));
  const parent = element.parent as ElementNode;
  const written = rest.map(({ range }) => ` ${d.text.slice(range.start, range.end)}`).join("");
  const start = opening(parent, "g", [
    ["id", id ?? null],
    ["transform", transformText(place, 1, finestStep(d))],
  ]);
  return `${start}${written}>${copy}</${svgName(parent, "g")}>`;
}

/** The target itself, with the place of its <use> in its transform, and the id of this, if any. */
function placedEdits(
  d: Drawing,
  target: Item,
  place: Affine,
  id: string | undefined,
  taken: Set<string>,
): Edit[] {
  const { element } = target;
  const names = freshNames(element, taken);
  const old = valueOf(element, "id");
  if (old !== undefined && id !== undefined) names.set(old, id);
  const edits = renaming(d.text, element, names);
  if (old === undefined && id !== undefined) edits.push(...setAttribute(d.text, element, "id", id));
  const placed = composed(place, ownTransform(element));
  return [...edits, ...setTransform(d, element, placed, finestStep(d))];
}

