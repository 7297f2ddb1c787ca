// How elements stand in the text: their lines and indentation, which new ones take over.
import type { Edit } from "../../../source/patch.js";
import type { ElementNode, Range } from "../../../source/tree.js";

const isBlank = (c: string | undefined) => c === " " || c === "\t";
const isBreak = (c: string | undefined) => c === "\n" || c === "\r";

/** The line break and the blanks before a place; "" where something else stands there on its line. */
export function leadOf(text: string, at: number): string {
  let from = at;
  while (isBlank(text[from - 1])) from -= 1;
  if (!isBreak(text[from - 1])) return "";
  from -= text[from - 1] === "\n" && text[from - 2] === "\r" ? 2 : 1;
  return text.slice(from, at);
}

/** Returns the range to remove with an element: its line if it has one, else the blanks before it. */
export function removalOf(text: string, { start, end }: Range): Range {
  const lead = leadOf(text, start);
  let behind = end;
  while (isBlank(text[behind])) behind += 1;
  if (lead !== "") {
    const isLast = behind === text.length || isBreak(text[behind]) || text.startsWith("</", behind);
    return isLast ? { start: start - lead.length, end: behind } : { start, end: behind };
  }
  let before = start;
  while (isBlank(text[before - 1])) before -= 1;
  return { start: before, end };
}

function rootOf(element: ElementNode): ElementNode {
  let root = element;
  while (root.parent) root = root.parent;
  return root;
}

function lineEnd(text: string): string {
  const at = text.search(/[\r\n]/);
  return at < 0 ? "\n" : text.startsWith("\r\n", at) ? "\r\n" : text[at];
}

/** By how much children of an element are indented beyond it. */
function indentStep(text: string, element: ElementNode): string {
  for (let outer: ElementNode | null = element; outer; outer = outer.parent) {
    const own = leadOf(text, outer.range.start).replace(/^[\r\n]+/, "");
    const child = outer.children.find((it) => leadOf(text, it.range.start) !== "");
    if (!child) continue;
    const inner = leadOf(text, child.range.start).replace(/^[\r\n]+/, "");
    return inner.startsWith(own) ? inner.slice(own.length) : "";
  }
  return "  ";
}

/** Returns the text before a child of an element: a line break and blanks, or "" in a file of one line. */
export function childLead(text: string, parent: ElementNode): string {
  for (const child of parent.children) {
    const lead = leadOf(text, child.range.start);
    if (lead !== "") return lead;
  }
  if (parent.children.length > 0) return "";
  const own = leadOf(text, parent.range.start);
  if (own === "" && parent !== rootOf(parent)) return "";
  const step = indentStep(text, parent);
  return (own === "" ? lineEnd(text) : own) + step;
}

/** Returns the text before the child of a new child, from that child's own lead. */
export function deeperLead(text: string, parent: ElementNode, lead: string): string {
  return lead === "" ? "" : lead + indentStep(text, parent);
}

/** A comment that ends the line of an element speaks of this element. */
function behindRemark(text: string, at: number): number {
  const found = /^[ \t]*<!--(?:(?!-->)[^\r\n])*-->(?=[ \t]*[\r\n])/.exec(text.slice(at, at + 400));
  return at + (found ? found[0].length : 0);
}

export interface Insertion {
  readonly edit: Edit;
  /** Where each piece begins in what the edit inserts. */
  readonly starts: readonly number[];
}

/** Puts elements (their text) into a parent, behind one of its children, or with null as the first. */
export function insertion(
  text: string,
  parent: ElementNode,
  after: ElementNode | null,
  pieces: readonly string[],
): Insertion {
  const lead = (after && leadOf(text, after.range.start)) || childLead(text, parent);
  const starts: number[] = [];
  const { content, startTag } = parent;
  let at = after ? behindRemark(text, after.range.end) : content.start;
  let end = at;
  let inserted = "";
  if (parent.closesItself) {
    end = startTag.end;
    at = end - 2;
    while (isBlank(text[at - 1]) || isBreak(text[at - 1])) at -= 1;
    inserted = ">";
  }
  for (const piece of pieces) {
    inserted += lead;
    starts.push(inserted.length);
    inserted += piece;
  }
  const rest = text.slice(content.start, content.end);
  const isEmpty = parent.closesItself || !/\S/.test(rest);
  if (isEmpty && lead !== "" && !/[\r\n]/.test(rest)) {
    inserted += leadOf(text, parent.range.start) || lineEnd(text);
  }
  if (parent.closesItself) inserted += `</${parent.name}>`;
  return { edit: { at, removed: text.slice(at, end), inserted }, starts };
}

/**
 * Returns the ranges to remove with elements, in order of the text; neighbours in one line are removed
 * together.
 */
export function removalsOf(text: string, elements: readonly ElementNode[]): Range[] {
  const runs: { start: number; end: number }[] = [];
  for (const { range } of elements) {
    const last = runs.at(-1);
    if (last && /^[ \t]*$/.test(text.slice(last.end, range.start))) last.end = range.end;
    else runs.push({ start: range.start, end: range.end });
  }
  return runs.map((run) => removalOf(text, run));
}
