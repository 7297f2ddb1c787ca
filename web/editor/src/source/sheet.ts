// Style sheets, whose selectors are a name, .class, #id or *; the engine reads no others.
import { behindComponent, solid, tokensOf } from "./css.js";
import type { Token } from "./css.js";
import { declarationsOf, settingsOf } from "./declarations.js";
import type { Setting, Settings } from "./declarations.js";
import type { Property } from "./properties.js";

interface Rule {
  readonly settings: Settings;
  readonly order: number;
}

/** Whether a media query, or the attribute media, asks for a screen and no features. */
export function isForScreen(query: string): boolean {
  const words = query
    .replace(/\/\*[\s\S]*?\*\//g, " ")
    .trim()
    .toLowerCase();
  return (
    words === "" ||
    words.split(",").some((one) => {
      const [, not, type] = /^\s*(not\s+|only\s+)?([a-z-]+)\s*$/.exec(one) ?? [];
      if (type === undefined) return false;
      const fits = type === "screen" || type === "all";
      return not?.startsWith("not") ? !fits : fits;
    })
  );
}

/** Rules of one kind of selector by name. */
type Index = Map<string, Rule[]>;

/** What selectors ask of an element. */
export interface Bearer {
  readonly id: string;
  readonly classes: readonly string[];
  readonly name: string;
}

/** The rules of all sheets of a document. */
export class Sheet {
  readonly #byId: Index = new Map();
  readonly #byClass: Index = new Map();
  readonly #byName: Index = new Map();
  readonly #ofAll: Rule[] = [];
  #count = 0;

  get isEmpty(): boolean {
    return this.#count === 0;
  }

  /** What the rules say of a property of an element, by importance, specificity and order. */
  find({ id, classes, name }: Bearer, property: Property): Setting | null {
    let best: Setting | null = null;
    const consider = (rules: readonly Rule[] | undefined) => {
      const setting = rules && strongest(rules, property);
      if (setting && (!best || (setting.isImportant && !best.isImportant))) best = setting;
    };
    consider(this.#byId.get(id));
    consider(classes.flatMap((one) => this.#byClass.get(one) ?? []));
    consider(this.#byName.get(name));
    consider(this.#ofAll);
    return best;
  }

  /** Adds the rules of a sheet. */
  add(sheet: string): void {
    const tokens = tokensOf(sheet);
    /** Of @media that apply: their braces are passed over. */
    let depth = 0;
    for (let at = 0; at < tokens.length;) {
      const { kind } = tokens[at];
      const isMark = depth === 0 && (kind === "cdo" || kind === "cdc");
      if (kind === "blank" || kind === "comment" || isMark) at += 1;
      else if (kind === "}" && depth > 0) [at, depth] = [at + 1, depth - 1];
      else {
        const prelude = preludeAt(tokens, at, depth > 0);
        const isMedia = prelude.hasBlock && isMediaThatApplies(sheet, tokens, at, prelude.end);
        if (isMedia) depth += 1;
        at = isMedia ? prelude.end + 1 : this.#addRule(sheet, tokens, at, prelude);
      }
    }
  }

  /** Reads the rule that begins at a token; gives the token behind it. */
  #addRule(sheet: string, tokens: readonly Token[], from: number, prelude: Prelude): number {
    const { end: open, hasBlock } = prelude;
    if (!hasBlock) return open + (tokens[open]?.kind === ";" ? 1 : 0);
    const behind = behindComponent(tokens, open);
    const isClosed = behind - 1 > open && tokens[behind - 1].kind === "}";
    const end = isClosed ? tokens[behind - 1].start : sheet.length;
    if (tokens[from].kind !== "at") {
      this.#addRules(solid(tokens.slice(from, open)), sheet.slice(tokens[open].end, end));
    }
    return behind;
  }

  #addRules(prelude: readonly Token[], block: string): void {
    const selectors: Token[][] = [[]];
    for (const token of prelude) {
      if (token.kind === ",") selectors.push([]);
      else selectors[selectors.length - 1].push(token);
    }
    if (selectors.some(isNoSelector)) return;
    const declarations = declarationsOf(block);
    const rule = { settings: settingsOf(declarations), order: this.#count };
    this.#count += Math.max(declarations.length, 1);
    for (const selector of selectors) this.#rulesOf(selector)?.push(rule);
  }

  /** Where the rules of a selector are kept; null for selectors that are not read. */
  #rulesOf([first, second, ...more]: readonly Token[]): Rule[] | null {
    const listed = (index: Index, name: string) => {
      const rules = index.get(name) ?? [];
      index.set(name, rules);
      return rules;
    };
    if (more.length > 0) return null;
    if (second) {
      const isClass = first.value === "." && second.kind === "ident" && first.end === second.start;
      return isClass ? listed(this.#byClass, second.value) : null;
    }
    if (first.kind === "ident") return listed(this.#byName, first.value);
    if (first.kind === "hash") return listed(this.#byId, first.value);
    return first.value === "*" ? this.#ofAll : null;
  }
}

/** What stands before a block, or before what ends a rule without one. */
interface Prelude {
  /** The token of the brace, or what ends the rule. */
  readonly end: number;
  readonly hasBlock: boolean;
}

function preludeAt(tokens: readonly Token[], from: number, isWithin: boolean): Prelude {
  const isAtRule = tokens[from].kind === "at";
  let at = from;
  while (at < tokens.length) {
    const { kind } = tokens[at];
    if (kind === "{") return { end: at, hasBlock: true };
    if ((isAtRule && kind === ";") || (isWithin && kind === "}")) break;
    at = behindComponent(tokens, at);
  }
  return { end: at, hasBlock: false };
}

function isMediaThatApplies(
  sheet: string,
  tokens: readonly Token[],
  from: number,
  open: number,
): boolean {
  const { kind, value, end } = tokens[from];
  const isMedia = kind === "at" && value.toLowerCase() === "media";
  return isMedia && isForScreen(sheet.slice(end, tokens[open].start));
}

/** What no selector of CSS is: CSS drops the whole rule then. */
function isNoSelector(tokens: readonly Token[]): boolean {
  return (
    tokens.length === 0 ||
    tokens.some(({ kind, value }) => {
      if (kind === "delim") return !"*.>+~|&=^$".includes(value);
      return ["number", "percentage", "dimension", "bad", "at", ";", "}"].includes(kind);
    })
  );
}

function strongest(rules: readonly Rule[], property: Property): Setting | null {
  let best: { setting: Setting; order: number } | null = null;
  for (const { settings, order } of rules) {
    const setting = settings.get(property);
    if (!setting) continue;
    const isStronger =
      !best ||
      (setting.isImportant === best.setting.isImportant
        ? order >= best.order
        : setting.isImportant);
    if (isStronger) best = { setting, order };
  }
  return best?.setting ?? null;
}
