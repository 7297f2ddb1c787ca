// The palette of a document: named colours in the form that Inkscape gives its swatches, gradients of one stop.
import type { Rgb } from "../geometry/color.js";
import { INKSCAPE, valueOf } from "../source/attributes.js";
import { isSvg, Styles } from "../source/styles.js";
import type { ElementNode } from "../source/tree.js";
import { stopColor, stopsWithin } from "./gradients.js";
import type { Drawing } from "./types.js";

/** The namespace that older versions of Inkscape mark swatches with. */
const OSB = "http://www.openswatchbook.org/uri/2009/osb";

export interface Swatch {
  /** Its id, or "". */
  readonly name: string;
  readonly color: Rgb;
  readonly element: ElementNode;
}

export const SWATCH = { namespace: INKSCAPE, local: "swatch" } as const;

/** Returns whether an element is a colour of the palette. */
export function isSwatch(element: ElementNode): boolean {
  if (element.local !== "linearGradient" || !isSvg(element)) return false;
  const marks = [SWATCH, { namespace: OSB, local: "paint" }].map((name) => valueOf(element, name));
  return marks.includes("solid") && stopsWithin(element).length === 1;
}

/** Elements outside of groups and layers, where definitions stand. */
export function* definitionsOf({ root }: Drawing): Generator<ElementNode> {
  const within = function* (element: ElementNode): Generator<ElementNode> {
    yield element;
    for (const child of element.children) yield* within(child);
  };
  for (const child of root.children) if (child.local !== "g") yield* within(child);
}

/** The palettes that were read, by the root of their document, with the objects that say whether they are the same. */
const read = new WeakMap<ElementNode, { readonly parts: readonly unknown[]; readonly swatches: readonly Swatch[] }>();

/** Returns an element with the attributes of its stop and of the elements around that: edits replace them. */
function partsOf(element: ElementNode): readonly unknown[] {
  const parts: unknown[] = [element];
  for (let at: ElementNode | null = stopsWithin(element)[0]; at; at = at.parent) parts.push(at.attributes);
  return parts;
}

/** Returns the palette, in the order of the text. It is read again only when its elements change. */
export function swatchesOf(d: Drawing): readonly Swatch[] {
  const elements = [...definitionsOf(d)].filter(isSwatch);
  const parts = elements.flatMap(partsOf);
  const known = read.get(d.root);
  if (known?.parts.length === parts.length && known.parts.every((part, k) => part === parts[k])) return known.swatches;
  const styles = new Styles(d.text, d.root);
  const swatches = elements.map((element) => ({
    name: valueOf(element, "id") ?? "",
    color: stopColor(styles, stopsWithin(element)[0]).rgb,
    element,
  }));
  read.set(d.root, { parts, swatches });
  return swatches;
}
