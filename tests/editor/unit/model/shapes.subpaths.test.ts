// Several subpaths of one element edited at once.
import { describe, expect, test } from "vitest";
import { pieceCount, type CubicPath } from "../../../../web/editor/src/geometry/cubic.js";
import { leftNormalAt, pathPointAt } from "../../../../web/editor/src/geometry/length.js";
import { kindOf } from "../../../../web/editor/src/geometry/nodes.js";
import {
  deleteNodes,
  moveNodes,
  setClosed,
  setNodeKind,
} from "../../../../web/editor/src/model/commands/curves/shapes.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { CurveItem } from "../../../../web/editor/src/model/types.js";
import { Random } from "../random.js";
import { after, curvesIn, documentOf, expectNear, shownAt, STEP } from "../support/shapes.js";

const opened = (shape: string) => {
  const drawing = openDrawing(documentOf(shape));
  const [curve] = curvesIn(drawing);
  return { drawing, curve };
};
const all = (curve: CurveItem, nodes: readonly number[]) =>
  new Map(curve.paths.map((_, i) => [i, nodes]));

describe("nodes of several subpaths", () => {
  test("move together, and what stands between them keeps how it is written", () => {
    const { drawing, curve } = opened('<path d="M0 0h10v10M 40,40 l10 0 0 10z m 20 20 h5" sf:left="red"/>');
    const nodes = new Map([
      [0, [2]],
      [2, [0]],
    ]);
    const { text } = after(drawing, moveNodes(drawing, curve.handle, nodes, [1, 2], STEP));
    expect(text).toMatch(/d="M0 0h10l 1,12M 40,40 l10 0 0 10z m 21,22 l 4,-2"/);
    const [now] = curvesIn(openDrawing(text));
    const ends = now.paths.map(({ points }) => [points[0], points.at(-1)]);
    expect(ends).toEqual([
      [[0, 0], [11, 12]],
      [[40, 40], [40, 40]],
      [[61, 62], [65, 60]],
    ]);
  });

  test("move as each of them would alone", () => {
    for (let seed = 0; seed < 40; ++seed) {
      const random = new Random(seed);
      const number = () => Math.round(random.between(-50, 150));
      const subpath = (relative: boolean) => {
        const [m, c, h] = relative ? ["m", "c", "h"] : ["M", "C", "H"];
        const curve = Array.from({ length: 6 }, number).join(" ");
        return `${m}${number()} ${number()}${c}${curve}${h}${number()}${random.below(2) ? "z" : ""}`;
      };
      const d = Array.from({ length: 3 }, () => subpath(random.below(2) === 1)).join(" ");
      const { drawing, curve } = opened(`<path d="${d}" sf:left="red, blue"/>`);
      const nodes = new Map([[0, [random.below(2)]], [2, [1]]]);
      const once = after(drawing, moveNodes(drawing, curve.handle, nodes, [3, 4], STEP));
      let each = drawing;
      for (const [path, of] of nodes) {
        const [now] = curvesIn(each);
        each = after(each, moveNodes(each, now.handle, new Map([[path, of]]), [3, 4], STEP));
      }
      const points = (paths: readonly CubicPath[]) => paths.flatMap((path) => path.points.flat());
      const [a, b] = [once, each].map((one) => points(curvesIn(one)[0].paths));
      expect(a.length, d).toBe(b.length);
      a.forEach((value, k) => expect(Math.abs(value - b[k]), d).toBeLessThan(2 * STEP));
    }
  });

  test("become of a kind together", () => {
    const { drawing, curve } = opened('<path d="M0 0L10 0L10 10M40 40L50 40L50 50" sf:left="red"/>');
    const next = after(drawing, setNodeKind(drawing, curve.handle, all(curve, [1]), "symmetric", STEP));
    expect(curvesIn(next)[0].paths.map((path) => kindOf(path, 1))).toEqual(["symmetric", "symmetric"]);
  });

  test("go together, and subpaths without two nodes with them", () => {
    const { drawing, curve } = opened('<path d="M0 0L10 0L10 10M40 40L50 40M60 60L70 60L70 70L60 70z" sf:left="red"/>');
    const next = after(drawing, deleteNodes(drawing, curve.handle, all(curve, [1]), STEP));
    expect(curvesIn(next)[0].paths.map(({ points }) => [points[0], points.length])).toEqual([
      [[0, 0], 4],
      [[60, 60], 10],
    ]);
    const gone = after(drawing, deleteNodes(drawing, curve.handle, all(curve, [0, 1, 2]), STEP));
    expect(curvesIn(gone)).toEqual([]);
  });

  test("of no subpath that is there change nothing", () => {
    const { drawing, curve } = opened('<path d="M0 0L10 0" sf:left="red"/>');
    expect(moveNodes(drawing, curve.handle, new Map([[4, [0]]]), [1, 1], STEP)).toBeNull();
    expect(deleteNodes(drawing, curve.handle, new Map([[0, []]]), STEP)).toBeNull();
    expect(moveNodes(drawing, curve.handle, new Map(), [1, 1], STEP)).toBeNull();
  });
});

test("subpaths close and open together", () => {
  const { drawing, curve } = opened('<path d="M0 0L10 0L10 10M40 40L50 40L50 50" sf:left="red"/>');
  const closed = after(drawing, setClosed(drawing, curve.handle, [0, 1], true, STEP));
  expect(curvesIn(closed)[0].paths.map((path) => path.closed)).toEqual([true, true]);
  const [now] = curvesIn(closed);
  const opened2 = after(closed, setClosed(closed, now.handle, [0, 1], false, STEP));
  expect(curvesIn(opened2)[0].paths.map((path) => path.closed)).toEqual([false, false]);
});

describe("subpaths that share a list with @ and change at once", () => {
  const straight = "M0 0L10 0L20 0L20 20M40 40L50 40L60 40L60 60";
  const third = "M80 80L90 80L99 80L99 99";
  const lists = 'sf:left="red @0, blue @1, gold @2, white @3" sf:right="#000, #fff"';

  test.each([
    ["all of them", straight],
    ["two of three", straight + third],
  ])("part and keep their picture: %s", (_, d) => {
    const { drawing, curve } = opened(`<path id="p" d="${d}" ${lists}/>`);
    const nodes = new Map([[0, [1]], [1, [1]]]);
    const outcome = deleteNodes(drawing, curve.handle, nodes, STEP)!;
    const next = after(drawing, outcome);
    const curves = curvesIn(next);
    expect(curves.map(({ paths }) => paths.length)).toEqual(curve.paths.map(() => 1));
    expect(new Set(next.text.match(/ id="p[^"]*"/g)).size).toBe(curves.length);
    const edited = curves.filter(({ paths }) => pieceCount(paths[0]) === 2);
    expect(outcome.select!.map(({ at }) => next.itemAt(at))).toEqual(edited);
    curve.paths.forEach((path, i) => {
      const now = curves.find(({ paths }) => paths[0].points[0].join() === path.points[0].join())!;
      for (let k = 1; k < 20; ++k) {
        const at = (k / 20.3) * pieceCount(path);
        const [point, normal] = [pathPointAt(path, at), leftNormalAt(path, at)!];
        const before = shownAt(curve, i, point, normal);
        expectNear(before, shownAt(now, 0, point, normal), 0.02, `${i} ${at}\n${next.text}`);
      }
    });
  });
});
