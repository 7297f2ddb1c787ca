// A drawing with some of its objects alone.
import { patchOf } from "../../../source/attributes.js";
import { applied } from "../../../source/patch.js";
import type { Drawing, Handle, Item } from "../../types.js";
import { svgName } from "../markup.js";

/**
 * Returns a text that draws only the outermost objects that contain these items. It moves all other objects into
 * <defs>, because a linked copy needs its original.
 */
export function onlyItems(d: Drawing, handles: readonly Handle[]): string {
  const wanted = new Set(handles);
  const has = (item: Item): boolean => wanted.has(item.handle) || item.children.some(has);
  const name = svgName(d.root, "defs");
  const edits = d.items
    .filter((item) => !has(item))
    .flatMap(({ element: { range } }) => [
      { at: range.start, removed: "", inserted: `<${name}>` },
      { at: range.end, removed: "", inserted: `</${name}>` },
    ]);
  return applied(d.text, patchOf(edits));
}
