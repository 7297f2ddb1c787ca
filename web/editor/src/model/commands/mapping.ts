// Items under a map: of curves the points, of everything else the transform.
import { composed, determinant, inverted, lengthScale } from "../../geometry/affine.js";
import type { Affine } from "../../geometry/affine.js";
import { mappedData } from "../../geometry/mappeddata.js";
import { numberText } from "../../geometry/path.js";
import { attributeOf, setAttribute, sf, valueOf } from "../../source/attributes.js";
import type { Edit } from "../../source/patch.js";
import type { ElementNode } from "../../source/tree.js";
import { ownTransform } from "../building.js";
import type { Drawing, Item } from "../types.js";
import { layerOf, outerFrame } from "./structure/items.js";

/** The largest coordinate that the artboard has. */
function extentOf({ artboard }: Drawing): number {
  return Math.max(1, ...artboard.map(Math.abs));
}

/** A step that no picture shows, for what has to stay where it is. */
export function finestStep(d: Drawing): number {
  return 10 ** Math.floor(Math.log10(extentOf(d) * 1e-7));
}

function isNear(a: number, b: number, slack: number): boolean {
  return Math.abs(a - b) <= slack;
}

/** Whether a map moves nothing on an artboard of this extent by half a step. */
export function isIdentity([a, b, c, d, e, f]: Affine, extent: number, step: number): boolean {
  const slack = step / 2 / extent;
  const keepsAxes = isNear(a, 1, slack) && isNear(d, 1, slack);
  const still = isNear(b, 0, slack) && isNear(c, 0, slack);
  return keepsAxes && still && isNear(e, 0, step / 2) && isNear(f, 0, step / 2);
}

/** A `transform` in short; null where it does nothing. */
export function transformText(map: Affine, extent: number, step: number): string | null {
  const [a, b, c, d, e, f] = map;
  const [x, y] = [numberText(e, step), numberText(f, step)];
  if (isIdentity([a, b, c, d, 0, 0], extent, step)) {
    return x === "0" && y === "0" ? null : `translate(${x} ${y})`;
  }
  const fine = Math.min(1e-6, step / extent);
  return `matrix(${[a, b, c, d].map((k) => numberText(k, fine)).join(" ")} ${x} ${y})`;
}

/** The edits that give an element a transform. */
export function setTransform(d: Drawing, element: ElementNode, map: Affine, step: number): Edit[] {
  return setAttribute(d.text, element, "transform", transformText(map, extentOf(d), step));
}

/** A list of radii, each times a factor; offsets and units stay. */
export function scaledRadii(list: string, factor: number): string {
  const radius = /^(\s*)([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)/;
  const scaled = (item: string) =>
    item.replace(radius, (_, blanks: string, number: string) => {
      const value = Number(number) * factor;
      return blanks + numberText(value, 10 ** Math.floor(Math.log10(value || 1) - 4));
    });
  return list.split(",").map(scaled).join(",");
}

const MIRRORED = [
  ["left", "right"],
  ["left-opacity", "right-opacity"],
  ["left-blur", "right-blur"],
] as const;

/** Returns a curve's attributes after a map of its points: radii grow, a mirror swaps the sides. */
function mappedAttributes(text: string, element: ElementNode, map: Affine): Edit[] {
  const factor = lengthScale(map);
  const mirrors = determinant(map) < 0;
  const radii = (value: string | undefined) =>
    value === undefined || isNear(factor, 1, 1e-9) ? value : scaledRadii(value, factor);
  const edits: Edit[] = [];
  const set = (name: string, value: string | undefined) => {
    if (value !== valueOf(element, sf(name))) {
      edits.push(...setAttribute(text, element, sf(name), value ?? null));
    }
  };
  for (const [left, right] of MIRRORED) {
    const read = left === "left-blur" ? radii : (value: string | undefined) => value;
    const values = [valueOf(element, sf(left)), valueOf(element, sf(right))].map(read);
    if (mirrors) values.reverse();
    set(left, values[0]);
    set(right, values[1]);
  }
  set("blur", radii(valueOf(element, sf("blur"))));
  return edits;
}

/** Whether a side shows a paint, which goes with the element's own coordinates. */
function hasPaint(element: ElementNode): boolean {
  const names = ["left", "right", "left-opacity", "right-opacity", "opacity"];
  return names.some((name) => valueOf(element, sf(name))?.includes("url(") ?? false);
}

/** The edits of a path of a layer whose points go through a map; null: it needs a transform. */
function mappedPoints(d: Drawing, item: Item, map: Affine, step: number): Edit[] | null {
  const { element } = item;
  const data = attributeOf(element, "d");
  if (item.kind !== "curve" || !item.isPath || !data || hasPaint(element)) return null;
  const written = mappedData(data.value, map, step);
  if (written === null) return null;
  const edits = setAttribute(d.text, element, "d", written);
  return [...edits, ...mappedAttributes(d.text, element, map)];
}

/**
 * The edits that map an item by a map of the coordinates that its transform leads to. Paths of
 * layers get other points, everything else another transform.
 */
export function mapping(d: Drawing, item: Item, map: Affine, step: number): Edit[] {
  if (isIdentity(map, extentOf(d), step)) return [];
  const own = ownTransform(item.element);
  const back = inverted(own);
  const points = back && layerOf(item) ? mappedPoints(d, item, conjugate(back, map, own), step) : null;
  return points ?? setTransform(d, item.element, composed(map, own), step);
}

/** A map as it is in other coordinates, which `there` leads from and `back` leads to. */
export function conjugate(back: Affine, map: Affine, there: Affine): Affine {
  return cleaned(composed(back, composed(map, there)));
}

/** Without the last bits of a product that came out as a translation or a scaling. */
function cleaned(map: Affine): Affine {
  return map.map((k, i) => (i < 4 && isNear(k, Math.round(k), 1e-12) ? Math.round(k) : k));
}

/**
 * The edits that leave an item where it is seen when it moves into another frame; null: that frame
 * flattens everything.
 */
export function reframing(d: Drawing, item: Item, frame: Affine): Edit[] | null {
  const back = inverted(frame);
  if (!back) return null;
  return mapping(d, item, cleaned(composed(back, outerFrame(item))), finestStep(d));
}

/** The edits that map an item by a map of the artboard; null where what is around it flattens it. */
export function artboardMapping(d: Drawing, item: Item, map: Affine, step: number): Edit[] | null {
  const outer = outerFrame(item);
  const back = inverted(outer);
  return back && mapping(d, item, conjugate(back, map, outer), step);
}
