// Closed curves that take the shape of a region: sides, lists and layers afterwards.
import { describe, expect, test } from "vitest";
import {
  canCombine,
  replaceByRegion,
  shapePaths,
} from "../../../../web/editor/src/model/commands/curves/combine.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import { STEP, after, curvesIn, documentOf } from "../support/shapes.js";

const square = 'd="M0 0L10 0L10 10L0 10Z"';
/** A region, its inside on the right. */
const region = "M0 0L10 0L10 5L0 5Z";

describe("a curve takes the shape of a region", () => {
  test("with its inside on the same side", () => {
    const drawing = openDrawing(
      documentOf(`<path id="right" ${square} sf:right="red"/>`, '<path id="left" d="M0 0L0 10L10 10L10 0Z" sf:left="red"/>'),
    );
    const [right, left] = curvesIn(drawing);
    expect(after(drawing, replaceByRegion(drawing, right.handle, region, [], STEP)).text).toMatch(/id="right" d="M0 0 L10 0 L10 5 L0 5 Z"/);
    expect(after(drawing, replaceByRegion(drawing, left.handle, region, [], STEP)).text).toMatch(/id="left" d="M0 0 L0 5 L10 5 L10 0 Z"/);
  });

  test("in its own coordinates, which may be mirrored", () => {
    const drawing = openDrawing(documentOf(`<path id="m" transform="matrix(-2 0 0 2 20 0)" ${square} sf:right="red"/>`));
    const [curve] = curvesIn(drawing);
    expect(shapePaths(drawing, curve)).toBe("M20 0 L0 0 L0 20 L20 20 Z");
    const { text } = after(drawing, replaceByRegion(drawing, curve.handle, "M0 0L20 0L20 10L0 10Z", [], STEP));
    const [now] = curvesIn(openDrawing(text));
    const xs = now.paths[0].points.map(([x]) => x);
    const ys = now.paths[0].points.map(([, y]) => y);
    expect([Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)]).toEqual([0, 10, 0, 5]);
    expect(text).toContain('sf:right="red"');
  });

  test("with all its contours, and stops by share of the length", () => {
    const drawing = openDrawing(documentOf(`<path id="c" ${square} sf:left="red @0, blue @1, red @4"/>`));
    const [curve] = curvesIn(drawing);
    const { text } = after(drawing, replaceByRegion(drawing, curve.handle, `${region}M2 1L2 2L3 2Z`, [], STEP));
    expect(curvesIn(openDrawing(text))[0].paths.length).toBe(2);
    expect(text).toContain('sf:left="red, blue 25%, red"');
  });

  test("and the other ones go, with layers that would be empty", () => {
    const drawing = openDrawing(
      documentOf(`<rect id="c" width="10" height="10" sf:right="red"/>`).replace(
        "</svg>",
        `<g id="alone" sf:diffuse="true"><path id="d" ${square}/></g><g id="more" sf:diffuse="true"><path id="e" ${square}/><path id="f" ${square}/></g></svg>`,
      ),
    );
    const [c, d, e] = curvesIn(drawing);
    const { text } = after(drawing, replaceByRegion(drawing, c.handle, region, [d.handle, e.handle], STEP));
    expect(text).not.toMatch(/id="(alone|d|e)"/);
    expect(text).toMatch(/id="more"[^]*id="f"/);
    expect(text).toMatch(/<path id="c" d="M0 0 L10 0 L10 5 L0 5 Z"/);
  });

  test("only if it is closed, and there is a region", () => {
    const drawing = openDrawing(documentOf('<path d="M0 0L9 9"/>', '<path d="M0 0L9 9L9 0Z"/>'));
    const [open, closed] = curvesIn(drawing);
    expect([canCombine(open), canCombine(closed)]).toEqual([false, true]);
    expect(replaceByRegion(drawing, closed.handle, "", [open.handle], STEP)).toBeNull();
    expect(replaceByRegion(drawing, 12345, region, [], STEP)).toBeNull();
  });
});
