// Where dragged rows would go.
import type { Drawing, Item } from "../../model/types.js";
import { ancestors, siblingsOf, type Row } from "./rows.js";

export interface Drop {
  readonly parent: Item | null;
  /** As moveInto() counts: before this child of the parent. */
  readonly index: number;
  /** "into": the row itself is outlined; else the line stands above row `row`. */
  readonly kind: "into" | "line";
  readonly row: number;
  readonly depth: number;
}

const isInLayer = (parent: Item | null) =>
  parent !== null && [parent, ...ancestors(parent)].some(({ kind }) => kind === "layer");

/**
 * Whether items may stand in a parent: not within themselves, and what a layer holds stays in
 * layers.
 */
export function mayHold(parent: Item | null, items: readonly Item[]): boolean {
  const above = parent ? [parent, ...ancestors(parent)] : [];
  if (parent && parent.kind !== "layer" && parent.kind !== "group") return false;
  return items.every(
    (item) => !above.includes(item) && isInLayer(parent) === isInLayer(item.parent),
  );
}

/** The gap above row `at`, at the depth that is nearest to the wish. */
function gap(drawing: Drawing, rows: readonly Row[], at: number, wish: number): Drop {
  const above = rows[at - 1];
  const below = rows[at];
  if (!above) return { parent: null, index: drawing.items.length, kind: "line", row: at, depth: 0 };
  const deepest = above.isOpen ? above.depth + 1 : above.depth;
  const depth = Math.min(Math.max(wish, below?.depth ?? 0), deepest);
  if (above.isOpen && depth === deepest) {
    return { parent: above.item, index: above.item.children.length, kind: "line", row: at, depth };
  }
  const chain = [above.item, ...ancestors(above.item)];
  const upper = chain[above.depth - depth];
  const index = siblingsOf(drawing, upper).indexOf(upper);
  return { parent: upper.parent, index, kind: "line", row: at, depth };
}

/**
 * @param y pointer below the first row's upper edge, in rows
 * @param depth that the pointer's x stands for
 * @returns null where the items may not go
 */
export function dropAt(
  drawing: Drawing,
  rows: readonly Row[],
  y: number,
  depth: number,
  items: readonly Item[],
): Drop | null {
  if (rows.length === 0) return null;
  const over = Math.min(Math.max(Math.floor(y), 0), rows.length - 1);
  const part = y - over;
  const row = rows[over];
  const isContainer = row.item.kind === "layer" || row.item.kind === "group";
  if (isContainer && part > 1 / 3 && part < 2 / 3 && mayHold(row.item, items)) {
    return {
      parent: row.item,
      index: row.item.children.length,
      kind: "into",
      row: over,
      depth: row.depth,
    };
  }
  const place = gap(drawing, rows, part < 0.5 ? over : over + 1, depth);
  return mayHold(place.parent, items) ? place : null;
}
