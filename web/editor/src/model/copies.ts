// The effect of <use> on items: how often each is shown, and which uses form a circle.
import type { Built } from "./building.js";
import type { Building } from "./item-object.js";
import type { CurveItem, Item, UseItem } from "./types.js";

/** Uses of uses that are followed. */
const DEEPEST = 1000;

/** Uses that would copy themselves copy nothing. */
function cutCircles(built: Built): void {
  const entered = new Set<Item>();
  const done = new Set<Item>();
  const visit = (item: Item, depth: number): void => {
    if (done.has(item)) return;
    entered.add(item);
    for (const child of item.children) visit(child, depth + 1);
    if (item.kind === "use" && item.target) {
      const isCircle = entered.has(item.target) && !done.has(item.target);
      if (isCircle || depth > DEEPEST) (item as Building<UseItem>).target = null;
      else visit(item.target, depth + 1);
    }
    done.add(item);
  };
  for (const item of [...built.items, ...built.detached]) visit(item, 0);
}

/** Sets CurveItem.copies, and takes targets from uses that go round in a circle. */
export function countCopies(built: Built): void {
  if (built.uses.length === 0) return;
  cutCircles(built);
  const usesOf = new Map<Item, UseItem[]>();
  for (const use of built.uses) {
    if (!use.target) continue;
    const uses = usesOf.get(use.target) ?? [];
    uses.push(use as UseItem);
    usesOf.set(use.target, uses);
  }
  const detached = new Set<Item>(built.detached);
  const known = new Map<Item, number>();
  const count = (item: Item): number => {
    let copies = known.get(item);
    if (copies !== undefined) return copies;
    copies = item.parent ? count(item.parent) : detached.has(item) ? 0 : 1;
    for (const use of usesOf.get(item) ?? []) copies += count(use);
    copies = Math.min(copies, Number.MAX_SAFE_INTEGER);
    known.set(item, copies);
    return copies;
  };
  for (const item of built.byHandle.values()) {
    const isCurve = item.kind === "curve" || item.kind === "stroke";
    if (isCurve) (item as Building<CurveItem>).copies = count(item);
  }
}
