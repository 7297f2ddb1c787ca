// Names of items: labels of Inkscape, or ids with all that refers to them.
import { attributeOf, INKSCAPE, prefixOf, setAttribute } from "../../../source/attributes.js";
import { encodeValue } from "../../../source/entities.js";
import { elementsOf } from "../../../source/nodes.js";
import type { Edit } from "../../../source/patch.js";
import { isSvg } from "../../../source/styles.js";
import type { AttributeNode, ElementNode } from "../../../source/tree.js";
import type { Drawing, Handle, Outcome } from "../../types.js";
import { freeId } from "./references.js";
import { outcomeOf } from "./together.js";

/** A name as an id: its letters and digits, begun by a letter. */
function asId(name: string): string {
  const kept = name
    .trim()
    .replace(/\s+/g, "-")
    .replace(/[^-.\w\u00c0-\uffff]/g, "");
  return /^[A-Za-z_\u00c0-\uffff]/.test(kept) || kept === "" ? kept : `_${kept}`;
}

function escaped(text: string): string {
  return text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
}

/** The text with each url(#from) and, in style sheets, #from as url(#to) and #to. */
function withId(text: string, from: string, to: string, isSheet: boolean): string {
  const url = new RegExp(`(url\\(\\s*(["']?)#)${escaped(from)}(?=\\2\\s*\\))`, "gi");
  const renamed = text.replace(url, (_, before: string) => before + to);
  if (!isSheet) return renamed;
  const selector = new RegExp(`#${escaped(from)}(?![-\\w\\u0080-\\uffff\\\\])(?=[^{}]*\\{)`, "g");
  return renamed.replace(selector, () => `#${to}`);
}

/** Returns an attribute's value after an id was renamed; the same value if it does not name the id. */
function referring({ local, namespace, value }: AttributeNode, from: string, to: string): string {
  const isHref = local === "href" && (namespace === "" || namespace.endsWith("/xlink"));
  if (isHref && value.trim() === `#${from}`) return `#${to}`;
  return value.includes("#") ? withId(value, from, to, false) : value;
}

/** The edits that make all that refers to an id refer to another. */
function referenceEdits(text: string, root: ElementNode, from: string, to: string): Edit[] {
  const edits: Edit[] = [];
  for (const element of elementsOf(root)) {
    for (const attribute of element.attributes) {
      const value = referring(attribute, from, to);
      if (value === attribute.value) continue;
      const { start, end } = attribute.valueRange;
      const inserted = encodeValue(value, attribute.quote);
      edits.push({ at: start, removed: text.slice(start, end), inserted });
    }
    if (element.local === "style" && isSvg(element)) {
      const { start, end } = element.content;
      const removed = text.slice(start, end);
      const inserted = withId(removed, from, to, true);
      if (inserted !== removed) edits.push({ at: start, removed, inserted });
    }
  }
  return edits;
}

/**
 * inkscape:label where the document knows Inkscape, else the id, made valid and unique; what refers
 * to an id follows. An empty name takes a label away, and an id that nothing refers to.
 */
export function rename(d: Drawing, h: Handle, name: string): Outcome | null {
  const element = d.item(h)?.element;
  if (!element) return null;
  const { text } = d;
  const label = { namespace: INKSCAPE, local: "label" };
  if (prefixOf(element, INKSCAPE) !== null) {
    return outcomeOf(setAttribute(text, element, label, name.trim() || null));
  }
  const before = attributeOf(element, "id")?.value;
  const wanted = asId(name);
  if (wanted === before) return null;
  const isFirst = before !== undefined && isFirstOfId(d.root, element, before);
  const references = (to: string) => (isFirst ? referenceEdits(text, d.root, before, to) : []);
  if (wanted === "") {
    const isReferred = before !== undefined && references(`${before}-`).length > 0;
    return isReferred ? null : outcomeOf(setAttribute(text, element, "id", null));
  }
  const to = freeId(wanted, new Set(d.ids.keys()));
  return outcomeOf([...setAttribute(text, element, "id", to), ...references(to)]);
}

/** Whether an id means this element: the first of an id counts. */
function isFirstOfId(root: ElementNode, element: ElementNode, id: string): boolean {
  for (const one of elementsOf(root)) {
    if (attributeOf(one, "id")?.value === id) return one === element;
  }
  return false;
}
