// Properties of elements by the cascade of CSS: style="", the sheets of <style>, attributes. What
// the engine reads, and no more: selectors are a name, .class, #id or *.
import { attributeOf, SVG, valueOf } from "./attributes.js";
import { parseColor } from "./colors.js";
import { behindComponent, keywordOf, shareOf, solid, tokensOf } from "./css.js";
import type { Token } from "./css.js";
import { decodeText } from "./entities.js";
import { elementsOf } from "./nodes.js";
import type { ElementNode } from "./tree.js";

export const BLEND_MODES = [
  "normal", "multiply", "screen", "overlay", "darken", "lighten", "color-dodge", "color-burn",
  "hard-light", "soft-light", "difference", "exclusion", "hue", "saturation", "color", "luminosity",
] as const;

const isShare = (text: string) => shareOf(text) !== null;
const isColor = (text: string) => keywordOf(text) === "currentcolor" || parseColor(text) !== null;
const isOneOf = (...words: string[]) => (text: string) => words.includes(keywordOf(text) ?? "");

/** The words of `display`, up to three of them. */
const DISPLAYS: ReadonlySet<string> = new Set([
  "none", "inline", "block", "contents", "flow", "flow-root", "inline-block", "list-item", "run-in",
  "table", "inline-table", "table-row-group", "table-header-group", "table-footer-group",
  "table-row", "table-cell", "table-column-group", "table-column", "table-caption", "flex",
  "inline-flex", "grid", "inline-grid", "ruby", "ruby-base", "ruby-text", "ruby-base-container",
  "ruby-text-container",
]);

function isDisplay(text: string): boolean {
  const words = solid(tokensOf(text));
  const isKnown = ({ kind, value }: Token) => kind === "ident" && DISPLAYS.has(value.toLowerCase());
  return words.length > 0 && words.length <= 3 && words.every(isKnown);
}

/** Whether CSS keeps a declaration of a property with this value. */
const IS_VALUE = {
  display: isDisplay,
  visibility: isOneOf("visible", "hidden", "collapse"),
  opacity: isShare,
  "mix-blend-mode": isOneOf(...BLEND_MODES),
  fill: (text: string) => isColor(text) || keywordOf(text) === "none" || /^\s*url\(/i.test(text),
  "fill-opacity": isShare,
  color: isColor,
} as const;

export type Property = keyof typeof IS_VALUE;

const INHERITED: ReadonlySet<Property> = new Set(["visibility", "fill", "fill-opacity", "color"]);
const WIDE = ["inherit", "initial", "unset", "revert", "revert-layer"];

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
    last?.kind === "ident" && last.value.toLowerCase() === "important" && value.at(-2)?.value === "!";
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
  for (let i = 0; i <= tokens.length; ) {
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

interface Setting {
  readonly value: string;
  readonly isImportant: boolean;
}

type Settings = ReadonlyMap<Property, Setting>;

function settingsOf(declarations: readonly Declaration[]): Settings {
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

interface Rule {
  readonly settings: Settings;
  readonly order: number;
}

/** Whether a media query, or the attribute media, asks for a screen and no features. */
function isForScreen(query: string): boolean {
  const words = query.replace(/\/\*[\s\S]*?\*\//g, " ").trim().toLowerCase();
  return words === "" || words.split(",").some((one) => {
    const [, not, type] = /^\s*(not\s+|only\s+)?([a-z-]+)\s*$/.exec(one) ?? [];
    if (type === undefined) return false;
    const fits = type === "screen" || type === "all";
    return not?.startsWith("not") ? !fits : fits;
  });
}

/** Rules of one kind of selector by name. */
type Index = Map<string, Rule[]>;

export class Styles {
  readonly #byId: Index = new Map();
  readonly #byClass: Index = new Map();
  readonly #byName: Index = new Map();
  readonly #ofAll: Rule[] = [];
  readonly #own = new WeakMap<object, Settings>();
  #count = 0;

  /** The sheets of the document that `text` is. */
  constructor(text: string, root: ElementNode) {
    for (const element of elementsOf(root)) {
      if (element.local !== "style" || !isSvg(element)) continue;
      const type = (valueOf(element, "type") ?? "").trim().toLowerCase();
      const isCss = type === "" || type === "text/css";
      if (isCss && isForScreen(valueOf(element, "media") ?? "")) {
        this.#addSheet(sheetText(text.slice(element.content.start, element.content.end)));
      }
    }
  }

  get isEmpty(): boolean {
    return this.#count === 0;
  }

  /** What the sheets say of a property of an element. */
  inSheets(element: ElementNode, property: Property): Setting | null {
    let best: Setting | null = null;
    const consider = (rules: readonly Rule[] | undefined) => {
      const setting = rules && strongest(rules, property);
      if (setting && (!best || (setting.isImportant && !best.isImportant))) best = setting;
    };
    if (this.isEmpty) return best;
    consider(this.#byId.get(valueOf(element, "id") ?? ""));
    const classes = (valueOf(element, "class") ?? "").split(/\s+/).filter((name) => name !== "");
    consider(classes.flatMap((name) => this.#byClass.get(name) ?? []));
    consider(this.#byName.get(element.local));
    consider(this.#ofAll);
    return best;
  }

  /** What style="" says. */
  inStyle(element: ElementNode, property: Property): Setting | null {
    const style = attributeOf(element, "style");
    if (!style) return null;
    let settings = this.#own.get(style);
    if (!settings) {
      settings = settingsOf(declarationsOf(style.value));
      this.#own.set(style, settings);
    }
    return settings.get(property) ?? null;
  }

  /** The value of a property, or null where nothing or the initial value is set. */
  value(element: ElementNode, property: Property): string | null {
    for (let at: ElementNode | null = element; at; at = at.parent) {
      const own = this.#cascaded(at, property);
      const word = own === null ? null : keywordOf(own);
      if (word === null || !WIDE.includes(word)) {
        if (own !== null) return own;
        if (!INHERITED.has(property)) return null;
      } else if (word === "initial" || (word !== "inherit" && !INHERITED.has(property))) {
        return null;
      }
    }
    return null;
  }

  #cascaded(element: ElementNode, property: Property): string | null {
    const own = this.inStyle(element, property);
    const sheet = this.inSheets(element, property);
    const isSheetFirst = sheet?.isImportant && !own?.isImportant;
    const [first, second] = isSheetFirst ? [sheet, own] : [own, sheet];
    const attribute = valueOf(element, property)?.trim() ?? null;
    const candidates = [first?.value ?? null, second?.value ?? null, attribute];
    return candidates.find((v) => v !== null && keywordOf(v) !== "revert-layer") ?? null;
  }

  #addSheet(sheet: string): void {
    const tokens = tokensOf(sheet);
    /** Of @media that apply: their braces are passed over. */
    let depth = 0;
    for (let at = 0; at < tokens.length; ) {
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
      this.#add(solid(tokens.slice(from, open)), sheet.slice(tokens[open].end, end));
    }
    return behind;
  }

  #add(prelude: readonly Token[], block: string): void {
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

/** The characters of a <style>: its text and CDATA sections, without comments. */
function sheetText(content: string): string {
  const pieces = content.split(/(<!\[CDATA\[[\s\S]*?\]\]>|<!--[\s\S]*?-->|<[^>]*>)/);
  return pieces
    .map((piece) => {
      if (piece.startsWith("<![CDATA[")) return piece.slice(9, -3);
      return piece.startsWith("<") ? "" : decodeText(piece);
    })
    .join("");
}

/** Whether an element is SVG's; Illustrator writes an entity for the namespace, others none. */
export function isSvg({ name, local, namespace }: ElementNode): boolean {
  if (namespace === SVG) return true;
  return name === local && (namespace === "" || namespace.startsWith("&"));
}
