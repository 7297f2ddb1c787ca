// Deleting a chosen handle: it goes back into its node, and the curve stays.
import { movedHandle, nodeOfHandle } from "../geometry/nodes.js";
import { nodePath } from "../geometry/natural.js";
import { setPath } from "../model/commands/index.js";
import type { Handle, Part } from "../model/types.js";
import * as en from "../strings/en.js";
import type { Editor } from "./types.js";

export function takeInHandle(editor: Editor, handle: Handle, part: Part & { kind: "handle" }): void {
  const item = editor.drawing.item(handle);
  if (item?.kind !== "curve" && item?.kind !== "stroke") return;
  const shown = item.paths[part.path];
  const path = shown && nodePath(shown);
  if (!path?.points[part.index]) return;
  const node = nodeOfHandle(path, part.index);
  const { path: changed } = movedHandle(path, part.index, path.points[3 * node], "free");
  const made = setPath(editor.drawing, handle, part.path, changed, editor.step(item));
  if (!editor.run(en.commands.deleteHandle, made)) return;
  const chosen: Part = { kind: "node", path: part.path, index: node };
  editor.selection.value = [{ handle, part: chosen }];
}
