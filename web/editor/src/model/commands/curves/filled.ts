// Filled shapes: one colour inside, transparent outside, each alone in its layer.
import { inverted, lengthScale, mapped, mappedBox } from "../../../geometry/affine.js";
import type { Affine } from "../../../geometry/affine.js";
import type { Rgb } from "../../../geometry/color.js";
import { mappedPath } from "../../../geometry/cubic.js";
import { cornersOf, elementOf, outlineOf, polygonOf } from "../../../geometry/drawn-shape.js";
import type { DrawnShape } from "../../../geometry/drawn-shape.js";
import { numberText, shapePaths, writePath } from "../../../geometry/path.js";
import { declare, SFUMATO } from "../../../source/attributes.js";
import type { ElementNode } from "../../../source/tree.js";
import { filledSides, insideOf } from "../../sides.js";
import type { Drawing, Handle, Outcome } from "../../types.js";
import { opening } from "../markup.js";
import { fallback } from "../paint/fallback.js";
import { innerFrame } from "../structure/items.js";
import { insertion } from "../structure/layout.js";
import { innerPlace, isFreeLayer, newLayer, placeAbove } from "../structure/places.js";
import { sideAttributes } from "./create.js";
import { Draft } from "./draft.js";

/** Returns whether a map keeps upright boxes upright. */
const keepsUpright = ([a, b, c, d]: Affine) =>
  Math.abs(b) + Math.abs(c) <= 1e-12 * (Math.abs(a) + Math.abs(d));

/** Returns the element for a shape of the artboard. @param back from the artboard to the element's parent */
function elementIn(shape: DrawnShape, back: Affine, step: number) {
  const text = (value: number) => numberText(value, step);
  if (shape.kind === "polygon" || (shape.kind === "rectangle" && !keepsUpright(back))) {
    return polygonOf(cornersOf(shape).map((point) => mapped(back, point)), text);
  }
  if (keepsUpright(back)) return elementOf({ ...shape, box: mappedBox(back, shape.box) }, text);
  const outline = outlineOf(shape);
  if (!outline) return null;
  return { local: "path", attributes: [["d", writePath(mappedPath(back, outline), step)] as const] };
}

/** Returns the text of a shape's element; null: it encloses no area, or the frame flattens everything. */
function markupOf(
  d: Drawing,
  parent: ElementNode,
  frame: Affine,
  shape: DrawnShape,
  color: Rgb,
  step: number,
): string | null {
  const back = inverted(frame);
  const scale = lengthScale(frame);
  const element = back && elementIn(shape, back, step / scale);
  if (!element) return null;
  const { local, attributes } = element;
  const valueOf = (name: string) => attributes.find(([own]) => own === name)?.[1];
  const inside = insideOf({ paths: shapePaths(local, valueOf, d.artboard) });
  if (inside === null) return null;
  const sides = filledSides(inside, color);
  const written = [
    ...attributes,
    ...sideAttributes(parent, sides),
    ...fallback(d, [sides.left, sides.right], scale),
  ];
  return `${opening(parent, local, written)}/>`;
}

/**
 * Adds a filled shape: into `layer` if that is empty, else into a new layer above it, because curves meet within
 * their layer. Returns null if the shape has no area.
 * @param step unit of the last decimal, artboard units
 */
export function addShape(
  d: Drawing,
  layer: Handle | null,
  shape: DrawnShape,
  color: Rgb,
  step: number,
): Outcome | null {
  const target = (layer === null ? null : d.item(layer)) ?? null;
  const above = target && isFreeLayer(target) ? null : placeAbove(d, target);
  const place = above ?? (target && innerPlace(target));
  if (!place) return null;
  const markup = markupOf(d, place.parent, innerFrame(d, place.item), shape, color, step);
  if (markup === null) return null;
  const draft = new Draft(d.text);
  draft.add(declare(d.text, d.root, SFUMATO));
  if (above) newLayer(d, draft, above, [markup]);
  else {
    const { edit, starts } = insertion(d.text, place.parent, place.after, [markup]);
    draft.add([edit]);
    draft.selectWithin(edit, starts[0]);
  }
  return draft.outcome();
}
