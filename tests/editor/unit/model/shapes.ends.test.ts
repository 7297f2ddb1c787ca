// Edits that remove nodes, split subpaths, close and join, and the parts of the picture that stay the same.
import { describe, expect, test } from "vitest";
import { mapped } from "../../../../web/editor/src/geometry/affine.js";
import { pieceCount } from "../../../../web/editor/src/geometry/cubic.js";
import { leftNormalAt, pathPointAt } from "../../../../web/editor/src/geometry/length.js";
import { farthestFrom, nearestOn } from "../../../../web/editor/src/geometry/nearest.js";
import {
  closeByEnd,
  deleteNodes,
  joinCurves,
  moveNodes,
  reverseCurves,
  setClosed,
  setNodeKind,
  splitPiece,
} from "../../../../web/editor/src/model/commands/curves/shapes.js";
import { kindOf } from "../../../../web/editor/src/geometry/nodes.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { CurveItem, Drawing } from "../../../../web/editor/src/model/types.js";
import { Random } from "../random.js";
import {
  STEP,
  documentOf,
  curvesIn,
  after,
  shownAt,
  expectSamePicture,
  expectNear,
  COLORS,
  listOf,
  randomCurve,
} from "../support/shapes.js";

describe("deleting nodes", () => {
  test("stays near the shape, and stops near their places", () => {
    for (let seed = 0; seed < 30; ++seed) {
      const { random, pieces, closed, drawing, curve } = randomCurve(seed);
      const node = closed ? random.below(pieces) : 1 + random.below(pieces - 1);
      const next = after(drawing, deleteNodes(drawing, curve.handle, new Map([[0, [node]]]), STEP));
      const [now] = curvesIn(next);
      expect(pieceCount(now.paths[0])).toBe(pieces - 1);
      expect(farthestFrom(now.paths[0], curve.paths[0]), next.text).toBeLessThan(60);
    }
  });

  test("a node that a split added goes without a trace but rounding", () => {
    for (let seed = 0; seed < 20; ++seed) {
      const { pieces, drawing, curve } = randomCurve(seed);
      const split = after(drawing, splitPiece(drawing, curve.handle, 0, 1, 0.4, STEP));
      const [between] = curvesIn(split);
      const next = after(split, deleteNodes(split, between.handle, new Map([[0, [2]]]), STEP));
      const [now] = curvesIn(next);
      expect(pieceCount(now.paths[0])).toBe(pieces);
      expectSamePicture(curve, now, `seed ${seed}\n${drawing.text}\n${next.text}`, 0.2, 0.15);
    }
  });

  test("ends cut, corners leave lines, and too few nodes leave nothing", () => {
    const drawing = openDrawing(
      documentOf(
        '<path d="M0 0L10 0L10 10L0 10Z" sf:left="red"/>',
        '<path d="M0 0L5 5C6 6 7 6 8 5" sf:left="red"/>',
      ),
    );
    const [square, open] = curvesIn(drawing);
    expect(after(drawing, deleteNodes(drawing, square.handle, new Map([[0, [2]]]), STEP)).text).toContain(
      'd="M0 0L10 0L0 10Z"',
    );
    expect(after(drawing, deleteNodes(drawing, square.handle, new Map([[0, [0]]]), STEP)).text).toMatch(
      /d="M10 0L10 10[ L]0 10Z"/,
    );
    expect(after(drawing, deleteNodes(drawing, open.handle, new Map([[0, [2]]]), STEP)).text).toContain(
      'd="M0 0L5 5"',
    );
    const gone = after(drawing, deleteNodes(drawing, open.handle, new Map([[0, [0, 1]]]), STEP));
    expect(curvesIn(gone).length).toBe(1);
    expect(gone.text).toContain('sf:left="red"/>\n  </g>');
  });

  test("a subpath goes alone", () => {
    const drawing = openDrawing(documentOf('<path d="M0 0L9 0M20 20L30 30m1 1h5" sf:left="red"/>'));
    const [curve] = curvesIn(drawing);
    const [now] = curvesIn(after(drawing, deleteNodes(drawing, curve.handle, new Map([[1, [0, 1]]]), STEP)));
    expect(now.paths.map((path) => path.points[0])).toEqual([
      [0, 0],
      [31, 31],
    ]);
  });
});

describe("subpaths that share a list with @", () => {
  const shape =
    '<path id="p" d="M0 0L20 0L20 20M40 40h20v20h-20zm50 0h30" class="k" sf:left="red @0, blue @1.5, gold @2" sf:right="#000, #fff"/>';

  /** Returns the curve that draws a place. */
  const shownBy = (
    curves: readonly CurveItem[],
    point: readonly [number, number],
    facing: readonly [number, number],
  ) => {
    const near = curves.flatMap((item) =>
      item.paths.map((path, i) => ({ item, i, miss: nearestOn(path, point).distance })),
    );
    near.sort((a, b) => a.miss - b.miss);
    expect(near[0].miss).toBeLessThan(2 * STEP);
    const { item, i } = near[0];
    // The drawing's values follow the first subpath's segments; separate lists follow their own.
    return shownAt(item, i, point, facing);
  };

  test.each([
    ["split", (d: Drawing, c: CurveItem) => splitPiece(d, c.handle, 1, 1, 0.25, STEP)],
    ["reversed", (d: Drawing, c: CurveItem) => reverseCurves(d, [c.handle], STEP)],
  ])("keep their picture when one is %s, and part", (_, edit) => {
    const drawing = openDrawing(documentOf(shape));
    const [curve] = curvesIn(drawing);
    const outcome = edit(drawing, curve);
    const next = after(drawing, outcome);
    const curves = curvesIn(next);
    expect(curves.length).toBeGreaterThan(1);
    expect(curves.flatMap((item) => item.paths).length).toBe(3);
    expect(new Set(next.text.match(/ id="p[^"]*"/g)).size).toBe(curves.length);
    expect(next.text.match(/class="k"/g)?.length).toBe(curves.length);
    if (outcome!.select) expect(next.itemAt(outcome!.select[0].at)).toBe(curves[1]);
    curve.paths.forEach((path, i) => {
      for (let k = 1; k < 20; ++k) {
        const at = (k / 20.3) * pieceCount(path);
        const [point, normal] = [pathPointAt(path, at), leftNormalAt(path, at)!];
        for (const facing of [normal, [-normal[0], -normal[1]] as const]) {
          expectNear(
            shownAt(curve, i, point, facing),
            shownBy(curves, point, facing),
            0.02,
            `${i} ${at}\n${next.text}`,
          );
        }
      }
    });
  });

  test("stay together where nothing of the list changes", () => {
    const drawing = openDrawing(documentOf(shape));
    const [curve] = curvesIn(drawing);
    expect(
      curvesIn(after(drawing, moveNodes(drawing, curve.handle, new Map([[1, [1]]]), [1, 1], STEP))).length,
    ).toBe(1);
  });
});

describe("kinds of nodes", () => {
  test("are what was asked for", () => {
    for (let seed = 0; seed < 100; ++seed) {
      const { random, pieces, drawing, curve } = randomCurve(seed);
      const node = 1 + random.below(pieces - 1);
      for (const kind of ["smooth", "symmetric", "corner"] as const) {
        const outcome = setNodeKind(drawing, curve.handle, new Map([[0, [node]]]), kind, 1e-6);
        const [now] = outcome ? curvesIn(after(drawing, outcome)) : [curve];
        const found = kindOf(now.paths[0], node);
        if (kind === "smooth") expect(["smooth", "symmetric"], `seed ${seed}`).toContain(found);
        else expect(found, `seed ${seed} ${kind}`).toBe(kind);
      }
    }
  });
});

describe("closing", () => {
  test("draws a line where the ends differ, and opening keeps the shape", () => {
    const drawing = openDrawing(
      documentOf('<path d="M0 0L10 0L10 10" sf:left="red @0, gold @2"/>'),
    );
    const [curve] = curvesIn(drawing);
    const closed = after(drawing, setClosed(drawing, curve.handle, [0], true, STEP));
    expect(closed.text).toContain('d="M0 0L10 0L10 10 Z"');
    expect(closed.text).toContain('sf:left="red @0, gold @2"');
    const opened = after(closed, setClosed(closed, curvesIn(closed)[0].handle, [0], false, STEP));
    const [now] = curvesIn(opened);
    expect(now.paths[0].closed).toBe(false);
    expect(now.paths[0].points[9]).toEqual([0, 0]);
    expect(setClosed(drawing, curve.handle, [0], false, STEP)).toBeNull();
  });
});

describe("joining", () => {
  const straight = (d: string, rest: string) => `<path d="${d}" ${rest}/>`;

  test("lays stops behind each other by shares of the length", () => {
    const drawing = openDrawing(
      documentOf(
        straight("M0 0H30", 'sf:left="red, blue" sf:blur="1"'),
        straight("M30 0H40", 'sf:left="gold" sf:blur="1"'),
      ),
    );
    const [a, b] = curvesIn(drawing);
    const outcome = joinCurves(drawing, a.handle, b.handle, STEP);
    const next = after(drawing, outcome);
    expect(curvesIn(next).length).toBe(1);
    expect(next.text).toContain('sf:left="red, blue 75%, gold 75%"');
    expect(next.text).toContain('sf:blur="1"');
    expect(next.itemAt(outcome!.select![0].at)?.kind).toBe("curve");
  });

  test("keeps the picture in every order and direction", () => {
    for (let seed = 0; seed < 30; ++seed) {
      const random = new Random(seed);
      // Halves of a wave; the second one may be reversed, mirrored, or in its own frame.
      const pieces = ["M10 50 C20 40 40 70 60 50", "M60 50 C80 30 90 60 120 50 L150 40"];
      const shapes = pieces.map((d, i) => {
        const segments = i + 1;
        const lists = ["left", "right"].map(
          (side) => `sf:${side}="${listOf(random, segments, () => random.pick(COLORS))}"`,
        );
        const radius = `sf:left-blur="${listOf(random, segments, () => random.between(0, 5).toFixed(2))}"`;
        return straight(
          d,
          [...lists, random.chance(0.5) ? radius : 'sf:blur="2"', 'sf:opacity=".5"'].join(" "),
        );
      });
      let drawing = openDrawing(documentOf(...(random.chance(0.5) ? shapes : shapes.reverse())));
      for (const { handle } of curvesIn(drawing)) {
        const outcome = random.chance(0.5) ? reverseCurves(drawing, [handle], STEP) : null;
        if (outcome) drawing.apply(outcome.patch);
      }
      drawing = openDrawing(drawing.text);
      const [a, b] = curvesIn(drawing);
      const [first, second] = random.chance(0.5) ? [a, b] : [b, a];
      const next = after(drawing, joinCurves(drawing, first.handle, second.handle, STEP));
      const [now] = curvesIn(next);
      expect(pieceCount(now.paths[0])).toBe(3);
      for (const half of [a, b]) {
        const path = half.paths[0];
        for (let k = 1; k < 20; ++k) {
          const at = (k / 20) * pieceCount(path);
          const [point, normal] = [pathPointAt(path, at), leftNormalAt(path, at)!];
          for (const facing of [normal, [-normal[0], -normal[1]] as const]) {
            const isInParameters = /@/.test(drawing.text);
            const [p, q] = [shownAt(half, 0, point, facing), shownAt(now, 0, point, facing)];
            expectNear(
              p,
              q,
              isInParameters ? 5 : 0.03,
              `seed ${seed}, ${at}\n${drawing.text}\n${next.text}`,
            );
          }
        }
      }
    }
  });

  test("brings the second into the first's frame: radii grow, a mirror image changes sides", () => {
    const drawing = openDrawing(
      documentOf(
        straight("M0 0H30", 'sf:left="red" sf:right="blue" sf:blur="1"'),
        straight("M15 0H30", 'transform="scale(2 -2)" sf:left="red" sf:right="blue" sf:blur="1"'),
      ),
    );
    const [a, b] = curvesIn(drawing);
    const { text } = after(drawing, joinCurves(drawing, a.handle, b.handle, STEP));
    expect(text).toContain('sf:left="red, red 50%, blue 50%"');
    expect(text).toContain('sf:right="blue, blue 50%, red 50%"');
    expect(text).toContain('sf:blur="1, 1 50%, 2 50%"');
  });

  test("bridges far ends by a line, closes a curve with itself, and refuses others", () => {
    const drawing = openDrawing(
      documentOf(
        straight("M0 0H30", 'sf:left="red"'),
        straight("M80 0H120", 'sf:left="red"'),
        straight("M0 9H9V20Z", 'sf:left="red"'),
      ).replace("</svg>", '<g sf:diffuse="true"><path d="M0 0H5" sf:left="red"/></g></svg>'),
    );
    const [a, b, loop, elsewhere] = curvesIn(drawing);
    const { text } = after(drawing, joinCurves(drawing, a.handle, b.handle, STEP));
    expect(text).toMatch(/d="M0 0H30 L80 0[ L]120 0" sf:left="red"/);
    expect(after(drawing, joinCurves(drawing, a.handle, a.handle, STEP)).text).toContain("Z");
    expect(joinCurves(drawing, a.handle, loop.handle, STEP)).toBeNull();
    expect(joinCurves(drawing, a.handle, elsewhere.handle, STEP)).toBeNull();
    expect(mapped([1, 0, 0, 1, 0, 0], [1, 2])).toEqual([1, 2]);
  });
});

describe("an end that comes to its curve's other end", () => {
  const lists = 'sf:left="red @0, blue @1.5, gold @3" sf:right="#000 10%, #fff 60%"';
  const opened = (d: string) => {
    const drawing = openDrawing(documentOf(`<path d="${d}" ${lists}/>`));
    return { drawing, curve: curvesIn(drawing)[0] };
  };

  test("closes it, and stops keep their offsets", () => {
    const { drawing, curve } = opened("M3 4L20 0C25 0 30 5 30 10C30 15 20 20 8 9");
    const outcome = closeByEnd(drawing, curve.handle, 0, 3, STEP)!;
    const next = after(drawing, outcome);
    expect(next.text).toMatch(/d="M3 4L20 0C25 0 30 5 30 10C30 15 15 15 3 4 Z"/);
    expect(next.text).toContain(lists);
    const [now] = curvesIn(next);
    expect(now.paths[0].closed).toBe(true);
    expect(outcome.select).toEqual([
      { at: curve.element.range.start, part: { kind: "node", path: 0, index: 0 } },
    ]);
  });

  test("brings its beginning likewise, and a line stays a line", () => {
    const { drawing, curve } = opened("M3 4L20 0L30 10L1 2");
    const next = after(drawing, closeByEnd(drawing, curve.handle, 0, 0, STEP));
    expect(next.text).toMatch(/d="M1 2 ?L20 0L30 10L1 2 ?Z"/);
    expect(next.text).toContain(lists);
  });

  test("closes that subpath alone", () => {
    const { drawing, curve } = opened("M0 0L9 0L9 9M20 20l9 0l0 9m5 5h9");
    const [now] = curvesIn(after(drawing, closeByEnd(drawing, curve.handle, 1, 2, STEP)));
    expect(now.paths.map((path) => path.closed)).toEqual([false, true, false]);
    expect(now.paths[2].points[0]).toEqual([34, 34]);
  });

  test("is none of a closed curve, of one piece, or in the middle", () => {
    const closed = opened("M0 0L9 0L9 9Z");
    expect(closeByEnd(closed.drawing, closed.curve.handle, 0, 0, STEP)).toBeNull();
    const line = opened("M0 0L9 0");
    expect(closeByEnd(line.drawing, line.curve.handle, 0, 1, STEP)).toBeNull();
    const open = opened("M0 0L9 0L9 9");
    expect(closeByEnd(open.drawing, open.curve.handle, 0, 1, STEP)).toBeNull();
    expect(closeByEnd(open.drawing, open.curve.handle, 7, 0, STEP)).toBeNull();
  });
});
