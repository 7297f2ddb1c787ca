// The positions of gradients and textures: read as the engine draws them, and moved by their grips.
import { describe, expect, test } from "vitest";
import { inverted, mapped, type Point } from "../../../../web/editor/src/geometry/affine.js";
import { movePaint } from "../../../../web/editor/src/model/commands/index.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import { gradientOf } from "../../../../web/editor/src/model/gradients.js";
import { gripPlace, paintFrame } from "../../../../web/editor/src/model/paint-frames.js";
import type { CurveItem, Drawing, PaintGrip } from "../../../../web/editor/src/model/types.js";
import { applied, inverse } from "../../../../web/editor/src/source/patch.js";
import { hasModule } from "../wasm.js";
import { painter, type Painter } from "../picture.js";
import { Random } from "../random.js";

const SIZE = 64;
const head = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" xmlns:sf="urn:sfumato:1" viewBox="0 0 ${SIZE} ${SIZE}">`;
/** Returns a curve whose paint covers the whole picture. */
const shape = (transform = "") =>
  `<path id="c" d="M10 12H52V50H10Z" sf:left="url(#p)" sf:right="url(#p)"${transform && ` transform="${transform}"`}/>`;
const documentWith = (paint: string, transform = "") =>
  `${head}<defs>${paint}</defs><g id="l" sf:diffuse="true">${shape(transform)}</g></svg>`;

const stops = '<stop offset="0" stop-color="#103050"/><stop offset="1" stop-color="#f0c0a0"/>';
const linear = (attributes: string) => `<linearGradient id="p" ${attributes}>${stops}</linearGradient>`;
const radial = (attributes: string) => `<radialGradient id="p" ${attributes}>${stops}</radialGradient>`;
const texture = (attributes: string) =>
  `<pattern id="p" ${attributes}><image href="tile.png" width="8" height="8" preserveAspectRatio="none"/></pattern>`;

const curveOf = (d: Drawing) => [...d.all()].find(({ kind }) => kind === "curve") as CurveItem;
const frameIn = (text: string) => {
  const d = openDrawing(text);
  return paintFrame(d, curveOf(d), "left", "color");
};
const gripIn = (text: string, grip: PaintGrip) => {
  const d = openDrawing(text);
  return gripPlace(d, curveOf(d), "left", "color", grip);
};

function moved(text: string, grip: PaintGrip, to: Point, step = 1e-4): string {
  const d = openDrawing(text);
  const outcome = movePaint(d, curveOf(d).handle, "left", "color", grip, to, step);
  if (!outcome) return text;
  const after = applied(text, outcome.patch);
  expect(applied(after, inverse(outcome.patch))).toBe(text);
  return after;
}

function expectNear(a: Point | null, b: Point, digits = 3) {
  expect(a).not.toBeNull();
  expect(a?.[0]).toBeCloseTo(b[0], digits);
  expect(a?.[1]).toBeCloseTo(b[1], digits);
}

/** Returns frames of all kinds, units and transforms. */
function randomPaint(random: Random): string {
  const isInBox = random.chance(0.5);
  const unit = isInBox ? 1 : SIZE;
  const share = (from: number, to: number) => {
    const value = random.between(from, to);
    return random.chance(0.3) ? `${(100 * value).toFixed(2)}%` : (value * unit).toFixed(4);
  };
  const units = isInBox ? (random.chance(0.5) ? 'gradientUnits="objectBoundingBox"' : "") : 'gradientUnits="userSpaceOnUse"';
  const map = random.chance(0.5)
    ? `gradientTransform="rotate(${random.between(-90, 90).toFixed(2)} ${unit / 2} ${unit / 2}) scale(${random.between(0.6, 1.4).toFixed(3)} ${random.between(0.6, 1.4).toFixed(3)})"`
    : "";
  if (random.chance(0.5)) {
    return linear(`${units} ${map} x1="${share(0, 0.3)}" y1="${share(0, 0.4)}" x2="${share(0.6, 1)}" y2="${share(0.3, 1)}"`);
  }
  const focus = random.chance(0.3) ? `fx="${share(0.45, 0.5)}" fy="${share(0.45, 0.5)}"` : "";
  return radial(`${units} ${map} cx="${share(0.4, 0.6)}" cy="${share(0.4, 0.6)}" r="${share(0.4, 0.8)}" ${focus}`);
}

/** Returns the share along a gradient at a point of its frame. */
function shareAt(kind: "linear" | "radial", [x, y]: Point, focus: Point): number {
  if (kind === "linear") return Math.min(1, Math.max(0, x));
  const [fx, fy] = focus;
  const [dx, dy] = [x - fx, y - fy];
  // The circle from the focus through the point meets the unit circle at 1 / share.
  const [a, b, c] = [dx * dx + dy * dy, fx * dx + fy * dy, fx * fx + fy * fy - 1];
  if (a === 0) return 0;
  return Math.min(1, a / (-b + Math.sqrt(b * b - a * c)));
}

/** Compares the engine's picture with the frame, in code values. */
function expectDrawnSo(paint: Painter, text: string) {
  const d = openDrawing(text);
  const frame = paintFrame(d, curveOf(d), "left", "color");
  const gradient = gradientOf(d, "#p");
  if (!frame || !gradient || frame.kind === "texture") throw new Error("no frame");
  const back = inverted(frame.itemFromFrame);
  const fromArtboard = inverted(curveOf(d).artboardFromItem);
  if (!back || !fromArtboard) throw new Error("no way back");
  const pixels = paint.paint(text, SIZE);
  const [from, to] = gradient.stops.map(({ value }) => value);
  for (const [x, y] of [[5, 7], [20, 31], [31, 22], [45, 55], [60, 40]]) {
    const at = mapped(back, mapped(fromArtboard, [x + 0.5, y + 0.5]));
    const share = shareAt(frame.kind, at, frame.focus ?? [0, 0]);
    const pixel = 4 * (y * SIZE + x);
    (["r", "g", "b"] as const).forEach((channel, k) => {
      const wanted = 255 * (from[channel] + (to[channel] - from[channel]) * share);
      expect(Math.abs(pixels[pixel + k] - wanted), `${channel} at ${x},${y} of ${text}`).toBeLessThan(2.5);
    });
  }
}

describe.skipIf(!hasModule)("frames are where the engine draws", () => {
  test("gradients of all units and transforms, before and after a grip is moved", async () => {
    const paint = (await painter()) as Painter;
    const random = new Random(15);
    const grips: readonly PaintGrip[] = ["start", "end", "across", "focus"];
    for (let k = 0; k < 60; k += 1) {
      const transform = random.chance(0.3) ? "translate(3 -2) scale(1.1 .9)" : "";
      const text = documentWith(randomPaint(random), transform);
      expectDrawnSo(paint, text);
      const to: Point = [random.between(15, 50), random.between(15, 50)];
      expectDrawnSo(paint, moved(text, random.pick(grips), to));
    }
  });
});

describe("a line", () => {
  const text = documentWith(linear('gradientUnits="userSpaceOnUse" x1="10" y1="12" x2="52" y2="12"'));

  test("has its end where it is taken to; one attribute changes", () => {
    const after = moved(text, "end", [40, 12]);
    expect(after).toBe(text.replace('x2="52"', 'x2="40"'));
    expectNear(gripIn(after, "start"), [10, 12]);
  });

  test("of a box's units stays in them", () => {
    const after = moved(documentWith(linear("")), "start", [31, 31]);
    expect(after).toContain('x1="0.5"');
    expect(after).toContain('y1="0.5"');
    expectNear(gripIn(after, "end"), [52, 12]);
  });

  test("that inherits its place says its own where it is moved", () => {
    const both = `<linearGradient id="q" gradientUnits="userSpaceOnUse" x1="1" y1="2" x2="30" y2="2">${stops}</linearGradient><linearGradient id="p" href="#q"/>`;
    const after = moved(documentWith(both), "start", [5, 2]);
    expect(after).toContain('<linearGradient id="p" href="#q" x1="5"/>');
    expect(after).toContain('x1="1" y1="2"');
  });

  test("under a transform that turns it comes to where it is taken", () => {
    const turned = documentWith(linear('gradientTransform="rotate(30)"'));
    expectNear(gripIn(moved(turned, "end", [33, 44]), "end"), [33, 44], 2);
  });

  test("of a curve without a box, or of no length, has no grips", () => {
    const flat = documentWith(linear("")).replace("M10 12H52V50H10Z", "M10 12H52");
    expect(frameIn(flat)).toBeNull();
    expect(frameIn(documentWith(linear('x1="1" x2="1"')))).toBeNull();
    expect(moved(flat, "start", [1, 1])).toBe(flat);
  });

  test("is not made a point", () => {
    expect(moved(text, "end", [10, 12])).toBe(text);
  });
});

describe("a circle", () => {
  const circle = 'gradientUnits="userSpaceOnUse" cx="30" cy="30" r="10"';
  const text = documentWith(radial(circle));

  test("changes its middle and its radius in its own attributes", () => {
    expect(moved(text, "start", [32, 28])).toBe(text.replace('cx="30" cy="30"', 'cx="32" cy="28"'));
    expect(moved(text, "end", [30, 45])).toBe(text.replace('r="10"', 'r="15"'));
  });

  test("is an ellipse by its transform, and is turned by it then", () => {
    const ellipse = moved(text, "across", [30, 50]);
    expect(ellipse).toContain("gradientTransform=");
    expectNear(gripIn(ellipse, "across"), [30, 50]);
    expectNear(gripIn(ellipse, "end"), [40, 30]);
    const turned = moved(ellipse, "end", [30, 40]);
    expectNear(gripIn(turned, "end"), [30, 40]);
    expectNear(gripIn(turned, "across"), [10, 30]);
  });

  test("has a focus that stays within it, and goes with its middle", () => {
    const focused = moved(text, "focus", [33, 30]);
    expect(focused).toContain('fx="33"');
    expectNear(gripIn(moved(text, "focus", [90, 30]), "focus"), [39.9, 30]);
    expectNear(gripIn(moved(focused, "start", [20, 20]), "focus"), [23, 20]);
  });

  test("has its focus where the engine draws it, also beyond it", () => {
    const beyond = gripIn(documentWith(radial(`${circle} fx="60" fy="30"`)), "focus");
    expectNear(beyond, [60, 30]);
  });

  test("is never made so small that it is gone", () => {
    expect(frameIn(moved(text, "end", [30, 30]))).not.toBeNull();
    expect(frameIn(moved(text, "across", [30, 10]))).not.toBeNull();
  });
});

describe("a texture", () => {
  const tile = 'patternUnits="userSpaceOnUse" width="8" height="8"';
  const text = documentWith(texture(tile));

  test("is moved, scaled in proportion and turned, and stretched by its transform", () => {
    const away = moved(text, "start", [20, 10]);
    expect(away).toContain('patternTransform="translate(20 10)"');
    const turned = moved(away, "end", [20, 26]);
    expectNear(gripIn(turned, "end"), [20, 26]);
    expectNear(gripIn(turned, "across"), [4, 10]);
    const stretched = moved(turned, "across", [12, 10]);
    expectNear(gripIn(stretched, "across"), [12, 10]);
    expectNear(gripIn(stretched, "end"), [20, 26]);
  });

  test("that inherits a transform says its own, also where it does nothing", () => {
    const both = `<pattern id="q" ${tile} patternTransform="translate(30 0)"><image href="t.png" width="8" height="8"/></pattern><pattern id="p" href="#q" patternTransform="translate(10 0)"/>`;
    expectNear(gripIn(moved(documentWith(both), "start", [0, 0]), "start"), [0, 0]);
  });

  test("of a box's units has the box's tile", () => {
    const after = moved(documentWith(texture('width=".5" height=".25"')), "start", [12, 13]);
    expectNear(gripIn(after, "start"), [12, 13]);
    expectNear(gripIn(after, "end"), [33, 13]);
    expectNear(gripIn(after, "across"), [12, 22.5]);
  });

  test("without a tile has no grips", () => {
    expect(frameIn(documentWith(texture('width="0" height="8"')))).toBeNull();
  });
});

test("grips come to where they are taken, whatever the paint", () => {
  const random = new Random(4);
  for (let k = 0; k < 300; k += 1) {
    const text = documentWith(randomPaint(random));
    const kind = frameIn(text)?.kind;
    const to: Point = [random.between(11, 51), random.between(13, 49)];
    expectNear(gripIn(moved(text, "start", to, 1e-6), "start"), to, 2);
    // Circles keep to their axis; other shapes follow the grip.
    if (kind === "linear") expectNear(gripIn(moved(text, "end", to, 1e-6), "end"), to, 2);
  }
});

test("what is no paint, or none that can be read, has no grips", () => {
  for (const paint of ['<g id="p"/>', "", linear('x1="a"'), linear('gradientTransform="turn(3)"'), radial('r="0"')]) {
    expect(frameIn(documentWith(paint))).toBeNull();
  }
});
