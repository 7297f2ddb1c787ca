// Declarations of CSS: what style="" and the blocks of rules say.
import { behindComponent, solidFrom, tokensOf, trimmed, uncommented } from "./css.js";
import type { Token, TokenKind } from "./css.js";
import { VARIABLES_PER_BLOCK } from "./limits.js";
import { isProperty, isValue, PROPERTIES, wideOf } from "./properties.js";
import type { PropertyName } from "./properties.js";
import { isVariableName, variablesIn } from "./variables.js";

export interface Declaration {
  /** In lower case, but that of a custom property, which is as it is written. */
  readonly name: string;
  readonly value: string;
  readonly isImportant: boolean;
  /** Range in the text: from the name to behind the value (and !important). */
  readonly start: number;
  readonly end: number;
  /** Where the value stands. */
  readonly valueStart: number;
  readonly valueEnd: number;
}

/** Tokens that no value has. */
const BREAKING: ReadonlySet<TokenKind> = new Set(["bad", ")", "]", "}"]);

/** The components of a value, with an optional "!important" at the end. */
class Value {
  readonly #tokens: readonly Token[];
  readonly #isCustom: boolean;
  /** Start of the first component, and end of the last before "!". */
  start: number | null = null;
  end = 0;
  important: "none" | "begun" | "whole" = "none";
  #hasBlock = false;
  #hasOther = false;

  constructor(tokens: readonly Token[], isCustom: boolean) {
    this.#tokens = tokens;
    this.#isCustom = isCustom;
  }

  /** Takes the component that begins at a token; the token behind it. null: it may not stand here. */
  take(at: number): number | null {
    const { kind, value, start } = this.#tokens[at];
    if (BREAKING.has(kind)) return null;
    const isMark = kind === "delim" && value === "!";
    const isBlock = kind === "{";
    // A brace begins the block of a rule, if the value is not just that.
    if (isBlock && !this.#isCustom && this.#hasOther) return null;
    if (this.#hasBlock && !this.#isCustom && !isMark && this.important === "none") return null;
    const behind = behindComponent(this.#tokens, at);
    if (isMark && this.important === "none") {
      this.important = "begun";
    } else if (this.important === "begun" && kind === "ident") {
      if (value.toLowerCase() !== "important") return null;
      this.important = "whole";
    } else if (this.important !== "none") {
      return null;
    } else {
      this.#hasBlock ||= isBlock;
      this.#hasOther ||= !isBlock;
      this.start ??= start;
      this.end = this.#tokens[behind - 1].end;
    }
    return behind;
  }
}

class DeclarationReader {
  readonly #text: string;
  readonly #tokens: readonly Token[];
  /** Up to here the value of a custom property was read in vain: others within are none either. */
  #broken = 0;
  /** The token that comes next. */
  #at = 0;

  constructor(text: string) {
    this.#text = text;
    this.#tokens = uncommented(tokensOf(text));
  }

  *all(): Iterable<Declaration> {
    const tokens = this.#tokens;
    while (this.#at < tokens.length) {
      const { kind } = tokens[this.#at];
      if (kind === "blank" || kind === ";") {
        this.#at += 1;
        continue;
      }
      const declaration = this.#declaration();
      if (declaration) yield declaration;
      else this.#skipRule();
    }
  }

  /** The one that comes next, which is passed over; null: there is none, and nothing is. */
  #declaration(): Declaration | null {
    const tokens = this.#tokens;
    const name = tokens[this.#at];
    const colonAt = solidFrom(tokens, this.#at + 1);
    if (name.kind !== "ident" || tokens[colonAt]?.kind !== ":") return null;
    const written = this.#text.slice(name.start, name.end);
    const isCustom = written.startsWith("--");
    if (isCustom && this.#at < this.#broken) return null;
    const value = new Value(tokens, isCustom);
    let end = tokens[colonAt].end;
    let at = colonAt + 1;
    while (at < tokens.length && tokens[at].kind !== ";") {
      if (tokens[at].kind === "blank") {
        at += 1;
        continue;
      }
      const behind = value.take(at);
      if (behind === null) {
        if (isCustom) this.#broken = at;
        return null;
      }
      at = behind;
      end = tokens[at - 1].end;
    }
    if (value.important === "begun") {
      this.#broken = at;
      return null;
    }
    this.#at = at;
    const behindColon = tokens[colonAt].end;
    const valueStart = value.start ?? behindColon;
    const valueEnd = value.start === null ? valueStart : value.end;
    // The substitute of var() includes the comments before it.
    const read = this.#text.slice(isCustom ? behindColon : valueStart, valueEnd);
    return {
      name: isCustom ? written : name.value.toLowerCase(),
      value: trimmed(read),
      isImportant: value.important === "whole",
      start: name.start,
      end,
      valueStart,
      valueEnd,
    };
  }

  /** Passes over a rule: up to the end of its braces, or without any to the semicolon. */
  #skipRule(): void {
    const tokens = this.#tokens;
    while (this.#at < tokens.length) {
      const { kind } = tokens[this.#at];
      this.#at = behindComponent(tokens, this.#at);
      if (kind === ";" || kind === "{") return;
    }
  }
}

/** Returns the declarations of style="" or of a rule's block. */
export function declarationsOf(text: string): Declaration[] {
  return [...new DeclarationReader(text).all()];
}

export interface Setting {
  readonly value: string;
  readonly isImportant: boolean;
}

export type Settings = ReadonlyMap<PropertyName, Setting>;

/** Returns the resulting setting of each property, without the declarations that CSS drops. */
export function settingsOf(declarations: readonly Declaration[]): Settings {
  const settings = new Map<PropertyName, Setting>();
  let variables = 0;
  const set = (property: PropertyName, { value, isImportant }: Declaration) => {
    if (settings.get(property)?.isImportant && !isImportant) return;
    settings.set(property, { value, isImportant });
  };
  for (const declaration of declarations) {
    const { name, value } = declaration;
    if (name === "all") {
      if (wideOf(value) !== null) for (const property of PROPERTIES) set(property, declaration);
    } else if (isVariableName(name)) {
      if (variablesIn(value) === "invalid") continue;
      const isNew = !settings.has(name);
      if (isNew && variables === VARIABLES_PER_BLOCK) continue;
      variables += isNew ? 1 : 0;
      set(name, declaration);
    } else if (isProperty(name) && isValue(name, value)) {
      set(name, declaration);
    }
  }
  return settings;
}
