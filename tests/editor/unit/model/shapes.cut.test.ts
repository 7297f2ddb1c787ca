// Continuing, cutting and simplifying curves, and copying their style: what stays where it was.
import { describe, expect, test } from "vitest";
import { pieceCount, reversedPath } from "../../../../web/editor/src/geometry/cubic.js";
import { leftNormalAt, pathPointAt } from "../../../../web/editor/src/geometry/length.js";
import { farthestFrom, nearestOn } from "../../../../web/editor/src/geometry/nearest.js";
import {
  cutCurve,
  extendCurve,
  simplifyCurve,
  splitPiece,
} from "../../../../web/editor/src/model/commands/curves/shapes.js";
import { pasteStyle, styleOf } from "../../../../web/editor/src/model/commands/style.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { CurveItem } from "../../../../web/editor/src/model/types.js";
import {
  STEP,
  after,
  curvesIn,
  documentOf,
  expectNear,
  expectSamePicture,
  randomCurve,
  shownAt,
} from "../support/shapes.js";

/** Expects that curves have the values of another one along a subpath of it. */
function expectSameValues(before: CurveItem, now: readonly CurveItem[], hint: string): void {
  const [path] = before.paths;
  for (let k = 1; k < 20; ++k) {
    const at = (k / 20.3) * pieceCount(path);
    const normal = leftNormalAt(path, at);
    if (!normal) continue;
    const point = pathPointAt(path, at);
    const near = now.filter(({ paths }) => nearestOn(paths[0], point).distance < 0.05);
    expect(near.length, `${hint}, place ${at}`).toBeGreaterThan(0);
    // Where two parts meet, the point belongs to both.
    if (near.length > 1) continue;
    for (const facing of [normal, [-normal[0], -normal[1]] as const]) {
      const [p, q] = [before, near[0]].map((item) => shownAt(item, 0, point, facing));
      expectNear(p, q, 0.02, `${hint}, place ${at}`);
    }
  }
}

/** Two lines that lead away from a point. */
const away = (x: number, y: number) => {
  const points = [[x, y], [x + 2, y], [x + 4, y], [x + 6, y + 1], [x + 7, y + 3], [x + 7, y + 6], [x + 7, y + 9]];
  return { points: points as unknown as readonly [number, number][], closed: false };
};

describe("continuing", () => {
  test("leaves what was there as it was", () => {
    for (let seed = 0; seed < 60; ++seed) {
      const { drawing, curve, closed, pieces } = randomCurve(seed);
      if (closed) continue;
      for (const end of ["start", "end"] as const) {
        const { points } = curve.paths[0];
        const added = away(...(points[end === "start" ? 0 : points.length - 1] as [number, number]));
        const next = after(drawing, extendCurve(drawing, curve.handle, 0, end, added, STEP));
        const [now] = curvesIn(next);
        expect(pieceCount(now.paths[0])).toBe(pieces + 2);
        expectSameValues(curve, [now], `seed ${seed} ${end}\n${drawing.text}\n${next.text}`);
      }
    }
  });

  test("closes the curve where it ends at the other end", () => {
    const drawing = openDrawing(documentOf('<path d="M0 0L40 0L40 40" sf:left="red, blue"/>'));
    const [curve] = curvesIn(drawing);
    const back = { points: [[40, 40], [25, 30], [10, 20], [0, 0]] as const, closed: false };
    const { text } = after(drawing, extendCurve(drawing, curve.handle, 0, "end", back, STEP));
    expect(text).toMatch(/d="M0 0L40 0L40 40\s?C25 30 10 20 0 0\s?Z"/);
    const forth = reversedPath(back);
    const other = after(drawing, extendCurve(drawing, curve.handle, 0, "start", forth, STEP));
    expect(curvesIn(other)[0].paths[0].closed).toBe(true);
  });

  test("of closed curves and missing subpaths is nothing", () => {
    const drawing = openDrawing(documentOf('<path d="M0 0L40 0L40 40Z" sf:left="red"/>'));
    const [curve] = curvesIn(drawing);
    expect(extendCurve(drawing, curve.handle, 0, "end", away(0, 0), STEP)).toBeNull();
    expect(extendCurve(drawing, curve.handle, 3, "end", away(0, 0), STEP)).toBeNull();
    expect(extendCurve(drawing, 12345, 0, "end", away(0, 0), STEP)).toBeNull();
  });

  test("of one subpath of several leaves the other ones their colours", () => {
    const drawing = openDrawing(
      documentOf('<path id="two" d="M0 0L10 0M0 20L10 20" sf:left="red, blue" sf:right="gold"/>'),
    );
    const [curve] = curvesIn(drawing);
    const next = after(drawing, extendCurve(drawing, curve.handle, 1, "end", away(10, 20), STEP));
    const items = curvesIn(next);
    expect(items.map(({ paths }) => paths.length)).toEqual([1, 1]);
    expect(next.text).toContain('d="M0 0L10 0" sf:left="red, blue"');
    expect(next.text).toMatch(/id="two-2".*sf:left="red, blue \d+(\.\d+)?%"/);
  });
});

describe("cutting", () => {
  test("leaves the picture as it was", () => {
    for (let seed = 0; seed < 60; ++seed) {
      const { random, drawing, curve, closed, pieces } = randomCurve(seed);
      const nodes = closed ? [random.below(pieces)] : [1 + random.below(pieces - 1)];
      if (random.chance(0.5)) nodes.push(closed ? random.below(pieces) : 1 + random.below(pieces - 1));
      const next = after(drawing, cutCurve(drawing, curve.handle, new Map([[0, nodes]]), STEP));
      const items = curvesIn(next);
      const cuts = new Set(nodes).size;
      expect(items.length).toBe(closed ? cuts : cuts + 1);
      expect(items.every(({ paths }) => !paths[0].closed)).toBe(true);
      expect(items.reduce((sum, { paths }) => sum + pieceCount(paths[0]), 0)).toBe(pieces);
      expectSameValues(curve, items, `seed ${seed} at ${nodes}\n${drawing.text}\n${next.text}`);
      expect(next.text).toContain("<!-- before -->");
    }
  });

  test("selects all parts, and gives them ids of their own", () => {
    const drawing = openDrawing(documentOf('<path id="c" d="M0 0L10 0L20 0L30 0" sf:left="red"/>'));
    const [curve] = curvesIn(drawing);
    const made = cutCurve(drawing, curve.handle, new Map([[0, [1, 2]]]), STEP)!;
    const next = after(drawing, made);
    const names = made.select!.map(({ at }) => next.itemAt(at)?.name);
    expect(names).toEqual(["c", "c-2", "c-3"]);
    expect(curvesIn(next).map(({ element }) => element.attributes.find(({ local }) => local === "d")!.value)).toEqual([
      "M0 0 L10 0",
      "M10 0 L20 0",
      "M20 0 L30 0",
    ]);
  });

  test("keeps a hard step on the side where it was", () => {
    const drawing = openDrawing(documentOf('<path d="M0 0L10 0L20 0" sf:left="red, lime 50%, blue 50%, gold"/>'));
    const [curve] = curvesIn(drawing);
    const { text } = after(drawing, cutCurve(drawing, curve.handle, new Map([[0, [1]]]), STEP));
    expect(text).toContain('sf:left="red, lime"');
    expect(text).toContain('sf:left="blue, gold"');
  });

  test("opens a shape at its node", () => {
    const drawing = openDrawing(documentOf('<circle id="o" cx="50" cy="50" r="20" sf:left="red" sf:right="gold"/>'));
    const [curve] = curvesIn(drawing);
    const next = after(drawing, cutCurve(drawing, curve.handle, new Map([[0, [2]]]), STEP));
    const [now] = curvesIn(next);
    expect(now.paths[0].closed).toBe(false);
    expect(farthestFrom(now.paths[0], curve.paths[0], 6)).toBeLessThan(0.02);
    expect(next.text).not.toContain("<circle");
  });

  test("leaves other subpaths alone", () => {
    const drawing = openDrawing(documentOf('<path id="c" d="M0 0h10h10M0 20h10h10" sf:left="red, blue"/>'));
    const [curve] = curvesIn(drawing);
    const { text } = after(drawing, cutCurve(drawing, curve.handle, new Map([[1, [1]]]), STEP));
    expect(text).toContain('id="c" d="M0 0h10h10" sf:left="red, blue"');
    expect(curvesIn(openDrawing(text)).length).toBe(3);
  });

  test("at ends, at no node and of nothing is nothing", () => {
    const drawing = openDrawing(documentOf('<path d="M0 0L10 0L20 0" sf:left="red"/>'));
    const [curve] = curvesIn(drawing);
    for (const nodes of [new Map(), new Map([[0, []]]), new Map([[0, [0, 2]]]), new Map([[4, [1]]])]) {
      expect(cutCurve(drawing, curve.handle, nodes, STEP)).toBeNull();
    }
    expect(cutCurve(drawing, 12345, new Map([[0, [1]]]), STEP)).toBeNull();
  });
});

describe("simplifying", () => {
  test("takes away nodes that splits added, and keeps the picture", () => {
    for (let seed = 0; seed < 20; ++seed) {
      const { drawing, curve, pieces } = randomCurve(seed);
      let now = drawing;
      for (const t of [0.5, 0.5]) {
        const [item] = curvesIn(now);
        now = after(now, splitPiece(now, item.handle, 0, pieces - 1, t, STEP));
      }
      const [split] = curvesIn(now);
      const next = after(now, simplifyCurve(now, split.handle, 0.05, STEP));
      const [simple] = curvesIn(next);
      // A fit may need one of the added nodes.
      expect(pieceCount(simple.paths[0])).toBeLessThan(pieceCount(split.paths[0]));
      expectSamePicture(curve, simple, `seed ${seed}\n${now.text}\n${next.text}`, 0.2, 0.15);
    }
  });

  test("keeps corners and the last two nodes", () => {
    const zigzag = Array.from({ length: 9 }, (_, i) => `${i * 5} ${i % 2 ? 8 : 0}`).join("L");
    const drawing = openDrawing(documentOf(`<path d="M${zigzag}" sf:left="red"/>`, '<path d="M0 50L0 50.01L0 50.02" sf:left="red"/>'));
    const [corners, tiny] = curvesIn(drawing);
    expect(simplifyCurve(drawing, corners.handle, 0.5, STEP)).toBeNull();
    const next = after(drawing, simplifyCurve(drawing, tiny.handle, 5, STEP));
    expect(pieceCount(curvesIn(next)[1].paths[0])).toBe(1);
    expect(simplifyCurve(drawing, 12345, 1, STEP)).toBeNull();
  });
});

describe("the style of a curve", () => {
  const source = '<path id="a" d="M0 0L10 0L40 0" sf:left="red @0, blue @1" sf:right="gold" sf:blur="4" sf:left-opacity=".5" sf:weight="2"/>';

  test("goes onto another one, whatever that had", () => {
    const drawing = openDrawing(
      documentOf(source, '<path id="b" d="M0 50L40 50" sf:left="url(#x)" sf:right-blur="7" sf:right-opacity="0"/>'),
    );
    const [a, b] = curvesIn(drawing);
    const { text } = after(drawing, pasteStyle(drawing, [b.handle], styleOf(drawing, a.handle)!));
    const [, now] = curvesIn(openDrawing(text));
    expect(now.left.color).toEqual({ kind: "stops", space: "arc", stops: [
      { offset: 0, value: { r: 1, g: 0, b: 0 } },
      { offset: 0.25, value: { r: 0, g: 0, b: 1 } },
    ] });
    expect(text).toMatch(/id="b".*sf:right="gold"/);
    expect(text).toMatch(/id="b".*sf:blur="4"/);
    expect(text).toMatch(/id="b".*sf:left-opacity="\.5"/);
    expect(text).toMatch(/id="b".*sf:weight="2"/);
    expect(text).not.toMatch(/right-blur|right-opacity|url\(#x\)/);
  });

  test("keeps the size of the blur on the artboard", () => {
    const drawing = openDrawing(
      documentOf(source, '<path id="b" transform="scale(2)" d="M0 20L20 20" sf:left="lime"/>'),
    );
    const [a, b] = curvesIn(drawing);
    const { text } = after(drawing, pasteStyle(drawing, [b.handle], styleOf(drawing, a.handle)!));
    expect(text).toMatch(/id="b".*sf:blur="2"/);
  });

  test("leaves out a gradient that the other drawing lacks", () => {
    const from = openDrawing(documentOf('<linearGradient id="g"/>', '<path d="M0 0L9 0" sf:left="url(#g)" sf:right="red"/>'));
    const style = styleOf(from, curvesIn(from)[0].handle)!;
    const to = openDrawing(documentOf('<path d="M0 0L9 0" sf:left="gold" sf:right="gold"/>'));
    const { text } = after(to, pasteStyle(to, [curvesIn(to)[0].handle], style));
    expect(text).not.toContain("sf:left=");
    expect(text).toContain('sf:right="red"');
  });

  test("of a curve without colours leaves a local stroke its colours", () => {
    const text = documentOf('<path id="a" d="M0 0L9 0"/>').replace("</svg>", '<path id="s" d="M0 9L9 9" sf:radius="5" sf:left="red"/></svg>');
    const drawing = openDrawing(text);
    const [a, stroke] = curvesIn(drawing);
    expect(stroke.kind).toBe("stroke");
    expect(pasteStyle(drawing, [stroke.handle], styleOf(drawing, a.handle)!)).toBeNull();
    expect(styleOf(drawing, 12345)).toBeNull();
    expect(pasteStyle(drawing, [], styleOf(drawing, a.handle)!)).toBeNull();
  });
});
