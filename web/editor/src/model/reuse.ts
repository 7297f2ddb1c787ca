// Items that are as they were stay the objects that they were, so that identity says what changed.
import type { Built } from "./building.js";
import type { BuildingItem, Within } from "./item-object.js";
import type { Handle, Item, UseItem } from "./types.js";

function isSameValue(a: unknown, b: unknown): boolean {
  if (a === b) return true;
  if (typeof a !== "object" || typeof b !== "object" || !a || !b) return Object.is(a, b);
  const [keys, others] = [Object.keys(a), Object.keys(b)];
  const values = (from: object, key: string) => (from as Record<string, unknown>)[key];
  return (
    keys.length === others.length && keys.every((k) => isSameValue(values(a, k), values(b, k)))
  );
}

/** Fields to compare separately: nodes and items lead to everything. */
const APART: ReadonlySet<string> = new Set(["element", "around", "inside", "children", "target"]);

function isSameItem(fresh: Item, old: Item): boolean {
  if (fresh.kind !== old.kind || fresh.element !== old.element) return false;
  if (fresh.kind === "use" && fresh.target?.handle !== (old as UseItem).target?.handle)
    return false;
  if (fresh.children.length !== old.children.length) return false;
  if (fresh.children.some((child, i) => child !== old.children[i])) return false;
  return Object.keys(fresh).every((key) => {
    if (APART.has(key)) return true;
    return isSameValue(fresh[key as keyof Item], old[key as keyof Item]);
  });
}

/** Puts old items in the place of new ones that say the same. */
export function reuseItems(built: Built, before: ReadonlyMap<Handle, Item>): void {
  const settled = (fresh: Item): Item => {
    const item = fresh as BuildingItem;
    item.children = fresh.children.map(settled);
    const old = before.get(fresh.handle);
    const kept = old && isSameItem(fresh, old) ? old : fresh;
    const { inside, children } = kept as BuildingItem;
    inside.item = kept;
    for (const child of children) (child as BuildingItem).around = inside;
    // Where its own parent is settled this is set again.
    (kept as BuildingItem).around = { item: null };
    built.byHandle.set(kept.handle, kept);
    return kept;
  };
  for (const items of [built.items, built.detached]) {
    items.forEach((item, i) => (items[i] = settled(item)));
  }
  built.uses.forEach((use, i) => {
    const kept = built.byHandle.get(use.handle) as Within<UseItem>;
    kept.target = (use.target && built.byHandle.get(use.target.handle)) ?? null;
    built.uses[i] = kept;
  });
}
