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
  /** Of dimensions, in lower case. */
  readonly unit: string;
  readonly start: number;
  readonly end: number;
}

const ESCAPE = String.raw`\\(?:[0-9a-fA-F]{1,6}(?:\r\n|[ \t\r\n\f])?|[^0-9a-fA-F\r\n\f])`;
const START = String.raw`(?:[a-zA-Z_\u0080-\uffff]|${ESCAPE})`;
const PART = String.raw`(?:[-\w\u0080-\uffff]|${ESCAPE})`;
const IDENT = String.raw`(?:--${PART}*|-?${START}${PART}*)`;

const PATTERNS: readonly (readonly [TokenKind, RegExp])[] = [
  ["comment", /\/\*[\s\S]*?(?:\*\/|$)/y],
  ["blank", /[ \t\r\n\f]+/y],
  ["cdo", /<!--/y],
  ["cdc", /-->/y],
  [
    "url",
    /url\([ \t\r\n\f]*(?!["' \t\r\n\f])((?:[^"'()\\ \t\r\n\f]|\\[^\r\n\f])*)[ \t\r\n\f]*(?:\)|$)/iy,
  ],
  ["function", new RegExp(`(${IDENT})\\(`, "y")],
  ["percentage", /([+-]?(?:\d+(?:\.\d+)?|\.\d+)(?:[eE][+-]?\d+)?)%/y],
  [
    "dimension",
    new RegExp(String.raw`([+-]?(?:\d+(?:\.\d+)?|\.\d+)(?:[eE][+-]?\d+)?)(${IDENT})`, "y"),
  ],
  ["number", /([+-]?(?:\d+(?:\.\d+)?|\.\d+)(?:[eE][+-]?\d+)?)/y],
  ["ident", new RegExp(`(${IDENT})`, "y")],
  ["hash", new RegExp(`#(${PART}+)`, "y")],
  ["at", new RegExp(`@(${IDENT})`, "y")],
  ["string", /"((?:[^"\\\r\n\f]|\\(?:\r\n|[\s\S]))*)(?:"|$)/y],
  ["string", /'((?:[^'\\\r\n\f]|\\(?:\r\n|[\s\S]))*)(?:'|$)/y],
];

const UNESCAPE = /\\(?:([0-9a-fA-F]{1,6})(?:\r\n|[ \t\r\n\f])?|(\r\n|[\r\n\f])|([\s\S]))/g;

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

function tokenAt(text: string, start: number): Token {
  for (const [kind, pattern] of PATTERNS) {
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
  const value = text[start];
  const isMark = "()[]{},:;".includes(value);
  const kind = isMark ? (value as TokenKind) : value === '"' || value === "'" ? "bad" : "delim";
  return { kind, value, unit: "", start, end: start + 1 };
}

/** All tokens of a text. */
export function tokensOf(text: string): Token[] {
  const tokens: Token[] = [];
  for (let at = 0; at < text.length; at = tokens[tokens.length - 1].end) {
    tokens.push(tokenAt(text, at));
  }
  return tokens;
}

/** Without blanks and comments. */
export function solid(tokens: readonly Token[]): Token[] {
  return tokens.filter(({ kind }) => kind !== "blank" && kind !== "comment");
}

const CLOSING: Partial<Record<TokenKind, TokenKind>> = {
  "(": ")",
  function: ")",
  "[": "]",
  "{": "}",
};

/**
 * Behind token `i` and, where it opens brackets, all within and what closes them. What is open
 * where a text ends is closed there.
 */
export function behindComponent(tokens: readonly Token[], i: number): number {
  const open: TokenKind[] = [];
  for (let at = i; at < tokens.length; at += 1) {
    const { kind } = tokens[at];
    const closing = CLOSING[kind];
    if (closing) open.push(closing);
    else if (open.length > 0 && kind === open[open.length - 1]) open.pop();
    if (open.length === 0) return at + 1;
  }
  return tokens.length;
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

/** What url(…) refers to, or null where a value is something else. */
export function urlOf(text: string): string | null {
  const tokens = solid(tokensOf(text));
  const [first, second, third] = tokens;
  if (first?.kind === "url") return tokens.length === 1 ? first.value : null;
  if (first?.kind !== "function" || first.value.toLowerCase() !== "url") return null;
  if (second?.kind !== "string" || tokens.length > 3) return null;
  return third === undefined || third.kind === ")" ? second.value : null;
}
