// Curves: evaluated, split, measured and searched, compared with simple methods.
import { describe, expect, test } from "vitest";
import {
  composed,
  inverted,
  lengthScale,
  mapped,
  mappedBox,
} from "../../../../web/editor/src/geometry/affine.js";
import {
  boundsOf,
  cubicBounds,
  derivativeAt,
  directionAt,
  isLine,
  lineBetween,
  mappedPath,
  pieceCount,
  pointAt,
  reversedPath,
  split,
  subcurve,
  type Cubic,
  type CubicPath,
} from "../../../../web/editor/src/geometry/cubic.js";
import {
  cubicLength,
  fractionAtParameter,
  leftNormalAt,
  offsetOfPlace,
  parameterAtFraction,
  parameterAtSegment,
  pathLength,
  pathPointAt,
  placeOfOffset,
  segmentAtParameter,
} from "../../../../web/editor/src/geometry/length.js";
import { flatten, nearestOn } from "../../../../web/editor/src/geometry/nearest.js";
import { readPath } from "../../../../web/editor/src/geometry/path.js";
import {
  atAngle,
  nearestTarget,
  onGrid,
  weldTarget,
} from "../../../../web/editor/src/geometry/snap.js";
import { simplified, simplifiedGraph } from "../../../../web/editor/src/geometry/simplify.js";
import { distance } from "../../../../web/editor/src/geometry/vector.js";
import { Random } from "../random.js";

const cubicOf = (random: Random, extent = 100): Cubic => [
  random.point(extent),
  random.point(extent),
  random.point(extent),
  random.point(extent),
];

/** Returns a path with cusps, loops, straight pieces and handles on their nodes. */
function pathOf(random: Random, closed = random.chance(0.3)): CubicPath {
  const points = [random.point()] as [number, number][];
  for (let i = 1 + random.below(5); i > 0; --i) {
    const from = points[points.length - 1];
    const to = random.point();
    const kind = random.below(4);
    if (kind === 0) points.push(...(lineBetween(from, to).slice(1) as [number, number][]));
    else points.push(kind === 1 ? from : random.point(), kind === 2 ? to : random.point(), to);
  }
  if (closed) points[points.length - 1] = points[0];
  return { points, closed };
}

describe("maps", () => {
  test("an inverse leads back, and a singular map has none", () => {
    const random = new Random(1);
    for (let i = 0; i < 500; ++i) {
      const map = Array.from({ length: 6 }, () => random.between(-3, 3));
      const back = inverted(map)!;
      const point = random.point();
      expect(distance(mapped(back, mapped(map, point)), point)).toBeLessThan(1e-6);
      const both = composed(map, back);
      [1, 0, 0, 1, 0, 0].forEach((value, k) => expect(both[k]).toBeCloseTo(value, 6));
    }
    expect(inverted([1, 2, 2, 4, 5, 6])).toBeNull();
    expect(inverted([0, 0, 0, 0, 0, 0])).toBeNull();
    expect(inverted([NaN, 0, 0, 1, 0, 0])).toBeNull();
    expect(lengthScale([0, 2, -3, 0, 9, 9])).toBeCloseTo(Math.sqrt(6), 12);
    expect(mappedBox([0, 1, -1, 0, 10, 0], [1, 2, 3, 5])).toEqual([5, 1, 8, 3]);
  });
});

describe("a piece", () => {
  test("split in two keeps its shape to 1e-9", () => {
    const random = new Random(2);
    for (let i = 0; i < 500; ++i) {
      const cubic = cubicOf(random);
      const t = random.next();
      const [first, second] = split(cubic, t);
      for (let k = 0; k <= 20; ++k) {
        const u = k / 20;
        const whole = pointAt(cubic, u);
        const part = u <= t ? pointAt(first, u / t) : pointAt(second, (u - t) / (1 - t));
        expect(distance(whole, part)).toBeLessThan(1e-9);
      }
      expect(subcurve(cubic, 0, t).every((p, k) => distance(p, first[k]) < 1e-9)).toBe(true);
    }
  });

  test("has bounds that its points fill", () => {
    const random = new Random(3);
    for (let i = 0; i < 300; ++i) {
      const cubic = cubicOf(random);
      const box = cubicBounds(cubic);
      const points = Array.from({ length: 2001 }, (_, k) => pointAt(cubic, k / 2000));
      for (const axis of [0, 1] as const) {
        const values = points.map((p) => p[axis]);
        expect(Math.min(...values) - box[axis]).toBeGreaterThanOrEqual(-1e-9);
        expect(Math.min(...values) - box[axis]).toBeLessThan(1e-3);
        expect(box[axis + 2] - Math.max(...values)).toBeGreaterThanOrEqual(-1e-9);
        expect(box[axis + 2] - Math.max(...values)).toBeLessThan(1e-3);
      }
    }
  });

  test("has a direction even where handles lie on nodes, unless it is a point", () => {
    expect(
      directionAt(
        [
          [0, 0],
          [0, 0],
          [3, 0],
          [3, 0],
        ],
        0,
      ),
    ).toEqual([1, 0]);
    expect(
      directionAt(
        [
          [0, 0],
          [0, 0],
          [3, 0],
          [3, 0],
        ],
        1,
      ),
    ).toEqual([1, 0]);
    expect(
      directionAt(
        [
          [5, 5],
          [5, 5],
          [5, 5],
          [5, 5],
        ],
        0.5,
      ),
    ).toBeNull();
    const random = new Random(4);
    for (let i = 0; i < 200; ++i) {
      const cubic = cubicOf(random);
      const t = random.next();
      const [dx, dy] = derivativeAt(cubic, t);
      const direction = directionAt(cubic, t)!;
      expect(dx * direction[1] - dy * direction[0]).toBeCloseTo(0, 6);
    }
  });

  test("is a line only where a line command draws it", () => {
    expect(isLine(lineBetween([1, 2], [30, -4]))).toBe(true);
    expect(
      isLine([
        [0, 0],
        [1, 0],
        [2, 0],
        [3.1, 0],
      ]),
    ).toBe(false);
  });

  test("is as long as its chords", () => {
    const random = new Random(5);
    for (let i = 0; i < 100; ++i) {
      const cubic = cubicOf(random);
      let chords = 0;
      for (let k = 0; k < 4000; ++k)
        chords += distance(pointAt(cubic, k / 4000), pointAt(cubic, (k + 1) / 4000));
      expect(cubicLength(cubic) / chords).toBeCloseTo(1, 5);
    }
  });
});

describe("offsets", () => {
  test("lead to places and back, by arc length", () => {
    const random = new Random(6);
    for (let i = 0; i < 300; ++i) {
      const path = pathOf(random);
      const share = random.next();
      const at = parameterAtFraction(path, share);
      // Near a cusp the engine's quadrature, which this is, is no better.
      expect(fractionAtParameter(path, at)).toBeCloseTo(share, 5);
    }
  });

  test("count arcs once", () => {
    const [path] = readPath("M0 0 A20 20 0 0 1 40 0 L50 0");
    const pieces = pieceCount(path);
    expect(pieces).toBeGreaterThan(4);
    expect(parameterAtSegment(path, 0.5)).toBe((pieces - 1) / 2);
    expect(parameterAtSegment(path, 1.25)).toBe(pieces - 0.75);
    expect(pathPointAt(path, parameterAtSegment(path, 0.5))[1]).toBeCloseTo(-20, 5);
    const random = new Random(8);
    for (let i = 0; i < 200; ++i) {
      const offset = random.between(0, 2);
      expect(segmentAtParameter(path, parameterAtSegment(path, offset))).toBeCloseTo(offset, 12);
      for (const space of ["arc", "parameter"] as const) {
        const share = random.next();
        expect(offsetOfPlace(path, space, placeOfOffset(path, space, share))).toBeCloseTo(share, 7);
      }
    }
    expect([-1, NaN, 2, 99].map((offset) => parameterAtSegment(path, offset))).toEqual([
      0,
      0,
      pieces,
      pieces,
    ]);
  });

  test("a closed clockwise path has its outside on the left", () => {
    const [circle] = readPath("M10 0 A10 10 0 0 1 -10 0 A10 10 0 0 1 10 0Z");
    const normal = leftNormalAt(circle, 0)!;
    expect(normal[0]).toBeCloseTo(1, 6);
    expect(pathLength(circle)).toBeCloseTo(20 * Math.PI, 4);
  });

  test("run backwards on the reversed path", () => {
    const random = new Random(9);
    for (let i = 0; i < 100; ++i) {
      const path = pathOf(random);
      const back = reversedPath(path);
      const share = random.next();
      const [a, b] = [parameterAtFraction(path, share), parameterAtFraction(back, 1 - share)];
      expect(distance(pathPointAt(path, a), pathPointAt(back, b))).toBeLessThan(0.01);
    }
    expect(reversedPath(readPath("M0 0 A5 5 0 0 1 5 5 L9 9")[0]).segments![1]).toBe(1);
  });

  test("bounds of a path move with it", () => {
    const path = pathOf(new Random(10));
    const [x0, y0, x1, y1] = boundsOf(path);
    const moved = boundsOf(mappedPath([2, 0, 0, 2, 5, -7], path));
    [2 * x0 + 5, 2 * y0 - 7, 2 * x1 + 5, 2 * y1 - 7].forEach((value, i) =>
      expect(moved[i]).toBeCloseTo(value, 9),
    );
  });
});

describe("the nearest point", () => {
  test("is as near as the nearest of many points", () => {
    const random = new Random(12);
    for (let i = 0; i < 400; ++i) {
      const path = pathOf(random);
      const point = random.point(150);
      const found = nearestOn(path, point);
      let least = Infinity;
      for (let k = 0; k <= 3000; ++k) {
        least = Math.min(least, distance(pathPointAt(path, (k / 3000) * pieceCount(path)), point));
      }
      expect(found.distance - least, `case ${i}`).toBeLessThan(0.001);
      expect(distance(pathPointAt(path, found.at), found.point)).toBeLessThan(1e-9);
      expect(distance(found.point, point)).toBeCloseTo(found.distance, 9);
    }
  });

  test("of a point on the curve is itself", () => {
    const random = new Random(13);
    for (let i = 0; i < 200; ++i) {
      const path = pathOf(random);
      const point = pathPointAt(path, random.between(0, pieceCount(path)));
      expect(nearestOn(path, point).distance).toBeLessThan(1e-3);
    }
    expect(
      nearestOn(
        {
          points: [
            [3, 3],
            [3, 3],
            [3, 3],
            [3, 3],
          ],
          closed: false,
        },
        [0, -1],
      ).distance,
    ).toBe(5);
  });

  test("chords stay within the tolerance", () => {
    const random = new Random(14);
    for (let i = 0; i < 100; ++i) {
      const path = pathOf(random);
      const { points, places } = flatten(path, 0.05);
      expect(places[places.length - 1]).toBe(pieceCount(path));
      for (let k = 0; k + 1 < points.length; ++k) {
        const middle = pathPointAt(path, (places[k] + places[k + 1]) / 2);
        const chord: CubicPath = { points: lineBetween(points[k], points[k + 1]), closed: false };
        expect(nearestOn(chord, middle).distance).toBeLessThan(0.0501);
      }
    }
  });
});

describe("snapping", () => {
  test("angles are multiples of 15 degrees, and what is near wins", () => {
    const random = new Random(15);
    for (let i = 0; i < 200; ++i) {
      const [from, to] = [random.point(), random.point()];
      const snapped = atAngle(from, to);
      const angle = (Math.atan2(snapped[1] - from[1], snapped[0] - from[0]) * 180) / Math.PI / 15;
      expect(Math.abs(angle - Math.round(angle))).toBeLessThan(1e-6);
      expect(distance(snapped, to)).toBeLessThanOrEqual(
        distance(from, to) * Math.sin((7.5 * Math.PI) / 180) + 1e-9,
      );
    }
    expect(atAngle([1, 1], [1, 1])).toEqual([1, 1]);
    const [a, b] = [{ point: [0, 3] as const }, { point: [4, 0] as const }];
    expect(nearestTarget([0, 0], [b, a], 5)).toBe(a);
    expect(nearestTarget([0, 0], [a, b], 2)).toBeNull();
    expect(onGrid([7.4, -2.6], 5)).toEqual([5, -5]);
  });

  test("an end goes before a nearer point of a curve", () => {
    const [path] = readPath("M0 0H100");
    expect(weldTarget([4, 1], [path], 8)).toEqual({ point: [0, 0], path: 0, at: 0 });
    expect(weldTarget([50, 1], [path], 8)!.point[1]).toBe(0);
    expect(weldTarget([50, 9], [path], 8)).toBeNull();
  });
});

describe("simplification", () => {
  test("keeps every row within the tolerance, and no row that a line tells", () => {
    const random = new Random(16);
    for (let i = 0; i < 100; ++i) {
      const rows = Array.from({ length: 60 }, (_, k) => [
        k,
        Math.sin(k / random.between(3, 9)),
        random.between(0, 0.05),
      ]);
      const tolerance = random.between(0.01, 0.5);
      const kept = simplifiedGraph(rows, tolerance);
      for (let s = 0; s + 1 < kept.length; ++s) {
        const [from, to] = [rows[kept[s]], rows[kept[s + 1]]];
        for (let k = kept[s]; k <= kept[s + 1]; ++k) {
          const share = (k - from[0]) / (to[0] - from[0]);
          const miss = Math.hypot(
            ...[1, 2].map((c) => rows[k][c] - from[c] - share * (to[c] - from[c])),
          );
          expect(miss).toBeLessThanOrEqual(tolerance + 1e-12);
        }
      }
    }
    expect(
      simplified(
        [
          [0, 0],
          [1, 0.001],
          [2, 0],
          [3, 5],
        ],
        0.01,
      ),
    ).toEqual([0, 2, 3]);
    expect(
      simplifiedGraph(
        [
          [0, 1],
          [0, 1],
          [0, 1],
        ],
        0.1,
      ),
    ).toEqual([0, 2]);
    expect(simplified([], 1)).toEqual([]);
    expect(simplified([[1, 2]], 1)).toEqual([0]);
    expect(
      simplified(
        [
          [0, 0],
          [9, 9],
          [0, 0],
        ],
        1,
      ),
    ).toEqual([0, 1, 2]);
  });
});
