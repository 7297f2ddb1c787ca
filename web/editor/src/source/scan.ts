// The tokens of an XML file: what begins at a `<`.
import { SourceError } from "./tree.js";

/** Where an attribute stands: offsets of the text. */
export interface AttributeToken {
  readonly name: string;
  readonly nameAt: number;
  readonly valueAt: number;
  readonly valueEnd: number;
}

export interface StartTag {
  readonly name: string;
  readonly attributes: readonly AttributeToken[];
  readonly end: number;
  readonly closesItself: boolean;
}

/** Line and column, from 1. CR, LF and both together end a line. */
export function placeOf(text: string, offset: number): { line: number; column: number } {
  const before = text.slice(0, offset);
  let line = 1;
  let begin = 0;
  for (const { index, 0: end } of before.matchAll(/\r\n?|\n/g)) {
    line += 1;
    begin = index + end.length;
  }
  return { line, column: offset - begin + 1 };
}

export function failure(text: string, offset: number, reason: string): SourceError {
  const { line, column } = placeOf(text, offset);
  return new SourceError(reason, offset, line, column);
}

const NAME = /[\p{L}_:][-.\p{L}\p{N}\p{M}_:\u00b7]*/uy;
const BLANKS = /[ \t\r\n]*/y;

/** The name that begins at a place, or "". */
export function nameAt(text: string, at: number): string {
  NAME.lastIndex = at;
  return NAME.exec(text)?.[0] ?? "";
}

export function skipBlanks(text: string, at: number): number {
  BLANKS.lastIndex = at;
  BLANKS.test(text);
  return BLANKS.lastIndex;
}

/** The name in a message, however long it is. */
export function shown(name: string): string {
  return name.length > 40 ? `${name.slice(0, 40)}…` : name;
}

/** Behind `closing`, which ends what begins with `opening` at `at`. */
export function behind(
  text: string,
  at: number,
  [opening, closing]: readonly [string, string],
  what: string,
): number {
  const found = text.indexOf(closing, at + opening.length);
  if (found < 0) throw failure(text, at, `${what} has no end; expected "${closing}"`);
  return found + closing.length;
}

/** Reads the tag whose `<` stands at `at`. */
export function scanStartTag(text: string, at: number): StartTag {
  const name = nameAt(text, at + 1);
  if (name === "") {
    throw failure(text, at, 'expected a name after "<"; a "<" of the text is written as "&lt;"');
  }
  const attributes: AttributeToken[] = [];
  const names = new Set<string>();
  let here = at + 1 + name.length;
  for (;;) {
    const next = skipBlanks(text, here);
    if (text[next] === ">") return { name, attributes, end: next + 1, closesItself: false };
    if (text.startsWith("/>", next)) return { name, attributes, end: next + 2, closesItself: true };
    if (next >= text.length) throw failure(text, at, `<${shown(name)}> has no end; expected ">"`);
    const token = scanAttribute(text, next, name);
    if (next === here) {
      throw failure(text, next, `expected a blank before the attribute ${shown(token.name)}`);
    }
    if (names.has(token.name)) {
      throw failure(text, next, `<${shown(name)}> has the attribute ${shown(token.name)} twice`);
    }
    names.add(token.name);
    attributes.push(token);
    here = token.valueEnd + 1;
  }
}

function scanAttribute(text: string, at: number, tag: string): AttributeToken {
  const name = nameAt(text, at);
  if (name === "") throw failure(text, at, `expected an attribute or ">" in <${shown(tag)}>`);
  const equals = skipBlanks(text, at + name.length);
  if (text[equals] !== "=") {
    throw failure(text, at, `the attribute ${shown(name)} of <${shown(tag)}> has no value`);
  }
  const open = skipBlanks(text, equals + 1);
  const quote = text[open];
  if (quote !== '"' && quote !== "'") {
    throw failure(text, at, `the value of ${shown(name)} is not in quotes`);
  }
  const close = text.indexOf(quote, open + 1);
  if (close < 0) throw failure(text, at, `the value of ${shown(name)} has no closing quote`);
  const inside = text.slice(open + 1, close).indexOf("<");
  if (inside >= 0) {
    throw failure(
      text,
      open + 1 + inside,
      `"<" in the value of ${shown(name)}; a quote is missing`,
    );
  }
  return { name, nameAt: at, valueAt: open + 1, valueEnd: close };
}

export interface Doctype {
  readonly end: number;
  readonly definesEntities: boolean;
}

const DOCTYPE_PART = /<!--|<!ENTITY|<\?|["'[\]>]/g;

/** Reads the DOCTYPE whose `<` stands at `at`, with its declarations in brackets. */
export function scanDoctype(text: string, at: number): Doctype {
  let definesEntities = false;
  let isInside = false;
  DOCTYPE_PART.lastIndex = at + "<!DOCTYPE".length;
  for (let part = DOCTYPE_PART.exec(text); part; part = DOCTYPE_PART.exec(text)) {
    const [token] = part;
    if (token === "[") isInside = true;
    else if (token === "]") isInside = false;
    else if (token === "<!ENTITY") definesEntities = true;
    else if (token === ">") {
      if (!isInside) return { end: part.index + 1, definesEntities };
    } else {
      const closing = token === "<!--" ? "-->" : token === "<?" ? "?>" : token;
      const found = text.indexOf(closing, part.index + token.length);
      if (found < 0) break;
      DOCTYPE_PART.lastIndex = found + closing.length;
    }
  }
  throw failure(text, at, "the DOCTYPE has no end");
}
