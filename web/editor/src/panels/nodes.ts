// Nodes that are selected, and of what kind they are.
import type { Editor } from "../app/types.js";
import { nodePath } from "../geometry/natural.js";
import { kindOf, type NodeKind } from "../geometry/nodes.js";
import type { CurveItem } from "../model/types.js";

export interface SelectedNodes {
  readonly item: CurveItem;
  /** The nodes of all subpaths. */
  readonly nodes: ReadonlyMap<number, readonly number[]>;
  /** The one that was chosen last. */
  readonly path: number;
  readonly index: number;
  readonly count: number;
}

/** Returns the nodes of the primary curve, or null where none is selected. */
export function selectedNodes(editor: Editor): SelectedNodes | null {
  const selection = editor.selection.value;
  const primary = [...selection].reverse().find(({ part }) => part.kind === "node");
  const item = primary && editor.drawing.item(primary.handle);
  if (!item || (item.kind !== "curve" && item.kind !== "stroke")) return null;
  const nodes = new Map<number, readonly number[]>();
  let last: { path: number; index: number } | null = null;
  for (const { handle, part } of selection) {
    if (handle !== item.handle || part.kind !== "node") continue;
    const { path, index } = part;
    // A selection may be of a time when there were more.
    if (!item.paths[path] || !nodePath(item.paths[path]).points[3 * index]) continue;
    nodes.set(path, [...new Set([...(nodes.get(path) ?? []), index])]);
    last = { path, index };
  }
  const count = [...nodes.values()].reduce((sum, of) => sum + of.length, 0);
  return last && { item, nodes, ...last, count };
}

/** The kind that all of them have, or null. */
export function kindOfNodes({ item, nodes }: SelectedNodes): NodeKind | null {
  const kinds = new Set(
    [...nodes].flatMap(([path, of]) => of.map((index) => kindOf(nodePath(item.paths[path]), index))),
  );
  return kinds.size === 1 ? [...kinds][0] : null;
}
