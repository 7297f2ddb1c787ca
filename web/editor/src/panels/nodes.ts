// Nodes that are selected, and of what kind they are.
import type { Editor } from "../app/types.js";
import type { Point } from "../geometry/affine.js";
import type { CubicPath } from "../geometry/cubic.js";
import type { NodeKind } from "../model/commands/index.js";
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
  return { item, path, indices: [...new Set(indices)].filter((index) => item.paths[path].points[3 * index]) };
}

const arm = (from: Point, to: Point): Point => [to[0] - from[0], to[1] - from[1]];
/** A tangent that turns by less than this is one, radians. */
const STRAIGHT = 0.01;
/** Handles of one length, relatively. */
const ALIKE = 0.01;

function kindOf({ points, closed }: CubicPath, index: number): NodeKind {
  const at = 3 * index;
  const before = points[at - 1] ?? (closed ? points[points.length - 2] : undefined);
  const behind = points[at + 1] ?? (closed ? points[1] : undefined);
  if (!before || !behind) return "corner";
  const [ax, ay] = arm(before, points[at]);
  const [bx, by] = arm(points[at], behind);
  const a = Math.hypot(ax, ay);
  const b = Math.hypot(bx, by);
  if (a === 0 || b === 0) return "corner";
  if (Math.abs(Math.atan2(ax * by - ay * bx, ax * bx + ay * by)) > STRAIGHT) return "corner";
  return Math.abs(a - b) <= ALIKE * Math.max(a, b) ? "symmetric" : "smooth";
}

/** The kind that all of them have, or null. */
export function kindOfNodes({ item, path, indices }: SelectedNodes): NodeKind | null {
  const kinds = new Set(indices.map((index) => kindOf(item.paths[path], index)));
  return kinds.size === 1 ? [...kinds][0] : null;
}
