// Ids, and what refers to them: href="#id" and url(#id), in whatever attribute.
import { hrefOf, valueOf } from "../../../source/attributes.js";
import type { Edit } from "../../../source/patch.js";
import type { AttributeNode, ElementNode } from "../../../source/tree.js";

/** An element and all within, each before its children. */
export function* within(element: ElementNode): Generator<ElementNode> {
  const waiting = [element];
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    yield next;
    for (let i = next.children.length - 1; i >= 0; i -= 1) waiting.push(next.children[i]);
  }
}

/** The first element of each id. */
export function idsWithin(root: ElementNode): Map<string, ElementNode> {
  const found = new Map<string, ElementNode>();
  for (const element of within(root)) {
    const id = valueOf(element, "id");
    if (id !== undefined && !found.has(id)) found.set(id, element);
  }
  return found;
}

const URL_OF_ID = /(url\(\s*(?:["']|&quot;|&apos;)?#)([^"')&\s]+)/g;

/** Ids that the attributes of one element name. */
export function namedBy(element: ElementNode): string[] {
  const found: string[] = [];
  const href = hrefOf(element)?.value.trim() ?? "";
  if (href.startsWith("#")) found.push(href.slice(1));
  for (const { value } of element.attributes) {
    if (!value.includes("#")) continue;
    for (const [, , id] of value.matchAll(URL_OF_ID)) found.push(id);
  }
  return found;
}

/** Whether anything in a document names an id. */
export function isNamed(root: ElementNode, id: string): boolean {
  for (const element of within(root)) if (namedBy(element).includes(id)) return true;
  return false;
}

function isWithinAny(element: ElementNode, outers: ReadonlySet<ElementNode>): boolean {
  for (let it: ElementNode | null = element; it; it = it.parent) if (outers.has(it)) return true;
  return false;
}

/**
 * Returns the elements outside that the given elements refer to, directly or through others: outermost, in
 * order of the text.
 */
export function neededBy(
  elements: readonly ElementNode[],
  ids: ReadonlyMap<string, ElementNode>,
): ElementNode[] {
  const given = new Set(elements);
  const needed = new Set<ElementNode>();
  const waiting = [...elements];
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    for (const element of within(next)) {
      for (const id of namedBy(element)) {
        const target = ids.get(id);
        if (!target || isWithinAny(target, given) || isWithinAny(target, needed)) continue;
        needed.add(target);
        waiting.push(target);
      }
    }
  }
  return outermostOf(needed);
}

function outermostOf(elements: ReadonlySet<ElementNode>): ElementNode[] {
  return [...elements]
    .filter(({ parent }) => !parent || !isWithinAny(parent, elements))
    .sort((a, b) => a.range.start - b.range.start);
}

/** Gives ids within an element other names, there and where they are named within it. */
export function renaming(
  text: string,
  element: ElementNode,
  names: ReadonlyMap<string, string>,
): Edit[] {
  const edits: Edit[] = [];
  if (names.size === 0) return edits;
  const change = ({ valueRange: { start, end } }: AttributeNode, to: (raw: string) => string) => {
    const removed = text.slice(start, end);
    const inserted = to(removed);
    if (inserted !== removed) edits.push({ at: start, removed, inserted });
  };
  const renamed = (id: string) => names.get(id) ?? id;
  for (const it of within(element)) {
    const href = hrefOf(it);
    for (const attribute of it.attributes) {
      if (attribute.name === "id") change(attribute, renamed);
      else if (attribute.local === "href" && href) {
        change(attribute, (raw) => raw.replace(/^(\s*#)(\S+)/, (_, hash, id) => hash + renamed(id)));
      } else if (attribute.value.includes("#")) {
        change(attribute, (raw) => raw.replace(URL_OF_ID, (_, url, id) => url + renamed(id)));
      }
    }
  }
  return edits;
}

/** An id that is not taken yet, near to the one wished for; it is taken then. */
export function freeId(wish: string, taken: Set<string>): string {
  const stem = wish.replace(/-\d+$/, "") || "item";
  let id = wish;
  for (let i = 2; taken.has(id); i += 1) id = `${stem}-${i}`;
  taken.add(id);
  return id;
}

/** New names for those ids within an element that are taken; all its ids are taken then. */
export function freshNames(element: ElementNode, taken: Set<string>): Map<string, string> {
  const names = new Map<string, string>();
  for (const id of idsWithin(element).keys()) {
    const free = freeId(id, taken);
    if (free !== id) names.set(id, free);
  }
  return names;
}

/**
 * Returns the outermost elements, among those that are removed and all within them, that something else
 * refers to.
 */
export function namedFromOutside(root: ElementNode, going: readonly ElementNode[]): ElementNode[] {
  const gone = new Set(going.flatMap((element) => [...within(element)]));
  const ids = idsWithin(root);
  const kept = new Set<ElementNode>();
  const look = (element: ElementNode) => {
    for (const id of namedBy(element)) {
      const target = ids.get(id);
      if (!target || !gone.has(target) || kept.has(target)) continue;
      kept.add(target);
      for (const inner of within(target)) look(inner);
    }
  };
  for (const element of within(root)) if (!gone.has(element)) look(element);
  return outermostOf(kept);
}
