// Which part of the picture's stack a layer or a group of the document is.
import type { readStack } from "../../../viewer/payload.js";
import type { Editor } from "../app/types.js";
import { inverted } from "../geometry/affine.js";
import type { Item } from "../model/types.js";

export type StackItem = ReturnType<typeof readStack>["stack"][number];

export interface Part {
  readonly items: StackItem[];
  /** The engine's numbers of the layers in it. */
  readonly layers: readonly number[];
}

/**
 * A layer of the engine by its number, a local curve, or a layer whose number is not known: one that
 * is empty, or holds copies alone.
 */
type Leaf = number | "stroke" | "layer";

/** Where what an item puts on the stack begins and ends, among all leaves in the stack's order. */
type Ranges = Map<Item, readonly [number, number]>;

function addLeaves(editor: Editor, item: Item, ranges: Ranges, leaves: Leaf[]): void {
  const from = leaves.length;
  if (item.hidden) return;
  if (item.kind === "stroke") leaves.push("stroke");
  else if (item.kind === "layer") {
    // The engine leaves out what its transform flattens to nothing.
    if (inverted(item.artboardFromItem)) leaves.push(editor.engineLayer(item) ?? "layer");
  } else if (item.kind === "use" && item.target) addLeaves(editor, item.target, new Map(), leaves);
  else if (item.kind === "group") for (const child of item.children) addLeaves(editor, child, ranges, leaves);
  ranges.set(item, [from, leaves.length]);
}

const isLeaf = (item: StackItem) => item.kind === "instance" || item.kind === "stroke";

/** Whether an item of the stack can be what a leaf stands for. */
const fits = (item: StackItem, leaf: Leaf) =>
  item.kind === "instance" ? leaf === "layer" || leaf === item.layer : leaf === "stroke";

/** Beginnings and ends of groups that stand whole within a part. */
function nested(items: readonly StackItem[]): StackItem[] {
  const open: StackItem[] = [];
  const whole = new Set<StackItem>();
  for (const item of items) {
    if (item.kind === "begin") open.push(item);
    else if (item.kind === "end") {
      const begin = open.pop();
      if (begin) whole.add(begin).add(item);
    }
  }
  return items.filter((item) => (item.kind !== "begin" && item.kind !== "end") || whole.has(item));
}

/** Items do not change: what each looks like is said once. */
const looks = new WeakMap<StackItem, string>();

function wordOf(item: StackItem): string {
  if (item.kind !== "stroke") return JSON.stringify(item);
  const { segments, ...rest } = item;
  const sums = [...segments.coefficient, ...segments.start, ...segments.attribute].map((column) =>
    column.reduce((sum, value, k) => sum + value * (k + 1), 0),
  );
  return JSON.stringify([rest, sums]);
}

function lookOfOne(item: StackItem): string {
  const look = looks.get(item) ?? wordOf(item);
  looks.set(item, look);
  return look;
}

/** A word for what items look like, apart from the tables of their layers. */
export const lookOf = (items: readonly StackItem[]): string => items.map(lookOfOne).join();

interface Placed {
  readonly ranges: Ranges;
  /** The place of each leaf on the stack. */
  readonly places: readonly number[];
}

/** null where the document's order is not the stack's: the text is another one. */
function placedOn(editor: Editor, stack: readonly StackItem[]): Placed | null {
  const ranges: Ranges = new Map();
  const leaves: Leaf[] = [];
  for (const item of editor.drawing.items) addLeaves(editor, item, ranges, leaves);
  const places = [...stack.keys()].filter((k) => isLeaf(stack[k]));
  const isSame = places.length === leaves.length && places.every((at, k) => fits(stack[at], leaves[k]));
  return isSame ? { ranges, places } : null;
}

/** Parts by their items; null where the text is another one. */
export function partsOf(editor: Editor, stack: readonly StackItem[]): ReadonlyMap<Item, Part> | null {
  const parts = new Map<Item, Part>();
  const placed = placedOn(editor, stack);
  if (!placed) return null;
  const { ranges, places } = placed;
  for (const [item, [from, to]] of ranges) {
    if (from === to || (item.kind !== "layer" && item.kind !== "group")) continue;
    const items = nested(stack.slice(places[from], places[to - 1] + 1));
    const layers = items.flatMap((one) => (one.kind === "instance" ? [one.layer] : []));
    parts.set(item, { items, layers });
  }
  return parts;
}

/** The group of all that is not isolated. */
const FADED: StackItem = { kind: "begin", opacity: 0.25, blend: 0 };
const END: StackItem = { kind: "end" };

/**
 * Returns a stack that shows an item in its own colours above all others, which are faded; null: the text is another
 * one.
 */
export function isolatedStack(editor: Editor, stack: readonly StackItem[], item: Item): StackItem[] | null {
  const parts = partsOf(editor, stack);
  if (!parts) return null;
  const own = new Set(parts.get(item)?.items);
  const others = stack.filter((one) => !own.has(one));
  return [FADED, ...others, END, ...own];
}

/**
 * Returns the item of the document that put an object on the stack, an instance as a whole; null: it cannot
 * be determined.
 */
export function itemAt(editor: Editor, stack: readonly StackItem[], at: number): Item | null {
  const placed = placedOn(editor, stack);
  const shown = stack[at];
  if (!placed || !shown || shown.kind === "end") return null;
  const leaf = placed.places.findIndex((place) => place >= at);
  // Each stands behind what is within it.
  const around = [...placed.ranges].filter(([, [from, to]]) => from <= leaf && leaf < to);
  if (shown.kind !== "begin") return around[0]?.[0] ?? null;
  const isBegun = ({ kind, opacity }: Item) =>
    kind === "use" || (kind === "group" && Math.abs(opacity - shown.opacity) < SAME);
  const begun = around.filter(([item, [from]]) => from === leaf && isBegun(item));
  return begun.at(-1)?.[0] ?? null;
}

/** Opacities of the stack are floats. */
const SAME = 1e-6;
