// Elements of a text: taken out and put in by edits, in lines of their own where siblings are.
import { blanksBefore } from "./attributes.js";
import type { Edit } from "./patch.js";
import type { ElementNode } from "./tree.js";

/** The line end and the blanks before an element, or "" where it does not begin its line. */
function lineBefore(text: string, element: ElementNode): string {
  const { start } = element.range;
  const from = blanksBefore(text, start, element.parent?.startTag.end ?? 0);
  return /\r?\n[ \t]*$/.exec(text.slice(from, start))?.[0] ?? "";
}

/** Takes an element away, with its line where it has one of its own. */
export function removeElement(text: string, element: ElementNode): Edit {
  const { start, end } = element.range;
  const isLastOfLine = /^[ \t]*(\r?\n|<)/.test(text.slice(end, end + 200));
  const at = isLastOfLine ? start - lineBefore(text, element).length : start;
  return { at, removed: text.slice(at, end), inserted: "" };
}

/** `edit`, and how far into what it inserts the new element begins. */
export interface Insertion {
  readonly edit: Edit;
  readonly lead: number;
}

/** Puts markup of one or more elements before a child of `parent`; null: behind the last. */
export function insertElement(
  text: string,
  parent: ElementNode,
  before: ElementNode | null,
  markup: string,
): Insertion {
  if (before) {
    const line = lineBefore(text, before);
    return { edit: { at: before.range.start, removed: "", inserted: markup + line }, lead: 0 };
  }
  const last = parent.children.at(-1);
  if (!last) return insertFirst(text, parent, markup);
  const line = lineBefore(text, last);
  return { edit: { at: last.range.end, removed: "", inserted: line + markup }, lead: line.length };
}

/** The line of a first child: the parent's, one step further in. */
function lineWithin(text: string, parent: ElementNode): string {
  const line = lineBefore(text, parent);
  if (line === "") return parent.parent ? "" : text.includes("\r\n") ? "\r\n" : "\n";
  const outer = parent.parent ? lineBefore(text, parent.parent) : "";
  const step =
    line.length > outer.length && line.startsWith(outer) && outer !== ""
      ? line.slice(outer.length)
      : "  ";
  return line + step;
}

function insertFirst(text: string, parent: ElementNode, markup: string): Insertion {
  const line = lineWithin(text, parent);
  const own = line === "" ? "" : lineBefore(text, parent) || line;
  if (parent.closesItself) {
    const at = parent.startTag.end - 2;
    const inserted = `>${line}${markup}${own}</${parent.name}>`;
    return { edit: { at, removed: "/>", inserted }, lead: 1 + line.length };
  }
  const { start, end } = parent.content;
  const at = blanksBefore(text, end, start);
  const inserted = line + markup + (at === end ? own : "");
  return { edit: { at, removed: "", inserted }, lead: line.length };
}
