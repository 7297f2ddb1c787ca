// The interface of tools, and the drags that most of them are built from.
import type { Gesture } from "../../app/types.js";
import type { Point } from "../../geometry/affine.js";
import type { Drawing, Handle, Outcome, Part } from "../../model/types.js";
import type { Canvas } from "../canvas.js";
import type { CursorName } from "../cursors.js";
import type { PointerKind } from "../hit.js";
import { NO_SKETCH } from "../sketch.js";

/** A moment of a pointer. Points are of the stage, CSS pixels. */
export interface Press {
  readonly at: Point;
  /** When it was there, milliseconds. */
  readonly time: number;
  /** Where it was since the last moment, `at` last. */
  readonly trail: readonly TrailPoint[];
  readonly pressure: number;
  readonly kind: PointerKind;
  readonly shift: boolean;
  readonly alt: boolean;
  readonly ctrl: boolean;
  /** 2: the second of a double click. */
  readonly clicks: number;
}

export interface TrailPoint {
  readonly at: Point;
  readonly time: number;
  readonly pressure: number;
}

export interface Modifiers {
  readonly shift: boolean;
  readonly alt: boolean;
  readonly ctrl: boolean;
}

export interface KeyPress extends Modifiers {
  readonly key: string;
}

/** From pointer down to up. It gets no more events after `end` or `cancel`. */
export interface Drag {
  move(p: Press): void;
  end(p: Press): void;
  /** Cancels the drag after Escape, a lost pointer, or a second finger: it leaves no change. */
  cancel(): void;
  /** A key was pressed or let go while it lasts; `p` is the last moment with the keys of now. */
  keys?(p: Press): void;
  /** Space goes down or up while it lasts; absent: Space moves the picture. */
  space?(isDown: boolean): void;
  /** Another key goes down while it lasts. @returns whether the key is the drag's */
  key?(key: KeyPress): boolean;
  readonly cursor?: CursorName;
}

export interface Tool {
  /** The pointer moves over the stage without a drag: what it would do. */
  hover(p: Press): CursorName;
  press(p: Press): Drag | null;
  /** @returns whether the key is the tool's */
  key?(key: KeyPress): boolean;
  /** Shift, Alt or Ctrl is pressed or released. */
  modifiers?(now: Modifiers): void;
  /** Another tool is taken up: what is unfinished is finished. */
  leave?(): void;
}

/** A pointer that moves less is a click, CSS pixels. */
export const CLICK_REACH = 3;

export interface Edit {
  /** In strings, of the step of undo. */
  readonly label: string;
  /** Returns the change of the drawing, compared with the drawing at the beginning. */
  make(p: Press, before: Drawing): Outcome | null;
  /** The part that is dragged: it keeps its strength while other handles fade. */
  readonly dragged?: { readonly handle: Handle; readonly part: Part };
  readonly cursor?: CursorName;
  /** The pointer did not move. */
  click?(p: Press): void;
  /** It was kept: what to say. */
  kept?(p: Press): void;
}

/** A drag that is one gesture: shown while it moves, one step of undo at its end. */
export class EditDrag implements Drag {
  private gesture: Gesture | null = null;
  private last: Press;

  constructor(
    private readonly canvas: Canvas,
    private readonly start: Press,
    private readonly edit: Edit,
  ) {
    this.last = start;
  }

  get cursor(): CursorName | undefined {
    return this.edit.cursor;
  }

  move(p: Press): void {
    this.last = p;
    if (!this.gesture) {
      if (!isBeyond(this.start.at, p.at)) return;
      this.gesture = this.canvas.editor.gesture(this.edit.label);
      this.canvas.draw({ dragged: this.edit.dragged ?? null, isFaded: true });
    }
    this.gesture.show((before) => this.edit.make(p, before));
  }

  keys(p: Press): void {
    if (this.gesture) this.move({ ...p, at: this.last.at });
  }

  end(p: Press): void {
    const { gesture } = this;
    this.canvas.sketch.value = NO_SKETCH;
    if (!gesture) {
      this.edit.click?.(p);
      return;
    }
    gesture.keep();
    this.edit.kept?.(p);
  }

  cancel(): void {
    this.gesture?.drop();
    this.canvas.sketch.value = NO_SKETCH;
  }
}

export function isBeyond(a: Point, b: Point, reach = CLICK_REACH): boolean {
  return Math.hypot(a[0] - b[0], a[1] - b[1]) > reach;
}

/** From where a drag began to where it is, on the stage; with Shift across or down alone. */
export function travelled(start: Press, p: Press): Point {
  const [dx, dy] = [p.at[0] - start.at[0], p.at[1] - start.at[1]];
  if (!p.shift) return [dx, dy];
  return Math.abs(dx) >= Math.abs(dy) ? [dx, 0] : [0, dy];
}

/** A rectangle that selects what it touches. */
export class MarqueeDrag implements Drag {
  private to: Point;

  constructor(
    private readonly canvas: Canvas,
    private readonly start: Press,
    private readonly done: (low: Point, high: Point, p: Press) => void,
    private readonly click: (p: Press) => void,
  ) {
    this.to = start.at;
  }

  private get isClick(): boolean {
    return !isBeyond(this.start.at, this.to);
  }

  move(p: Press): void {
    this.to = p.at;
    if (!this.isClick) this.canvas.draw({ marquee: [this.start.at, p.at] });
  }

  end(p: Press): void {
    this.canvas.draw({ marquee: null });
    if (this.isClick) {
      this.click(p);
      return;
    }
    const [[ax, ay], [bx, by]] = [this.start.at, this.to];
    this.done([Math.min(ax, bx), Math.min(ay, by)], [Math.max(ax, bx), Math.max(ay, by)], p);
  }

  cancel(): void {
    this.canvas.draw({ marquee: null });
  }
}

/** The selection with one more, or without it where it was in it. */
export function toggled<T>(
  list: readonly T[],
  one: T,
  isSame: (a: T, b: T) => boolean,
): readonly T[] {
  const rest = list.filter((other) => !isSame(other, one));
  return rest.length < list.length ? rest : [...list, one];
}
