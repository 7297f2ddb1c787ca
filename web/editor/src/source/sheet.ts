// Style sheets: the settings of their rules, and the elements that they select.
import { behindComponent, componentAt, tokensOf, uncommented } from "./css.js";
import type { Token } from "./css.js";
import { declarationsOf, settingsOf } from "./declarations.js";
import type { Setting, Settings } from "./declarations.js";
import { STYLE_VALUES } from "./limits.js";
import { isForScreen } from "./media.js";
import type { PropertyName } from "./properties.js";
import { isNamed, selectorsOf } from "./selectors.js";
import type { Part, PartKind, Selector } from "./selectors.js";

/** A setting of a rule, with its place in the cascade. */
export interface RankedSetting extends Setting {
  readonly specificity: number;
  /** Order of the rules in the sheets. */
  readonly order: number;
}

/** A rule whose selector has several parts, or one that is not found by a name. */
export interface ComplexRule {
  readonly parts: readonly Part[];
  readonly settings: Settings;
  readonly specificity: number;
  readonly order: number;
}

export function outranks(a: RankedSetting, b: RankedSetting): boolean {
  if (a.isImportant !== b.isImportant) return a.isImportant;
  return a.specificity === b.specificity ? a.order > b.order : a.specificity > b.specificity;
}

/** Sets a property where nothing stronger does. */
export function keepStronger(
  values: Map<PropertyName, RankedSetting>,
  property: PropertyName,
  setting: RankedSetting,
): void {
  const before = values.get(property);
  if (!before || outranks(setting, before)) values.set(property, setting);
}

/** The features of an element that selectors of one part use. */
export interface Bearer {
  readonly id: string;
  readonly classes: readonly string[];
  readonly name: string;
}

/** A kind of part and its name, as one text. */
const keyOf = (kind: PartKind, name: string) => `${kind} ${name}`;

/** The keys under which rules for an element may stand. */
export function* keysOf({ id, classes, name }: Bearer): Iterable<string> {
  yield keyOf("any", "");
  yield keyOf("element", name);
  for (const one of new Set(classes)) yield keyOf("class", one);
  if (id !== "") yield keyOf("id", id);
}

/** How much a part is preferred as a key: the later kinds are rarer. */
const KEY_KINDS: readonly PartKind[] = ["any", "element", "class", "id"];

/** Returns the key by which a selector's last compound is found: its id, else a class, else a name. */
function lastKeyOf(parts: readonly Part[]): string {
  let [kind, name] = ["any" as PartKind, ""];
  for (let i = parts.length - 1; i >= 0; i -= 1) {
    const part = parts[i];
    const isBetter = KEY_KINDS.indexOf(part.kind) > KEY_KINDS.indexOf(kind);
    if (isBetter && !part.isNegated) [kind, name] = [part.kind, part.name];
    if (part.combinator !== "") break;
  }
  return keyOf(kind, name);
}

/** The rules of all sheets of a document. */
export class Sheet {
  /** The settings of rules with a selector of one named part: the strongest for each property. */
  readonly #simple = new Map<string, Map<PropertyName, RankedSetting>>();
  readonly #complex = new Map<string, ComplexRule[]>();
  readonly #askedAttributes = new Set<string>();
  /** Number of values that rules set, and of selector parts except the first. */
  #count = 0;

  get isEmpty(): boolean {
    return this.#simple.size === 0 && !this.hasComplexRules;
  }

  get hasComplexRules(): boolean {
    return this.#complex.size > 0;
  }

  /** Returns whether rules use an attribute; ids and classes in selectors of one part do not count. */
  asksFor(attribute: string): boolean {
    const isNamed = attribute === "id" || attribute === "class";
    return this.#askedAttributes.has(attribute) || (isNamed && this.hasComplexRules);
  }

  /** Returns the setting of an element's property by rules with selectors of one part. */
  find(bearer: Bearer, property: PropertyName): RankedSetting | null {
    let best: RankedSetting | null = null;
    for (const key of keysOf(bearer)) {
      const setting = this.#simple.get(key)?.get(property);
      if (setting && (!best || outranks(setting, best))) best = setting;
    }
    return best;
  }

  /** The complex rules that stand under a key. */
  complexRules(key: string): readonly ComplexRule[] {
    return this.#complex.get(key) ?? [];
  }

  /** Adds the rules of a sheet. */
  add(sheet: string): void {
    const tokens = uncommented(tokensOf(sheet));
    /** Depth of @media that apply: their braces are skipped. */
    let depth = 0;
    for (let at = 0; at < tokens.length;) {
      const { kind } = tokens[at];
      const isMark = depth === 0 && (kind === "cdo" || kind === "cdc");
      if (kind === "blank" || isMark) at += 1;
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
    const { behind, isClosed } = componentAt(tokens, open);
    const end = isClosed ? tokens[behind - 1].start : sheet.length;
    if (tokens[from].kind !== "at") {
      this.#addRules(sheet, tokens.slice(from, open), sheet.slice(tokens[open].end, end));
    }
    return behind;
  }

  #addRules(sheet: string, prelude: readonly Token[], block: string): void {
    const selectors = selectorsOf(sheet, prelude);
    if (selectors.some(({ kind }) => kind === "invalid")) return;
    const declarations = declarationsOf(block);
    const settings = settingsOf(declarations);
    for (const selector of selectors) {
      if (selector.kind !== "read") continue;
      const order = this.#count;
      this.#count += declarations.length + selector.parts.length - 1;
      if (this.#count > STYLE_VALUES) return;
      if (settings.size > 0) this.#add(selector, settings, order);
    }
  }

  #add({ parts, specificity }: Selector, settings: Settings, order: number): void {
    const [first] = parts;
    if (parts.length > 1 || !isNamed(first)) {
      const rule = { parts, settings, specificity, order };
      listed(this.#complex, lastKeyOf(parts), (): ComplexRule[] => []).push(rule);
      for (const { kind, name } of parts) {
        if (kind === "attribute") this.#askedAttributes.add(name);
      }
      return;
    }
    const values = listed(this.#simple, keyOf(first.kind, first.name), () => new Map());
    for (const [property, setting] of settings) {
      keepStronger(values, property, { ...setting, specificity, order });
    }
  }
}

/** The value of a key, which is made where it is not there. */
function listed<Value>(map: Map<string, Value>, key: string, make: () => Value): Value {
  const value = map.get(key) ?? make();
  map.set(key, value);
  return value;
}

/** The text before a block, or before the end of a rule without one. */
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
