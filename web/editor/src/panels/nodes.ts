// Nodes that are selected, and of what kind they are.
import type { Editor } from "../app/types.js";
import { kindOf, type NodeKind } from "../geometry/nodes.js";
import type { CurveItem } from "../model/types.js";

export interface SelectedNodes {
  readonly item: CurveItem;
  readonly path: number;
  readonly indices: readonly number[];
}

/** The nodes of the primary curve's subpath, or null where none is selected. */
export function selectedNodes(editor: Editor): SelectedNodes | null {
  const selection = editor.selection.value;
  const primary = [...selection].reverse().find(({ part }) => part.kind === "node");
  if (!primary || primary.part.kind !== "node") return null;
  const item = editor.drawing.item(primary.handle);
  if (!item || (item.kind !== "curve" && item.kind !== "stroke")) return null;
  const { path } = primary.part;
  if (!item.paths[path]) return null;
  const indices = selection.flatMap(({ handle, part }) =>
    handle === primary.handle && part.kind === "node" && part.path === path ? [part.index] : [],
  );
  return {
    item,
    path,
    indices: [...new Set(indices)].filter((index) => item.paths[path].points[3 * index]),
  };
}

/** The kind that all of them have, or null. */
export function kindOfNodes({ item, path, indices }: SelectedNodes): NodeKind | null {
  const kinds = new Set(indices.map((index) => kindOf(item.paths[path], index)));
  return kinds.size === 1 ? [...kinds][0] : null;
}
