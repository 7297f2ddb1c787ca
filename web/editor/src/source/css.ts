// The tokens of CSS Syntax 3, as far as styles and colours of documents need them.

export type TokenKind =
  | "blank"
  | "comment"
  | "ident"
  | "function"
  | "at"
  | "hash"
  | "string"
  | "url"
  | "number"
  | "percentage"
  | "dimension"
  | "delim"
  | "bad"
  | "cdo"
  | "cdc"
  | "("
  | ")"
  | "["
  | "]"
  | "{"
  | "}"
  | ","
  | ":"
  | ";";

export interface Token {
  readonly kind: TokenKind;
  /** Names, strings and addresses without escapes; of numbers the digits; else as written. */
  readonly value: string;
  /** Unit of a dimension, in lower case. */
  readonly unit: string;
  readonly start: number;
  readonly end: number;
}

const HEX = "[0-9a-fA-F]";
// Each in one way: patterns that fail behind many of them do not try others.
const CODE = String.raw`(?:${HEX}{6}|${HEX}{1,5}(?!${HEX}))(?:\r\n|\r(?!\n)|[ \t\n\f]|(?![ \t\r\n\f]))`;
const ESCAPE = String.raw`\\(?:${CODE}|[^0-9a-fA-F\r\n\f])`;
/** Where a line ends behind the backslash, nothing stands there. */
const inString = (quote: string) =>
  String.raw`(?:[^${quote}\\\r\n\f]|${ESCAPE}|\\(?:\r\n|[\r\n\f]|$))*`;
const START = String.raw`(?:[a-zA-Z_\u0080-\uffff]|${ESCAPE})`;
const PART = String.raw`(?:[-\w\u0080-\uffff]|${ESCAPE})`;
const IDENT = String.raw`(?:--${PART}*|-?${START}${PART}*)`;

const PATTERNS: readonly (readonly [TokenKind, RegExp])[] = [
  ["comment", /\/\*[\s\S]*?(?:\*\/|$)/y],
  ["blank", /[ \t\r\n\f]+/y],
  ["cdo", /<!--/y],
  ["cdc", /-->/y],
  ["function", new RegExp(`(${IDENT})\\(`, "y")],
  ["percentage", /([+-]?(?:\d+(?:\.\d+)?|\.\d+)(?:[eE][+-]?\d+)?)%/y],
  [
    "dimension",
    // The number is what it is before the unit is looked for: 1e3 has no unit "e3".
    new RegExp(String.raw`(?=([+-]?(?:\d+(?:\.\d+)?|\.\d+)(?:[eE][+-]?\d+)?))\1(${IDENT})`, "y"),
  ],
  ["number", /([+-]?(?:\d+(?:\.\d+)?|\.\d+)(?:[eE][+-]?\d+)?)/y],
  ["ident", new RegExp(`(${IDENT})`, "y")],
  ["hash", new RegExp(`#(${PART}+)`, "y")],
  ["at", new RegExp(`@(${IDENT})`, "y")],
  ["string", new RegExp(`"(${inString('"')})(?:"|$)`, "y")],
  ["string", new RegExp(`'(${inString("'")})(?:'|$)`, "y")],
  // A string up to the end of its line.
  ["bad", new RegExp(`"${inString('"')}`, "y")],
  ["bad", new RegExp(`'${inString("'")}`, "y")],
];

/** The content after "url(": an address, or up to the parenthesis where it is not one. */
const IN_URL: readonly (readonly [TokenKind, RegExp])[] = [
  [
    "url",
    new RegExp(
      String.raw`[ \t\r\n\f]*((?:[^"'()\\\x00-\x20\x7f]|${ESCAPE})*)[ \t\r\n\f]*(?:\)|$)`,
      "y",
    ),
  ],
  ["bad", new RegExp(String.raw`(?:[^)\\]|${ESCAPE}|\\)*\)?`, "y")],
];
const QUOTE_IN_URL = /[ \t\r\n\f]*["']/y;
const NAME_START = new RegExp(`--|-?${START}`, "y");

const UNESCAPE = /\\(?:([0-9a-fA-F]{1,6})(?:\r\n|[ \t\r\n\f])?|(\r\n|[\r\n\f])|([\s\S])|$)/g;

function unescaped(text: string): string {
  if (!text.includes("\\")) return text;
  return text.replace(UNESCAPE, (_, hex?: string, line?: string, other?: string) => {
    if (line !== undefined) return "";
    if (hex === undefined) return other ?? "";
    const code = parseInt(hex, 16);
    const isScalar = code > 0 && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
    return isScalar ? String.fromCodePoint(code) : "\ufffd";
  });
}

/** Whether a name begins at a place. */
export function beginsName(text: string, at: number): boolean {
  NAME_START.lastIndex = at;
  return NAME_START.test(text);
}

/** The token that begins at a place by the first pattern that fits; null: by none. */
function tokenBy(
  patterns: readonly (readonly [TokenKind, RegExp])[],
  text: string,
  start: number,
): Token | null {
  for (const [kind, pattern] of patterns) {
    pattern.lastIndex = start;
    const match = pattern.exec(text);
    if (!match) continue;
    const [whole, value = whole, unit = ""] = match;
    return {
      kind,
      value: unescaped(value),
      unit: unescaped(unit).toLowerCase(),
      start,
      end: start + whole.length,
    };
  }
  return null;
}

/** An address without quotes, whose name and parenthesis are a token; else that token. */
function urlAt(text: string, name: Token): Token {
  QUOTE_IN_URL.lastIndex = name.end;
  if (QUOTE_IN_URL.test(text)) return name;
  const inside = tokenBy(IN_URL, text, name.end);
  return inside ? { ...inside, start: name.start } : name;
}

function tokenAt(text: string, start: number): Token {
  const token = tokenBy(PATTERNS, text, start);
  if (token) return isFunction(token, "url") ? urlAt(text, token) : token;
  const value = text[start];
  const kind = "()[]{},:;".includes(value) ? (value as TokenKind) : "delim";
  return { kind, value, unit: "", start, end: start + 1 };
}

/** Whether a token begins the function of this name, which is in lower case. */
export function isFunction({ kind, value }: Token, name: string): boolean {
  return kind === "function" && value.toLowerCase() === name;
}

/** All tokens of a text. */
export function tokensOf(text: string): Token[] {
  const tokens: Token[] = [];
  for (let at = 0; at < text.length; at = tokens[tokens.length - 1].end) {
    tokens.push(tokenAt(text, at));
  }
  return tokens;
}

const isBlank = (character: string) => " \t\r\n\f".includes(character);

/** A text without blanks of CSS at both ends. */
export function trimmed(text: string): string {
  let [start, end] = [0, text.length];
  while (start < end && isBlank(text[start])) start += 1;
  while (end > start && isBlank(text[end - 1])) end -= 1;
  return text.slice(start, end);
}

/** The words of a list that blanks part. */
export function wordsOf(list: string): string[] {
  return list.split(/[ \t\r\n\f]+/).filter((word) => word !== "");
}

/** Without comments. */
export function uncommented(tokens: readonly Token[]): Token[] {
  return tokens.filter(({ kind }) => kind !== "comment");
}

/** Without blanks and comments. */
export function solid(tokens: readonly Token[]): Token[] {
  return tokens.filter(({ kind }) => kind !== "blank" && kind !== "comment");
}

/** The first token from a place on that is no blank: where it stands, or their number. */
export function solidFrom(tokens: readonly Token[], from: number): number {
  let at = from;
  while (tokens[at]?.kind === "blank") at += 1;
  return at;
}

const CLOSING: Partial<Record<TokenKind, TokenKind>> = {
  "(": ")",
  function: ")",
  "[": "]",
  "{": "}",
};

/** Brackets within each other that are followed; deeper ones end with the text. */
const MOST_BRACKETS = 1000;

/**
 * Returns the token behind the component that begins at a token: behind the closing bracket if it opens one.
 * The end of a text closes all brackets.
 */
export function componentAt(
  tokens: readonly Token[],
  i: number,
): { behind: number; isClosed: boolean } {
  const open: TokenKind[] = [];
  for (let at = i; at < tokens.length; at += 1) {
    const { kind } = tokens[at];
    const closing = CLOSING[kind];
    if (closing && open.length === MOST_BRACKETS) break;
    if (closing) open.push(closing);
    else if (open.length > 0 && kind === open[open.length - 1]) open.pop();
    if (open.length === 0) return { behind: at + 1, isClosed: true };
  }
  return { behind: tokens.length, isClosed: false };
}

export function behindComponent(tokens: readonly Token[], i: number): number {
  return componentAt(tokens, i).behind;
}

/** The one word that a value is, in lower case, or null. */
export function keywordOf(text: string): string | null {
  if (/^[a-z-]+$/.test(text)) return text;
  const tokens = solid(tokensOf(text));
  return tokens.length === 1 && tokens[0].kind === "ident" ? tokens[0].value.toLowerCase() : null;
}

/** A number or percentage as a share, 0 to 1, or null. */
export function shareOf(text: string): number | null {
  const tokens = solid(tokensOf(text));
  if (tokens.length !== 1) return null;
  const [{ kind, value }] = tokens;
  if (kind !== "number" && kind !== "percentage") return null;
  const number = Number(value) / (kind === "percentage" ? 100 : 1);
  return Math.min(Math.max(number, 0), 1);
}

/** The url(…) that begins at one of solid tokens: what it refers to, and the token behind it. */
export function urlAmong(
  tokens: readonly Token[],
  at: number,
): { href: string; behind: number } | null {
  const [first, held, last] = tokens.slice(at, at + 3);
  if (first?.kind === "url") return { href: first.value, behind: at + 1 };
  if (!first || !isFunction(first, "url") || held?.kind !== "string") return null;
  return last && last.kind !== ")" ? null : { href: held.value, behind: at + (last ? 3 : 2) };
}

/** Returns the target of url(…), or null where a value is something else. */
export function urlOf(text: string): string | null {
  const tokens = solid(tokensOf(text));
  const url = urlAmong(tokens, 0);
  return url?.behind === tokens.length ? url.href : null;
}
