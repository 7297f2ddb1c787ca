// Traces of photos with known colours and edges.
import { describe, expect, test } from "vitest";
import { deltaE, type Rgb } from "../../../../web/editor/src/geometry/color.js";
import { Crossings, doCross } from "../../../../web/editor/src/geometry/crossings.js";
import { lineBetween, type CubicPath } from "../../../../web/editor/src/geometry/cubic.js";
import { edgeMap, magnet } from "../../../../web/editor/src/geometry/magnet.js";
import { readPath } from "../../../../web/editor/src/geometry/path.js";
import { colorAt, type Photo } from "../../../../web/editor/src/geometry/photo.js";
import { tracePhoto, type TraceOptions } from "../../../../web/editor/src/geometry/trace.js";
import { distance } from "../../../../web/editor/src/geometry/vector.js";
import { Random } from "../random.js";

type Color = readonly [number, number, number];

/** Returns a photo from a function of the pixels' centres, bytes, with noise of a size. */
function photoOf(
  width: number,
  height: number,
  color: (x: number, y: number) => Color,
  noise = 0,
): Photo {
  const random = new Random(99);
  const data = new Uint8ClampedArray(4 * width * height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const at = 4 * (y * width + x);
      color(x + 0.5, y + 0.5).forEach(
        (value, k) => (data[at + k] = value + random.between(-noise, noise)),
      );
      data[at + 3] = 255;
    }
  }
  return { width, height, data };
}

const RED: Color = [200, 30, 40];
const BLUE: Color = [30, 60, 180];
const mix = (a: Color, b: Color, t: number): Color =>
  [0, 1, 2].map((k) => a[k] + (b[k] - a[k]) * t) as unknown as Color;
const rgb = ([r, g, b]: Color): Rgb => ({ r: r / 255, g: g / 255, b: b / 255 });
const clamp = (t: number) => Math.min(Math.max(t, 0), 1);

const line = (from: readonly [number, number], to: readonly [number, number]): CubicPath => ({
  points: lineBetween(from, to),
  closed: false,
});

const options = (more: Partial<TraceOptions> = {}): TraceOptions => ({
  photoFromPath: [1, 0, 0, 1, 0, 0],
  spacing: 2,
  distance: 3,
  tolerance: 0.02,
  ...more,
});

describe("a step between two colours", () => {
  const photo = photoOf(100, 100, (x) => (x < 50 ? RED : BLUE));

  test("gives one stop a side, and no blur", () => {
    // Upwards on the screen, so left is left.
    const { left, right, blur } = tracePhoto(photo, line([50, 90], [50, 10]), options());
    expect(left).toEqual([{ offset: 0, value: rgb(RED) }]);
    expect(right).toEqual([{ offset: 0, value: rgb(BLUE) }]);
    expect(blur).toEqual([]);
  });

  test("sides change with the direction, and with a map that mirrors", () => {
    expect(tracePhoto(photo, line([50, 10], [50, 90]), options()).left[0].value).toEqual(rgb(BLUE));
    const mirrored = options({ photoFromPath: [-1, 0, 0, 1, 100, 0] });
    expect(tracePhoto(photo, line([50, 90], [50, 10]), mirrored).left[0].value).toEqual(rgb(BLUE));
    const scaled = options({ photoFromPath: [0.5, 0, 0, 0.5, 0, 0], spacing: 4 });
    expect(tracePhoto(photo, line([100, 180], [100, 20]), scaled).left[0].value).toEqual(rgb(RED));
  });

  test("under noise gives nearly these colours, in few stops", () => {
    const noisy = photoOf(100, 100, (x) => (x < 50 ? RED : BLUE), 6);
    const { left, right, blur } = tracePhoto(noisy, line([50, 95], [50, 5]), options());
    for (const [stops, color] of [
      [left, RED],
      [right, BLUE],
    ] as const) {
      expect(stops.length).toBeLessThan(4);
      for (const { value } of stops) expect(deltaE(value, rgb(color))).toBeLessThan(0.02);
    }
    expect(blur).toEqual([]);
  });

  test("specks are no colours of the side", () => {
    const specks = photoOf(100, 100, (x, y) =>
      Math.abs(y - 40) < 3 && x > 44 && x < 49 ? [255, 255, 255] : x < 50 ? RED : BLUE,
    );
    expect(tracePhoto(specks, line([50, 95], [50, 5]), options()).left).toEqual([
      { offset: 0, value: rgb(RED) },
    ]);
  });
});

describe("colours that change along the curve", () => {
  test("become stops at their arc lengths", () => {
    const photo = photoOf(220, 60, (x, y) => {
      const t = (x - 10) / 200;
      return y < 30 ? mix(RED, BLUE, clamp(t)) : t < 0.5 ? RED : BLUE;
    });
    const { left, right } = tracePhoto(
      photo,
      line([10, 30], [210, 30]),
      options({ tolerance: 0.03 }),
    );
    expect(left.length).toBeLessThan(6);
    expect(left[0].offset).toBe(0);
    expect(left[left.length - 1].offset).toBe(1);
    expect(deltaE(left[0].value, rgb(RED))).toBeLessThan(0.03);
    expect(deltaE(left[left.length - 1].value, rgb(BLUE))).toBeLessThan(0.03);
    // A step: two adjacent stops in the middle.
    const [before, behind] = [
      right.filter((s) => s.offset < 0.5).at(-1)!,
      right.find((s) => s.offset >= 0.5)!,
    ];
    expect(behind.offset - before.offset).toBeLessThan(0.03);
    expect(deltaE(before.value, rgb(RED))).toBeLessThan(0.03);
    expect(deltaE(behind.value, rgb(BLUE))).toBeLessThan(0.03);
  });

  test("never become more than thirty stops", () => {
    const random = new Random(4);
    const bands = Array.from(
      { length: 100 },
      () => [0, 1, 2].map(() => random.below(256)) as unknown as Color,
    );
    const photo = photoOf(600, 40, (x) => bands[Math.floor(x / 6)]);
    const { left } = tracePhoto(photo, line([0, 20], [600, 20]), options({ tolerance: 0.001 }));
    expect(left.length).toBeLessThanOrEqual(30);
    expect(left.length).toBeGreaterThan(10);
  });

  test("around a closed curve inside and outside are told apart", () => {
    const [circle] = readPath("M80 50 A30 30 0 0 1 20 50 A30 30 0 0 1 80 50Z");
    const photo = photoOf(100, 100, (x, y) => (Math.hypot(x - 50, y - 50) < 30 ? RED : BLUE));
    const { left, right } = tracePhoto(photo, circle, options());
    expect(left).toEqual([{ offset: 0, value: rgb(BLUE) }]);
    expect(right).toEqual([{ offset: 0, value: rgb(RED) }]);
  });
});

describe("a ramp", () => {
  /** The engine's transition across a curve. */
  const smoothstep = (t: number) => clamp(t) ** 2 * (3 - 2 * clamp(t));

  test.each([2, 3, 4, 6, 8])("that a blur of %d px makes asks for this blur", (radius) => {
    const photo = photoOf(100, 100, (x) =>
      mix(RED, BLUE, smoothstep((x - 50 + radius) / (2 * radius))),
    );
    const { blur } = tracePhoto(photo, line([50, 90], [50, 10]), options({ distance: 9 }));
    expect(blur.length).toBe(1);
    // OKLab bends the ramp of code values a little.
    expect(Math.abs(blur[0].value - radius) / radius).toBeLessThan(0.15);
    const halved = options({ photoFromPath: [2, 0, 0, 2, 0, 0], spacing: 1 });
    expect(tracePhoto(photo, line([25, 45], [25, 5]), halved).blur[0].value * 2).toBeCloseTo(
      blur[0].value,
      1,
    );
  });

  test.each([2, 4, 6, 8])(
    "that is straight for %d px asks for the blur of the same steepness",
    (width) => {
      const photo = photoOf(100, 100, (x) => mix(RED, BLUE, clamp((x - 50 + width) / (2 * width))));
      const { blur } = tracePhoto(photo, line([50, 90], [50, 10]), options());
      expect(blur[0].value).toBeGreaterThan(width);
      expect(blur[0].value).toBeLessThan(1.5 * width);
    },
  );

  test("that grows along the curve has growing radii", () => {
    const half = (y: number) => 2 + (6 * (95 - y)) / 90;
    const photo = photoOf(
      100,
      100,
      (x, y) => mix(RED, BLUE, clamp((x - 50 + half(y)) / (2 * half(y)))),
      1,
    );
    const { blur } = tracePhoto(photo, line([50, 95], [50, 5]), options());
    expect(blur.length).toBeGreaterThan(1);
    expect(blur.length).toBeLessThan(8);
    expect(blur[0].value).toBeLessThan(4);
    expect(blur[blur.length - 1].value).toBeGreaterThan(7);
  });

  test("of nothing is none", () => {
    const photo = photoOf(50, 50, () => RED);
    expect(tracePhoto(photo, line([25, 45], [25, 5]), options()).blur).toEqual([]);
  });
});

describe("what stands in the way", () => {
  test("of another curve: samples across it are left out", () => {
    // Blue begins behind a curve two pixels to the left, in the upper half.
    const photo = photoOf(100, 100, (x, y) => (y < 50 && x < 48 ? BLUE : RED));
    const path = line([50, 95], [50, 5]);
    const without = tracePhoto(photo, path, options({ distance: 4 }));
    expect(without.left.length).toBeGreaterThan(1);
    const others = [line([48, -5], [48, 51])];
    expect(tracePhoto(photo, path, options({ distance: 4, others })).left).toEqual([
      { offset: 0, value: rgb(RED) },
    ]);
  });

  test("of the photo's edge and its clear pixels: nothing is seen there", () => {
    const photo = photoOf(100, 100, () => RED);
    const { left, right } = tracePhoto(photo, line([1, 90], [1, 10]), options());
    expect(left).toEqual([]);
    expect(right).toEqual([{ offset: 0, value: rgb(RED) }]);
    photo.data.fill(0);
    expect(tracePhoto(photo, line([50, 90], [50, 10]), options())).toEqual({
      left: [],
      right: [],
      blur: [],
    });
    expect(colorAt(photo, [NaN, 3])).toBeNull();
  });

  test("a degenerate path or map gives nothing", () => {
    const photo = photoOf(20, 20, () => RED);
    const nothing = { left: [], right: [], blur: [] };
    expect(tracePhoto(photo, line([5, 5], [5, 5]), options())).toEqual(nothing);
    expect(
      tracePhoto(photo, line([5, 5], [9, 5]), options({ photoFromPath: [1, 0, 2, 0, 0, 0] })),
    ).toEqual(nothing);
    expect(tracePhoto(photo, line([5, 5], [9, 5]), options({ spacing: 0 }))).toEqual(nothing);
  });

  test("crossings in the grid are those of all pairs", () => {
    const random = new Random(8);
    const lines = Array.from({ length: 60 }, () => [random.point(80), random.point(80)] as const);
    const crossings = new Crossings();
    lines.forEach((points) => crossings.add(points));
    crossings.add([
      [-1e7, 500],
      [1e7, 501],
    ]);
    for (let i = 0; i < 400; ++i) {
      const from = random.point(90);
      const to = [from[0] + random.between(-9, 9), from[1] + random.between(-9, 9)] as const;
      expect(crossings.isCrossed(from, to)).toBe(lines.some(([c, d]) => doCross(from, to, c, d)));
    }
    expect(crossings.isCrossed([0, 499], [0, 502])).toBe(true);
  });
});

describe("the magnet", () => {
  const photo = photoOf(120, 100, (x, y) => (Math.hypot(x - 60, y - 50) < 30 ? RED : BLUE), 3);
  const edges = edgeMap(photo);

  test("draws a shaky circle onto the edge", () => {
    const random = new Random(2);
    const points = Array.from({ length: 60 }, (_, i) => {
      const [angle, radius] = [
        (i / 60) * 6,
        30 + 3.5 * Math.sin(i / 4) + random.between(-0.3, 0.3),
      ];
      return [60 + radius * Math.cos(angle), 50 + radius * Math.sin(angle)] as const;
    });
    const drawn = magnet(edges, points);
    const miss = (p: readonly [number, number]) => Math.abs(distance(p, [60, 50]) - 30);
    expect(Math.max(...points.map(miss))).toBeGreaterThan(3);
    expect(Math.max(...drawn.map(miss))).toBeLessThan(1);
    drawn.forEach((p, i) => expect(distance(p, points[i])).toBeLessThanOrEqual(6.001));
  });

  test("leaves points where there is no edge, and odd ones", () => {
    const far = [
      [5, 5],
      [8, 5],
      [11, 5],
    ] as const;
    expect(magnet(edges, far)).toEqual(far);
    expect(magnet(edges, [])).toEqual([]);
    expect(magnet(edges, [[60, 20]])).toEqual([[60, 20]]);
    expect(
      magnet(edges, [
        [NaN, 1],
        [2, 2],
      ]),
    ).toHaveLength(2);
  });
});

describe("a curve with the blur that was found", () => {
  const smoothstep = (t: number) => clamp(t) ** 2 * (3 - 2 * clamp(t));
  const [width, height] = [100, 60];

  /**
   * Returns the root mean square difference in OKLab between the photo and the picture of a vertical curve in the
   * middle.
   */
  function missOf(radius: number, noise: number, blurs: boolean): number {
    const at = (x: number) =>
      mix(RED, BLUE, radius > 0 ? smoothstep(((x - 50) / radius + 1) / 2) : x < 50 ? 0 : 1);
    const photo = photoOf(width, height, (x) => at(x), noise);
    const { left, right, blur } = tracePhoto(photo, line([50, 58], [50, 2]), options({ blurs }));
    const [a, b] = [left[0].value, right[0].value];
    const found = blurs ? (blur[0]?.value ?? 0) : 0;
    let sum = 0;
    for (let x = 38.5; x < 62; x += 1) {
      const t = found > 0 ? smoothstep(((x - 50) / found + 1) / 2) : x < 50 ? 0 : 1;
      const drawn = { r: a.r + (b.r - a.r) * t, g: a.g + (b.g - a.g) * t, b: a.b + (b.b - a.b) * t };
      sum += deltaE(drawn, rgb(at(x))) ** 2;
    }
    return Math.sqrt(sum / 24);
  }

  test.each([0, 1, 2, 3, 4, 6, 8])("of a transition of %d px is nearer to the photo, or as near", (radius) => {
    for (const noise of [0, 4, 8, 24]) {
      const [sharp, soft] = [missOf(radius, noise, false), missOf(radius, noise, true)];
      expect(soft).toBeLessThanOrEqual(sharp + 0.002);
      if (radius >= 3) expect(soft).toBeLessThan((noise < 24 ? 0.2 : 0.75) * sharp);
    }
  });
});
