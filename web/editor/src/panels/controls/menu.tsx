// Menus: one stack of them for the page. Opened by openMenu(), drawn by <Menus>.
import { signal } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import type { TargetedKeyboardEvent, TargetedMouseEvent, TargetedPointerEvent } from "preact";
import { Icon, type IconName } from "../../icons.js";
import { useShell } from "../services.js";
import { chordOf } from "./chords.js";
import { nextBeginning, typedWord } from "./typed.js";

export type MenuItem =
  | "line"
  | {
      readonly label: string;
      readonly icon?: IconName;
      /** Called by name, its key shown, unless `run` says otherwise. */
      readonly command?: string;
      readonly run?: () => void;
      /** A tick; undefined: the item cannot be on or off. */
      readonly checked?: boolean;
      readonly disabled?: boolean;
      /** Why it is disabled. */
      readonly reason?: string | null;
      readonly items?: readonly MenuItem[];
    };

interface Level {
  readonly items: readonly MenuItem[];
  readonly label: string;
  /** Below this box, or beside it if it is an item of a menu. */
  readonly at: { left: number; right: number; top: number; bottom: number };
  readonly beside: boolean;
}

const levels = signal<readonly Level[]>([]);
let opener: HTMLElement | null = null;

/** `anchor`: the element below which it opens, or a place of the window. */
export function openMenu(
  label: string,
  items: readonly MenuItem[],
  anchor: HTMLElement | { x: number; y: number },
) {
  opener = anchor instanceof HTMLElement ? anchor : (document.activeElement as HTMLElement | null);
  const at =
    anchor instanceof HTMLElement
      ? anchor.getBoundingClientRect()
      : { left: anchor.x, right: anchor.x, top: anchor.y, bottom: anchor.y };
  levels.value = [{ items, label, at, beside: false }];
}

function closeMenus() {
  if (levels.value.length === 0) return;
  levels.value = [];
  opener?.focus();
}

const EDGE = 6;

/** Within the window: beside its item, or below its opener; above where there is no room below. */
function place(menu: HTMLElement | null, { at, beside }: Level) {
  if (!menu) return;
  const { width, height } = menu.getBoundingClientRect();
  const isRight = at.right - 2 + width <= innerWidth - EDGE;
  // Where neither side has room, the item itself stays free: the pointer is on it.
  const isBeside = beside && (isRight || at.left + 2 - width >= EDGE);
  const side = isRight ? at.right - 2 : at.left + 2 - width;
  const gap = beside ? 0 : 4;
  const below = isBeside ? at.top - 4 : at.bottom + gap;
  const isAbove = !isBeside && below + height > innerHeight - EDGE && at.top - height - gap >= EDGE;
  const left = isBeside ? side : at.left;
  const top = isAbove ? at.top - height - gap : below;
  menu.style.left = `${Math.max(EDGE, Math.min(left, innerWidth - width - EDGE))}px`;
  menu.style.top = `${Math.max(EDGE, Math.min(top, innerHeight - height - EDGE))}px`;
}

function Entry({
  item,
  depth,
}: {
  readonly item: Exclude<MenuItem, "line">;
  readonly depth: number;
}) {
  const { editor } = useShell();
  const openInner = (element: HTMLElement) => {
    if (!item.items) return false;
    const level = {
      items: item.items,
      label: item.label,
      at: element.getBoundingClientRect(),
      beside: true,
    };
    levels.value = [...levels.value.slice(0, depth + 1), level];
    return true;
  };
  const choose = (event: TargetedMouseEvent<HTMLButtonElement>) => {
    if (openInner(event.currentTarget)) return;
    closeMenus();
    if (item.run) item.run();
    else if (item.command) editor.command(item.command);
  };
  const enter = (event: TargetedPointerEvent<HTMLButtonElement>) => {
    if (event.pointerType !== "mouse") return;
    event.currentTarget.focus();
    if (!openInner(event.currentTarget)) levels.value = levels.value.slice(0, depth + 1);
  };
  const key = (event: TargetedKeyboardEvent<HTMLButtonElement>) => {
    if (event.key === "ArrowRight" && openInner(event.currentTarget)) event.preventDefault();
  };
  const isOpen = levels.value[depth + 1]?.label === item.label;
  const chord = item.run && !item.command ? null : chordOf(item.command);
  return (
    <button
      type="button"
      class="menu-item"
      role={item.checked === undefined ? "menuitem" : "menuitemcheckbox"}
      aria-checked={item.checked}
      aria-haspopup={item.items ? "menu" : undefined}
      aria-expanded={item.items ? isOpen : undefined}
      disabled={item.disabled}
      tabIndex={-1}
      onClick={choose}
      onPointerEnter={enter}
      onKeyDown={key}
    >
      <span class="menu-mark">
        {item.checked ? <Icon name="check" small /> : item.icon && <Icon name={item.icon} small />}
      </span>
      <span class="menu-label">
        {item.label}
        {item.disabled && item.reason && <small class="menu-reason">{item.reason}</small>}
      </span>
      {chord && <span class="menu-chord">{chord}</span>}
      {item.items && <Icon name="chevron-right" small />}
    </button>
  );
}

/** Steps among the items of a menu; a letter goes to the next that begins with it. */
function step(menu: HTMLElement, event: KeyboardEvent): boolean {
  const items = [...menu.querySelectorAll<HTMLButtonElement>("button:not(:disabled)")];
  const at = items.indexOf(document.activeElement as HTMLButtonElement);
  const wrap = (index: number) => items[(index + items.length) % items.length]?.focus();
  if (event.key === "ArrowDown") wrap(at + 1);
  else if (event.key === "ArrowUp") wrap(at < 0 ? -1 : at - 1);
  else if (event.key === "Home") wrap(0);
  else if (event.key === "End") wrap(-1);
  else {
    const word = typedWord(event);
    if (word === null) return false;
    items[
      nextBeginning(
        items.map((item) => item.textContent?.trim() ?? ""),
        at,
        word,
      )
    ]?.focus();
  }
  return true;
}

function Menu({ level, depth }: { readonly level: Level; readonly depth: number }) {
  const menu = useRef<HTMLDivElement>(null);
  // At once, not a frame later: a key that comes next is the menu's.
  useLayoutEffect(() => {
    const now = menu.current;
    place(now, level);
    (
      now?.querySelector<HTMLElement>("[aria-checked=true]") ??
      now?.querySelector<HTMLElement>("button:not(:disabled)")
    )?.focus();
  }, [level]);
  const key = (event: TargetedKeyboardEvent<HTMLDivElement>) => {
    if (event.key === "Tab") closeMenus();
    else if (depth > 0 && (event.key === "ArrowLeft" || event.key === "Escape")) {
      levels.value = levels.value.slice(0, depth);
      document
        .querySelectorAll<HTMLElement>(".menu")
        [depth - 1]?.querySelector<HTMLElement>("[aria-expanded=true]")
        ?.focus();
    } else if (event.key === "Escape") closeMenus();
    else if (!step(event.currentTarget, event)) {
      event.stopPropagation();
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div class="menu floating" role="menu" aria-label={level.label} ref={menu} onKeyDown={key}>
      {level.items.map((item, index) =>
        item === "line" ? <hr key={index} /> : <Entry key={item.label} item={item} depth={depth} />,
      )}
    </div>
  );
}

export function Menus() {
  const open = levels.value;
  useLayoutEffect(() => {
    if (open.length === 0) return;
    const outside = (event: PointerEvent) => {
      if (!(event.target as Element).closest?.(".menu")) levels.value = [];
    };
    document.addEventListener("pointerdown", outside, true);
    window.addEventListener("blur", closeMenus);
    return () => {
      document.removeEventListener("pointerdown", outside, true);
      window.removeEventListener("blur", closeMenus);
    };
  }, [open.length === 0]);
  if (open.length === 0) return null;
  // A landmark, as all that stands on the page has to be in one.
  return (
    <nav aria-label={open[0].label}>
      {open.map((level, depth) => (
        <Menu key={depth} level={level} depth={depth} />
      ))}
    </nav>
  );
}
