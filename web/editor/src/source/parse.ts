// A lossless tree over the text of an XML file, in linear time and whatever the depth.
import { decodeValue } from "./entities.js";
import { Attribute, Element } from "./nodes.js";
import {
  behind,
  failure,
  nameAt,
  placeOf,
  scanDoctype,
  scanStartTag,
  shown,
  skipBlanks,
} from "./scan.js";
import type { StartTag } from "./scan.js";

const XMLNS = "http://www.w3.org/2000/xmlns/";
const FIXED: Readonly<Record<string, string>> = {
  xml: "http://www.w3.org/XML/1998/namespace",
  xmlns: XMLNS,
  // Files that forget to declare it are common, and every program understands them.
  xlink: "http://www.w3.org/1999/xlink",
};

/** Returns the meaning of an undeclared prefix: a namespace that no element has. */
function undeclared(prefix: string): string {
  return Object.hasOwn(FIXED, prefix) ? FIXED[prefix] : `urn:undeclared:${prefix}`;
}

function split(name: string): [prefix: string, local: string] {
  const colon = name.indexOf(":");
  return colon <= 0 ? ["", name] : [name.slice(0, colon), name.slice(colon + 1)];
}

/** The prefix that an attribute declares ("" is the default one), or null. */
export function declaredPrefix(name: string): string | null {
  if (name === "xmlns") return "";
  return name.startsWith("xmlns:") ? name.slice("xmlns:".length) : null;
}

/** The attributes of a start tag. `text` holds the tag, whose `<` stands at `at`. */
function attributesOf(
  owner: Element,
  tag: StartTag,
  text: string,
  at: number,
  meaning: (prefix: string) => string,
): Attribute[] {
  return tag.attributes.map(({ name, nameAt: begin, valueAt, valueEnd }) => {
    const [prefix, local] = split(name);
    const namespace = name === "xmlns" ? XMLNS : prefix === "" ? "" : meaning(prefix);
    const value = decodeValue(text.slice(valueAt, valueEnd));
    const quote = text[valueEnd] as '"' | "'";
    return new Attribute(
      owner,
      name,
      local,
      namespace,
      value,
      begin - at,
      valueAt - at,
      valueEnd - at,
      quote,
    );
  });
}

export interface Parsed {
  readonly root: Element;
  readonly definesEntities: boolean;
}

class Parser {
  readonly #text: string;
  readonly #newHandle: () => number;
  /** The meaning of each prefix here. */
  readonly #meanings = new Map<string, string>();
  /** The meanings that the declarations of each open element hid. */
  readonly #hidden: (readonly [string, string | undefined][])[] = [];
  #root: Element | null = null;
  #open: Element | null = null;
  #definesEntities = false;

  constructor(text: string, newHandle: () => number) {
    this.#text = text;
    this.#newHandle = newHandle;
  }

  parse(): Parsed {
    const text = this.#text;
    let at = text.startsWith("\ufeff") ? 1 : 0;
    for (;;) {
      const next = text.indexOf("<", at);
      const end = next < 0 ? text.length : next;
      if (!this.#open) this.#expectBlank(at, end);
      if (next < 0) break;
      at = this.#read(next);
    }
    if (this.#open) throw this.#missingEnd(this.#open, text.length);
    if (!this.#root) throw failure(text, 0, "there is no element; expected <svg>");
    return { root: this.#root, definesEntities: this.#definesEntities };
  }

  /** Reads what begins at a `<`; gives the place behind it. */
  #read(at: number): number {
    const text = this.#text;
    switch (text[at + 1]) {
      case "/":
        return this.#endTag(at);
      case "?":
        return behind(text, at, ["<?", "?>"], "the processing instruction");
      case "!":
        return this.#declaration(at);
      default:
        return this.#startTag(at);
    }
  }

  #declaration(at: number): number {
    const text = this.#text;
    if (text.startsWith("<!--", at)) return behind(text, at, ["<!--", "-->"], "the comment");
    if (text.startsWith("<![CDATA[", at)) {
      if (this.#open) return behind(text, at, ["<![CDATA[", "]]>"], "the CDATA section");
    } else if (text.startsWith("<!DOCTYPE", at) && !this.#root) {
      const doctype = scanDoctype(text, at);
      this.#definesEntities = doctype.definesEntities;
      return doctype.end;
    }
    throw failure(text, at, 'what begins with "<!" here is neither a comment nor a DOCTYPE');
  }

  #startTag(at: number): number {
    const tag = scanStartTag(this.#text, at);
    const parent = this.#open;
    if (!parent && this.#root) {
      throw failure(this.#text, at, `<${shown(tag.name)}> stands behind the end of the document`);
    }
    this.#declare(tag);
    const [prefix, local] = split(tag.name);
    const element = new Element(
      parent,
      tag.name,
      local,
      this.#meaning(prefix),
      this.#newHandle(),
      at,
      tag.closesItself,
    );
    element.attributes = attributesOf(element, tag, this.#text, at, (name) => this.#meaning(name));
    element.tagLength = element.contentLength = element.length = tag.end - at;
    this.#root ??= element;
    parent?.children.push(element);
    if (tag.closesItself) this.#forget();
    else this.#open = element;
    return tag.end;
  }

  #endTag(at: number): number {
    const text = this.#text;
    const name = nameAt(text, at + 2);
    const end = skipBlanks(text, at + 2 + name.length);
    if (name === "" || text[end] !== ">") throw failure(text, at, "the end tag is not complete");
    const element = this.#open;
    if (element?.name !== name) {
      for (let outer = element; outer; outer = outer.parent) {
        if (outer.name === name && element) throw this.#missingEnd(element, at);
      }
      throw failure(text, at, `</${shown(name)}> ends an element that did not begin`);
    }
    element.contentLength = at - element.at;
    element.length = end + 1 - element.at;
    this.#open = element.parent;
    this.#forget();
    return end + 1;
  }

  #missingEnd(element: Element, at: number) {
    const { line } = placeOf(this.#text, element.at);
    const reason = `the end tag of <${shown(element.name)}> from line ${line} is missing`;
    return failure(this.#text, at, reason);
  }

  #expectBlank(from: number, to: number): void {
    const at = skipBlanks(this.#text, from);
    if (at < to) throw failure(this.#text, at, "there is text outside of the outermost element");
  }

  #meaning(prefix: string): string {
    return this.#meanings.get(prefix) ?? (prefix === "" ? "" : undeclared(prefix));
  }

  #declare(tag: StartTag): void {
    const hidden: [string, string | undefined][] = [];
    for (const { name, valueAt, valueEnd } of tag.attributes) {
      const prefix = declaredPrefix(name);
      if (prefix === null) continue;
      hidden.push([prefix, this.#meanings.get(prefix)]);
      this.#meanings.set(prefix, decodeValue(this.#text.slice(valueAt, valueEnd)));
    }
    this.#hidden.push(hidden);
  }

  #forget(): void {
    for (const [prefix, meaning] of this.#hidden.pop() ?? []) {
      if (meaning === undefined) this.#meanings.delete(prefix);
      else this.#meanings.set(prefix, meaning);
    }
  }
}

/** Numbers from 1. */
export function counter(): () => number {
  let last = 0;
  return () => ++last;
}

/** @throws SourceError */
export function parseDocument(text: string, newHandle = counter()): Parsed {
  return new Parser(text, newHandle).parse();
}

/** The outermost element of an XML file. @throws SourceError */
export function parse(text: string): Element {
  return parseDocument(text).root;
}

/** What a prefix means within an element. */
export function meaningWithin(element: Element | null, prefix: string): string {
  const name = prefix === "" ? "xmlns" : `xmlns:${prefix}`;
  for (let outer = element; outer; outer = outer.parent) {
    const found = outer.attributes.find((attribute) => attribute.name === name);
    if (found) return found.value;
  }
  return prefix === "" ? "" : undeclared(prefix);
}

/**
 * Reads again the attributes of an element, whose start tag is now `tag`. The caller moves the text behind
 * it.
 * @throws SourceError where it is not a start tag with this name and end; offsets count in the tag
 */
export function rereadTag(element: Element, tag: string): void {
  const read = scanStartTag(tag, 0);
  if (read.name !== element.name || read.end !== tag.length) {
    throw failure(tag, 0, `the tag of <${shown(element.name)}> became another`);
  }
  if (read.closesItself !== element.closesItself) {
    throw failure(tag, 0, `the tag of <${shown(element.name)}> ends in another way`);
  }
  const own = new Map<string, string>();
  for (const { name, valueAt, valueEnd } of read.attributes) {
    const prefix = declaredPrefix(name);
    if (prefix !== null) own.set(prefix, decodeValue(tag.slice(valueAt, valueEnd)));
  }
  element.attributes = attributesOf(
    element,
    read,
    tag,
    0,
    (prefix) => own.get(prefix) ?? meaningWithin(element.parent, prefix),
  );
}
