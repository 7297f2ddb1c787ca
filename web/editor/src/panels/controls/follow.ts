// A held pointer: moves beyond a slop, and how it ends.

interface Follow {
  /** CSS pixels: nearer to where it was pressed, nothing has moved. */
  readonly slop: number;
  readonly onMove: (event: PointerEvent) => void;
  /** Once. false: Escape, or the system took the pointer away. */
  readonly onEnd: (isKept: boolean) => void;
}

/** The holder gets the pointer's events until it is let go; it must outlive the movement. */
export function follow(holder: HTMLElement, pressed: PointerEvent, { slop, onMove, onEnd }: Follow) {
  let hasMoved = slop === 0;
  const move = (event: PointerEvent) => {
    hasMoved ||= Math.hypot(event.clientX - pressed.clientX, event.clientY - pressed.clientY) > slop;
    if (hasMoved) onMove(event);
  };
  const end = (isKept: boolean) => {
    holder.removeEventListener("pointermove", move);
    holder.removeEventListener("lostpointercapture", keep);
    holder.removeEventListener("pointercancel", drop);
    window.removeEventListener("keydown", escape, true);
    if (holder.hasPointerCapture(pressed.pointerId)) holder.releasePointerCapture(pressed.pointerId);
    onEnd(isKept);
  };
  const keep = () => end(true);
  const drop = () => end(false);
  const escape = (key: KeyboardEvent) => {
    if (key.key !== "Escape") return;
    key.preventDefault();
    key.stopPropagation();
    drop();
  };
  holder.setPointerCapture(pressed.pointerId);
  holder.addEventListener("pointermove", move);
  holder.addEventListener("lostpointercapture", keep);
  holder.addEventListener("pointercancel", drop);
  window.addEventListener("keydown", escape, true);
}
