// The state of the tree of layers: the rows, which are unfolded, and the selection by clicks.
import type { Signal } from "@preact/signals";
import type { Editor } from "../../app/types.js";
import type { Handle, Item, Selection } from "../../model/types.js";
import type { Row } from "./rows.js";

export interface TreeState {
  readonly editor: Editor;
  readonly open: Signal<ReadonlySet<Handle>>;
  /** The row in the tab order. */
  readonly active: Signal<Handle | null>;
  readonly renamed: Signal<Handle | null>;
  readonly rows: readonly Row[];
}

export const whole = (handle: Handle) => ({ handle, part: { kind: "whole" } }) as const;

/**
 * A click's meaning: alone; with Ctrl, in or out; with Shift, all rows from the primary to here.
 */
export function select(
  state: TreeState,
  item: Item,
  event: { ctrlKey: boolean; metaKey: boolean; shiftKey: boolean },
) {
  const { selection } = state.editor;
  const now = selection.value;
  const primary = now[now.length - 1]?.handle;
  if (event.shiftKey && primary !== undefined) {
    const handles = state.rows.map((row) => row.item.handle);
    const [from, to] = [handles.indexOf(primary), handles.indexOf(item.handle)];
    if (from >= 0) {
      const range = handles
        .slice(Math.min(from, to), Math.max(from, to) + 1)
        .filter((handle) => handle !== primary);
      selection.value = [...range, primary].map(whole);
      return;
    }
  }
  if (event.ctrlKey || event.metaKey) {
    const rest: Selection = now.filter(({ handle }) => handle !== item.handle);
    selection.value = rest.length === now.length ? [...now, whole(item.handle)] : rest;
    return;
  }
  selection.value = [whole(item.handle)];
}

export function toggle(open: Signal<ReadonlySet<Handle>>, handle: Handle, to?: boolean) {
  const next = new Set(open.value);
  if (to ?? !next.has(handle)) next.add(handle);
  else next.delete(handle);
  open.value = next;
}
