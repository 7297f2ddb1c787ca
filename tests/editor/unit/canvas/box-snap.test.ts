// Boxes that are aligned with other boxes.
import { describe, expect, test } from "vitest";
import { snappedBox } from "../../../../web/editor/src/geometry/box-snap.js";

const other = [100, 100, 200, 140] as const;

describe("a box", () => {
  test("takes the nearest of edges and middles, in each direction", () => {
    const { by, lines } = snappedBox([103, 200, 123, 220], [other], 8);
    expect(by).toEqual([-3, 0]);
    expect(lines).toEqual([{ from: [100, 100], to: [100, 220] }]);
    expect(snappedBox([138, 119, 158, 126], [other], 8)).toEqual({
      by: [2, 1],
      lines: [
        { from: [150, 100], to: [150, 140] },
        { from: [100, 120], to: [200, 120] },
      ],
    });
  });

  test("stays where nothing is near enough", () => {
    expect(snappedBox([209, 200, 300, 300], [other], 8)).toEqual({ by: [0, 0], lines: [] });
    expect(snappedBox([0, 0, 1, 1], [], 8)).toEqual({ by: [0, 0], lines: [] });
  });

  test("takes a line like an edge, and the line that shows it spans the box alone", () => {
    expect(snappedBox([303, 200, 323, 220], [other], 8, [[300, 400], [216]])).toEqual({
      by: [-3, -4],
      lines: [
        { from: [300, 196], to: [300, 216] },
        { from: [300, 216], to: [320, 216] },
      ],
    });
    expect(snappedBox([191, 300, 201, 310], [other], 8, [[194], []]).by[0]).toBe(-1);
    expect(snappedBox([191, 300, 201, 310], [], 8, [[194], []]).by[0]).toBe(-2);
  });

  test("takes the first of several that are equally near", () => {
    const { by } = snappedBox([103, 300, 104, 301], [[100, 0, 100, 1], [107, 0, 107, 1]], 8);
    expect(by[0]).toBe(-3);
  });
});
