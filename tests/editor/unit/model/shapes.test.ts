// Edits of curves by their nodes: their changes of the text, and the parts of the picture that stay the same.
import { describe, expect, test } from "vitest";
import {
  pieceCount,
  segmentsOf,
  type CubicPath,
} from "../../../../web/editor/src/geometry/cubic.js";
import { mixed, type Rgb } from "../../../../web/editor/src/geometry/color.js";
import { parameterAtSegment } from "../../../../web/editor/src/geometry/length.js";
import { distance } from "../../../../web/editor/src/geometry/vector.js";
import {
  moveNodes,
  reverseCurves,
  setPath,
  splitPiece,
} from "../../../../web/editor/src/model/commands/curves/shapes.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import {
  STEP,
  documentOf,
  curvesIn,
  after,
  expectSamePicture,
  expectNear,
  randomCurve,
  valueAt,
} from "../support/shapes.js";

describe("splitting", () => {
  test("keeps the picture, and adds one node", () => {
    for (let seed = 0; seed < 30; ++seed) {
      const { random, pieces, drawing, curve } = randomCurve(seed);
      const piece = random.below(pieces);
      const next = after(
        drawing,
        splitPiece(drawing, curve.handle, 0, piece, random.between(0.1, 0.9), STEP),
      );
      const [now] = curvesIn(next);
      expect(pieceCount(now.paths[0])).toBe(pieces + 1);
      expectSamePicture(curve, now, `seed ${seed}\n${drawing.text}\n${next.text}`);
    }
  });

  test("leaves lists by arc length alone, and @ ones follow", () => {
    const drawing = openDrawing(
      documentOf(
        '<path d="M0 0L10 0L10 10" sf:left="red, blue 40%, gold" sf:right="red @0, blue @1.5, gold @2"/>',
      ),
    );
    const [curve] = curvesIn(drawing);
    const { text } = after(drawing, splitPiece(drawing, curve.handle, 0, 0, 0.5, STEP));
    expect(text).toContain('sf:left="red, blue 40%, gold"');
    expect(text).toMatch(/d="M0 0L5 0[ L]10 0L10 10"/);
    expect(text).toMatch(/sf:right="red @0, .* @2, blue @2\.5, gold @3"/);
  });

  test("of nothing is nothing", () => {
    const { drawing, curve } = randomCurve(1);
    for (const [piece, t] of [
      [-1, 0.5],
      [99, 0.5],
      [0, 0],
      [0, 1],
      [0, NaN],
    ]) {
      expect(splitPiece(drawing, curve.handle, 0, piece, t, STEP)).toBeNull();
    }
    expect(splitPiece(drawing, curve.handle, 7, 0, 0.5, STEP)).toBeNull();
    expect(splitPiece(drawing, 12345, 0, 0, 0.5, STEP)).toBeNull();
  });
});

describe("reversing", () => {
  test("keeps the picture", () => {
    for (let seed = 0; seed < 30; ++seed) {
      const { drawing, curve } = randomCurve(seed);
      const next = after(drawing, reverseCurves(drawing, [curve.handle], STEP));
      const [now] = curvesIn(next);
      expect(
        distance(now.paths[0].points[1], curve.paths[0].points[curve.paths[0].points.length - 2]),
      ).toBeLessThan(STEP);
      expectSamePicture(curve, now, `seed ${seed}\n${drawing.text}\n${next.text}`);
    }
  });

  test("twice leads back to the same values", () => {
    for (let seed = 0; seed < 20; ++seed) {
      const { drawing, curve } = randomCurve(seed);
      const once = after(drawing, reverseCurves(drawing, [curve.handle], STEP));
      const twice = after(once, reverseCurves(once, [curvesIn(once)[0].handle], STEP));
      const [now] = curvesIn(twice);
      now.paths[0].points.forEach((p, i) =>
        expect(distance(p, curve.paths[0].points[i])).toBeLessThan(STEP),
      );
      for (const side of ["left", "right"] as const) {
        for (const key of ["color", "opacity", "blur"] as const)
          expectNear(curve[side][key], now[side][key], 1e-5, `seed ${seed}`);
      }
    }
  });

  test("a circle, an arc and subpaths keep their segments", () => {
    const drawing = openDrawing(
      documentOf(
        '<circle cx="50" cy="50" r="20" sf:left="red @0, blue @1, gold @2.5" sf:right="#000"/>',
        '<path d="M0 0A9 7 30 0 1 20 4q3 3 9 1t5 5M50 0h9v4h3z" sf:right="#111, #999" sf:left="#000"/>',
      ),
    );
    const curves = curvesIn(drawing);
    const next = after(
      drawing,
      reverseCurves(
        drawing,
        curves.map((c) => c.handle),
        STEP,
      ),
    );
    curvesIn(next).forEach((now, i) => {
      expectSamePicture(curves[i], now, next.text);
      now.paths.forEach((path, k) =>
        expect(segmentsOf(path).length).toBe(segmentsOf(curves[i].paths[k]).length),
      );
    });
    expect(next.text).toContain("<path d=");
    expect(next.text).not.toContain("circle");
  });
});

describe("shapes that become paths", () => {
  test.each([
    '<circle id="a" cx="50" cy="50" r="20" class="x" sf:left="red @0, blue @1.5, gold @4"/>',
    '<ellipse sf:left="red @0, blue @1.5, gold @4" cx="50%" cy="5mm" rx="20" ry="10"></ellipse>',
    "<rect x='3' y='4' width='50' height='20' rx='5' sf:left='red @0, blue @1.5, gold @7'/>",
    '<rect x="3" y="4" width="50" height="20" sf:left="red @0, blue @1.5, gold @4"/>',
    '<line x1="3" y1="4" x2="50" y2="20" sf:left="red @0, blue @.5"/>',
    '<polyline points="1,2 30,4 50,60" sf:left="red @0, blue @1.5"/>',
    '<polygon points="1,2 30,4 50,60" sf:left="red @0, blue @1.5, gold @3"><title>&lt;kept&gt;</title></polygon>',
  ])("%s keeps its picture and its other attributes when a node is added", (shape) => {
    const drawing = openDrawing(documentOf(shape));
    const [curve] = curvesIn(drawing);
    const next = after(drawing, splitPiece(drawing, curve.handle, 0, 0, 0.25, STEP));
    const [now] = curvesIn(next);
    expect(now.handle).toBe(curve.handle);
    expect(now.isPath).toBe(true);
    expectSamePicture(curve, now, next.text);
    expect(next.text).not.toMatch(/<\/?(circle|ellipse|rect|line|polyline|polygon)\b/);
    expect(next.text).not.toMatch(/ (cx|cy|r|rx|ry|x|y|width|height|points|x1|y2)=/);
    if (shape.includes("title")) expect(next.text).toContain("<title>&lt;kept&gt;</title></path>");
    if (shape.includes("class")) expect(next.text).toContain('<path id="a" d="M70 50');
  });

  test("Inkscape's own words for a shape go, others stay", () => {
    const text = documentOf(
      '<path sodipodi:type="star" sodipodi:nodetypes="ccc" inkscape:label="s" d="M0 0L9 0L9 9" sf:left="red"/>',
    ).replace(
      "<svg ",
      '<svg xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" ',
    );
    const drawing = openDrawing(text);
    const [curve] = curvesIn(drawing);
    const moved = after(drawing, moveNodes(drawing, curve.handle, new Map([[0, [1]]]), [1, 1], STEP));
    expect(moved.text).toContain(
      '<path sodipodi:nodetypes="ccc" inkscape:label="s" d="M0 0L10 1L9 9" sf:left="red"/>',
    );
    const split = after(drawing, splitPiece(drawing, curve.handle, 0, 0, 0.5, STEP));
    expect(split.text).toContain('<path inkscape:label="s" d="M0 0L');
  });
});

describe("moving nodes", () => {
  test("changes d alone, moves handles along, and keeps lines straight", () => {
    const drawing = openDrawing(
      documentOf('<path d="m 0,0 10,0 0,10 c 1,1 2,2 3,3 z" sf:left="red @0, gold @3"/>'),
    );
    const [curve] = curvesIn(drawing);
    const { text } = after(drawing, moveNodes(drawing, curve.handle, new Map([[0, [1]]]), [2, 3], STEP));
    expect(text).toBe(drawing.text.replace("m 0,0 10,0 0,10 c", "m 0,0 12,3 -2,7 c"));
    const first = after(drawing, moveNodes(drawing, curve.handle, new Map([[0, [0]]]), [2, 3], STEP));
    const [now] = curvesIn(first);
    expect(now.paths[0].points[0]).toEqual([2, 3]);
    expect(now.paths[0].closed).toBe(true);
    expect(pieceCount(now.paths[0])).toBe(4);
  });

  test("of an arc's node lets stops on it stay at their places", () => {
    const drawing = openDrawing(
      documentOf(
        '<circle cx="50" cy="50" r="20" sf:left="red @0, blue @1.5, gold @4" sf:right="#000"/>',
      ),
    );
    const [curve] = curvesIn(drawing);
    const next = after(drawing, moveNodes(drawing, curve.handle, new Map([[0, [2]]]), [0.001, 0], 1e-6));
    const [now] = curvesIn(next);
    expect(segmentsOf(now.paths[0]).length).toBe(segmentsOf(curve.paths[0]).length);
    for (const place of [0, 1, 1.5, 1.8, 2, 2.7, 4]) {
      const [before, behind] = [curve, now].map(({ paths, left }) =>
        valueAt(paths[0], left.color, parameterAtSegment(paths[0], place), (a, b, t) => mixed(a, b, t, "srgb")),
      ) as [Rgb, Rgb];
      expect(Math.abs(before.g - behind.g) + Math.abs(before.b - behind.b), `${place}`).toBeLessThan(0.01);
    }
  });

  test("one subpath of several leaves the others' text", () => {
    const drawing = openDrawing(
      documentOf('<path d="M0 0L9 0L9 9M20,20c1,1 2,2 3,9Zm5 5h9" sf:left="red"/>'),
    );
    const [curve] = curvesIn(drawing);
    const { text } = after(drawing, moveNodes(drawing, curve.handle, new Map([[1, [1]]]), [1, 1], STEP));
    expect(text).toContain('d="M0 0L9 0L9 9M20,20c');
    expect(text).toContain('Zm5 5h9"');
  });

  test("that go nowhere changes nothing, nor does a missing subpath", () => {
    const { drawing, curve } = randomCurve(3);
    expect(moveNodes(drawing, curve.handle, new Map([[0, [1]]]), [0, 0], STEP)).toBeNull();
    expect(moveNodes(drawing, curve.handle, new Map([[5, [1]]]), [1, 0], STEP)).toBeNull();
  });
});

describe("setting a path", () => {
  test("writes it, and never one of no length", () => {
    const { drawing, curve } = randomCurve(4);
    const to: CubicPath = {
      points: [
        [0, 0],
        [1, 5],
        [8, 5],
        [9, 0],
      ],
      closed: false,
    };
    const [now] = curvesIn(after(drawing, setPath(drawing, curve.handle, 0, to, STEP)));
    expect(now.paths[0].points).toEqual(to.points);
    const point: CubicPath = {
      points: [
        [3, 3],
        [3, 3],
        [3, 3],
        [3, 3],
      ],
      closed: false,
    };
    expect(setPath(drawing, curve.handle, 0, point, STEP)).toBeNull();
  });
});
