// Splitting, reversing and joining, as the engine draws them.
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { beforeAll, describe, expect, test } from "vitest";
import { mappedPath } from "../../../../web/editor/src/geometry/cubic.js";
import { nearestOn } from "../../../../web/editor/src/geometry/nearest.js";
import {
  joinCurves,
  reverseCurves,
  splitPiece,
} from "../../../../web/editor/src/model/commands/curves/shapes.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { CurveItem, Drawing, Outcome } from "../../../../web/editor/src/model/types.js";

const file = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));
const wasm = process.env.SFUMATO_WASM ?? file("../../../../build-wasm/sfumato.wasm");
const STEP = 0.0001;
/** Points between pixel centres, so that few lie on a curve. */
const GRID = Float64Array.from({ length: 2 * 800 }, (_, i) => {
  const k = i >> 1;
  return i % 2 === 0 ? 2.47 + 5 * (k % 40) : 2.53 + 5 * Math.floor(k / 40);
});

/** Returns exact colours at the points. */
let draw: (text: string) => Float32Array;

const documentOf = (...shapes: string[]) =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 200 100" sf:version="1" sf:interpolation="linear"><g sf:diffuse="true">
${shapes.join("\n")}
</g></svg>`;

// Free ends are far away, because the picture beyond them depends on their chords.
const SHAPES = [
  '<path d="M-900 80C50 10 90 95 120 40S170 60 200 30L1100 30" sf:left="gold @0, #c21 @1.4, #e52 @2, #911 @3" sf:right="#dfe9f2, #0a8 30%, navy" sf:left-blur="0 @0, 12 @1.5, 0 @3" sf:blur="3"/>',
  '<circle cx="60" cy="50" r="30" sf:left="white @0, red @.6, blue @2.2, white @4" sf:right="#123 10%, #8cf 60%"/>',
  '<rect x="30" y="20" width="120" height="60" rx="12" sf:left="gold @0, teal @3.3, gold @8" sf:right="#222 @1, #eee @6" sf:right-opacity=".3 @0, 1 @5" sf:left-opacity="1"/>',
  '<path transform="rotate(10 100 50) scale(1 -1) translate(0 -100)" d="m30,30 h60 q40,0 40,30 t-30,20 z" sf:left="red @0, white @1, blue @4" sf:right="black, gold"/>',
];

/** Returns whether a point is so close to a curve that chords may pass on its other side. */
function isOnCurve(drawing: Drawing, point: readonly [number, number]): boolean {
  return curvesIn(drawing).some((item) =>
    item.paths.some(
      (path) => nearestOn(mappedPath(item.layerFromItem, path), point).distance < 0.5,
    ),
  );
}

/** Returns the largest difference of both pictures away from curves, in code values. */
function difference(before: Drawing, outcome: Outcome | null): number {
  const after = openDrawing(before.text);
  after.apply(outcome!.patch);
  const [a, b] = [draw(before.text), draw(after.text)];
  return a.reduce((most, value, i) => {
    const off = 255 * Math.abs(value - b[i]);
    const point = [GRID[2 * (i >> 2)], GRID[2 * (i >> 2) + 1]] as const;
    return off > most && !isOnCurve(before, point) ? off : most;
  }, 0);
}

const curvesIn = (drawing: Drawing) =>
  [...drawing.all()].filter((item): item is CurveItem => item.kind === "curve");

describe.skipIf(!existsSync(wasm))("the engine's picture stays", () => {
  beforeAll(async () => {
    const { loadSfumato } = await import(file("../../../../web/wasm/sfumato.mjs"));
    const library = await loadSfumato(readFileSync(wasm));
    draw = (text) => {
      const context = library.context();
      const document = context.read(text);
      const field = context.field(document, 0);
      const colors = field.colors(GRID);
      [field, document, context].forEach((handle) => handle.free());
      return colors;
    };
  });

  test.each(SHAPES)("when it is split or reversed: %s", (shape) => {
    const drawing = openDrawing(documentOf(shape));
    const [{ handle }] = curvesIn(drawing);
    for (const outcome of [
      splitPiece(drawing, handle, 0, 1, 0.3, STEP),
      splitPiece(drawing, handle, 0, 2, 0.8, STEP),
      reverseCurves(drawing, [handle], STEP),
    ]) {
      expect(difference(drawing, outcome)).toBeLessThan(1);
    }
  });

  test("when two halves are joined", () => {
    const drawing = openDrawing(
      documentOf(
        '<path d="M20 80C50 10 90 95 120 40" sf:left="gold, #c21 40%, navy" sf:right="#dfe9f2" sf:blur="2, 6"/>',
        '<path d="M190 30C170 30 150 0 120 40" sf:left="#0a8, white 30%, #dfe9f2" sf:right="red, navy" sf:blur="4, 6"/>',
      ),
    );
    const [a, b] = curvesIn(drawing).map(({ handle }) => handle);
    for (const [first, second] of [
      [a, b],
      [b, a],
    ]) {
      expect(difference(drawing, joinCurves(drawing, first, second, STEP))).toBeLessThan(1);
    }
  });
});
