// The last frame stands in for frames of other views where drawing takes long.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { MovedFrame } from "../../../../web/viewer/moved_frame.js";

const VIEW = [2, 0, 0, 2, 10, 20];

/** Returns a frame of VIEW that took this time, and its canvas. */
function drawn(milliseconds: number) {
  const canvas = { style: {} as Record<string, string> };
  const frame = new MovedFrame(canvas as unknown as HTMLCanvasElement);
  frame.begin(VIEW);
  vi.advanceTimersByTime(milliseconds);
  frame.finish();
  return { canvas, frame };
}

describe("moved frame", () => {
  beforeEach(() => void vi.useFakeTimers({ toFake: ["performance"] }));
  afterEach(() => void vi.useRealTimers());

  it("stands in where a frame took more than 30 ms, until the view rests", () => {
    const { frame } = drawn(100);
    const changedAt = performance.now();
    expect(frame.standsIn(changedAt)).toBe(true);
    vi.advanceTimersByTime(149);
    expect(frame.standsIn(changedAt)).toBe(true);
    vi.advanceTimersByTime(1);
    expect(frame.standsIn(changedAt)).toBe(false);
  });

  it("does not stand in where drawing is fast, or before the first frame", () => {
    expect(drawn(30).frame.standsIn(performance.now())).toBe(false);
    const first = new MovedFrame({ style: {} } as unknown as HTMLCanvasElement);
    expect(first.standsIn(performance.now())).toBe(false);
  });

  it("leaves a fifth of the time to frames of a view that moves on", () => {
    const { frame } = drawn(100);
    vi.advanceTimersByTime(499);
    expect(frame.standsIn(performance.now())).toBe(true);
    vi.advanceTimersByTime(1);
    expect(frame.standsIn(performance.now())).toBe(false);
    frame.begin(VIEW);
    vi.advanceTimersByTime(5000);
    expect(frame.standsIn(performance.now())).toBe(true);
  });

  it("lies where the other view shows it, and in place once it is drawn", () => {
    const { canvas, frame } = drawn(100);
    frame.move([4, 0, 0, 4, 30, 60]);
    expect(canvas.style.transform).toBe("matrix(2,0,0,2,10,20)");
    expect(canvas.style.transformOrigin).toBe("0 0");
    frame.begin([4, 0, 0, 4, 30, 60]);
    expect(canvas.style.transform).toBe("");
  });
});
