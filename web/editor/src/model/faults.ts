// Results that an edit must not leave: a text that the library would refuse as a whole.
import { mapped, type Affine, type Point } from "../geometry/affine.js";
import type { CubicPath } from "../geometry/cubic.js";
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

/** The largest coordinate. */
function reachOf(paths: readonly CubicPath[]): number {
  let reach = 0;
  for (const { points } of paths) {
    for (const [x, y] of points) reach = Math.max(reach, Math.abs(x), Math.abs(y));
  }
  return reach;
}

function isFar(paths: readonly CubicPath[], map: Affine): boolean {
  // Some edits check all curves: most are certainly near.
  const reach = reachOf(paths);
  const [a, b, c, d, e, f] = map.map(Math.abs);
  if (Math.max(reach, (a + c) * reach + e, (b + d) * reach + f) <= LARGEST) return false;
  return paths.some(({ points }) => points.some((point) => !isIn(point) || !isIn(mapped(map, point))));
}

function faultOfCurve(item: CurveItem): Fault | null {
  const { kind, element, paths, layerFromItem, artboardFromItem, left, right } = item;
  if (isFar(paths, layerFromItem) || !artboardFromItem.every((n) => Math.abs(n) <= LARGEST)) return "far";
  // Numbers that are too large are none, and draw nothing.
  const isUnread = () => geometryAttributes(element.local).some((name) => isTooLarge(valueOf(element, name)));
  if (paths.length === 0 && isUnread()) return "far";
  const isColorless = left.color.kind === "open" && right.color.kind === "open";
  return kind === "stroke" && isColorless ? "colorless stroke" : null;
}

/** Where an element moves what is in it. */
const MOVES = ["transform", "x", "y"];

/** Returns the fault of an item and of its content. */
function faultOfItem(item: Item): Fault | null {
  if (MOVES.some((name) => isTooLarge(valueOf(item.element, name)))) return "far";
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

/** Returns for each element the elements that instances within it copy. */
function copiedWithin(drawing: Drawing): Map<ElementNode, Set<ElementNode>> {
  const copied = new Map<ElementNode, Set<ElementNode>>();
  for (const { kind, element } of drawing.all()) {
    const target = kind === "use" ? referredElement(element, drawing.ids) : undefined;
    if (!target) continue;
    for (let around: ElementNode | null = element; around; around = around.parent)
      copied.set(around, (copied.get(around) ?? new Set()).add(target));
  }
  return copied;
}

/** Returns whether an instance lies within its own original, directly or through any number of others. */
function hasCircle(drawing: Drawing): boolean {
  const copied = copiedWithin(drawing);
  const way = new Set<ElementNode>();
  const done = new Set<ElementNode>();
  const waiting = [...copied.keys()];
  for (let element = waiting.at(-1); element; element = waiting.at(-1)) {
    if (way.has(element) || done.has(element)) {
      // Everything that it leads to was checked.
      way.delete(element);
      done.add(element);
      waiting.pop();
      continue;
    }
    way.add(element);
    for (const target of copied.get(element) ?? []) {
      if (way.has(target)) return true;
      if (!done.has(target)) waiting.push(target);
    }
  }
  return false;
}

/** Returns the fault in the changed items, or null. */
export function faultOf(drawing: Drawing, { isStructural, touched }: Change): Fault | null {
  if (!isStructural) return firstFault([...touched.keys()].map((handle) => drawing.item(handle)));
  return firstFault(drawing.items) ?? (hasCircle(drawing) ? "circle of instances" : null);
}
