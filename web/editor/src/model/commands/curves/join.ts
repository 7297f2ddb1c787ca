// Two open curves made one.
import { composed, determinant, inverted, lengthScale } from "../../../geometry/affine.js";
import { mappedPath, reversedPath, type CubicPath } from "../../../geometry/cubic.js";
import { pathLength } from "../../../geometry/length.js";
import { joined, withClosed } from "../../../geometry/nodes.js";
import { rewritePath } from "../../../geometry/path.js";
import { distance } from "../../../geometry/vector.js";
import { patchOf } from "../../../source/attributes.js";
import type { Edit } from "../../../source/patch.js";
import type { CurveItem, Drawing, Handle, Item, Outcome } from "../../types.js";
import { joinedAttributes, type Half } from "./join-sides.js";
import { removal } from "../structure/removal.js";
import { dataEdits } from "../data-edits.js";
import { curveOf, dataOf, editShape } from "./shape-edit.js";

/** Ends this near become one node, in CSS pixels; a step is a thousandth of one. */
const WELD = 8 * 1000;

/** The first subpath that has two ends; -1: there is none. */
function openPath(item: CurveItem): number {
  return item.paths.findIndex((path) => !path.closed);
}

function layerOf(item: Item): Item | null {
  let outer: Item | null = item;
  while (outer && outer.kind !== "layer") outer = outer.parent;
  return outer;
}

/** Returns both in the order and directions in which the ends between them are nearest. */
function arranged(a: CubicPath, b: CubicPath) {
  const ends = ({ points }: CubicPath) => [points[0], points[points.length - 1]];
  const [[a0, a1], [b0, b1]] = [ends(a), ends(b)];
  const ways = [
    { aIsFirst: true, isReversed: false, gap: distance(a1, b0) },
    { aIsFirst: true, isReversed: true, gap: distance(a1, b1) },
    { aIsFirst: false, isReversed: false, gap: distance(b1, a0) },
    { aIsFirst: false, isReversed: true, gap: distance(b0, a0) },
  ];
  return ways.reduce((best, way) => (way.gap < best.gap ? way : best));
}

/** Returns the rest of the second curve: nothing, or its other subpaths. */
function rest(drawing: Drawing, item: CurveItem, index: number, step: number): Edit[] {
  if (item.paths.length === 1) return [removal(drawing.text, item.element)];
  const data = rewritePath(dataOf(drawing, item.element), index, item.paths[index], null, step);
  return dataEdits(drawing.text, item.element, data, true);
}

/** Both curves as one subpath of the first, in its coordinates, and the attributes of each. */
function halvesOf(a: CurveItem, b: CurveItem, step: number) {
  const back = inverted(a.layerFromItem);
  const [own, other] = [a.paths[openPath(a)], b.paths[openPath(b)]];
  if (!back || !own || !other) return null;
  const map = composed(back, b.layerFromItem);
  const mapped = mappedPath(map, other);
  const { aIsFirst, isReversed, gap } = arranged(own, mapped);
  const isWelded = gap <= WELD * step;
  const walked = isReversed ? reversedPath(mapped) : mapped;
  const plain = ({ points }: CubicPath): CubicPath => ({ points, closed: false });
  const kept: Half = {
    element: a.element,
    own,
    length: pathLength(own),
    isReversed: false,
    isSwapped: false,
    scale: 1,
  };
  const added: Half = {
    element: b.element,
    own: other,
    length: pathLength(mapped),
    isReversed,
    // Sides change with the direction, and where one of both elements is a mirror image.
    isSwapped: isReversed !== determinant(map) < 0,
    scale: lengthScale(map),
  };
  const path = aIsFirst ? joined(own, walked, isWelded) : joinedBefore(own, walked, isWelded);
  const halves = aIsFirst ? ([kept, added] as const) : ([added, kept] as const);
  return { path: plain(path), halves, bridge: isWelded ? 0 : gap };
}

/** The second in front of the first, whose points stay: the end that moves is the second's. */
function joinedBefore(own: CubicPath, before: CubicPath, isWelded: boolean): CubicPath {
  return reversedPath(joined(reversedPath(own), reversedPath(before), isWelded));
}

/**
 * Joins the nearest ends of two open curves of one layer to one curve: the first, in its direction. Near ends
 * become one node; a line joins others. Stops keep their places, by shares of the arc length. A curve joined
 * with itself is closed. null: they cannot be joined.
 */
export function joinCurves(drawing: Drawing, a: Handle, b: Handle, step: number): Outcome | null {
  const [first, second] = [curveOf(drawing, a), curveOf(drawing, b)];
  if (!first || !second || first.kind !== second.kind) return null;
  if (a === b) {
    return editShape(drawing, a, openPath(first), step, (path) => withClosed(path, true, step));
  }
  if (first.kind === "curve" && layerOf(first) !== layerOf(second)) return null;
  const halves = halvesOf(inOneFrame(first), inOneFrame(second), step);
  if (!halves) return null;
  const { element } = first;
  const index = openPath(first);
  const data = rewritePath(dataOf(drawing, element), index, first.paths[index], halves.path, step);
  const patch = patchOf([
    ...dataEdits(drawing.text, element, data, true),
    ...joinedAttributes(drawing.text, element, first.kind, halves.halves, halves.bridge),
    ...rest(drawing, second, openPath(second), step),
  ]);
  const { start } = element.range;
  const shift = patch
    .filter((edit) => edit.at < start)
    .reduce((sum, edit) => sum + edit.inserted.length - edit.removed.length, 0);
  return { patch, select: [{ at: start + shift }] };
}

/** Local curves have frames of their own: they meet on the artboard. */
function inOneFrame(item: CurveItem): CurveItem {
  return item.kind === "curve" ? item : { ...item, layerFromItem: item.artboardFromItem };
}
