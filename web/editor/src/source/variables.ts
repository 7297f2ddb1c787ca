// The syntax of custom properties and of var(), which refers to one.
import { behindComponent, isFunction, solidFrom, tokensOf, trimmed, uncommented } from "./css.js";
import type { Token } from "./css.js";
import { VARIABLE_NAME_BYTES } from "./limits.js";

/** A custom property. */
export type VariableName = `--${string}`;

/** A var() in a value. */
export interface Reference {
  readonly name: VariableName;
  /** Perhaps ""; null: none. */
  readonly fallback: string | null;
  /** The token behind it. */
  readonly behind: number;
}

const encoder = new TextEncoder();

/** Bytes of a text in UTF-8. */
export function byteLength(text: string): number {
  return /^[\x00-\x7f]*$/.test(text) ? text.length : encoder.encode(text).length;
}

/** Whether a declaration's name, as it is written, is that of a custom property that is read. */
export function isVariableName(name: string): name is VariableName {
  const isNamed = name.length > 2 && name.startsWith("--") && !name.includes("\\");
  return isNamed && byteLength(name) <= VARIABLE_NAME_BYTES;
}

const beginsVariable = (token: Token): boolean => isFunction(token, "var");

/** Reads the name in a var() and the text after it; its first token stands at `at`. */
function head(text: string, tokens: readonly Token[], at: number) {
  const nameAt = solidFrom(tokens, at + 1);
  const nextAt = solidFrom(tokens, nameAt + 1);
  const token = tokens[nameAt];
  const name = token?.kind === "ident" ? text.slice(token.start, token.end) : "";
  const next = tokens[nextAt]?.kind ?? ")";
  const isValid = name.startsWith("--") && (next === ")" || next === ",");
  return isValid ? { name: name as VariableName, hasFallback: next === ",", nextAt } : null;
}

/** The var() that begins at a token; null: it is none that is valid. No token is a comment. */
function referenceAt(text: string, tokens: readonly Token[], at: number): Reference | null {
  const begun = head(text, tokens, at);
  if (!begun) return null;
  const { name, hasFallback, nextAt } = begun;
  if (!hasFallback) return { name, fallback: null, behind: Math.min(nextAt + 1, tokens.length) };
  let end = nextAt + 1;
  while (end < tokens.length && tokens[end].kind !== ")") end = behindComponent(tokens, end);
  const fallback = trimmed(text.slice(tokens[nextAt].end, tokens[end]?.start ?? text.length));
  return { name, fallback, behind: Math.min(end + 1, tokens.length) };
}

export type Variables = "none" | "valid" | "invalid";

/** Whether a value has var(), and all of them are valid, those in fallbacks too. */
export function variablesIn(text: string): Variables {
  if (!text.includes("(")) return "none";
  const tokens = uncommented(tokensOf(text));
  let found: Variables = "none";
  for (const [at, token] of tokens.entries()) {
    if (!beginsVariable(token)) continue;
    if (!head(text, tokens, at)) return "invalid";
    found = "valid";
  }
  return found;
}

/** A value in pieces: text as it is, and each var() outside of others; null: one is not valid. */
export function piecesOf(text: string): (string | Reference)[] | null {
  const tokens = uncommented(tokensOf(text));
  const pieces: (string | Reference)[] = [];
  let copied = 0;
  for (let at = 0; at < tokens.length;) {
    if (!beginsVariable(tokens[at])) {
      at += 1;
      continue;
    }
    const reference = referenceAt(text, tokens, at);
    if (!reference) return null;
    pieces.push(text.slice(copied, tokens[at].start), reference);
    at = reference.behind;
    copied = tokens[at - 1].end;
  }
  pieces.push(text.slice(copied));
  return pieces;
}
