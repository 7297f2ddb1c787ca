// Dragging rows: a ghost at the pointer, a line where they would go, edges that scroll.
import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import type { TargetedMouseEvent, TargetedPointerEvent } from "preact";
import { moveInto, setHidden, setLocked } from "../../model/commands/index.js";
import type { Handle, Item } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { openMenu } from "../controls/menu.js";
import { contextMenu } from "../menus/main.js";
import { dropAt, type Drop } from "./drop.js";
import { select, type TreeState } from "./state.js";
import { Thumb } from "./thumb.js";

const words = en.layers;
/** CSS pixels: further, and a press is a drag. */
const SLOP = 4;
/** Nearer to an edge than this the tree scrolls, by this much a move. */
const EDGE = 24;
const SCROLL = 8;
const INDENT = 16;

export interface RowDrag {
  readonly dragged: ReadonlySet<Handle>;
  readonly items: readonly Item[];
  readonly drop: Drop | null;
  readonly at: { readonly x: number; readonly y: number };
  press(item: Item, event: TargetedPointerEvent<HTMLElement>): void;
  menu(event: TargetedMouseEvent<HTMLElement>): void;
}

interface Dragging {
  readonly items: readonly Item[];
  readonly drop: Drop | null;
  readonly x: number;
  readonly y: number;
}

/**
 * Returns the items that move when `item` is dragged: the selection if it is selected, else it alone; nothing
 * twice.
 */
function movable({ editor, rows }: TreeState, item: Item): readonly Item[] {
  const chosen = editor.selection.value.map(({ handle }) => handle);
  if (!chosen.includes(item.handle)) return [item];
  const set = new Set(chosen);
  const isWithin = (at: Item) => {
    for (let above = at.parent; above; above = above.parent) if (set.has(above.handle)) return true;
    return false;
  };
  return rows
    .map((row) => row.item)
    .filter((at) => set.has(at.handle) && !isWithin(at))
    .reverse();
}

export function useRowDrag(
  state: TreeState,
  tree: { current: HTMLElement | null },
  rowHeight: number,
): RowDrag {
  const dragging = useSignal<Dragging | null>(null);
  const latest = useRef(state);
  latest.current = state;

  const follow = (items: readonly Item[], event: PointerEvent) => {
    const view = tree.current;
    if (!view) return;
    const box = view.getBoundingClientRect();
    if (event.clientY < box.top + EDGE) view.scrollTop -= SCROLL;
    else if (event.clientY > box.bottom - EDGE) view.scrollTop += SCROLL;
    const y = (event.clientY - box.top + view.scrollTop) / rowHeight;
    const depth = Math.round((event.clientX - box.left - 2 * INDENT) / INDENT);
    const { editor, rows } = latest.current;
    dragging.value = {
      items,
      drop: dropAt(editor.drawing, rows, y, depth, items),
      x: event.clientX,
      y: event.clientY,
    };
  };

  const finish = () => {
    const now = dragging.value;
    dragging.value = null;
    if (!now?.drop) return;
    const { editor } = latest.current;
    const handles = now.items.map(({ handle }) => handle);
    editor.run(
      words.move,
      moveInto(editor.drawing, handles, now.drop.parent?.handle ?? null, now.drop.index),
    );
  };

  const press = (item: Item, event: TargetedPointerEvent<HTMLElement>) => {
    const from = { x: event.clientX, y: event.clientY };
    const isTouch = event.pointerType === "touch" && !(event.target as Element).closest(".grip");
    const wasSelected = state.editor.selection.value.some(({ handle }) => handle === item.handle);
    if (!wasSelected || event.ctrlKey || event.metaKey || event.shiftKey)
      select(state, item, event);
    const move = (to: PointerEvent) => {
      if (
        !dragging.value &&
        (isTouch || Math.hypot(to.clientX - from.x, to.clientY - from.y) < SLOP)
      )
        return;
      follow(dragging.value?.items ?? movable(latest.current, item), to);
    };
    const stop = () => {
      window.removeEventListener("pointermove", move);
      window.removeEventListener("pointerup", up);
      window.removeEventListener("pointercancel", cancel);
      window.removeEventListener("keydown", key, true);
    };
    const up = (to: PointerEvent) => {
      stop();
      const isClick =
        dragging.value === null && Math.hypot(to.clientX - from.x, to.clientY - from.y) < SLOP;
      finish();
      if (isClick && wasSelected && !to.ctrlKey && !to.metaKey && !to.shiftKey)
        select(latest.current, item, to);
    };
    const cancel = () => {
      stop();
      dragging.value = null;
    };
    const key = (pressed: KeyboardEvent) => {
      if (pressed.key !== "Escape" || !dragging.value) return;
      pressed.stopPropagation();
      cancel();
    };
    window.addEventListener("pointermove", move);
    window.addEventListener("pointerup", up);
    window.addEventListener("pointercancel", cancel);
    window.addEventListener("keydown", key, true);
  };

  const menu = (event: TargetedMouseEvent<HTMLElement>) => {
    const handle = Number(
      (event.target as Element).closest<HTMLElement>("[role=treeitem]")?.dataset.handle,
    );
    const item = state.editor.drawing.item(handle);
    if (!item) return;
    event.preventDefault();
    if (!state.editor.selection.value.some((chosen) => chosen.handle === handle)) {
      select(state, item, { ctrlKey: false, metaKey: false, shiftKey: false });
    }
    openMenu(item.name, rowMenu(state, item), { x: event.clientX, y: event.clientY });
  };

  const now = dragging.value;
  return {
    dragged: new Set(now?.items.map(({ handle }) => handle)),
    items: now?.items ?? [],
    drop: now?.drop ?? null,
    at: { x: now?.x ?? 0, y: now?.y ?? 0 },
    press,
    menu,
  };
}

/** Returns the row's own menu, then the menu of the selection. */
export function rowMenu({ editor, renamed }: TreeState, item: Item) {
  const chosen = () => [...new Set(editor.selection.value.map(({ handle }) => handle))];
  return [
    {
      label: words.rename,
      run: () => {
        renamed.value = item.handle;
      },
    },
    {
      label: item.hidden ? words.show : words.hide,
      run: () =>
        void editor.run(
          words.set.hidden[item.hidden ? "off" : "on"],
          setHidden(editor.drawing, chosen(), !item.hidden),
        ),
    },
    {
      label: item.locked ? words.unlock : words.lock,
      run: () =>
        void editor.run(
          words.set.locked[item.locked ? "off" : "on"],
          setLocked(editor.drawing, chosen(), !item.locked),
        ),
    },
    "line" as const,
    ...contextMenu(editor),
  ];
}

export function Ghost({ drag }: { readonly drag: RowDrag }) {
  const [item] = drag.items;
  if (!item) return null;
  return (
    <div
      class="drag-ghost floating"
      aria-hidden="true"
      style={{ left: `${drag.at.x - 20}px`, top: `${drag.at.y + 6}px` }}
    >
      {(item.kind === "layer" || item.kind === "group") && <Thumb item={item} />}
      {drag.items.length > 1 ? words.many(drag.items.length) : item.name}
    </div>
  );
}
