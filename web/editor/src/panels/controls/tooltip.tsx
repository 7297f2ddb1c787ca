// One tooltip for the page: over whatever bears data-tip, with the key of data-tip-key.
import { useEffect, useState } from "preact/hooks";

/**
 * After this long over an element; at once if another was shown this short a time ago.
 * Milliseconds.
 */
const WAIT = 500;
const NEIGHBOUR = 300;
const GAP = 6;

interface Shown {
  readonly text: string;
  readonly chord: string | undefined;
  readonly at: DOMRect;
}

/** Calls show with what is to be seen, and null. Returns what ends it. */
function watch(show: (shown: Shown | null) => void): () => void {
  let timer = 0;
  let hiddenAt = -Infinity;
  let current: Element | null = null;
  const leave = () => {
    window.clearTimeout(timer);
    if (current) hiddenAt = performance.now();
    current = null;
    show(null);
  };
  const reveal = (element: HTMLElement) => {
    if (!element.isConnected) return;
    current = element;
    show({
      text: element.dataset.tip ?? "",
      chord: element.dataset.tipKey,
      at: element.getBoundingClientRect(),
    });
  };
  const enter = (event: Event, wait: number) => {
    const element = (event.target as Element).closest?.<HTMLElement>("[data-tip]");
    if (element === current && element) return;
    const soon = current !== null || performance.now() - hiddenAt < NEIGHBOUR;
    leave();
    if (!element) return;
    timer = window.setTimeout(() => reveal(element), soon ? 0 : wait);
  };
  const over = (event: PointerEvent) =>
    event.pointerType === "mouse" && event.buttons === 0 && enter(event, WAIT);
  const focus = (event: FocusEvent) =>
    (event.target as Element).matches?.(":focus-visible") && enter(event, WAIT);
  const key = (event: KeyboardEvent) => event.key === "Escape" && leave();
  document.addEventListener("pointerover", over);
  document.addEventListener("focusin", focus);
  document.addEventListener("focusout", leave);
  document.addEventListener("pointerdown", leave, true);
  document.addEventListener("keydown", key);
  return () => {
    leave();
    document.removeEventListener("pointerover", over);
    document.removeEventListener("focusin", focus);
    document.removeEventListener("focusout", leave);
    document.removeEventListener("pointerdown", leave, true);
    document.removeEventListener("keydown", key);
  };
}

/** Below the element, above it where there is no room; never out of the window. */
function place(tip: HTMLElement | null, at: DOMRect) {
  if (!tip) return;
  const { width, height } = tip.getBoundingClientRect();
  const left = Math.min(
    Math.max(at.left + at.width / 2 - width / 2, GAP),
    innerWidth - width - GAP,
  );
  const below = at.bottom + GAP;
  tip.style.left = `${left}px`;
  tip.style.top = `${below + height < innerHeight ? below : at.top - GAP - height}px`;
}

export function Tooltip() {
  const [shown, setShown] = useState<Shown | null>(null);
  useEffect(() => watch(setShown), []);
  if (!shown) return null;
  return (
    <div class="tooltip floating" aria-hidden="true" ref={(tip) => place(tip, shown.at)}>
      {shown.text}
      {shown.chord && <kbd>{shown.chord}</kbd>}
    </div>
  );
}
