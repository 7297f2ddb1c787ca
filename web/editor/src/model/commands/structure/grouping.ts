// Groups made of items.
import type { ElementNode } from "../../../source/tree.js";
import type { Drawing, Handle, Item, Outcome } from "../../types.js";
import { Draft } from "../curves/draft.js";
import { outermost, siblingsOf } from "./items.js";
import { childLead, deeperLead, leadOf } from "./layout.js";
import { opening, svgName } from "../markup.js";
import { mayStandIn, reframed } from "../curves/moving.js";
import { carriedOut } from "./stacking.js";

/** Puts items into a new group, which stands where the topmost of them stood. */
export function group(d: Drawing, handles: readonly Handle[]): Outcome | null {
  const items = outermost(d, handles);
  const top = items.at(-1);
  if (!top || items.some((item) => !mayStandIn(item, top.parent))) return null;
  const siblings = siblingsOf(d, top);
  // A group around what stands in <defs> would be seen nowhere.
  if (!siblings.includes(top) || isInDefs(top.element)) return null;
  const first = siblings.indexOf(items[0]);
  const isRun = items.every((item, i) => item === siblings[first + i]);
  return isRun ? wrapped(d, items) : gathered(d, items, top);
}

function isInDefs({ parent }: ElementNode): boolean {
  return parent !== null && (parent.local === "defs" || isInDefs(parent));
}

/** Siblings in a row stay where they are: a start tag and an end tag go around them. */
function wrapped(d: Drawing, items: readonly Item[]): Outcome | null {
  const { text } = d;
  const [first, last] = [items[0].element, items[items.length - 1].element];
  const parent = first.parent as ElementNode;
  const lead = leadOf(text, first.range.start);
  const inner = deeperLead(text, parent, lead);
  const draft = new Draft(text);
  const start = draft.replace(
    { start: first.range.start, end: first.range.start },
    `${opening(parent, "g", [])}>${inner}`,
  );
  for (const { element } of items.slice(1)) {
    const own = leadOf(text, element.range.start);
    if (own === "") continue;
    const deeper = deeperLead(text, parent, own);
    draft.replace({ start: element.range.start - own.length, end: element.range.start }, deeper);
  }
  const end = last.range.end;
  draft.replace({ start: end, end }, `${lead}</${svgName(parent, "g")}>`);
  draft.selectWithin(start, 0);
  return draft.outcome();
}

function gathered(d: Drawing, items: readonly Item[], top: Item): Outcome | null {
  const draft = new Draft(d.text);
  const pieces = reframed(d, draft, items, top.parent);
  if (!pieces) return null;
  const parent = top.element.parent as ElementNode;
  const lead = leadOf(d.text, top.element.range.start) || childLead(d.text, parent);
  const inner = deeperLead(d.text, parent, lead);
  const end = `${lead}</${svgName(parent, "g")}>`;
  const markup = `${opening(parent, "g", [])}>${pieces.map((it) => inner + it).join("")}${end}`;
  const elements = items.map(({ element }) => element);
  let after: ElementNode | null = top.element;
  while (after && elements.includes(after)) {
    after = parent.children[parent.children.indexOf(after) - 1] ?? null;
  }
  return carriedOut(d, draft, [{ parent, after, elements, pieces: [markup] }]);
}
