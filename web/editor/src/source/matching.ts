// Which rules with selectors of several parts match which elements.
import { isSvg, SFUMATO, valueOf, XLINK } from "./attributes.js";
import { wordsOf } from "./css.js";
import { SELECTOR_STEPS } from "./limits.js";
import type { PropertyName } from "./properties.js";
import type { Combinator, Part } from "./selectors.js";
import { keepStronger, keysOf } from "./sheet.js";
import type { Bearer, ComplexRule, RankedSetting, Sheet } from "./sheet.js";
import type { AttributeNode, ElementNode } from "./tree.js";

/** The settings of each element by such rules: the strongest for each property. */
export type Matches = ReadonlyMap<ElementNode, ReadonlyMap<PropertyName, RankedSetting>>;

/** Characters of a text that cost as much as any other step. */
const STEP_TEXT = 32;
/** Steps that a setting of a rule that matches costs. */
const SETTING_STEPS = 2;

/** Returns the features of an element that rules can match. */
export function bearerOf(element: ElementNode): Bearer {
  return {
    id: valueOf(element, "id") ?? "",
    classes: wordsOf(valueOf(element, "class") ?? ""),
    name: element.local,
  };
}

/**
 * Returns a selector's name for an attribute: Sfumato's attributes have a colon before their name.
 * @param hasHref whether the element has an href without a prefix
 */
export function askedName({ name, local, namespace }: AttributeNode, hasHref: boolean): string {
  if (namespace === SFUMATO) return `:${local}`;
  return namespace === XLINK && local === "href" && !hasHref ? "href" : name;
}

/** A document and all within that is SVG's, each element before its children. */
export function* svgElementsOf(root: ElementNode): Iterable<ElementNode> {
  const waiting = [root];
  for (let node = waiting.pop(); node; node = waiting.pop()) {
    yield node;
    const { children } = node;
    for (let i = children.length - 1; i >= 0; i -= 1) {
      if (isSvg(children[i])) waiting.push(children[i]);
    }
  }
}

/** The elements beside one, of SVG's. */
interface Siblings {
  readonly previous: ElementNode | null;
  readonly next: ElementNode | null;
}

const ALONE: Siblings = { previous: null, next: null };

/**
 * Why parts do not match: a search from another sibling or ancestor may succeed, or none can. With
 * that each part is tried once for each ancestor.
 */
type Outcome = "matched" | "try sibling" | "try ancestor" | "failed";

function compares(text: string, { match, value, ignoresCase }: Part): boolean {
  const folded = (one: string) =>
    ignoresCase ? one.replace(/[A-Z]/g, (letter) => letter.toLowerCase()) : one;
  const [own, asked] = [folded(text), folded(value)];
  switch (match) {
    case "":
      return true;
    case "=":
      return own === asked;
    case "~":
      return wordsOf(own).includes(asked);
    case "|":
      return own === asked || own.startsWith(`${asked}-`);
    case "^":
      return asked !== "" && own.startsWith(asked);
    case "$":
      return asked !== "" && own.endsWith(asked);
    case "*":
      return asked !== "" && own.includes(asked);
  }
}

/** Where the compound of the last of some parts begins. */
function compoundBegin(parts: readonly Part[], end: number): number {
  let begin = end - 1;
  while (begin > 0 && parts[begin].combinator === "") begin -= 1;
  return begin;
}

class Matcher {
  readonly #sheet: Sheet;
  readonly #siblings = new Map<ElementNode, Siblings>();
  #steps = 0;

  constructor(sheet: Sheet) {
    this.#sheet = sheet;
  }

  get isOver(): boolean {
    return this.#steps > SELECTOR_STEPS;
  }

  /** Counts steps; false once they are used up. */
  take(steps: number): boolean {
    this.#steps += steps;
    return !this.isOver;
  }

  *rulesFor(element: ElementNode): Iterable<ComplexRule> {
    const bearer = bearerOf(element);
    if (!this.take(bearer.classes.length)) return;
    for (const key of keysOf(bearer)) {
      for (const rule of this.#sheet.complexRules(key)) {
        if (this.#matchFrom(rule.parts, rule.parts.length, element) === "matched") yield rule;
        if (this.isOver) return;
      }
    }
  }

  /** Whether the parts before `end` match, the last of them this element. */
  #matchFrom(parts: readonly Part[], end: number, element: ElementNode): Outcome {
    const begin = compoundBegin(parts, end);
    for (let i = begin; i < end; i += 1) {
      if (!this.take(1) || this.#isMet(parts[i], element) === parts[i].isNegated) {
        return "try sibling";
      }
    }
    if (begin === 0) return "matched";
    return this.#matchBefore(parts, begin, parts[begin].combinator, element);
  }

  #matchBefore(
    parts: readonly Part[],
    end: number,
    combinator: Combinator,
    element: ElementNode,
  ): Outcome {
    if (combinator === "+" || combinator === "~") {
      return this.#matchSibling(parts, end, element, combinator === "~");
    }
    if (combinator !== ">") return this.#matchAncestor(parts, end, element);
    if (!element.parent) return "failed";
    const outcome = this.#matchFrom(parts, end, element.parent);
    return outcome === "try sibling" ? "try ancestor" : outcome;
  }

  #matchAncestor(parts: readonly Part[], end: number, element: ElementNode): Outcome {
    for (let outer = element.parent; outer; outer = outer.parent) {
      const outcome = this.#matchFrom(parts, end, outer);
      if (outcome === "matched" || outcome === "failed" || this.isOver) return outcome;
    }
    return "failed";
  }

  /** @param isAny whether it may be any sibling before, not the previous one alone */
  #matchSibling(
    parts: readonly Part[],
    end: number,
    element: ElementNode,
    isAny: boolean,
  ): Outcome {
    for (let one = this.#previous(element); one; one = this.#previous(one)) {
      const outcome = this.#matchFrom(parts, end, one);
      if (outcome !== "try sibling" || !isAny || this.isOver) return outcome;
    }
    return "try ancestor";
  }

  #previous(element: ElementNode): ElementNode | null {
    return this.take(1) ? this.#siblingsOf(element).previous : null;
  }

  #next(element: ElementNode): ElementNode | null {
    return this.take(1) ? this.#siblingsOf(element).next : null;
  }

  #siblingsOf(element: ElementNode): Siblings {
    const { parent } = element;
    if (!parent) return ALONE;
    if (!this.#siblings.has(element)) {
      const all = parent.children.filter(isSvg);
      all.forEach((one, i) => {
        this.#siblings.set(one, { previous: all[i - 1] ?? null, next: all[i + 1] ?? null });
      });
    }
    return this.#siblings.get(element) ?? ALONE;
  }

  #isMet(part: Part, element: ElementNode): boolean {
    switch (part.kind) {
      case "any":
        return true;
      case "element":
        return part.name === element.local;
      case "class":
        return this.#hasClass(part.name, element);
      case "id":
        return part.name === (valueOf(element, "id") ?? "");
      case "attribute":
        return this.#hasAttribute(part, element);
      case "root":
        return !element.parent;
      case "first-child":
        return !this.#previous(element);
      case "last-child":
        return !this.#next(element);
      case "only-child":
        return !this.#previous(element) && !this.#next(element);
      case "never":
        return false;
    }
  }

  #hasClass(asked: string, element: ElementNode): boolean {
    const classes = valueOf(element, "class") ?? "";
    return this.take(Math.floor(classes.length / STEP_TEXT)) && wordsOf(classes).includes(asked);
  }

  #hasAttribute(part: Part, { attributes }: ElementNode): boolean {
    const hasHref = attributes.some(({ name }) => name === "href");
    const at = attributes.findIndex((one) => askedName(one, hasHref) === part.name);
    if (!this.take(at < 0 ? attributes.length : at + 1) || at < 0) return false;
    const { value } = attributes[at];
    const tries = part.match === "*" ? 1 + part.value.length : 1;
    return this.take(tries * Math.floor(value.length / STEP_TEXT)) && compares(value, part);
  }
}

/**
 * Matches all elements in the order of the document. Once the steps are used up, rules with
 * selectors of several parts match no more.
 */
export function matchesOf(sheet: Sheet, root: ElementNode): Matches {
  const matches = new Map<ElementNode, ReadonlyMap<PropertyName, RankedSetting>>();
  if (!sheet.hasComplexRules) return matches;
  const matcher = new Matcher(sheet);
  for (const element of svgElementsOf(root)) {
    const winners = new Map<PropertyName, RankedSetting>();
    for (const { settings, specificity, order } of matcher.rulesFor(element)) {
      if (!matcher.take(SETTING_STEPS * settings.size)) break;
      for (const [property, setting] of settings) {
        keepStronger(winners, property, { ...setting, specificity, order });
      }
    }
    if (matcher.isOver) break;
    if (winners.size > 0) matches.set(element, winners);
  }
  return matches;
}
