// Moves curves outside of layers into a layer, for the clipboard.
import { composed, IDENTITY } from "../../../geometry/affine.js";
import type { Affine } from "../../../geometry/affine.js";
import { declare, isOfSfumato, patchOf, setAttribute, sf, SFUMATO, sfName, valueOf } from "../../../source/attributes.js";
import { keywordOf } from "../../../source/css.js";
import { parseTransform } from "../../../source/lengths.js";
import { applied } from "../../../source/patch.js";
import { isSvg, Styles } from "../../../source/styles.js";
import type { ElementNode } from "../../../source/tree.js";
import { CURVES_MARK } from "./copying.js";
import { Draft } from "../curves/draft.js";
import { transformText } from "../mapping.js";
import { svgName } from "../markup.js";

const SHAPES = new Set(["path", "line", "polyline", "polygon", "circle", "ellipse", "rect"]);
const HOLDERS = new Set(["svg", "g", "a", "switch"]);

interface Found {
  readonly element: ElementNode;
  /** From the shape's coordinates to the document's. */
  readonly frame: Affine;
}

/** Moves curves outside of layers into a marked layer. Returns the new text. */
export function adopted(text: string, root: ElementNode): string {
  const shapes = new Shapes(text, root).all();
  if (shapes.length === 0) return text;
  const draft = new Draft(text);
  const pieces = shapes.map(({ element, frame }) =>
    draft.rewritten(element, setAttribute(text, element, "transform", transformText(frame, 1, 1e-7))),
  );
  const g = svgName(root, "g");
  const layer = `<${g} ${sfName(root, "diffuse")}="true" ${CURVES_MARK}="true">${pieces.join("")}</${g}>`;
  const { end } = root.content;
  return applied(text, patchOf([...declare(text, root, SFUMATO), { at: end, removed: "", inserted: layer }]));
}

class Shapes {
  readonly #styles: Styles;
  readonly #found: Found[] = [];

  constructor(
    text: string,
    readonly root: ElementNode,
  ) {
    this.#styles = new Styles(text, root);
  }

  all(): readonly Found[] {
    for (const child of this.root.children) this.#look(child, IDENTITY);
    return this.#found;
  }

  #look(element: ElementNode, outer: Affine): void {
    if (!isSvg(element) || this.#isHidden(element)) return;
    const frame = composed(outer, parseTransform(valueOf(element, "transform") ?? "") ?? IDENTITY);
    if (HOLDERS.has(element.local)) {
      if (valueOf(element, sf("diffuse")) === "true") return;
      for (const child of element.children) this.#look(child, frame);
    } else if (SHAPES.has(element.local)) {
      const isStroke = valueOf(element, sf("radius")) !== undefined;
      if (isOfSfumato(element) && !isStroke) this.#found.push({ element, frame });
    }
  }

  #isHidden(element: ElementNode): boolean {
    return (
      keywordOf(this.#styles.value(element, "display") ?? "inline") === "none" ||
      keywordOf(this.#styles.value(element, "visibility") ?? "visible") !== "visible"
    );
  }
}
