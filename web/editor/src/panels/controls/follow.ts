// A held pointer: moves beyond a slop, and how it ends.

interface Follow {
  /** CSS pixels: nearer to where it was pressed, nothing has moved. */
  readonly slop: number;
  readonly onMove: (event: PointerEvent) => void;
  /** Once. false: Escape, or the system took the pointer away. */
  readonly onEnd: (isKept: boolean) => void;
}

/**
 * Follows the pointer until it is let go. The holder captures it once it moves, and not sooner, so
 * that clicks and double clicks stay with what was pressed.
 */
export function follow(
  holder: HTMLElement,
  pressed: PointerEvent,
  { slop, onMove, onEnd }: Follow,
) {
  const { pointerId, clientX, clientY } = pressed;
  let hasMoved = false;
  const move = (event: PointerEvent) => {
    if (event.pointerId !== pointerId) return;
    if (!hasMoved && Math.hypot(event.clientX - clientX, event.clientY - clientY) <= slop) return;
    if (!hasMoved && holder.isConnected) holder.setPointerCapture(pointerId);
    hasMoved = true;
    onMove(event);
  };
  const end = (isKept: boolean) => {
    window.removeEventListener("pointermove", move);
    window.removeEventListener("pointerup", up);
    window.removeEventListener("pointercancel", cancel);
    window.removeEventListener("keydown", escape, true);
    if (holder.hasPointerCapture(pointerId)) holder.releasePointerCapture(pointerId);
    onEnd(isKept);
  };
  const up = (event: PointerEvent) => event.pointerId === pointerId && end(true);
  const cancel = (event: PointerEvent) => event.pointerId === pointerId && end(false);
  const escape = (key: KeyboardEvent) => {
    if (key.key !== "Escape") return;
    key.preventDefault();
    key.stopPropagation();
    end(false);
  };
  window.addEventListener("pointermove", move);
  window.addEventListener("pointerup", up);
  window.addEventListener("pointercancel", cancel);
  window.addEventListener("keydown", escape, true);
}
