// A drawing with some of its objects alone.
import { patchOf } from "../../../source/attributes.js";
import { applied } from "../../../source/patch.js";
import type { Drawing, Handle, Item } from "../../types.js";
import { svgName } from "../markup.js";

/**
 * Returns the text in which only the outermost objects with these items are drawn. The other ones become definitions,
 * so that linked copies of them are still drawn.
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
