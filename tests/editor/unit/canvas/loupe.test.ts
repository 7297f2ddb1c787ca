import { beforeEach, describe, expect, test, vi } from "vitest";
import type { Canvas } from "../../../../web/editor/src/canvas/canvas.js";
import { cut, loupeOf, LOUPE_PIXELS, REACH } from "../../../../web/editor/src/canvas/loupe.js";
import { loupePlace } from "../../../../web/editor/src/canvas/loupe-view.js";
import type { PlacedPhoto } from "../../../../web/editor/src/canvas/photo.js";
import { curve, layer, line } from "../support/drawing.js";
import { canvasOf, fakeEditor } from "../support/editor.js";

vi.mock(
  "../../../../web/editor/src/model/commands/index.js",
  async () => (await import("../support/drawing.js")).fakeCommands,
);

/** Returns 40 by 30 pixels, each 10 artboard units wide: red above row 10, blue below. */
function photo(): PlacedPhoto {
  const [width, height] = [40, 30];
  const data = new Uint8ClampedArray(4 * width * height);
  for (let k = 0; k < width * height; k += 1)
    data.set(k < 10 * width ? [255, 0, 0, 255] : [0, 0, 255, 255], 4 * k);
  return { width, height, data, artboardFromPixel: [10, 0, 0, 10, 0, 0] };
}

let canvas: Canvas;

beforeEach(() => {
  canvas = canvasOf(fakeEditor([layer("layer", [curve("a", [line([100, 100], [200, 100])])])]));
});

const wish = (at: readonly [number, number], more = {}) => ({
  at,
  kind: "mouse" as const,
  photo: photo(),
  hit: null,
  old: null,
  ...more,
});

describe("the loupe", () => {
  test("tells the colour under the pointer, new above old", () => {
    const loupe = loupeOf(canvas, wish([55, 55], { old: { r: 0, g: 1, b: 0 } }))!;
    expect(loupe.text).toBe("#ff0000");
    expect(loupe.ring.map((color) => color && Math.round(color.r))).toEqual([1, 0]);
    expect(loupe.pixels).toHaveLength(4 * LOUPE_PIXELS ** 2);
  });

  test("tells both sides of a curve, and where they are taken", () => {
    const hit = canvas.curveAt([150, 100], "mouse");
    const loupe = loupeOf(canvas, wish([150, 100], { hit }))!;
    expect(loupe.text).toBe("Left #ff0000 · Right #0000ff");
    // The curve runs to the right, so its left is above.
    expect(loupe.turn).toBeCloseTo(0);
    expect(loupe.spots.map(([, y]) => y)).toEqual([-3, 3]);
  });

  test("where the photo is clear it shows the picture, which is what is taken there", () => {
    const clear = { ...photo(), data: new Uint8ClampedArray(4 * 40 * 30) };
    const green = Uint8ClampedArray.from({ length: 4 * LOUPE_PIXELS ** 2 }, (_, k) => (k % 4 === 1 || k % 4 === 3 ? 255 : 0));
    const still = { getContext: () => ({ getImageData: () => ({ data: green }) }) } as unknown as OffscreenCanvas;
    const loupe = loupeOf(canvas, wish([55, 55], { photo: clear, still }))!;
    expect(loupe.text).toBe("#00ff00");
    expect(loupe.pixels).toBe(green);
    expect(loupeOf(canvas, wish([55, 55], { still }))!.text).toBe("#ff0000");
  });

  test("of a curve it shows the photo that is traced, clear where it has nothing", () => {
    const hit = canvas.curveAt([150, 100], "mouse");
    const clear = { ...photo(), data: new Uint8ClampedArray(4 * 40 * 30) };
    const loupe = loupeOf(canvas, wish([150, 100], { hit, photo: clear }))!;
    expect(loupe.text).toBe("Left transparent · Right transparent");
    expect(loupe.pixels.every((value) => value === 0)).toBe(true);
  });

  test("of a place with neither photo nor picture is none", () => {
    expect(loupeOf(canvas, wish([50, 50], { photo: null }))).toBeNull();
  });
});

test("beside the photo its pixels are clear", () => {
  const pixels = cut(photo(), [0, 0]);
  const alpha = (x: number, y: number) => pixels[4 * (y * LOUPE_PIXELS + x) + 3];
  expect([alpha(REACH, REACH), alpha(REACH - 1, REACH), alpha(REACH, REACH - 1)]).toEqual([255, 0, 0]);
  expect(cut(photo(), [500, 500]).every((value) => value === 0)).toBe(true);
});

test("it stands above a finger, and within the stage", () => {
  const stage = { width: 400, height: 300 };
  expect(loupePlace({ at: [200, 250], kind: "touch" }, stage)[1]).toBeLessThan(150);
  expect(loupePlace({ at: [200, 20], kind: "touch" }, stage)[1]).toBeGreaterThan(100);
  for (const kind of ["mouse", "pen", "touch"] as const) {
    for (const at of [[0, 0], [400, 0], [0, 300], [400, 300], [200, 150]] as const) {
      const [x, y] = loupePlace({ at, kind }, stage);
      expect(x).toBeGreaterThanOrEqual(60);
      expect(x).toBeLessThanOrEqual(340);
      expect(y).toBeGreaterThanOrEqual(60);
      expect(y).toBeLessThanOrEqual(240);
    }
  }
});
