// Fits of hand-drawn strokes.
import { describe, expect, test } from "vitest";
import {
  directionAt,
  isLine,
  pieceAt,
  pieceCount,
  type CubicPath,
} from "../../../../web/editor/src/geometry/cubic.js";
import { fitStroke, pressureStops } from "../../../../web/editor/src/geometry/fit.js";
import { pathPointAt } from "../../../../web/editor/src/geometry/length.js";
import type { Sample } from "../../../../web/editor/src/geometry/sample.js";
import { distance, dot } from "../../../../web/editor/src/geometry/vector.js";
import { Random } from "../random.js";

const sample = (x: number, y: number, time = 0, pressure = 0.5): Sample => ({
  point: [x, y],
  time,
  pressure,
});

/** Returns steps of a walk that turns smoothly, and sometimes sharply. */
function strokeOf(random: Random): Sample[] {
  const samples: Sample[] = [];
  let [x, y, angle, bend] = [0, 0, random.between(0, 6), 0];
  for (let i = 0; i < 5 + random.below(200); ++i) {
    bend += random.between(-0.05, 0.05);
    angle += bend + (random.chance(0.02) ? random.between(1, 2.5) : 0);
    const step = random.between(0.2, 4);
    x += step * Math.cos(angle);
    y += step * Math.sin(angle);
    samples.push(sample(x, y, 8 * i, random.next()));
  }
  return samples;
}

const isFinitePath = ({ points }: CubicPath) => points.every((p) => p.every(Number.isFinite));

describe("a fitted stroke", () => {
  test("passes every sample within the tolerance, with its pressure there", () => {
    for (let seed = 0; seed < 300; ++seed) {
      const random = new Random(seed);
      const tolerance = random.between(0.2, 4);
      const closed = random.chance(0.3);
      const fit = fitStroke(strokeOf(random), tolerance, closed)!;
      expect(isFinitePath(fit.path)).toBe(true);
      expect(fit.path.closed).toBe(closed);
      expect(fit.places.length).toBe(fit.samples.length);
      fit.samples.forEach(({ point }, i) => {
        expect(distance(pathPointAt(fit.path, fit.places[i]), point), `seed ${seed}`).toBeLessThan(
          tolerance + 1e-9,
        );
        if (i > 0) expect(fit.places[i]).toBeGreaterThanOrEqual(fit.places[i - 1]);
      });
      expect(fit.places[fit.places.length - 1]).toBe(pieceCount(fit.path));
      if (closed) expect(fit.path.points[fit.path.points.length - 1]).toEqual(fit.path.points[0]);
    }
  });

  test("takes few pieces for a smooth line, and meets smoothly", () => {
    const samples = Array.from({ length: 200 }, (_, i) => sample(i, 30 * Math.sin(i / 25), 8 * i));
    const { path } = fitStroke(samples, 0.5)!;
    expect(pieceCount(path)).toBeLessThan(9);
    for (let i = 1; i < pieceCount(path); ++i) {
      const [into, out] = [
        directionAt(pieceAt(path, i - 1), 1)!,
        directionAt(pieceAt(path, i), 0)!,
      ];
      expect(dot(into, out)).toBeGreaterThan(0.999999);
    }
  });

  test("has a corner where the hand had one", () => {
    const samples = [
      ...Array.from({ length: 30 }, (_, i) => sample(2 * i, 0, 8 * i)),
      ...Array.from({ length: 30 }, (_, i) => sample(60, 2 * i, 240 + 8 * i)),
    ];
    const { path } = fitStroke(samples, 0.5)!;
    expect(pieceCount(path)).toBe(2);
    expect(distance(path.points[3], [60, 0])).toBeLessThan(1e-9);
    expect(path.points.every(([x, y]) => Math.abs(y) < 1e-6 || Math.abs(x - 60) < 1e-6)).toBe(true);
  });

  test("takes a turn of 50 degrees for a corner only where the hand was slow", () => {
    const strokeWith = (pause: number) => {
      const out = Array.from({ length: 30 }, (_, i) => sample(2 * i, 0, 8 * i));
      const turn = (50 * Math.PI) / 180;
      const time = (i: number) => 232 + pause + 8 * i;
      const on = Array.from({ length: 30 }, (_, i) =>
        sample(
          58 + 2 * (i + 1) * Math.cos(turn),
          2 * (i + 1) * Math.sin(turn),
          time(i + 1) + pause,
        ),
      );
      return fitStroke([...out, ...on], 1)!.path;
    };
    const sharp = strokeWith(400);
    const node = Array.from({ length: pieceCount(sharp) - 1 }, (_, i) => i + 1).find(
      (i) => dot(directionAt(pieceAt(sharp, i - 1), 1)!, directionAt(pieceAt(sharp, i), 0)!) < 0.9,
    );
    expect(node).toBeDefined();
    const smooth = strokeWith(0);
    for (let i = 1; i < pieceCount(smooth); ++i) {
      expect(
        dot(directionAt(pieceAt(smooth, i - 1), 1)!, directionAt(pieceAt(smooth, i), 0)!),
      ).toBeGreaterThan(0.999);
    }
  });

  test("closes smoothly where there is no corner", () => {
    const samples = Array.from({ length: 100 }, (_, i) => {
      const angle = (2 * Math.PI * i) / 100;
      return sample(50 * Math.cos(angle), 50 * Math.sin(angle), 8 * i);
    });
    const { path } = fitStroke(samples, 0.3, true)!;
    const [out, into] = [
      directionAt(pieceAt(path, 0), 0)!,
      directionAt(pieceAt(path, pieceCount(path) - 1), 1)!,
    ];
    expect(dot(out, into)).toBeGreaterThan(0.9999);
    expect(pieceCount(path)).toBeLessThan(9);
  });

  test("of hostile samples is none, or finite", () => {
    expect(fitStroke([], 1)).toBeNull();
    expect(fitStroke([sample(1, 1)], 1)).toBeNull();
    expect(fitStroke([sample(1, 1), sample(1, 1), sample(1, 1)], 1, true)).toBeNull();
    expect(fitStroke([sample(NaN, 1), sample(1, 1)], 1)).toBeNull();
    const values = [0, 1, -1, 1e-300, 1e300, -1e300, Infinity, NaN, 1e7, 0.1, 5];
    for (let seed = 0; seed < 1500; ++seed) {
      const random = new Random(seed);
      const samples = Array.from({ length: random.below(9) }, () =>
        sample(random.pick(values), random.pick(values), random.pick(values), random.pick(values)),
      );
      const fit = fitStroke(samples, random.pick([0, 1, NaN, -1, 1e9, 1e-9]), random.chance(0.5));
      if (!fit) continue;
      expect(isFinitePath(fit.path), JSON.stringify(samples)).toBe(true);
      expect(fit.places.every(Number.isFinite)).toBe(true);
      expect(pressureStops(fit, 0.1).flat().every(Number.isFinite)).toBe(true);
    }
  });

  test("of ten thousand samples that jump about ends soon", () => {
    const random = new Random(1);
    const samples = Array.from({ length: 10000 }, (_, i) =>
      sample(random.between(0, 99), random.between(0, 99), i),
    );
    const fit = fitStroke(samples, 0.5)!;
    expect(
      fit.samples.every(
        ({ point }, i) => distance(pathPointAt(fit.path, fit.places[i]), point) < 0.51,
      ),
    ).toBe(true);
  });
});

test("pressure becomes few stops that are near it everywhere", () => {
  const samples = Array.from({ length: 100 }, (_, i) => sample(i, 0, 8 * i, i < 50 ? i / 50 : 1));
  const stops = pressureStops(fitStroke(samples, 0.5)!, 0.03);
  expect(stops.length).toBeLessThan(6);
  expect(stops[0][1]).toBe(0);
  expect(stops[stops.length - 1][1]).toBe(1);
});

/** Returns samples of a trembling hand along a shape of a length, rounded to whole pixels. */
function handAlong(
  shape: (share: number) => readonly [number, number],
  length: number,
  { seed = 1, tremble = 0, spacing = 4, pauses = false } = {},
): Sample[] {
  const random = new Random(seed);
  const count = Math.ceil(length / spacing);
  const off = [0, 0];
  let time = 0;
  return Array.from({ length: count + 1 }, (_, i) => {
    time += pauses && random.chance(0.1) ? 60 : 8;
    const [x, y] = shape(i / count).map((value, axis) => {
      off[axis] = 0.7 * off[axis] + random.between(-tremble, tremble);
      return Math.round(value + off[axis]);
    });
    return sample(x, y, time);
  });
}

const shapes = {
  line: (u: number) => [30 + 400 * u, 50 + 130 * u] as const,
  corner: (u: number) => (u < 0.5 ? ([400 * u, 0] as const) : ([200, 400 * u - 200] as const)),
  square: (u: number) => {
    const [side, way] = [Math.min(Math.floor(4 * u), 3), 800 * u];
    return ([[way, 0], [200, way - 200], [600 - way, 200], [0, 800 - way]] as const)[side];
  },
  circle: (u: number) => [100 * Math.cos(2 * Math.PI * u), 100 * Math.sin(2 * Math.PI * u)] as const,
  long: (u: number) => [2000 * u, 80 * Math.sin(17 * u) + 30 * Math.sin(41 * u)] as const,
};

describe("as few pieces as the tolerance allows", () => {
  test.each([
    ["line", 420, false, 0, 1],
    ["line", 420, false, 0.3, 1],
    ["corner", 400, false, 0, 2],
    ["corner", 400, false, 0.3, 2],
    ["corner", 400, false, 0.6, 2],
    ["square", 800, true, 0, 4],
    ["square", 800, true, 0.6, 4],
    ["circle", 628, true, 0, 3],
    ["circle", 628, true, 0.6, 4],
    ["long", 2600, false, 0, 14],
    ["long", 2600, false, 0.6, 16],
  ] as const)("of a %s %s px long, closed: %s, trembling by %s, are %s", (name, length, closed, tremble, most) => {
    let pieces = 0;
    const seeds = 12;
    for (let seed = 0; seed < seeds; ++seed) {
      const samples = handAlong(shapes[name], length, { seed, tremble, pauses: seed % 2 === 1 });
      const fit = fitStroke(samples, 2, closed)!;
      pieces += pieceCount(fit.path);
      fit.samples.forEach(({ point }, i) =>
        expect(distance(pathPointAt(fit.path, fit.places[i]), point)).toBeLessThan(2 + 1e-9),
      );
    }
    expect(pieces / seeds).toBeLessThan(most + 0.5);
  });

  test("a straight run is a line, however slow the hand was", () => {
    for (const spacing of [1, 2, 8]) {
      const samples = handAlong(shapes.line, 420, { spacing, tremble: 0.2, pauses: true });
      const { path } = fitStroke(samples, 2)!;
      expect(pieceCount(path)).toBe(1);
      expect(isLine(pieceAt(path, 0))).toBe(true);
    }
  });

  test("a straight run between bends has a node at each of its ends at most", () => {
    const arc = (u: number, from: number) =>
      [60 * Math.sin(u * 1.5) + from, 60 * (1 - Math.cos(u * 1.5))] as const;
    const [endX, endY] = arc(1, 0);
    const way = [Math.cos(1.5), Math.sin(1.5)];
    const shape = (u: number) =>
      u < 0.3 ? arc(u / 0.3, 0) : ([endX + way[0] * 210 * (u - 0.3) / 0.7, endY + way[1] * 210 * (u - 0.3) / 0.7] as const);
    const { path } = fitStroke(handAlong(shape, 300, { tremble: 0.3 }), 2)!;
    expect(pieceCount(path)).toBeLessThanOrEqual(3);
  });
});
