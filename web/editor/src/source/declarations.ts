// Declarations of CSS: what style="" and the blocks of rules say.
import { behindComponent, keywordOf, solid, tokensOf } from "./css.js";
import type { Token } from "./css.js";
import { IS_VALUE, WIDE } from "./properties.js";
import type { Property } from "./properties.js";

export interface Declaration {
  readonly name: string;
  readonly value: string;
  readonly isImportant: boolean;
  /** Of the text: from the name, to behind the value (and !important). */
  readonly start: number;
  readonly end: number;
  /** Where the value stands. */
  readonly valueStart: number;
  readonly valueEnd: number;
}

/** The declaration that tokens from `from` up to `to` are, or null. */
function declarationOf(text: string, tokens: readonly Token[], from: number, to: number) {
  const own = solid(tokens.slice(from, to));
  const [name, colon, ...value] = own;
  if (name?.kind !== "ident" || colon?.kind !== ":") return null;
  if (own.some(({ kind }) => kind === "bad")) return null;
  const last = value.at(-1);
  const isImportant =
    last?.kind === "ident" &&
    last.value.toLowerCase() === "important" &&
    value.at(-2)?.value === "!";
  const kept = isImportant ? value.slice(0, -2) : value;
  if (kept.some((token) => token.kind === "delim" && token.value === "!")) return null;
  const valueStart = kept[0]?.start ?? colon.end;
  const valueEnd = kept.at(-1)?.end ?? colon.end;
  return {
    name: name.value.toLowerCase(),
    value: text.slice(valueStart, valueEnd),
    isImportant,
    start: name.start,
    end: last?.end ?? colon.end,
    valueStart,
    valueEnd,
  };
}

/** What style="" or the block of a rule declares. */
export function declarationsOf(text: string): Declaration[] {
  const tokens = tokensOf(text);
  const found: Declaration[] = [];
  let from = 0;
  for (let i = 0; i <= tokens.length;) {
    if (i === tokens.length || tokens[i].kind === ";") {
      const declaration = declarationOf(text, tokens, from, i);
      if (declaration) found.push(declaration);
      i += 1;
      from = i;
    } else {
      i = behindComponent(tokens, i);
    }
  }
  return found;
}

export interface Setting {
  readonly value: string;
  readonly isImportant: boolean;
}

export type Settings = ReadonlyMap<Property, Setting>;

/** What declarations come to for each property; those that CSS drops are left out. */
export function settingsOf(declarations: readonly Declaration[]): Settings {
  const settings = new Map<Property, Setting>();
  const set = (property: Property, { value, isImportant }: Declaration) => {
    if (settings.get(property)?.isImportant && !isImportant) return;
    settings.set(property, { value, isImportant });
  };
  for (const declaration of declarations) {
    const { name, value } = declaration;
    const isWide = WIDE.includes(keywordOf(value) ?? "");
    if (name === "all" && isWide) {
      for (const property of Object.keys(IS_VALUE)) set(property as Property, declaration);
    } else if (Object.hasOwn(IS_VALUE, name) && (isWide || IS_VALUE[name as Property](value))) {
      set(name as Property, declaration);
    }
  }
  return settings;
}
