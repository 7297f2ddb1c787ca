// The tree of layers by WAI-ARIA. Only the rows in sight are in the page, and the one with the
// focus.
import { useSignal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import type { TargetedPointerEvent } from "preact";
import { isolatedBy } from "../../app/selected.js";
import type { Editor } from "../../app/types.js";
import { setHidden, setLocked } from "../../model/commands/index.js";
import type { Handle, Item } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { useShell } from "../services.js";
import { Ghost, useRowDrag } from "./drag.js";
import { treeKeys } from "./keys.js";
import { RowView, type RowEvents } from "./row.js";
import { ancestors, rowsOf, type Row } from "./rows.js";
import { toggle, type TreeState } from "./state.js";

const words = en.layers;
/** Rows beyond the edges that are made all the same. */
const SPARE = 6;

const setters = { hidden: setHidden, locked: setLocked } as const;

/**
 * Sweeps over eyes or locks: the one that was pressed and all that the pointer crosses get the same state, in
 * one step.
 */
function sweep(editor: Editor, item: Item, what: "hidden" | "locked") {
  const to = !item[what];
  const handles = new Set([item.handle]);
  const gesture = editor.gesture(words.set[what][to ? "on" : "off"]);
  const show = () => gesture.show((before) => setters[what](before, [...handles], to));
  const move = (event: PointerEvent) => {
    const button = document
      .elementFromPoint(event.clientX, event.clientY)
      ?.closest<HTMLElement>(`[data-sweep=${what}]`);
    const handle = Number(button?.dataset.handle);
    if (!button || handles.has(handle)) return;
    handles.add(handle);
    show();
  };
  const end = () => {
    window.removeEventListener("pointermove", move);
    window.removeEventListener("pointerup", end);
    window.removeEventListener("pointercancel", end);
    gesture.keep();
  };
  show();
  window.addEventListener("pointermove", move);
  window.addEventListener("pointerup", end);
  window.addEventListener("pointercancel", end);
}

/** Rows from `first` up to `last`, and the active one. */
function inSight(
  rows: readonly Row[],
  scroll: { top: number; height: number },
  rowHeight: number,
  active: number,
) {
  const first = Math.max(Math.floor(scroll.top / rowHeight) - SPARE, 0);
  const last = Math.min(Math.ceil((scroll.top + scroll.height) / rowHeight) + SPARE, rows.length);
  const indices = Array.from({ length: Math.max(last - first, 0) }, (_, k) => first + k);
  if (active >= 0 && (active < first || active >= last)) indices.push(active);
  return indices;
}

/** Unfolds what holds the selection, and scrolls to it when it was made elsewhere. */
function useReveal(state: TreeState, tree: { current: HTMLElement | null }, rowHeight: number) {
  const { editor, open, active, rows } = state;
  const selection = editor.selection.value;
  const primary = selection[selection.length - 1]?.handle ?? null;
  const sought = useRef<Handle | null>(null);
  const scroll = () => {
    const index = rows.findIndex(({ item }) => item.handle === sought.current);
    const view = tree.current;
    if (!view || index < 0) return;
    sought.current = null;
    const top = index * rowHeight;
    if (top < view.scrollTop) view.scrollTop = top;
    else if (top + rowHeight > view.scrollTop + view.clientHeight)
      view.scrollTop = top + rowHeight - view.clientHeight;
  };
  // Rows that were unfolded for it have to be there first: until then the tree is too short.
  useLayoutEffect(scroll, [rows]);
  useEffect(() => {
    const item = primary === null ? undefined : editor.drawing.item(primary);
    if (!item) return;
    const closed = ancestors(item).filter(({ handle }) => !open.peek().has(handle));
    if (closed.length > 0)
      open.value = new Set([...open.peek(), ...closed.map(({ handle }) => handle)]);
    active.value = primary;
    sought.current = primary;
    scroll();
  }, [primary]);
}

export function Tree() {
  const { editor } = useShell();
  const tree = useRef<HTMLDivElement>(null);
  const open = useSignal<ReadonlySet<Handle>>(new Set());
  const active = useSignal<Handle | null>(null);
  const renamed = useSignal<Handle | null>(null);
  const scroll = useSignal({ top: 0, height: 600 });
  const rowHeight = useSignal(28);
  const rows = rowsOf(editor.drawing, open.value);
  const state: TreeState = { editor, open, active, renamed, rows };
  const measure = () => {
    const view = tree.current;
    if (!view) return;
    scroll.value = { top: view.scrollTop, height: view.clientHeight };
    rowHeight.value = parseFloat(getComputedStyle(view).getPropertyValue("--row")) || 28;
  };
  useLayoutEffect(() => {
    measure();
    const observer = new ResizeObserver(measure);
    if (tree.current) observer.observe(tree.current);
    return () => observer.disconnect();
  }, []);
  useReveal(state, tree, rowHeight.value);
  const drag = useRowDrag(state, tree, rowHeight.value);

  const selected = new Set(editor.selection.value.map(({ handle }) => handle));
  const inside = new Set<Handle>();
  for (const handle of selected) {
    const item = editor.drawing.item(handle);
    if (item) ancestors(item).forEach((above) => inside.add(above.handle));
  }
  const activeIndex = Math.max(
    rows.findIndex(({ item }) => item.handle === active.value),
    0,
  );
  const press = (item: Item, event: TargetedPointerEvent<HTMLElement>) => {
    if (event.button !== 0) return;
    active.value = item.handle;
    drag.press(item, event);
  };
  const events = useRef<RowEvents>(null!);
  events.current = {
    onPress: press,
    onTwist: (item) => toggle(open, item.handle),
    onSweep: (item, what) => sweep(editor, item, what),
    onToggle: (item, what) =>
      void editor.run(
        words.set[what][item[what] ? "off" : "on"],
        setters[what](editor.drawing, [item.handle], !item[what]),
      ),
    onIsolate: (item) => {
      const wanted = isolatedBy(item)?.handle ?? null;
      editor.isolate(editor.isolated.value === wanted ? null : wanted);
    },
    onRename: (item) => {
      renamed.value = item.handle;
    },
    onRenamed: (item, goesOn) => {
      renamed.value = null;
      if (goesOn) tree.current?.querySelector<HTMLElement>(`#row-${item.handle}`)?.focus();
    },
  };
  return (
    <div
      class="tree"
      role="tree"
      aria-label={words.treeOf(editor.file.value.name)}
      aria-multiselectable="true"
      ref={tree}
      onScroll={measure}
      onKeyDown={treeKeys(state, tree, rowHeight.value)}
      onContextMenu={(event) => drag.menu(event)}
    >
      <div
        class="tree-rows"
        role="presentation"
        style={{ height: `${rows.length * rowHeight.value}px` }}
      >
        {inSight(rows, scroll.value, rowHeight.value, activeIndex).map((index) => {
          const row = rows[index];
          const { handle } = row.item;
          return (
            <RowView
              key={handle}
              row={row}
              top={index * rowHeight.value}
              isActive={index === activeIndex}
              isSelected={selected.has(handle)}
              isInside={inside.has(handle) && !selected.has(handle)}
              isDragged={drag.dragged.has(handle)}
              isTarget={drag.drop?.kind === "into" && drag.drop.row === index}
              isRenamed={renamed.value === handle}
              events={events}
            />
          );
        })}
        {drag.drop?.kind === "line" && (
          <div
            class="drop-line"
            style={{ "--depth": drag.drop.depth, top: `${drag.drop.row * rowHeight.value}px` }}
          />
        )}
      </div>
      <Ghost drag={drag} />
    </div>
  );
}
