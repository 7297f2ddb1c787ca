// Plain shapes made curves: what is inside of a filled one gets its fill, a line its stroke.
import { composed, IDENTITY, translation } from "../../../geometry/affine.js";
import type { Affine } from "../../../geometry/affine.js";
import type { CubicPath } from "../../../geometry/cubic.js";
import { shapePaths } from "../../../geometry/path.js";
import { declare, hrefOf, setAttribute, sf, SFUMATO, sfName, valueOf } from "../../../source/attributes.js";
import { colorText, parseColor } from "../../../source/colors.js";
import { keywordOf, urlOf } from "../../../source/css.js";
import { parseLength, parseTransform } from "../../../source/lengths.js";
import type { Edit } from "../../../source/patch.js";
import { applied } from "../../../source/patch.js";
import { patchOf } from "../../../source/attributes.js";
import { isSvg, Styles } from "../../../source/styles.js";
import type { ElementNode } from "../../../source/tree.js";
import { CURVES_MARK } from "./copying.js";
import { Draft } from "../curves/draft.js";
import { transformText } from "../mapping.js";
import { svgName } from "../markup.js";
import { idsWithin, within } from "./references.js";

const SHAPES = new Set(["path", "line", "polyline", "polygon", "circle", "ellipse", "rect"]);
const HOLDERS = new Set(["svg", "g", "a", "switch"]);
/** Uses of uses, deeper than anybody draws. */
const DEEPEST_USE = 8;

interface Found {
  readonly element: ElementNode;
  /** From the shape's coordinates to the document's. */
  readonly frame: Affine;
}

/** Returns whether an element belongs to Sfumato. The version alone does not count. */
function isOfSfumato({ attributes }: ElementNode): boolean {
  return attributes.some((it) => it.namespace === SFUMATO && it.local !== "version");
}

/**
 * A text whose plain shapes stand in a marked layer: of a drawing those with Sfumato's attributes
 * that no layer holds, of any other text all that are shown.
 */
export function adopted(text: string, root: ElementNode): string {
  const isDrawing = [...within(root)].some(isOfSfumato);
  const shapes = new Shapes(text, root).all(isDrawing);
  if (shapes.length === 0) return isDrawing ? text : hidden(text, root, "");
  const draft = new Draft(text);
  const sides = new Sides(text, root);
  const pieces = shapes.map((shape) => sides.markup(draft, shape, isDrawing));
  const g = svgName(root, "g");
  const layer = `<${g} ${sfName(root, "diffuse")}="true" ${CURVES_MARK}="true">${pieces.join("")}</${g}>`;
  const declared = declare(text, root, SFUMATO);
  if (!isDrawing) return hidden(text, root, layer, declared);
  const { end } = root.content;
  return applied(text, patchOf([...declared, { at: end, removed: "", inserted: layer }]));
}

/** All that a document holds as definitions, with a layer besides. */
function hidden(text: string, root: ElementNode, layer: string, declared: readonly Edit[] = []): string {
  if (root.closesItself) return text;
  const defs = svgName(root, "defs");
  const { start, end } = root.content;
  return applied(
    text,
    patchOf([
      ...declared,
      { at: start, removed: "", inserted: `<${defs}>` },
      { at: end, removed: "", inserted: `</${defs}>${layer}` },
    ]),
  );
}

class Shapes {
  readonly #styles: Styles;
  readonly #ids: Map<string, ElementNode>;
  readonly #found: Found[] = [];

  constructor(
    text: string,
    readonly root: ElementNode,
  ) {
    this.#styles = new Styles(text, root);
    this.#ids = idsWithin(root);
  }

  all(isDrawing: boolean): readonly Found[] {
    for (const child of this.root.children) this.#look(child, IDENTITY, isDrawing, 0);
    return this.#found;
  }

  #look(element: ElementNode, outer: Affine, isDrawing: boolean, uses: number): void {
    if (!isSvg(element) || this.#isHidden(element)) return;
    const frame = composed(outer, parseTransform(valueOf(element, "transform") ?? "") ?? IDENTITY);
    if (HOLDERS.has(element.local)) {
      if (isDrawing && valueOf(element, sf("diffuse")) === "true") return;
      for (const child of element.children) this.#look(child, frame, isDrawing, uses);
    } else if (SHAPES.has(element.local)) {
      const isStroke = valueOf(element, sf("radius")) !== undefined;
      if (!isDrawing || (isOfSfumato(element) && !isStroke)) this.#found.push({ element, frame });
    } else if (element.local === "use" && !isDrawing && uses < DEEPEST_USE) {
      const target = this.#ids.get(hrefOf(element)?.value.trim().slice(1) ?? "");
      const [x, y] = ["x", "y"].map((name) => parseLength(valueOf(element, name) ?? "0", 0) ?? 0);
      if (target) this.#look(target, composed(frame, translation(x, y)), isDrawing, uses + 1);
    }
  }

  #isHidden(element: ElementNode): boolean {
    return (
      keywordOf(this.#styles.value(element, "display") ?? "inline") === "none" ||
      keywordOf(this.#styles.value(element, "visibility") ?? "visible") !== "visible"
    );
  }
}

/** Twice the area that a path encloses, above 0 where it runs clockwise on the screen. */
function doubledArea(paths: readonly CubicPath[]): number {
  let area = 0;
  for (const { points } of paths) {
    points.forEach(([x, y], i) => {
      const [x1, y1] = points[(i + 1) % points.length];
      area += x * y1 - x1 * y;
    });
  }
  return area;
}

class Sides {
  readonly #styles: Styles;
  readonly #ids: Map<string, ElementNode>;

  constructor(
    readonly text: string,
    root: ElementNode,
  ) {
    this.#styles = new Styles(text, root);
    this.#ids = idsWithin(root);
  }

  markup(draft: Draft, { element, frame }: Found, keepsSides: boolean): string {
    const place = transformText(frame, 1, 1e-7);
    const edits = setAttribute(this.text, element, "transform", place);
    if (keepsSides) return draft.rewritten(element, edits);
    for (const [side, value] of this.#sidesOf(element)) {
      edits.push(...setAttribute(this.text, element, sf(side), value));
    }
    return draft.rewritten(element, edits);
  }

  /** A filled shape has its fill inside and a barrier outside, any other its stroke on both sides. */
  #sidesOf(element: ElementNode): [side: string, value: string][] {
    const fill = this.#paint(element, this.#styles.value(element, "fill") ?? "black");
    if (fill === null || element.local === "line") {
      const stroke = this.#paint(element, this.#styles.value(element, "stroke") ?? "none") ?? fill ?? "#000";
      return [["left", stroke], ["right", stroke]];
    }
    const attribute = (name: string) => valueOf(element, name);
    const isClockwise = doubledArea(shapePaths(element.local, attribute, [0, 0, 100, 100])) >= 0;
    return isClockwise ? [["left", "none"], ["right", fill]] : [["left", fill], ["right", "none"]];
  }

  /** Returns a side's paint; null for none. */
  #paint(element: ElementNode, value: string): string | null {
    const word = keywordOf(value);
    if (word === "none") return null;
    const url = urlOf(value);
    if (url !== null) {
      const target = this.#ids.get(url.slice(1));
      const isGradient = /^(linear|radial)Gradient$/.test(target?.local ?? "");
      return isGradient ? `url(${url})` : "#808080";
    }
    const text = word === "currentcolor" ? (this.#styles.value(element, "color") ?? "black") : value;
    const color = parseColor(text);
    if (!color) return "#000";
    return color.alpha === 0 ? null : colorText(color.rgb);
  }
}
