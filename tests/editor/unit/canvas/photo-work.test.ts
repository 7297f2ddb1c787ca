// Drawings that follow a photo: workers fit colours and blur, find curves on its edges, and compare.
import { describe, expect, it, test } from "vitest";
import { fitToPhoto, snapToPhoto } from "../../../../web/editor/src/engine/photo-trace.js";
import type { FitWish, PhotoPixels } from "../../../../web/editor/src/engine/types.js";
import type { Point } from "../../../../web/editor/src/geometry/affine.js";
import { pieceCount, type CubicPath } from "../../../../web/editor/src/geometry/cubic.js";
import { differenceOf, MOST_DIFFERENCE } from "../../../../web/editor/src/geometry/difference.js";
import { snappedPath } from "../../../../web/editor/src/geometry/edge-snap.js";
import { pathPointAt } from "../../../../web/editor/src/geometry/length.js";
import { edgeMap } from "../../../../web/editor/src/geometry/magnet.js";
import { kindOf } from "../../../../web/editor/src/geometry/nodekind.js";
import { readPath } from "../../../../web/editor/src/geometry/path.js";
import { isOpaque, layered } from "../../../../web/editor/src/geometry/photo.js";
import { setFittedBlur, setFittedColors, setPoints } from "../../../../web/editor/src/model/commands/index.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { CurveItem, Drawing } from "../../../../web/editor/src/model/types.js";
import { beginningsOf, fittedRadii, rowsOf } from "../../../../web/editor/src/page/blur-work.js";
import { applied } from "../../../../web/editor/src/source/patch.js";
import { hasModule, localHost } from "../wasm.js";

type Color = readonly number[];

/** Returns a photo from a function of the pixels' centres; RGBA in bytes, opaque for three channels. */
function photoOf(width: number, height: number, color: (x: number, y: number) => Color): PhotoPixels {
  const data = new Uint8ClampedArray(4 * width * height).fill(255);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) data.set(color(x + 0.5, y + 0.5), 4 * (y * width + x));
  }
  return { width, height, data };
}

const RED = [220, 40, 30];
const BLUE = [20, 60, 200];

describe("a difference", () => {
  test("is a number, and a picture that shows small ones larger", () => {
    const photo = photoOf(4, 1, (x) => (x < 2 ? [100, 100, 100] : [100, 100, 100 + MOST_DIFFERENCE]));
    const found = differenceOf(photo, photoOf(4, 1, () => [100, 100, 100]));
    expect(found.psnr).toBeCloseTo(10 * Math.log10((255 * 255 * 12) / (2 * MOST_DIFFERENCE ** 2)), 9);
    const [none, much] = [found.data.slice(0, 4), found.data.slice(12, 16)];
    expect([...none]).toEqual([0, 0, 4, 255]);
    expect(much[0]).toBeGreaterThan(200);
  });

  test("is infinite between equals, and none where there is no photo", () => {
    const photo = photoOf(2, 2, () => RED);
    expect(differenceOf(photo, photo).psnr).toBe(Infinity);
    const clear = photoOf(2, 2, () => [0, 0, 0, 0]);
    const found = differenceOf(clear, photo);
    expect(found.psnr).toBeNull();
    expect(found.data.every((value) => value === 0)).toBe(true);
  });
});

test("a photo lies on what is below it", () => {
  const photo = photoOf(3, 1, (x) => [...RED, x < 1 ? 255 : x < 2 ? 0 : 127.5]);
  expect(isOpaque(photo)).toBe(false);
  const { data } = layered(photo, photoOf(3, 1, () => [...BLUE, 255]));
  expect([...data.slice(0, 8)]).toEqual([...RED, 255, ...BLUE, 255]);
  expect(data[8]).toBeGreaterThan(BLUE[0]);
  expect(data[8]).toBeLessThan(RED[0]);
  expect(isOpaque({ ...photo, data })).toBe(true);
  // Where neither has a colour, the result is white.
  expect([...layered(photoOf(1, 1, () => [0, 0, 0, 0]), photoOf(1, 1, () => [0, 0, 0, 0])).data]).toEqual([255, 255, 255, 255]);
});

/** Returns a circle of four nodes with slightly wrong radius and middle. */
function circle([x, y]: Point, r: number): CubicPath {
  const k = 0.5522847498 * r;
  const d = `M${x + r} ${y}C${x + r} ${y + k} ${x + k} ${y + r} ${x} ${y + r}S${x - r} ${y + k} ${x - r} ${y}S${x - k} ${y - r} ${x} ${y - r}S${x + r} ${y - k} ${x + r} ${y}Z`;
  return readPath(d)[0];
}

const disc = photoOf(120, 120, (x, y) => {
  const inside = Math.min(Math.max(30.5 - Math.hypot(x - 60, y - 60), 0), 1);
  return [0, 1, 2].map((k) => BLUE[k] + inside * (RED[k] - BLUE[k]));
});

const places = (path: CubicPath) => Array.from({ length: 81 }, (_, i) => pathPointAt(path, (i / 80) * pieceCount(path)));
const farFromEdge = (path: CubicPath) => Math.max(...places(path).map(([x, y]) => Math.abs(Math.hypot(x - 60, y - 60) - 30)));

describe("a curve near an edge", () => {
  test("goes to it, and keeps its nodes", () => {
    const before = circle([62, 58.5], 28);
    expect(farFromEdge(before)).toBeGreaterThan(4);
    const after = snappedPath(edgeMap(disc), before, 8)!;
    expect(farFromEdge(after)).toBeLessThan(0.6);
    expect(pieceCount(after)).toBe(4);
    expect(after.closed).toBe(true);
    expect(after.points.at(-1)).toEqual(after.points[0]);
    for (const node of [0, 1, 2, 3]) expect(kindOf(after, node)).not.toBe("corner");
  });

  test("takes along what is farther from the edge than it reaches", () => {
    const round = circle([60, 60], 29);
    const bulge = round.points.map(([x, y]): Point => (x > 60 && y > 60 ? [x + 6, y + 6] : [x, y]));
    const before = { ...round, points: bulge };
    expect(farFromEdge(before)).toBeGreaterThan(5);
    expect(farFromEdge(snappedPath(edgeMap(disc), before, 5)!)).toBeLessThan(0.6);
  });

  test("keeps its corners, and an end beyond the edge where it was", () => {
    const step = photoOf(100, 60, (x) => (x < 50 ? RED : BLUE));
    const [before] = readPath("M46 5L47 30L46 55");
    const after = snappedPath(edgeMap(step), before, 8)!;
    expect(Math.max(...places(after).map(([x]) => Math.abs(x - 50)))).toBeLessThan(0.6);
    expect(kindOf(after, 1)).toBe("corner");
  });

  test("stays where no edge is within reach", () => {
    const edges = edgeMap(disc);
    expect(snappedPath(edges, circle([60, 60], 12), 6)).toBeNull();
    const point: CubicPath = { closed: false, points: [[30, 60], [30, 60], [30, 60], [30, 60]] };
    expect(snappedPath(edges, point, 6)).toBeNull();
    expect(snappedPath(edgeMap(photoOf(1, 1, () => RED)), circle([60, 60], 30), 6)).toBeNull();
  });
});

const drawing = (left: string, right: string, more = "") => `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 64 64" sf:version="1">
  <g sf:diffuse="true">
    <path id="line" d="M32 -20L32 84" sf:left="${left}" sf:right="${right}"${more}/>
    <path id="other" d="M2000 -20L2000 84" sf:left="#123456" sf:right="#123456"/>
  </g>
</svg>
`;
const named = (d: Drawing, name: string) => [...d.all()].find((item) => item.name === name) as CurveItem;
const never = () => new AbortController().signal;

const halves = photoOf(64, 64, (x) => (x < 32 ? RED : BLUE));
const wishFor = (text: string, more: Partial<FitWish> = {}): FitWish => ({
  text,
  photo: halves,
  fits: "colors",
  offsets: [named(openDrawing(text), "line").element.range.start],
  radii: [],
  ...more,
});

const hexOf = (color: Color) => `#${color.map((value) => value.toString(16).padStart(2, "0")).join("")}`;

describe.skipIf(!hasModule)("a drawing in a worker", () => {
  it("takes the colours of a photo, those of chosen curves alone", async () => {
    const host = localHost();
    // The left on the screen is the left of a curve that goes up; for this one it is the right.
    const text = drawing("#888", "#444");
    const [fitted, ...others] = await fitToPhoto(host, wishFor(text), [], never());
    expect(others).toEqual([]);
    expect(host.living).toBe(0);
    const d = openDrawing(text);
    const outcome = setFittedColors(d, named(d, "line"), fitted.colors)!;
    const after = applied(text, outcome.patch);
    const line = named(openDrawing(after), "line");
    for (const [side, color] of [["left", BLUE], ["right", RED]] as const) {
      const value = line[side].color;
      if (value.kind !== "stops") throw new Error("no stops");
      const { r, g, b } = value.stops[0].value;
      [r, g, b].forEach((channel, k) => expect(Math.abs(255 * channel - color[k])).toBeLessThan(6));
    }
    expect(after).toContain('sf:left="#123456" sf:right="#123456"');
    // A second fit changes nothing.
    const [again] = await fitToPhoto(host, wishFor(after), [], never());
    const now = openDrawing(after);
    expect(setFittedColors(now, named(now, "line"), again.colors)).toBeNull();
  });

  it("changes nothing where there is no photo", async () => {
    const text = drawing(hexOf(BLUE), hexOf(RED));
    const clear = photoOf(64, 64, () => [255, 255, 255, 0]);
    const [fitted] = await fitToPhoto(localHost(), wishFor(text, { photo: clear }), [], never());
    const d = openDrawing(text);
    expect(setFittedColors(d, named(d, "line"), fitted.colors)).toBeNull();
  });

  it("takes the blur of a photo, also where it had none", async () => {
    const ramp = (x: number) => Math.min(Math.max((x - 24) / 16, 0), 1);
    const soft = photoOf(64, 64, (x) => [0, 1, 2].map((k) => RED[k] + ramp(x) * (BLUE[k] - RED[k])));
    for (const blur of ["", ' sf:blur="3"']) {
      const text = drawing(hexOf(BLUE), hexOf(RED), blur);
      const d = openDrawing(text);
      const line = named(d, "line");
      const begun = beginningsOf(d, line, { ...soft, artboardFromPixel: [1, 0, 0, 1, 0, 0] })!;
      const wish = wishFor(text, { photo: soft, fits: "blur", radii: rowsOf(line, begun) });
      const [fitted] = await fitToPhoto(localHost(), wish, [], never());
      const outcome = setFittedBlur(d, line, fittedRadii(begun, fitted.factor, 1))!;
      const after = named(openDrawing(applied(text, outcome.patch)), "line");
      const value = after.left.blur;
      if (value.kind !== "stops") throw new Error("no blur");
      // A ramp of 16 pixels in total.
      expect(value.stops[0].value).toBeGreaterThan(7);
      expect(value.stops[0].value).toBeLessThan(13);
      expect(after.right.blur).toEqual(value);
      expect(after.left.color).toEqual(line.left.color);
    }
  });

  it("has its curves moved to a photo's edges", async () => {
    const host = localHost();
    const paths = [circle([62, 58.5], 28), circle([60, 60], 12)];
    const [moved, stays] = await snapToPhoto(host, { photo: disc, paths, reach: 8 }, never());
    expect(farFromEdge(moved!)).toBeLessThan(0.6);
    expect(stays).toBeNull();
    expect(host.living).toBe(0);
  });

  it("is left alone when it is stopped, before and meanwhile", async () => {
    const host = localHost();
    const wish = wishFor(drawing("#888", "#444"));
    await expect(fitToPhoto(host, wish, [], AbortSignal.abort(new Error("over")))).rejects.toThrow("over");
    expect(host.workers).toBe(0);
    const stop = new AbortController();
    setTimeout(() => stop.abort(new Error("enough")));
    await expect(fitToPhoto(host, wish, [], stop.signal)).rejects.toThrow("enough");
    expect(host.living).toBe(0);
  });

  it("that cannot be read is refused in the library's words", async () => {
    const host = localHost();
    await expect(fitToPhoto(host, { ...wishFor(drawing("#888", "#444")), text: "<svg" }, [], never())).rejects.toThrow();
    await expect(fitToPhoto(host, wishFor(drawing("#888", "#444"), { offsets: [] }), [], never())).resolves.toEqual([]);
    expect(host.living).toBe(0);
  });
});

test("a sharp curve on a sharp edge has no blur to begin with, and what is little is none", () => {
  const d = openDrawing(drawing("#00f", "#f00"));
  const line = named(d, "line");
  expect(beginningsOf(d, line, { ...halves, artboardFromPixel: [1, 0, 0, 1, 0, 0] })).toBeNull();
  expect(rowsOf(line, null)).toEqual([]);
  const blurred = named(openDrawing(drawing("#00f", "#f00", ' sf:blur="2"')), "line");
  const radii = { left: blurred.left.blur, right: blurred.right.blur };
  expect(rowsOf(blurred, radii)).toEqual([]);
  expect(fittedRadii(radii, 0.3, 1)).toBeNull();
  expect(fittedRadii(radii, 1.5, 1)?.left).toMatchObject({ stops: [{ value: 3 }] });
  const outcome = setFittedBlur(openDrawing(drawing("#00f", "#f00", ' sf:blur="2"')), blurred, null)!;
  expect(outcome.patch.map(({ removed, inserted }) => removed + inserted).join("")).toContain("sf:blur");
});

test("points of several subpaths change in one patch", () => {
  const text = drawing("#00f", "#f00").replace("M32 -20L32 84", "M10 10L20 20M30 30L40 30");
  const d = openDrawing(text);
  const { handle, paths } = named(d, "line");
  const shifted = paths.map(({ points, closed }): CubicPath => ({ closed, points: points.map(([x, y]) => [x + 1, y]) }));
  const outcome = setPoints(d, handle, new Map(shifted.map((path, i) => [i, path])), 0.01)!;
  expect(applied(text, outcome.patch)).toContain("M11 10L21 20M31 30L41 30");
  const less: CubicPath = { closed: false, points: [[0, 0]] };
  expect(setPoints(d, handle, new Map([[0, less]]), 0.01)).toBeNull();
});
