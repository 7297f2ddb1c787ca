// Which pointer does what: draws, moves the picture, or is not heard.
import { signal, type Signal } from "@preact/signals";
import type { Point } from "../geometry/affine.js";
import * as en from "../strings/en.js";
import type { Canvas } from "./canvas.js";
import type { CursorName } from "./cursors.js";
import { rulerAt, rulerDrag } from "./guides/drag.js";
import type { PointerKind } from "./hit.js";
import { PanDrag } from "./tools/hand.js";
import type { Drag, KeyPress, Modifiers, Press, Tool, TrailPoint } from "./tools/tool.js";

/** A pointer event, with its place on the stage in CSS pixels. */
export interface StagePointer {
  readonly id: number;
  readonly kind: PointerKind;
  readonly button: number;
  readonly at: Point;
  readonly pressure: number;
  readonly shift: boolean;
  readonly alt: boolean;
  readonly ctrl: boolean;
  /** Milliseconds. */
  readonly time: number;
  /** Moments since the last event, the last of them `at`. */
  readonly trail: readonly TrailPoint[];
}

/** A palm that touches the screen this long after the pen is not a finger: milliseconds. */
const PALM_TIME = 500;
/** Two presses within these are a double click: milliseconds, CSS pixels by kind. */
const DOUBLE_TIME = 400;
const DOUBLE_REACH = { mouse: 4, pen: 8, touch: 24 } as const;
const MIDDLE = 1;
/** Fingers that tap together: for at most this long, milliseconds, and moving at most so far, CSS pixels. */
const TAP_TIME = 300;
const TAP_REACH = 12;

/** Fingers that came down together, and may be a tap. */
interface Tap {
  readonly began: number;
  readonly places: Map<number, Point>;
  /** How many were down at once. */
  count: number;
  /** A finger has moved, or drawn something. */
  isOver: boolean;
}

interface Held {
  readonly id: number;
  readonly drag: Drag | null;
  readonly clicks: number;
  last: Press;
}

/** The state of all pointers over a stage. It knows no DOM. */
export class Pointers {
  readonly cursor: Signal<CursorName> = signal("default");
  private held: Held | null = null;
  private readonly fingers = new Map<number, Point>();
  private tap: Tap | null = null;
  /** Fingers that move the picture: until all are lifted none of them draws. */
  private isPinching = false;
  private isSpace = false;
  /** When a pen was seen last, milliseconds: from then on a finger moves the picture. */
  private penTime = -Infinity;
  private lastDown = { time: -Infinity, at: [0, 0] as Point, clicks: 0 };

  constructor(
    private readonly canvas: Canvas,
    private readonly tool: () => Tool,
  ) {}

  get isDragging(): boolean {
    return this.held !== null || this.isPinching;
  }

  private isPalm(e: StagePointer): boolean {
    if (e.kind === "pen") this.penTime = e.time;
    return e.kind === "touch" && e.time - this.penTime < PALM_TIME;
  }

  private press(e: StagePointer, clicks = 1): Press {
    const { at, time, pressure, kind, shift, alt, ctrl } = e;
    const trail = e.trail.length > 0 ? e.trail : [{ at, time, pressure }];
    return { at, time, pressure, kind, shift, alt, ctrl, clicks, trail };
  }

  private countClicks(e: StagePointer): number {
    const { time, at, clicks } = this.lastDown;
    const isNear = Math.hypot(e.at[0] - at[0], e.at[1] - at[1]) <= DOUBLE_REACH[e.kind];
    const now = e.time - time <= DOUBLE_TIME && isNear ? clicks + 1 : 1;
    // A third click starts a new count.
    this.lastDown = { time: e.time, at: e.at, clicks: now === 2 ? 0 : now };
    return now;
  }

  /** @returns whether the pointer is to be captured */
  down(e: StagePointer): boolean {
    if (this.isPalm(e)) return false;
    if (e.kind === "touch") {
      this.fingers.set(e.id, e.at);
      this.tapDown(e);
      if (this.fingers.size >= 2) {
        this.cancel();
        this.isPinching = true;
      }
      if (this.isPinching) return true;
    }
    if (this.held || (e.button !== 0 && e.button !== MIDDLE)) return false;
    const isFingerBesidePen = e.kind === "touch" && this.penTime > -Infinity;
    const isPan = e.button === MIDDLE || this.isSpace || isFingerBesidePen;
    const p = this.press(e, isPan ? 1 : this.countClicks(e));
    const drag = isPan ? new PanDrag(this.canvas, p) : this.pressOn(p);
    this.held = { id: e.id, drag, clicks: p.clicks, last: p };
    this.cursor.value = drag?.cursor ?? this.cursor.peek();
    return true;
  }

  private pressOn(p: Press): Drag | null {
    return rulerAt(this.canvas, p.at) ? rulerDrag(this.canvas, p) : this.tool().press(p);
  }

  move(e: StagePointer): void {
    if (this.isPalm(e)) return;
    this.tapMove(e);
    if (this.tap && this.isPinching && !this.tap.isOver) return;
    this.canvas.editor.pointer.value = this.canvas.toArtboard(e.at);
    if (this.fingers.has(e.id) && this.isPinching) {
      this.pinch(e);
      return;
    }
    if (this.fingers.has(e.id)) this.fingers.set(e.id, e.at);
    const { held } = this;
    if (held && held.id !== e.id) return;
    if (held) {
      held.last = this.press(e, held.clicks);
      held.drag?.move(held.last);
    } else if (e.kind !== "touch") this.hover(e);
  }

  private hover(e: StagePointer): void {
    const ruler = rulerAt(this.canvas, e.at);
    if (ruler) this.clearHover();
    const over = ruler?.cursor ?? this.tool().hover(this.press(e));
    this.cursor.value = this.isSpace ? "grab" : over;
  }

  /** Two fingers: what lies under them stays under them. */
  private pinch(e: StagePointer): void {
    const before = this.spread();
    this.fingers.set(e.id, e.at);
    const after = this.spread();
    const { navigation } = this.canvas;
    navigation.moveBy(after.at[0] - before.at[0], after.at[1] - before.at[1]);
    if (before.width > 0 && after.width > 0)
      navigation.zoomBy(after.width / before.width, after.at, false);
  }

  private spread(): { at: Point; width: number } {
    const [a, b] = [...this.fingers.values()];
    if (!b) return { at: a, width: 0 };
    return {
      at: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2],
      width: Math.hypot(a[0] - b[0], a[1] - b[1]),
    };
  }

  up(e: StagePointer): void {
    if (this.isPalm(e) && !this.fingers.has(e.id)) return;
    this.lift(e.id);
    this.tapUp(e);
    const { held } = this;
    if (held?.id !== e.id) return;
    this.held = null;
    held.drag?.end(this.press(e, held.clicks));
    if (e.kind !== "touch") this.hover(e);
  }

  // Taps of several fingers: two undo, three redo.

  private tapDown(e: StagePointer): void {
    // The first finger begins a tap; a finger that comes while others move the picture does not.
    if (this.fingers.size === 1) this.tap = { began: e.time, places: new Map(), count: 0, isOver: false };
    const { tap } = this;
    if (!tap) return;
    tap.places.set(e.id, e.at);
    tap.count = Math.max(tap.count, this.fingers.size);
    tap.isOver ||= e.time - tap.began > TAP_TIME;
  }

  private tapMove({ id, at: [x, y], time }: StagePointer): void {
    const { tap } = this;
    const from = tap?.places.get(id);
    if (!tap || !from) return;
    tap.isOver ||= time - tap.began > TAP_TIME || Math.hypot(x - from[0], y - from[1]) > TAP_REACH;
  }

  private tapUp(e: StagePointer): void {
    const { tap } = this;
    if (!tap || this.fingers.size > 0) return;
    this.tap = null;
    if (tap.isOver || e.time - tap.began > TAP_TIME || (tap.count !== 2 && tap.count !== 3)) return;
    const { editor } = this.canvas;
    const label = tap.count === 2 ? editor.undoLabel.peek() : editor.redoLabel.peek();
    if (label === null) return;
    if (tap.count === 2) editor.undo();
    else editor.redo();
    editor.say(tap.count === 2 ? en.canvas.undone(label) : en.canvas.redone(label));
  }

  private lift(id: number): void {
    if (this.fingers.delete(id) && this.fingers.size === 0) this.isPinching = false;
  }

  /** Undoes the press, because the pointer was taken away. */
  lost(id: number): void {
    // A finger that is lifted is lost afterwards, too.
    if (this.fingers.has(id)) this.tap = null;
    this.lift(id);
    if (this.held?.id === id) this.cancel();
  }

  /** Drops what is dragged. @returns whether something was */
  cancel(): boolean {
    const { held } = this;
    this.held = null;
    held?.drag?.cancel();
    return held?.drag != null;
  }

  /** Keys that change what a drag does. */
  modifiers(now: Modifiers): void {
    const { held } = this;
    if (!held) return;
    held.last = { ...held.last, ...now, trail: [] };
    held.drag?.keys?.(held.last);
  }

  /** A key that is neither a modifier nor Space. @returns whether the drag took it */
  key(key: KeyPress): boolean {
    return this.held?.drag?.key?.(key) ?? false;
  }

  space(isDown: boolean): void {
    const drag = this.held?.drag;
    if (drag?.space) {
      drag.space(isDown);
      return;
    }
    if (this.isSpace === isDown) return;
    this.isSpace = isDown;
    if (!this.held) this.cursor.value = isDown ? "grab" : "default";
  }

  leave(): void {
    if (this.held) return;
    this.clearHover();
    this.canvas.editor.pointer.value = null;
  }

  private clearHover(): void {
    this.canvas.editor.hovered.value = null;
    this.canvas.draw({ brush: null, guides: [], loupe: null });
  }
}
