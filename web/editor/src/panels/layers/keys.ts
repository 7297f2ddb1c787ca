// Keys of the tree: WAI-ARIA's, F2, and Alt with arrows, which moves rows.
import type { TargetedKeyboardEvent } from "preact";
import { moveInto, restack } from "../../model/commands/index.js";
import type { Item } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { openMenu } from "../controls/menu.js";
import { nextBeginning, typedWord } from "../controls/typed.js";
import { rowMenu } from "./drag.js";
import { mayHold } from "./drop.js";
import { siblingsOf } from "./rows.js";
import { select, toggle, type TreeState } from "./state.js";

const words = en.layers;

/**
 * Alt with an arrow: up and down among siblings; right into the row above, left out of what holds
 * it.
 */
function move({ editor }: TreeState, item: Item, key: string): void {
  const { drawing } = editor;
  if (key === "ArrowUp" || key === "ArrowDown") {
    editor.run(words.move, restack(drawing, [item.handle], key === "ArrowUp" ? 1 : -1));
    return;
  }
  const siblings = siblingsOf(drawing, item);
  if (key === "ArrowRight") {
    const above = siblings[siblings.indexOf(item) + 1];
    if (above && mayHold(above, [item]))
      editor.run(words.move, moveInto(drawing, [item.handle], above.handle, 0));
    return;
  }
  const { parent } = item;
  if (!parent || !mayHold(parent.parent, [item])) return;
  const outer = siblingsOf(drawing, parent);
  editor.run(
    words.move,
    moveInto(drawing, [item.handle], parent.parent?.handle ?? null, outer.indexOf(parent) + 1),
  );
}

function goTo(
  state: TreeState,
  tree: { current: HTMLElement | null },
  rowHeight: number,
  index: number,
  event: KeyboardEvent,
) {
  const row = state.rows[Math.min(Math.max(index, 0), state.rows.length - 1)];
  const view = tree.current;
  if (!row || !view) return;
  const top = state.rows.indexOf(row) * rowHeight;
  if (top < view.scrollTop) view.scrollTop = top;
  else if (top + rowHeight > view.scrollTop + view.clientHeight)
    view.scrollTop = top + rowHeight - view.clientHeight;
  state.active.value = row.item.handle;
  if (!event.ctrlKey && !event.metaKey) select(state, row.item, event);
  // The row is drawn after this; somebody may have gone elsewhere in the meantime.
  requestAnimationFrame(() => {
    if (view.contains(document.activeElement))
      view.querySelector<HTMLElement>(`#row-${row.item.handle}`)?.focus();
  });
}

export function treeKeys(
  state: TreeState,
  tree: { current: HTMLElement | null },
  rowHeight: number,
) {
  const { rows, active, open, renamed } = state;
  return (event: TargetedKeyboardEvent<HTMLElement>) => {
    const at = Math.max(
      rows.findIndex(({ item }) => item.handle === active.value),
      0,
    );
    const row = rows[at];
    if (!row) return;
    const go = (index: number) => goTo(state, tree, rowHeight, index, event);
    if (event.altKey && event.key.startsWith("Arrow")) move(state, row.item, event.key);
    else if (event.key === "ArrowDown") go(at + 1);
    else if (event.key === "ArrowUp") go(at - 1);
    else if (event.key === "Home") go(0);
    else if (event.key === "End") go(rows.length - 1);
    else if (event.key === "ArrowRight") {
      if (row.isOpen === false) toggle(open, row.item.handle, true);
      else if (row.isOpen) go(at + 1);
    } else if (event.key === "ArrowLeft") {
      if (row.isOpen) toggle(open, row.item.handle, false);
      else if (row.item.parent) go(rows.findIndex(({ item }) => item === row.item.parent));
    } else if (event.key === "F2") renamed.value = row.item.handle;
    else if (event.key === "Enter") select(state, row.item, event);
    else if (event.key === " ")
      select(state, row.item, { ctrlKey: true, metaKey: false, shiftKey: false });
    else if (event.key === "ContextMenu" || (event.key === "F10" && event.shiftKey)) {
      if (!state.editor.selection.value.some(({ handle }) => handle === row.item.handle))
        select(state, row.item, { ctrlKey: false, metaKey: false, shiftKey: false });
      const box = document.getElementById(`row-${row.item.handle}`)?.getBoundingClientRect();
      if (box)
        openMenu(row.item.name, rowMenu(state, row.item), { x: box.left + 40, y: box.bottom });
    } else {
      const word = typedWord(event);
      if (word === null) return;
      const found = nextBeginning(
        rows.map(({ item }) => item.name),
        at,
        word,
      );
      if (found >= 0) go(found);
    }
    event.preventDefault();
    event.stopPropagation();
  };
}
