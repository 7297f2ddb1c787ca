// The detail of the picture for the visible part.
import { describe, expect, it } from "vitest";
import { detailFor, type Detail } from "../../../../web/editor/src/engine/detail.js";
import type { Box } from "../../../../web/editor/src/geometry/affine.js";

const artboard: Box = [0, 0, 400, 300];
const seen = (zoom: number, x = 200, y = 150): Box => [x - 500 / zoom, y - 400 / zoom, x + 500 / zoom, y + 400 / zoom];

describe("detail", () => {
  it("has at least half of the screen's pixels where the artboard shows", () => {
    let before: Detail | null = null;
    for (let i = 0; i < 4000; ++i) {
      const zoom = 2 ** (8 * Math.sin(i * 0.37) + 2);
      const box = seen(zoom, 200 + 150 * Math.sin(i), 150 + 100 * Math.cos(i * 1.7));
      const detail: Detail = detailFor(zoom, box, artboard, before);
      expect(detail.pixelsPerUnit).toBeGreaterThanOrEqual((zoom / 2) * (1 - 1e-9));
      const [x0, y0, x1, y1] = detail.part ?? artboard;
      const sides = [
        [x0, x1, box[0], box[2], 400],
        [y0, y1, box[1], box[3], 300],
      ];
      for (const [least, most, from, to, length] of sides) {
        expect(least).toBeLessThanOrEqual(Math.max(from, 0) + 1e-9);
        expect(most).toBeGreaterThanOrEqual(Math.min(to, length) - 1e-9);
      }
      const width = Number(detail.options.width);
      expect(width).toBeLessThan(20000);
      before = detail;
    }
  });

  it("stays while the view changes by a little", () => {
    const first = detailFor(1, seen(1), artboard, null);
    expect(detailFor(1.2, seen(1.2), artboard, detailFor(1.5, seen(1.5), artboard, null)).pixelsPerUnit).toBe(2);
    expect(detailFor(0.9, seen(0.9), artboard, first)).toBe(first);
    expect(detailFor(0.5, seen(0.5), artboard, first)).toBe(first);
    expect(detailFor(2, seen(2), artboard, first)).toBe(first);
    expect(detailFor(2.6, seen(2.6), artboard, first).pixelsPerUnit).toBe(4);
    const near = detailFor(100, seen(100), artboard, null);
    expect(detailFor(100, seen(100, 201, 151), artboard, near)).toBe(near);
    expect(detailFor(100, seen(100, 260, 151), artboard, near)).not.toBe(near);
  });

  it("is another one for another artboard: its width counts for all of it", () => {
    const small: Box = [0, 0, 40, 30];
    const before = detailFor(8, seen(8), small, null);
    expect(detailFor(8, seen(8), artboard, before)).toEqual(detailFor(8, seen(8), artboard, null));
    expect(detailFor(8, seen(8), [0, 0, 40, 30], before)).toBe(before);
  });

  it("takes artboards without a side, and views beside them", () => {
    expect(detailFor(1, [0, 0, 1, 1], [0, 0, 0, 0], null).options.width).toBe(1);
    expect(detailFor(1000, [1e6, 1e6, 1e6 + 1, 1e6 + 1], artboard, null).part).toBeNull();
  });
});
