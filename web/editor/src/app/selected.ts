// The selection, in the forms that commands need.
import { layerOf } from "../model/commands/structure/items.js";
import type { CurveItem, Handle, Item, Part } from "../model/types.js";
import type { Editor } from "./types.js";

/** Returns the selected elements, each once, in the order in which they were chosen. */
export function chosen(editor: Editor): readonly Handle[] {
  return [...new Set(editor.selection.value.map(({ handle }) => handle))];
}

export function chosenItems(editor: Editor): readonly Item[] {
  return chosen(editor).flatMap((handle) => editor.drawing.item(handle) ?? []);
}

/** The primary one. */
export function primaryItem(editor: Editor): Item | null {
  const last = editor.selection.value.at(-1);
  return (last && editor.drawing.item(last.handle)) ?? null;
}

/** Returns what is isolated for an item: its layer, or the group that is it or around it. null: nothing can be. */
export function isolatedBy(item: Item | null): Item | null {
  const isGroup = item?.kind === "group" || item?.kind === "layer";
  return layerOf(item) ?? (isGroup ? item : (item?.parent ?? null));
}

export function primaryCurve(editor: Editor): CurveItem | null {
  const item = primaryItem(editor);
  return item?.kind === "curve" || item?.kind === "stroke" ? item : null;
}

/** Whether all of the primary curve is closed: then it can be opened. */
export function isPrimaryClosed(editor: Editor): boolean {
  return primaryCurve(editor)?.paths.every(({ closed }) => closed) ?? false;
}

/** Returns the selected curves and local curves, including those inside selected containers. */
export function chosenCurves(editor: Editor): readonly CurveItem[] {
  const found = new Map<Handle, CurveItem>();
  const visit = (item: Item) => {
    if (item.kind === "curve" || item.kind === "stroke") found.set(item.handle, item);
    else item.children.forEach(visit);
  };
  chosenItems(editor).forEach(visit);
  return [...found.values()];
}

/** Chosen nodes of the primary curve, by subpath. */
export function chosenNodes(editor: Editor): ReadonlyMap<number, readonly number[]> {
  const handle = editor.selection.value.at(-1)?.handle;
  const nodes = new Map<number, number[]>();
  for (const { handle: of, part } of editor.selection.value) {
    if (of !== handle || part.kind !== "node") continue;
    nodes.set(part.path, [...(nodes.get(part.path) ?? []), part.index]);
  }
  return nodes;
}

/** The chosen stop of the primary curve. */
export function chosenStop(editor: Editor): (Part & { kind: "stop" }) | null {
  const part = editor.selection.value.at(-1)?.part;
  return part?.kind === "stop" ? part : null;
}
