// Attributes of elements: found, and set by edits that keep how the file is written.
import { encodeValue } from "./entities.js";
import { declaredPrefix } from "./parse.js";
import type { Edit, Patch } from "./patch.js";
import type { AttributeNode, ElementNode } from "./tree.js";

export const SFUMATO = "urn:sfumato:1";
export const SVG = "http://www.w3.org/2000/svg";
export const XLINK = "http://www.w3.org/1999/xlink";
export const INKSCAPE = "http://www.inkscape.org/namespaces/inkscape";
export const SODIPODI = "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd";

/** The prefix that files use for a namespace, where it is free. */
const USUAL_PREFIX: Readonly<Record<string, string>> = {
  [SFUMATO]: "sf",
  [XLINK]: "xlink",
  [INKSCAPE]: "inkscape",
  [SODIPODI]: "sodipodi",
};

/** A name without a prefix, or one of a namespace. */
export type AttributeName = string | { readonly namespace: string; readonly local: string };

/** A name of Sfumato's. */
export function sf(local: string): AttributeName {
  return { namespace: SFUMATO, local };
}

export function attributeOf(element: ElementNode, name: AttributeName): AttributeNode | undefined {
  const namespace = typeof name === "string" ? "" : name.namespace;
  const local = typeof name === "string" ? name : name.local;
  return element.attributes.find((a) => a.local === local && a.namespace === namespace);
}

export function valueOf(element: ElementNode, name: AttributeName): string | undefined {
  return attributeOf(element, name)?.value;
}

/** Returns whether an element has an attribute of Sfumato's. The version alone does not count. */
export function isOfSfumato({ attributes }: ElementNode): boolean {
  return attributes.some(({ namespace, local }) => namespace === SFUMATO && local !== "version");
}

/** href, or else xlink:href. */
export function hrefOf(element: ElementNode): AttributeNode | undefined {
  return attributeOf(element, "href") ?? attributeOf(element, { namespace: XLINK, local: "href" });
}

/** Whether an element is SVG's; Illustrator writes an entity for the namespace, others none. */
export function isSvg({ name, local, namespace }: ElementNode): boolean {
  if (namespace === SVG) return true;
  return name === local && (namespace === "" || namespace.startsWith("&"));
}

export function rootOf(element: ElementNode): ElementNode {
  let root = element;
  while (root.parent) root = root.parent;
  return root;
}

/** Returns the meaning of each prefix at an element: the nearest declaration. */
function meanings(element: ElementNode): Map<string, string> {
  const found = new Map<string, string>();
  for (let outer: ElementNode | null = element; outer; outer = outer.parent) {
    for (const { name, value } of outer.attributes) {
      const prefix = declaredPrefix(name);
      if (prefix !== null && !found.has(prefix)) found.set(prefix, value);
    }
  }
  return found;
}

/** Returns the prefix of a namespace at an element, or null where none is declared. */
export function prefixOf(element: ElementNode, namespace: string): string | null {
  for (const [prefix, meaning] of meanings(element)) {
    if (prefix !== "" && meaning === namespace) return prefix;
  }
  return null;
}

/** The prefix to declare for a namespace: the usual one, or with a number where it is taken. */
function freePrefix(element: ElementNode, namespace: string): string {
  const usual = USUAL_PREFIX[namespace] ?? "ns";
  const taken = meanings(element);
  for (let i = 1; ; i += 1) {
    const prefix = i === 1 ? usual : `${usual}${i}`;
    if (!taken.has(prefix)) return prefix;
  }
}

/** How an attribute of a namespace is to be written in new elements within `parent`. */
export function nameWithin(parent: ElementNode, namespace: string, local: string): string {
  return `${prefixOf(parent, namespace) ?? freePrefix(parent, namespace)}:${local}`;
}

/** The same of Sfumato's. */
export function sfName(parent: ElementNode, local: string): string {
  return nameWithin(parent, SFUMATO, local);
}

/**
 * The edits that declare a namespace on the outermost element, for use at `element`; with
 * sf:version for Sfumato's. None where it is declared.
 */
export function declare(text: string, element: ElementNode, namespace: string): Edit[] {
  if (prefixOf(element, namespace) !== null) return [];
  const prefix = freePrefix(element, namespace);
  const root = rootOf(element);
  const edits = [added(text, root, `xmlns:${prefix}`, namespace)];
  if (namespace === SFUMATO) edits.push(added(text, root, `${prefix}:version`, "1"));
  return edits;
}

/** Where the blanks before a place begin, not before `from`. */
export function blanksBefore(text: string, at: number, from: number): number {
  let begin = at;
  while (begin > from && " \t\r\n".includes(text[begin - 1])) begin -= 1;
  return begin;
}

/** A new attribute behind the last one, parted from it as that one is from what stands before. */
function added(text: string, element: ElementNode, name: string, value: string): Edit {
  const { attributes, startTag } = element;
  const last = attributes.at(-1);
  if (!last) {
    const at = startTag.start + 1 + element.name.length;
    return { at, removed: "", inserted: ` ${name}="${encodeValue(value, '"')}"` };
  }
  const before = attributes.at(-2)?.range.end ?? startTag.start + 1 + element.name.length;
  const blanks = text.slice(before, last.range.start);
  const parted = /\r?\n[ \t]*$/.exec(blanks)?.[0] ?? " ";
  const written = `${name}=${last.quote}${encodeValue(value, last.quote)}${last.quote}`;
  return { at: last.range.end, removed: "", inserted: parted + written };
}

/**
 * The edits that give an attribute a value; null takes it away, with the blanks before it. An
 * attribute that is there keeps its place and quotes. A namespace is declared where it is not yet.
 */
export function setAttribute(
  text: string,
  element: ElementNode,
  name: AttributeName,
  value: string | null,
): Edit[] {
  const found = attributeOf(element, name);
  if (found && value === null) {
    const { start, end } = found.range;
    const at = blanksBefore(text, start, element.startTag.start);
    return [{ at, removed: text.slice(at, end), inserted: "" }];
  }
  if (value === null || found?.value === value) return [];
  if (found) {
    const { start, end } = found.valueRange;
    const removed = text.slice(start, end);
    return [{ at: start, removed, inserted: encodeValue(value, found.quote) }];
  }
  if (typeof name === "string") return [added(text, element, name, value)];
  const { namespace, local } = name;
  const prefix = prefixOf(element, namespace) ?? freePrefix(element, namespace);
  const declaration = declare(text, element, namespace);
  const version = declaration.length > 0 && local === "version" && !element.parent;
  return version
    ? declaration
    : [...declaration, added(text, element, `${prefix}:${local}`, value)];
}

/**
 * Edits of one text as a patch, in order. Edits that are the same in all, as the declaration of a
 * namespace that two of them need, become one.
 * @throws RangeError where they overlap
 */
export function patchOf(edits: readonly Edit[]): Patch {
  const isRemoval = (edit: Edit) => (edit.removed === "" ? 0 : 1);
  const sorted = [...edits].sort((a, b) => a.at - b.at || isRemoval(a) - isRemoval(b));
  const patch: Edit[] = [];
  let end = 0;
  for (const edit of sorted) {
    if (isDeclaration(edit) && patch.some((other) => isSame(other, edit))) continue;
    if (edit.at < end) throw new RangeError("edits of one text overlap");
    end = edit.at + edit.removed.length;
    patch.push(edit);
  }
  return patch;
}

function isSame(a: Edit, b: Edit): boolean {
  return a.at === b.at && a.removed === b.removed && a.inserted === b.inserted;
}

function isDeclaration({ removed, inserted }: Edit): boolean {
  return removed === "" && /^\s+(xmlns:\w+|\w+:version)=/.test(inserted);
}
