// The values that var() stands for (CSS Custom Properties 1, section 3).
import { VARIABLE_BYTES, VARIABLE_DEPTH, VARIABLE_VALUE_BYTES } from "./limits.js";
import type { Wide } from "./properties.js";
import type { ElementNode } from "./tree.js";
import { byteLength, piecesOf } from "./variables.js";
import type { Reference, VariableName } from "./variables.js";

/** The declared value of an element's property: a CSS-wide keyword, or a value. */
export interface Cascaded {
  readonly wide: Wide | null;
  readonly value: string | null;
  /** Whether the element says so itself: not a sheet, and without var(). */
  readonly isOwn: boolean;
}

/** Returns an element's own declaration of a custom property. */
export type Declared = (element: ElementNode, name: VariableName) => Cascaded;

/** Cost of each visit of a var() or an element, so that empty values cost as well. */
const LOOK_BYTES = 16;

/** Bytes that all values of a document have used. */
export interface Spent {
  bytes: number;
}

/** A custom property whose value is being computed, and the element that declares it. */
interface Open {
  readonly element: ElementNode;
  readonly name: VariableName;
}

const IN_TOKEN = /[-\w.%#+\\\u0080-\uffff]/;

/** Pieces put together, kept apart where two would become one token. */
function joined(pieces: readonly string[]): string {
  const kept = pieces.filter((piece) => piece !== "");
  const apart = kept.map((piece, i) => {
    const isOne = i > 0 && IN_TOKEN.test(kept[i - 1].slice(-1)) && IN_TOKEN.test(piece[0]);
    return isOne ? `/**/${piece}` : piece;
  });
  return apart.join("");
}

/** Replaces var() in one value. */
class Substitution {
  readonly #declared: Declared;
  readonly #spent: Spent;
  readonly #open: Open[] = [];
  /** The outermost open property of a cycle that was found; those within it are invalid. */
  #cycleBegin = Infinity;
  #depth = 0;
  #bytes = 0;
  #isOver = false;

  constructor(declared: Declared, spent: Spent) {
    this.#declared = declared;
    this.#spent = spent;
  }

  /** null: a property is missing, of a cycle, or beyond a limit. */
  expand(scope: ElementNode, value: string): string | null {
    if (this.#depth >= VARIABLE_DEPTH) this.#isOver = true;
    if (!this.#take(LOOK_BYTES + byteLength(value))) return null;
    this.#depth += 1;
    const pieces = this.#pieces(scope, piecesOf(value) ?? []);
    this.#depth -= 1;
    return pieces && joined(pieces);
  }

  #pieces(scope: ElementNode, pieces: readonly (string | Reference)[]): string[] | null {
    const texts: string[] = [];
    for (const piece of pieces) {
      const text = typeof piece === "string" ? this.#taken(piece) : this.#replaced(scope, piece);
      if (text === null) return null;
      texts.push(text);
    }
    return texts;
  }

  #taken(text: string): string | null {
    return this.#take(byteLength(text)) ? text : null;
  }

  #take(bytes: number): boolean {
    this.#bytes += bytes;
    this.#spent.bytes += bytes;
    this.#isOver ||= this.#bytes > VARIABLE_VALUE_BYTES || this.#spent.bytes > VARIABLE_BYTES;
    return !this.#isOver;
  }

  #replaced(scope: ElementNode, { name, fallback }: Reference): string | null {
    const value = this.#valueOf(scope, name);
    if (value !== null) return value;
    // Within a cycle a fallback does not count; without a limit's room nothing does.
    if (this.#cycleBegin < Infinity || this.#isOver || fallback === null) return null;
    return this.expand(scope, fallback);
  }

  /** The value where the element or the nearest around it declares the property. */
  #valueOf(scope: ElementNode, name: VariableName): string | null {
    for (let element: ElementNode | null = scope; element; element = element.parent) {
      if (!this.#take(LOOK_BYTES)) return null;
      const { wide, value } = this.#declared(element, name);
      if (value !== null) return this.#declaredValue({ element, name }, value);
      if (wide === "initial") return null;
    }
    return null;
  }

  #declaredValue(open: Open, value: string): string | null {
    const { element, name } = open;
    const found = this.#open.findIndex((one) => one.element === element && one.name === name);
    if (found >= 0) {
      this.#cycleBegin = Math.min(this.#cycleBegin, found);
      return null;
    }
    this.#open.push(open);
    const expanded = this.expand(element, value);
    this.#open.pop();
    const isOfCycle = this.#cycleBegin <= this.#open.length;
    if (this.#cycleBegin === this.#open.length) this.#cycleBegin = Infinity;
    return isOfCycle || expanded === null ? null : this.#taken(expanded);
  }
}

/** A value of an element with each var() replaced; null: it comes to nothing. */
export function substituted(
  declared: Declared,
  spent: Spent,
  scope: ElementNode,
  value: string,
): string | null {
  return new Substitution(declared, spent).expand(scope, value);
}
