// Fixes of hints about layers, instances, groups and strokes as wholes.
import { mappedBox, type Box } from "../geometry/affine.js";
import { boundsOf, isOpen, unionOf, type CubicPath } from "../geometry/cubic.js";
import { cross, dot, subtract } from "../geometry/vector.js";
import { sf, valueOf } from "../source/attributes.js";
import { shareOf } from "../source/css.js";
import { deleteItems, setSideOpacity, transform } from "./commands/index.js";
import { finestStep } from "./commands/mapping.js";
import { together } from "./commands/structure/together.js";
import { boxOf } from "./item-boxes.js";
import type { CurveItem, Drawing, Item, Outcome, Side } from "./types.js";

/** Curves of a layer, in the order of the text. */
export function curvesWithin(item: Item): CurveItem[] {
  return item.kind === "curve" ? [item] : item.children.flatMap(curvesWithin);
}

/** How often the control polygon turns: 1 with the inside on the right, -1 on the left; of an eight 0. */
function turnsOf({ points }: CubicPath): number {
  const edges = points
    .map((from, k) => subtract(points[(k + 1) % points.length], from))
    .filter(([x, y]) => x !== 0 || y !== 0);
  const angle = edges.reduce((sum, edge, k) => {
    const next = edges[(k + 1) % edges.length];
    return sum + Math.atan2(cross(edge, next), dot(edge, next));
  }, 0);
  return Math.round(angle / (2 * Math.PI));
}

/** The side that all subpaths of a closed curve turn outwards; null: they differ, cross themselves, or are open. */
function outerSide({ paths }: CurveItem): Side | null {
  if (paths.length === 0 || paths.some(isOpen)) return null;
  const turns = paths.map(turnsOf);
  if (turns.some((turn) => Math.abs(turn) !== 1 || turn !== turns[0])) return null;
  return turns[0] > 0 ? "left" : "right";
}

const boxInLayer = ({ paths, layerFromItem }: CurveItem): Box | null =>
  unionOf(paths.map((path) => mappedBox(layerFromItem, boundsOf(path))));

const isWithin = (inner: Box, outer: Box) =>
  inner[0] >= outer[0] && inner[1] >= outer[1] && inner[2] <= outer[2] && inner[3] <= outer[3];

/**
 * A layer that covers all below ends at its outline: outside of its outermost closed curves it has no
 * opacity. null: something that is not closed lies outside of them.
 */
export function atOutline(d: Drawing, item: Item): Outcome | null {
  const layer = item.kind === "use" ? item.target : item;
  const curves = (layer ? curvesWithin(layer) : []).flatMap((curve) => {
    const box = boxInLayer(curve);
    return box ? [{ curve, box, outer: outerSide(curve) }] : [];
  });
  const closed = curves.filter(({ outer }) => outer);
  const outermost = curves.filter((one) => closed.every((other) => other === one || !isWithin(one.box, other.box)));
  if (outermost.length === 0 || outermost.some(({ outer }) => !outer)) return null;
  const nothing = { kind: "stops", space: "arc", stops: [{ offset: 0, value: 0 }] } as const;
  return together(outermost.map(({ curve, outer }) => setSideOpacity(d, curve.handle, outer as Side, nothing)));
}

function isInvisible({ kind, opacity, element }: Item): boolean {
  const alpha = kind === "stroke" ? valueOf(element, sf("alpha")) : undefined;
  return opacity === 0 || (alpha !== undefined && shareOf(alpha) === 0);
}

/**
 * Deletes an item that shows nothing, because of its own opacity or that of a group around it, which is
 * deleted then. null: it is visible by now.
 */
export function withoutInvisible(d: Drawing, item: Item): Outcome | null {
  for (let around: Item | null = item; around; around = around.parent)
    if (isInvisible(around)) return deleteItems(d, [around.handle]);
  return null;
}

/** How far an interval has to move to lie within another; one that is longer goes to its middle. */
function shiftInto([from, to]: readonly [number, number], [low, high]: readonly [number, number]): number {
  if (to - from > high - low) return (low + high - from - to) / 2;
  return Math.max(low - from, 0) + Math.min(high - to, 0);
}

/** Moves an item outside of the artboard into it, by the shortest way. */
export function broughtIn(d: Drawing, item: Item): Outcome | null {
  const box = boxOf([item]);
  const [x0, y0, x1, y1] = d.artboard;
  if (!box || (box[0] < x1 && box[2] > x0 && box[1] < y1 && box[3] > y0)) return null;
  const by = [shiftInto([box[0], box[2]], [x0, x1]), shiftInto([box[1], box[3]], [y0, y1])];
  return transform(d, [item.handle], [1, 0, 0, 1, ...by], finestStep(d));
}
