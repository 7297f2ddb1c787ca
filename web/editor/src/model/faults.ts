// What an edit must not leave behind: a text that the library would refuse as a whole.
import { mapped, type Point } from "../geometry/affine.js";
import { geometryAttributes } from "../geometry/path.js";
import { valueOf } from "../source/attributes.js";
import { LARGEST } from "../source/lengths.js";
import type { ElementNode } from "../source/tree.js";
import { referredElement } from "./building.js";
import type { Change, CurveItem, Drawing, Item } from "./types.js";

/** far: numbers larger than any that are read. */
export type Fault = "far" | "colorless stroke" | "circle of instances";

const NUMBER = /(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/g;
const isTooLarge = (text = "") => (text.match(NUMBER) ?? []).some((one) => Number(one) > LARGEST);
const isIn = ([x, y]: Point) => Math.abs(x) <= LARGEST && Math.abs(y) <= LARGEST;

function faultOfCurve({ kind, element, paths, artboardFromItem, left, right }: CurveItem): Fault | null {
  const isFar = (point: Point) => !isIn(point) || !isIn(mapped(artboardFromItem, point));
  if (paths.some(({ points }) => points.some(isFar))) return "far";
  // Numbers that are too large are none, and draw nothing.
  const isUnread = geometryAttributes(element.local).some((name) => isTooLarge(valueOf(element, name)));
  if (paths.length === 0 && isUnread) return "far";
  const isColorless = left.color.kind === "open" && right.color.kind === "open";
  return kind === "stroke" && isColorless ? "colorless stroke" : null;
}

/** Of an item and what is in it. */
function faultOfItem(item: Item): Fault | null {
  if (isTooLarge(valueOf(item.element, "transform"))) return "far";
  if (item.kind === "curve" || item.kind === "stroke") return faultOfCurve(item);
  return firstFault(item.children);
}

function firstFault(items: Iterable<Item | undefined>): Fault | null {
  for (const item of items) {
    const fault = item ? faultOfItem(item) : null;
    if (fault) return fault;
  }
  return null;
}

/** Whether an instance is within what it copies, itself or by way of others. */
function hasCircle(drawing: Drawing): boolean {
  const copied = new Map<ElementNode, Set<ElementNode>>();
  for (const { kind, element } of drawing.all()) {
    const target = kind === "use" ? referredElement(element, drawing.ids) : undefined;
    if (!target) continue;
    for (let around: ElementNode | null = element; around; around = around.parent)
      copied.set(around, (copied.get(around) ?? new Set()).add(target));
  }
  const done = new Set<ElementNode>();
  const goesRound = (element: ElementNode, way: Set<ElementNode>): boolean => {
    if (way.has(element)) return true;
    if (done.has(element)) return false;
    way.add(element);
    const isRound = [...(copied.get(element) ?? [])].some((next) => goesRound(next, way));
    way.delete(element);
    done.add(element);
    return isRound;
  };
  return [...copied.keys()].some((element) => goesRound(element, new Set()));
}

/** What is wrong with what changed, or null. */
export function faultOf(drawing: Drawing, { isStructural, touched }: Change): Fault | null {
  if (!isStructural) return firstFault([...touched.keys()].map((handle) => drawing.item(handle)));
  return firstFault(drawing.items) ?? (hasCircle(drawing) ? "circle of instances" : null);
}
