// Pointer input for tests: sequences of presses for a tool, or of pointers for a stage.
import type { Point } from "../../../../web/editor/src/geometry/affine.js";
import type { Drag, Press, Tool } from "../../../../web/editor/src/canvas/tools/tool.js";
import type { Pointers, StagePointer } from "../../../../web/editor/src/canvas/pointers.js";

export function press(at: Point, more: Partial<Press> = {}): Press {
  return {
    at,
    time: 0,
    trail: [{ at, time: more.time ?? 0, pressure: more.pressure ?? 0.5 }],
    pressure: 0.5,
    kind: "mouse",
    shift: false,
    alt: false,
    ctrl: false,
    clicks: 1,
    ...more,
  };
}

/** Presses, moves through the points, and releases at the last one. */
export function dragThrough(tool: Tool, points: readonly Point[], more: Partial<Press> = {}): void {
  const drag = tool.press(press(points[0], more));
  for (const at of points.slice(1)) drag?.move(press(at, more));
  drag?.end(press(points[points.length - 1], more));
}

export function click(tool: Tool, at: Point, more: Partial<Press> = {}): void {
  tool.hover(press(at, more));
  dragThrough(tool, [at], more);
}

/** Returns a drag that has moved but not ended. */
export function begun(tool: Tool, points: readonly Point[], more: Partial<Press> = {}): Drag {
  const drag = tool.press(press(points[0], more));
  if (!drag) throw new Error("nothing is dragged");
  for (const at of points.slice(1)) drag.move(press(at, more));
  return drag;
}

export class Hand {
  time = 1000;

  constructor(
    readonly pointers: Pointers,
    readonly kind: StagePointer["kind"] = "mouse",
    readonly id = 1,
  ) {}

  event(at: Point, more: Partial<StagePointer> = {}): StagePointer {
    this.time += 16;
    return {
      id: this.id,
      kind: this.kind,
      button: 0,
      at,
      pressure: 0.5,
      shift: false,
      alt: false,
      ctrl: false,
      time: this.time,
      trail: [],
      ...more,
    };
  }

  down(at: Point, more: Partial<StagePointer> = {}): boolean {
    return this.pointers.down(this.event(at, more));
  }

  move(at: Point, more: Partial<StagePointer> = {}): void {
    this.pointers.move(this.event(at, more));
  }

  up(at: Point, more: Partial<StagePointer> = {}): void {
    this.pointers.up(this.event(at, more));
  }

  wait(milliseconds: number): void {
    this.time += milliseconds;
  }
}
