// Selectors of CSS: the parts of each, and what is none.
import { beginsName, behindComponent, isFunction, solidFrom } from "./css.js";
import type { Token } from "./css.js";
import { SELECTOR_PARTS } from "./limits.js";

/** The condition of a part on an element; "never": a state that no element of a picture has, such as hovered. */
export type PartKind =
  | "any"
  | "element"
  | "class"
  | "id"
  | "attribute"
  | "root"
  | "first-child"
  | "last-child"
  | "only-child"
  | "never";

/** How the element relates to that of the part before; "": it is the same element. */
export type Combinator = "" | " " | ">" | "+" | "~";

/** How the value of an attribute compares; "": that it is there is enough. */
export type Match = "" | "=" | "~" | "|" | "^" | "$" | "*";

/** One condition on an element. */
export interface Part {
  readonly kind: PartKind;
  readonly name: string;
  readonly combinator: Combinator;
  readonly isNegated: boolean;
  readonly match: Match;
  /** The value that an attribute is compared with. */
  readonly value: string;
  readonly ignoresCase: boolean;
}

export interface Selector {
  /** "unsupported": CSS, but not read; "invalid": CSS drops the rule. */
  readonly kind: "read" | "unsupported" | "invalid";
  readonly parts: readonly Part[];
  /** The larger wins. */
  readonly specificity: number;
}

const PSEUDO_CLASSES: ReadonlyMap<string, PartKind> = new Map([
  ["root", "root"],
  ["first-child", "first-child"],
  ["last-child", "last-child"],
  ["only-child", "only-child"],
  ["hover", "never"],
  ["active", "never"],
  ["focus", "never"],
  ["focus-visible", "never"],
  ["focus-within", "never"],
  ["target", "never"],
  ["visited", "never"],
]);

/** Whether one part of this kind is found by its name. */
export function isNamed({ kind, isNegated }: Part): boolean {
  return !isNegated && (kind === "any" || kind === "element" || kind === "class" || kind === "id");
}

// Each counts at most SELECTOR_PARTS times.
const OF_CLASS = 2 * SELECTOR_PARTS;

function weightOf({ kind }: Part): number {
  if (kind === "any") return 0;
  if (kind === "element") return 1;
  return kind === "id" ? OF_CLASS * OF_CLASS : OF_CLASS;
}

function part(kind: PartKind, name = "", more: Partial<Part> = {}): Part {
  return {
    kind,
    name,
    combinator: "",
    isNegated: false,
    match: "",
    value: "",
    ignoresCase: false,
    ...more,
  };
}

function pseudoClass(name: string): Part | null {
  const kind = PSEUDO_CLASSES.get(name.toLowerCase());
  return kind ? part(kind) : null;
}

/** The content of brackets, and the token behind them. */
interface Inside {
  readonly part: Part;
  readonly behind: number;
}

/** Reads the selectors of a prelude. No token is a comment. */
class SelectorReader {
  readonly #text: string;
  readonly #tokens: readonly Token[];
  #at = 0;
  #parts: Part[] = [];
  #combinator: Combinator = "";
  #isValid = true;
  #isSupported = true;
  /** Something stands before, with nothing between. */
  #isInCompound = false;
  /** At the beginning and behind > + ~. */
  #needsCompound = true;
  #hasParts = false;

  constructor(text: string, tokens: readonly Token[]) {
    this.#text = text;
    this.#tokens = tokens;
  }

  *all(): Iterable<Selector> {
    for (;;) {
      const token = this.#tokens[this.#at];
      if (!token || token.kind === ",") {
        yield this.#finished();
        if (!token) return;
        this.#begin();
      }
      this.#at += 1;
      if (token.kind !== ",") this.#take(token);
    }
  }

  #begin(): void {
    this.#parts = [];
    this.#combinator = "";
    this.#isValid = this.#isSupported = this.#needsCompound = true;
    this.#isInCompound = this.#hasParts = false;
  }

  #finished(): Selector {
    const parts = this.#parts;
    if (!this.#isValid || this.#needsCompound) return { kind: "invalid", parts, specificity: 0 };
    if (!this.#isSupported) return { kind: "unsupported", parts, specificity: 0 };
    const specificity = parts.reduce((sum, one) => sum + weightOf(one), 0);
    return { kind: "read", parts, specificity };
  }

  #fail(): void {
    this.#isValid = false;
  }

  #add(added: Part): void {
    const isName = added.kind === "element" || added.kind === "any";
    // A name can only begin a compound: "g.a", not ".ag".
    if (isName && !added.isNegated && this.#isInCompound) this.#fail();
    const isNext = this.#hasParts && !this.#isInCompound;
    const combinator = isNext ? this.#combinator || " " : "";
    this.#combinator = "";
    this.#hasParts = this.#isInCompound = true;
    this.#needsCompound = false;
    if (this.#parts.length < SELECTOR_PARTS) this.#parts.push({ ...added, combinator });
    else this.#isSupported = false;
  }

  #addUnsupported(): void {
    this.#isSupported = false;
    this.#add(part("never"));
  }

  #combine(combinator: Combinator): void {
    if (this.#needsCompound) this.#fail();
    this.#combinator = combinator;
    this.#isInCompound = false;
    this.#needsCompound = true;
  }

  /** Takes what begins at the token before the next. */
  #take(token: Token): void {
    switch (token.kind) {
      case "blank":
        this.#isInCompound = false;
        return;
      case "ident":
        return this.#add(part("element", token.value));
      case "hash":
        return this.#isId(token) ? this.#add(part("id", token.value)) : this.#fail();
      case "delim":
        return this.#takeDelim(token.value);
      case ":":
        return this.#takePseudo();
      case "[":
        return this.#takeBrackets(this.#attribute(this.#at));
      default:
        this.#at = behindComponent(this.#tokens, this.#at - 1);
        return this.#fail();
    }
  }

  #isId({ start }: Token): boolean {
    return beginsName(this.#text, start + 1);
  }

  #takeDelim(sign: string): void {
    switch (sign) {
      case "*":
        return this.#add(part("any"));
      case ">":
      case "+":
      case "~":
        return this.#combine(sign);
      case "&":
        return this.#addUnsupported();
      case "|":
        // Behind the prefix of a namespace, which was taken for a name.
        this.#isSupported = false;
        this.#hasParts = this.#needsCompound = true;
        this.#isInCompound = false;
        return;
      case ".": {
        const name = this.#tokens[this.#at];
        if (name?.kind !== "ident") return this.#fail();
        this.#at += 1;
        return this.#add(part("class", name.value));
      }
      default:
        return this.#fail();
    }
  }

  #takePseudo(): void {
    const isElement = this.#tokens[this.#at]?.kind === ":";
    if (isElement) this.#at += 1;
    const token = this.#tokens[this.#at];
    if (token?.kind !== "ident" && token?.kind !== "function") return this.#fail();
    this.#at += 1;
    if (!isElement && isFunction(token, "not")) return this.#takeBrackets(this.#negated(this.#at));
    const known = !isElement && token.kind === "ident" ? pseudoClass(token.value) : null;
    if (known) return this.#add(known);
    this.#at = behindComponent(this.#tokens, this.#at - 1);
    this.#addUnsupported();
  }

  /** Takes a part in brackets, whose first token was taken; null: it is not read. */
  #takeBrackets(inside: Inside | null): void {
    this.#at = inside?.behind ?? behindComponent(this.#tokens, this.#at - 1);
    if (inside) this.#add(inside.part);
    else this.#addUnsupported();
  }

  /** Reads the text behind "[". The end of the text closes an open bracket. */
  #attribute(from: number): Inside | null {
    const tokens = this.#tokens;
    const solid = (at: number) => solidFrom(tokens, at);
    const nameAt = solid(from);
    if (tokens[nameAt]?.kind !== "ident") return null;
    const name = tokens[nameAt].value;
    let at = solid(nameAt + 1);
    const isClosed = () => at >= tokens.length || tokens[at].kind === "]";
    if (isClosed()) return { part: part("attribute", name), behind: at + 1 };
    const isSign = (i: number, signs: string) =>
      tokens[i]?.kind === "delim" && signs.includes(tokens[i].value);
    const isPlain = isSign(at, "=");
    if (!isPlain && !(isSign(at, "~|^$*") && isSign(at + 1, "="))) return null;
    const match = tokens[at].value as Match;
    const valueAt = solid(at + (isPlain ? 1 : 2));
    const value = tokens[valueAt];
    if (value?.kind !== "string" && value?.kind !== "ident") return null;
    at = solid(valueAt + 1);
    const flag = tokens[at]?.kind === "ident" ? tokens[at].value.toLowerCase() : "";
    if (flag === "i" || flag === "s") at = solid(at + 1);
    if (!isClosed()) return null;
    const asked = { match, value: value.value, ignoresCase: flag === "i" };
    return { part: part("attribute", name, asked), behind: at + 1 };
  }

  /** The only part within :not(…), whose name was taken. */
  #negated(from: number): Inside | null {
    const inside = this.#negatedPart(solidFrom(this.#tokens, from));
    if (!inside) return null;
    const last = solidFrom(this.#tokens, inside.behind);
    if (last < this.#tokens.length && this.#tokens[last].kind !== ")") return null;
    return { part: { ...inside.part, isNegated: true }, behind: last + 1 };
  }

  #negatedPart(at: number): Inside | null {
    const [token, name] = this.#tokens.slice(at, at + 2);
    if (!token) return null;
    const one = (found: Part | null) => found && { part: found, behind: at + 1 };
    if (token.kind === "ident") return one(part("element", token.value));
    if (token.kind === "hash" && this.#isId(token)) return one(part("id", token.value));
    if (token.kind === "[") return this.#attribute(at + 1);
    const isDelim = token.kind === "delim";
    if (isDelim && token.value === "*") return one(part("any"));
    if (name?.kind !== "ident") return null;
    const two = (found: Part | null) => found && { part: found, behind: at + 2 };
    if (isDelim && token.value === ".") return two(part("class", name.value));
    return token.kind === ":" ? two(pseudoClass(name.value)) : null;
  }
}

/** The selectors of a list. @param tokens of the text, without comments */
export function selectorsOf(text: string, tokens: readonly Token[]): Selector[] {
  return [...new SelectorReader(text, tokens).all()];
}
