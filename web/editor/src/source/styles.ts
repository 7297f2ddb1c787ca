// Properties of elements by the cascade of CSS: style="", the sheets of <style>, attributes. Only the
// properties that the engine reads.
import { attributeOf, valueOf } from "./attributes.js";
import { keywordOf, trimmed } from "./css.js";
import { declarationsOf, settingsOf } from "./declarations.js";
import type { Setting, Settings } from "./declarations.js";
import { decodeText } from "./entities.js";
import { askedName, bearerOf, matchesOf, svgElementsOf } from "./matching.js";
import type { Matches } from "./matching.js";
import { isForScreen } from "./media.js";
import { INHERITED, isValue, wideOf } from "./properties.js";
import type { Property, PropertyName } from "./properties.js";
import { outranks, Sheet } from "./sheet.js";
import { substituted } from "./substitution.js";
import type { Cascaded, Declared } from "./substitution.js";
import type { AttributeNode, ElementNode } from "./tree.js";
import { variablesIn } from "./variables.js";

export { isSvg } from "./attributes.js";
export { BLEND_MODES } from "./properties.js";
export type { Property } from "./properties.js";

const NOTHING: Cascaded = { wide: null, value: null, isOwn: true };
/** The value of a var() without a result. */
const UNSET: Cascaded = { wide: "unset", value: null, isOwn: false };

export class Styles {
  readonly #root: ElementNode;
  readonly #sheet = new Sheet();
  readonly #own = new WeakMap<object, Settings>();
  /** The settings of rules with selectors of several parts; null: not known. */
  #matches: Matches | null = null;
  /** Values after var() was replaced, and the bytes that this took. */
  #substituted = new Map<ElementNode, Map<string, Cascaded>>();
  #spent = { bytes: 0 };

  /** The sheets of the document that `text` is. */
  constructor(text: string, root: ElementNode) {
    this.#root = root;
    for (const element of svgElementsOf(root)) {
      if (element.local !== "style") continue;
      const type = valueOf(element, "type") ?? "";
      const isCss = type === "" || type.toLowerCase() === "text/css";
      if (isCss && isForScreen(valueOf(element, "media") ?? "")) {
        this.#sheet.add(sheetText(text.slice(element.content.start, element.content.end)));
      }
    }
  }

  get isEmpty(): boolean {
    return this.#sheet.isEmpty;
  }

  /**
   * Takes note that these attributes of an element changed, before or now. Whether rules may match
   * other elements now.
   */
  attributesChanged(changed: readonly AttributeNode[]): boolean {
    this.#substituted.clear();
    this.#spent = { bytes: 0 };
    const isAsked = changed.some((one) =>
      [one.name, askedName(one, false)].some((name) => this.#sheet.asksFor(name)),
    );
    if (isAsked) this.#matches = null;
    return isAsked;
  }

  /** Returns whether rules test an attribute, so that they may match or not once it is set. */
  asksFor(attribute: string): boolean {
    return this.#sheet.asksFor(attribute);
  }

  /** Returns the setting of an element's property in the sheets. */
  inSheets(element: ElementNode, property: PropertyName): Setting | null {
    if (this.isEmpty) return null;
    this.#matches ??= matchesOf(this.#sheet, this.#root);
    const simple = this.#sheet.find(bearerOf(element), property);
    const complex = this.#matches.get(element)?.get(property) ?? null;
    return simple && complex && outranks(simple, complex) ? simple : (complex ?? simple);
  }

  /** Returns the setting in style="". */
  inStyle(element: ElementNode, property: PropertyName): Setting | null {
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
      const { wide, value } = this.own(at, property);
      if (value !== null) return value;
      if (wide !== "inherit" && (wide === "initial" || !INHERITED.has(property))) return null;
    }
    return null;
  }

  /**
   * Returns an element's own value by its style="", the sheets and its attribute, with var() replaced. Where
   * var() has no result, the property counts as unset.
   */
  own(element: ElementNode, property: Property): Cascaded {
    const own = this.#withVariables(element, property);
    const isCurrent = property === "color" && keywordOf(own.value ?? "") === "currentcolor";
    // As a value of `color` itself it is the colour around the element.
    return isCurrent ? { ...own, wide: "inherit", value: null } : own;
  }

  #withVariables(element: ElementNode, property: Property): Cascaded {
    const attribute = valueOf(element, property);
    const declared = this.#declared(element, property, attribute ?? null);
    if (declared.value === null || variablesIn(declared.value) === "none") return declared;
    const known = this.#substituted.get(element) ?? new Map<string, Cascaded>();
    this.#substituted.set(element, known);
    const found = known.get(property) ?? this.#replaced(element, property, declared.value);
    known.set(property, found);
    return found;
  }

  #replaced(element: ElementNode, property: Property, written: string): Cascaded {
    if (variablesIn(written) === "invalid") return UNSET;
    const declared: Declared = (at, name) => this.#declared(at, name, null);
    const value = substituted(declared, this.#spent, element, written);
    if (value === null || !isValue(property, value)) return UNSET;
    const wide = wideOf(value);
    if (wide === null) return { wide, value, isOwn: false };
    return wide === "revert-layer" ? UNSET : { wide, value: null, isOwn: false };
  }

  /** The winner among style="", the sheets and an attribute. */
  #declared(element: ElementNode, property: PropertyName, attribute: string | null): Cascaded {
    const own = this.inStyle(element, property);
    const sheet = this.inSheets(element, property);
    const isSheetFirst = sheet?.isImportant && !own?.isImportant;
    const settings = isSheetFirst ? [sheet, own] : [own, sheet];
    const written = attribute === null ? null : { value: trimmed(attribute) };
    for (const setting of [...settings, written]) {
      if (!setting) continue;
      const wide = wideOf(setting.value);
      const isOwn = setting !== sheet;
      if (wide === null) return { wide, value: setting.value, isOwn };
      if (wide !== "revert-layer") return { wide, value: null, isOwn };
    }
    return NOTHING;
  }
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
