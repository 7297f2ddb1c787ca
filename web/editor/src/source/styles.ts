// Properties of elements by the cascade of CSS: style="", the sheets of <style>, attributes. What
// the engine reads, and no more.
import { attributeOf, SVG, valueOf } from "./attributes.js";
import { keywordOf } from "./css.js";
import { declarationsOf, settingsOf } from "./declarations.js";
import type { Setting, Settings } from "./declarations.js";
import { decodeText } from "./entities.js";
import { elementsOf } from "./nodes.js";
import { INHERITED, WIDE } from "./properties.js";
import type { Property } from "./properties.js";
import { isForScreen, Sheet } from "./sheet.js";
import type { ElementNode } from "./tree.js";

export { BLEND_MODES } from "./properties.js";
export type { Property } from "./properties.js";

export class Styles {
  readonly #sheet = new Sheet();
  readonly #own = new WeakMap<object, Settings>();

  /** The sheets of the document that `text` is. */
  constructor(text: string, root: ElementNode) {
    for (const element of elementsOf(root)) {
      if (element.local !== "style" || !isSvg(element)) continue;
      const type = (valueOf(element, "type") ?? "").trim().toLowerCase();
      const isCss = type === "" || type === "text/css";
      if (isCss && isForScreen(valueOf(element, "media") ?? "")) {
        this.#sheet.add(sheetText(text.slice(element.content.start, element.content.end)));
      }
    }
  }

  get isEmpty(): boolean {
    return this.#sheet.isEmpty;
  }

  /** What the sheets say of a property of an element. */
  inSheets(element: ElementNode, property: Property): Setting | null {
    if (this.isEmpty) return null;
    const classes = (valueOf(element, "class") ?? "").split(/\s+/).filter((name) => name !== "");
    const bearer = { id: valueOf(element, "id") ?? "", classes, name: element.local };
    return this.#sheet.find(bearer, property);
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
      const own = this.own(at, property);
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

  /** What an element itself has, by its style="", the sheets and its attribute; null: nothing. */
  own(element: ElementNode, property: Property): string | null {
    const own = this.inStyle(element, property);
    const sheet = this.inSheets(element, property);
    const isSheetFirst = sheet?.isImportant && !own?.isImportant;
    const [first, second] = isSheetFirst ? [sheet, own] : [own, sheet];
    const attribute = valueOf(element, property)?.trim() ?? null;
    const candidates = [first?.value ?? null, second?.value ?? null, attribute];
    return candidates.find((v) => v !== null && keywordOf(v) !== "revert-layer") ?? null;
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

/** Whether an element is SVG's; Illustrator writes an entity for the namespace, others none. */
export function isSvg({ name, local, namespace }: ElementNode): boolean {
  if (namespace === SVG) return true;
  return name === local && (namespace === "" || namespace.startsWith("&"));
}
