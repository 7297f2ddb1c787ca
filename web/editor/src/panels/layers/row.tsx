// One row of the tree.
import { memo } from "preact/compat";
import { useLayoutEffect, useRef } from "preact/hooks";
import type { TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import { Icon, type IconName } from "../../icons.js";
import { rename } from "../../model/commands/index.js";
import type { Item } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { blendName } from "../blend.js";
import { useShell } from "../services.js";
import { countWithin, type Row } from "./rows.js";
import { settledOf } from "./settled.js";
import { Thumb } from "./thumb.js";

const words = en.layers;

/** The events that a row sends to its tree. */
export interface RowEvents {
  readonly onTwist: (item: Item) => void;
  readonly onPress: (item: Item, event: TargetedPointerEvent<HTMLElement>) => void;
  readonly onSweep: (
    item: Item,
    what: "hidden" | "locked",
    event: TargetedPointerEvent<HTMLElement>,
  ) => void;
  readonly onToggle: (item: Item, what: "hidden" | "locked") => void;
  readonly onIsolate: (item: Item) => void;
  readonly onRename: (item: Item) => void;
  /** `goesOn`: the row gets the focus. */
  readonly onRenamed: (item: Item, goesOn: boolean) => void;
}

interface RowViewProps {
  /** The present events: a change of them alone is no reason to draw a row again. */
  readonly events: { readonly current: RowEvents };
  readonly row: Row;
  readonly top: number;
  readonly isActive: boolean;
  readonly isSelected: boolean;
  readonly isInside: boolean;
  readonly isDragged: boolean;
  readonly isTarget: boolean;
  readonly isRenamed: boolean;
}

const kindIcon = (item: Item, isOriginal: boolean): IconName => {
  if (isOriginal) return "component";
  return (
    {
      curve: "spline",
      stroke: "brush",
      use: "link-2",
      reference: "image",
      layer: "layers",
      group: "folder",
    } as const
  )[item.kind];
};

interface NameProps {
  readonly item: Item;
  /** `goesOn`: the keys are the row's again; else somebody has gone elsewhere. */
  readonly onDone: (goesOn: boolean) => void;
}

function Name({ item, onDone }: NameProps) {
  const { editor } = useShell();
  const input = useRef<HTMLInputElement>(null);
  const isOver = useRef(false);
  useLayoutEffect(() => {
    input.current?.focus();
    input.current?.select();
  }, []);
  const end = (isKept: boolean, goesOn: boolean) => {
    if (isOver.current) return;
    isOver.current = true;
    const name = input.current?.value.trim() ?? "";
    if (isKept && name !== "" && name !== item.name)
      editor.run(words.rename, rename(editor.drawing, item.handle, name));
    onDone(goesOn);
  };
  const key = (event: TargetedKeyboardEvent<HTMLInputElement>) => {
    event.stopPropagation();
    if (event.key === "Enter") end(true, true);
    else if (event.key === "Escape") end(false, true);
    else return;
    event.preventDefault();
  };
  return (
    <input
      class="name rename"
      ref={input}
      aria-label={words.nameOf(item.name)}
      defaultValue={item.name}
      onKeyDown={key}
      onBlur={() => end(true, false)}
      onPointerDown={(event) => event.stopPropagation()}
    />
  );
}

interface SwitchProps extends Pick<RowViewProps, "events"> {
  readonly item: Item;
  readonly what: "hidden" | "locked";
}

function Switch({ item, what, events }: SwitchProps) {
  const isOn = item[what];
  const icon = what === "hidden" ? (isOn ? "eye-off" : "eye") : isOn ? "lock" : "lock-open";
  return (
    <button
      type="button"
      class="icon-button"
      tabIndex={-1}
      aria-pressed={isOn}
      aria-label={words[what](item.name)}
      data-sweep={what}
      data-handle={item.handle}
      onPointerDown={(event) => {
        event.stopPropagation();
        if (event.button === 0) events.current.onSweep(item, what, event);
      }}
      onClick={(event) => event.detail === 0 && events.current.onToggle(item, what)}
    >
      <Icon name={icon} small />
    </button>
  );
}

/**
 * Returns a row's accessible name: the visible text first, in its order, so that voice control can use it;
 * then the meaning of icons and buttons. The buttons have names of their own.
 */
function rowName(item: Item, copies: number): string {
  const isContainer = item.kind === "layer" || item.kind === "group";
  const parts = [
    item.name,
    copies > 0 && words.original,
    item.blend !== "normal" && blendName(item.blend),
    isContainer && words.curvesIn(countWithin(item)),
    words.kinds[item.kind],
    copies > 0 && words.copiesFollow(copies),
    item.hidden && words.isHidden,
    item.locked && words.isLocked,
  ];
  return words.rowName(parts.filter((part) => part !== false));
}

/** A row that shows the same is not drawn again: an item with different content is another object. */
export const RowView = memo(PlainRow, (before, now) => {
  const { row: rowBefore, ...restBefore } = before;
  const { row, ...rest } = now;
  return isSame(rowBefore, row) && isSame(restBefore, rest);
});

function isSame<Props extends object>(a: Props, b: Props): boolean {
  return (Object.keys(b) as (keyof Props)[]).every((key) => a[key] === b[key]);
}

function PlainRow(props: RowViewProps) {
  const { row, isRenamed, events } = props;
  const { item } = row;
  const { editor } = useShell();
  const isContainer = item.kind === "layer" || item.kind === "group";
  const copies = settledOf(editor).uses.value.get(item.handle) ?? 0;
  const names = ["tree-row"];
  if (item.hidden) names.push("off");
  if (props.isInside) names.push("inside");
  if (props.isDragged) names.push("dragged");
  if (props.isTarget) names.push("target");
  return (
    <div
      class={names.join(" ")}
      role="treeitem"
      id={`row-${item.handle}`}
      data-handle={item.handle}
      aria-label={rowName(item, copies)}
      aria-level={row.depth + 1}
      aria-posinset={row.position}
      aria-setsize={row.siblings}
      aria-selected={props.isSelected}
      aria-expanded={row.isOpen ?? undefined}
      tabIndex={props.isActive ? 0 : -1}
      style={{ "--depth": row.depth, top: `${props.top}px` }}
      onPointerDown={(event) => events.current.onPress(item, event)}
      onDblClick={({ target }) => {
        if (isContainer && !(target as Element).closest("button, .twist, .name")) events.current.onIsolate(item);
      }}
      onPointerEnter={() => {
        editor.hovered.value = item.handle;
      }}
      onPointerLeave={() => {
        editor.hovered.value = null;
      }}
    >
      <span class="grip">
        <Icon name="grip-vertical" small />
      </span>
      <span
        class={row.isOpen ? "twist open" : "twist"}
        onPointerDown={(event) => {
          if (row.isOpen === null) return;
          event.stopPropagation();
          events.current.onTwist(item);
        }}
      >
        {row.isOpen !== null && <Icon name="chevron-right" small />}
      </span>
      {isContainer && copies === 0 ? (
        <Thumb item={item} />
      ) : (
        <Icon name={kindIcon(item, copies > 0)} small />
      )}
      {isRenamed ? (
        <Name item={item} onDone={(goesOn) => events.current.onRenamed(item, goesOn)} />
      ) : (
        <span class="name" onDblClick={() => events.current.onRename(item)}>
          {item.name}
        </span>
      )}
      {/* Blanks part the words where the row is read as one text. */}{" "}
      {copies > 0 && (
        <span class="badge" title={words.copiesFollow(copies)}>
          {words.original}
        </span>
      )}
      {" "}
      {item.blend !== "normal" && <span class="badge">{blendName(item.blend)}</span>}
      {" "}
      {isContainer && <span class="kind">{countWithin(item)}</span>}
      <Switch item={item} what="locked" events={events} />
      <Switch item={item} what="hidden" events={events} />
    </div>
  );
}
