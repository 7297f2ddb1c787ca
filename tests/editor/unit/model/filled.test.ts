// Filled shapes, shapes of their own, and the words for sides.
import { describe, expect, test } from "vitest";
import { mapped, type Box } from "../../../../web/editor/src/geometry/affine.js";
import { partnerOf, oklchFromRgb } from "../../../../web/editor/src/geometry/color.js";
import {
  boxOfDrag,
  cornersOf,
  outlineOf,
  regularRatio,
  type DrawnShape,
  type ShapeKind,
} from "../../../../web/editor/src/geometry/drawn-shape.js";
import { boundsOf, reversedPath } from "../../../../web/editor/src/geometry/cubic.js";
import { insideSign, signedArea } from "../../../../web/editor/src/geometry/orientation.js";
import { readPath } from "../../../../web/editor/src/geometry/path.js";
import { addShape, closedCurves, shapesOfTheirOwn } from "../../../../web/editor/src/model/commands/index.js";
import { blankText, openDrawing } from "../../../../web/editor/src/model/drawing.js";
import { insideOf, sidesInOrder, sideWord } from "../../../../web/editor/src/model/sides.js";
import type { CurveItem, Drawing } from "../../../../web/editor/src/model/types.js";
import { applied } from "../../../../web/editor/src/source/patch.js";
import { after, handle, named, SAMPLES } from "../drawings.js";

const RED = { r: 1, g: 0, b: 0 };
const BOX: Box = [10, 20, 110, 70];
const shape = (kind: ShapeKind, sides = 6, box = BOX): DrawnShape => ({ kind, sides, box });
const head = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 200 150">';
const svg = (inner: string) => `${head}${inner}</svg>\n`;
const curveOf = (d: Drawing, name: string) => named(d, name) as CurveItem;
const drawn = (d: Drawing) =>
  [...d.all()].filter((item): item is CurveItem => item.kind === "curve").at(-1) as CurveItem;

/** Returns the box of a curve on the artboard. */
function boxOf({ paths, artboardFromItem }: CurveItem): Box {
  const points = paths[0].points.map((point) => mapped(artboardFromItem, point));
  return boundsOf({ points, closed: true });
}

function expectBox(found: Box, wanted: Box, slack = 0.02) {
  found.forEach((value, k) => expect(Math.abs(value - wanted[k])).toBeLessThan(slack));
}

describe("the signed area", () => {
  test("of a rectangle is its area, positive if it runs clockwise on the screen", () => {
    const [path] = readPath("M0 0H4V3H0Z");
    expect(signedArea(path)).toBeCloseTo(12, 12);
    expect(signedArea(reversedPath(path))).toBeCloseTo(-12, 12);
  });

  test("of a circle of arcs is that of the circle", () => {
    const [path] = readPath("M1005 1000A5 5 0 0 1 995 1000A5 5 0 0 1 1005 1000Z");
    expect(signedArea(path) / (25 * Math.PI)).toBeCloseTo(1, 3);
  });

  test("has no sign for open paths, lines, and loops that cancel each other", () => {
    expect(insideSign(readPath("M0 0H4V3"))).toBe(0);
    expect(insideSign(readPath("M0 0L4 3Z"))).toBe(0);
    expect(insideSign(readPath("M0 0L4 4V0L0 4Z"))).toBe(0);
    expect(insideSign([])).toBe(0);
  });

  test("of an outline with a hole has the outline's sign", () => {
    expect(insideSign(readPath("M0 0H9V9H0ZM3 3V6H6V3Z"))).toBe(1);
    expect(insideSign(readPath("M3 3V6H6V3ZM0 0H9V9H0Z"))).toBe(1);
  });
});

describe("words for sides", () => {
  const words = (d: Drawing, name: string) => {
    const item = curveOf(d, name);
    return [sideWord(item, "left"), sideWord(item, "right"), ...sidesInOrder(item)].join(" ");
  };

  test("are inside and outside for closed curves, the inside first", () => {
    const d = openDrawing(
      svg(`<g sf:diffuse="true">
        <path id="clockwise" d="M0 0H9V9H0Z" sf:left="red"/>
        <path id="other" d="M0 0V9H9V0Z" sf:left="red"/>
        <path id="open" d="M0 0V9H9V0" sf:left="red"/>
        <path id="met" d="M0 0H9V9L0 0" sf:left="red"/>
        <circle id="circle" cx="50" cy="50" r="9" sf:left="red"/>
      </g>`),
    );
    expect(words(d, "clockwise")).toBe("outside inside right left");
    expect(words(d, "other")).toBe("inside outside left right");
    expect(words(d, "open")).toBe("left right left right");
    expect(words(d, "met")).toBe("outside inside right left");
    expect(words(d, "circle")).toBe("outside inside right left");
  });

  test("stay when a frame mirrors the curve, as its sides do", () => {
    const d = openDrawing(
      svg(`<g sf:diffuse="true" transform="scale(-1 1)">
        <path id="a" d="M0 0H9V9H0Z" sf:left="red" transform="translate(3) scale(1 -1)"/>
        <path id="b" d="M0 0H9V9H0Z" sf:left="red"/>
      </g>`),
    );
    expect(words(d, "a")).toBe("outside inside right left");
    expect(words(d, "b")).toBe("outside inside right left");
  });
});

describe("a drag's box", () => {
  test("goes from corner to corner in any direction", () => {
    expect(boxOfDrag([5, 5], [1, 9], { ratio: null, isCentred: false })).toEqual([1, 5, 5, 9]);
  });

  test("is a square with the longer side, towards the pointer", () => {
    expect(boxOfDrag([5, 5], [1, 6], { ratio: 1, isCentred: false })).toEqual([1, 5, 5, 9]);
  });

  test("has its middle where the drag began", () => {
    expect(boxOfDrag([5, 5], [7, 4], { ratio: null, isCentred: true })).toEqual([3, 4, 7, 6]);
  });

  test("fits a regular polygon", () => {
    for (const sides of [3, 4, 5, 6, 12]) {
      const ratio = regularRatio({ kind: "polygon", sides });
      const box = boxOfDrag([0, 0], [100, 1], { ratio, isCentred: false });
      const corners = cornersOf({ kind: "polygon", sides, box });
      const [xs, ys] = [0, 1].map((k) => corners.map((corner) => corner[k]));
      expectBox([Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)], box, 1e-9);
      const lengths = corners.map(([x, y], k) => {
        const [u, v] = corners[(k + 1) % sides];
        return Math.hypot(u - x, v - y);
      });
      expect(Math.max(...lengths) - Math.min(...lengths)).toBeLessThan(1e-9);
    }
  });
});

describe("a new shape", () => {
  test("goes into an empty layer, and nothing else changes", () => {
    const text = blankText(200, 150, null);
    expect(after(text, (d) => addShape(d, handle(d, "layer-1"), shape("rectangle"), RED, 0.01))).toBe(
      text.replace(
        '"true">\n',
        '"true">\n    <rect x="10" y="20" width="100" height="50" sf:right="#f00" sf:left-opacity="0" ' +
          'sf:right-opacity="1" fill="none" stroke="#f00" stroke-width="0.39"/>\n',
      ),
    );
  });

  test("covers what is below: it gets a new layer above a layer that has curves", () => {
    const text = svg('\n  <g id="l" sf:diffuse="true">\n    <path d="M0 0L9 9" sf:left="red"/>\n  </g>\n  <g id="m" sf:diffuse="true"/>\n');
    const now = after(text, (d) => addShape(d, handle(d, "l"), shape("ellipse"), RED, 0.01));
    expect(now).toContain('</g>\n  <g sf:diffuse="true">\n    <ellipse cx="60" cy="45" rx="50" ry="25" ');
    expect(now.indexOf("<ellipse")).toBeLessThan(now.indexOf('id="m"'));
    expect(now.replace(/\n {2}<g sf:diffuse="true">\n[^\n]*<ellipse[^\n]*\n {2}<\/g>/, "")).toBe(text);
  });

  test("is selected", () => {
    const d = openDrawing(blankText(200, 150, null));
    const made = addShape(d, handle(d, "layer-1"), shape("polygon", 5), RED, 0.01);
    d.apply(made?.patch ?? []);
    expect(made?.select?.map(({ at }) => d.itemAt(at))).toEqual([drawn(d)]);
  });

  test.each(["rectangle", "ellipse", "polygon"] as const)("%s lies where it was drawn in every frame", (kind) => {
    for (const transform of ["translate(5 -3)", "scale(2 -.5)", "scale(-1)", "rotate(30)", "matrix(1 .2 .7 -1 3 4)"]) {
      const text = svg(`<g transform="${transform}"><g id="l" sf:diffuse="true" transform="translate(9)"/></g>`);
      const d = openDrawing(text);
      d.apply(addShape(d, handle(d, "l"), shape(kind), RED, 0.001)?.patch ?? []);
      const item = drawn(d);
      expect(item.parent?.name).toBe("l");
      expectBox(boxOf(item), BOX);
      const inside = insideOf(item)!;
      expect(item[inside].color).toMatchObject({ kind: "stops", stops: [{ offset: 0, value: RED }] });
      expect(item[inside].opacity).toMatchObject({ stops: [{ value: 1 }] });
      expect(item[inside === "left" ? "right" : "left"]).toMatchObject({ color: { kind: "open" }, opacity: { stops: [{ value: 0 }] } });
    }
  });

  test("avoids a hidden and a locked layer, and what is around them", () => {
    const off = ['display="none"', 'sodipodi:insensitive="true" xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"'];
    for (const said of off) {
      const own = openDrawing(svg(`<g id="l" sf:diffuse="true" ${said}/>`));
      own.apply(addShape(own, handle(own, "l"), shape("rectangle"), RED, 0.01)?.patch ?? []);
      expect(own.items.map(({ children }) => children.length)).toEqual([0, 1]);
      const outer = openDrawing(svg(`<g id="g" ${said}><g id="l" sf:diffuse="true"/></g>`));
      outer.apply(addShape(outer, handle(outer, "l"), shape("rectangle"), RED, 0.01)?.patch ?? []);
      expect(outer.items.map(({ kind }) => kind)).toEqual(["group", "layer"]);
    }
  });

  test("without an area is none", () => {
    const d = openDrawing(blankText(200, 150, null));
    for (const kind of ["rectangle", "ellipse", "polygon"] as const) {
      for (const box of [[10, 20, 10, 70], [10, 20, 110, 20], [10, 20, 10.001, 20.001]] as Box[]) {
        expect(addShape(d, handle(d, "layer-1"), shape(kind, 6, box), RED, 0.01)).toBeNull();
      }
    }
  });

  test("without any layer makes one, and declares what it needs", () => {
    const now = after('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 150"/>', (d) =>
      addShape(d, null, shape("rectangle"), RED, 0.01));
    expect(now).toMatch(/xmlns:sf="urn:sfumato:1" sf:version="1">\n {2}<g sf:diffuse="true">\n {4}<rect /);
  });

  test("shows as it will be while it is drawn", () => {
    for (const kind of ["rectangle", "ellipse", "polygon"] as const) {
      const d = openDrawing(blankText(200, 150, null));
      d.apply(addShape(d, handle(d, "layer-1"), shape(kind), RED, 1e-6)?.patch ?? []);
      const [path] = drawn(d).paths;
      path.points.forEach(([x, y], k) => {
        const [u, v] = outlineOf(shape(kind))!.points[k];
        expect(Math.hypot(u - x, v - y)).toBeLessThan(1e-5);
      });
    }
  });
});

describe("a shape of its own", () => {
  const make = (d: Drawing, ...names: string[]) => shapesOfTheirOwn(d, names.map((name) => handle(d, name)), RED);

  test("moves to a layer above, and only its own text changes", () => {
    const text = svg(`
  <g id="l" sf:diffuse="true">
    <path id="a" d="M0 0L9 9" sf:left="red"/>
    <!-- round -->
    <circle id="b" cx="40" cy="40" r="9" sf:left='#123'  sf:right="#fc6, #f00"/>
  </g>
  <g id="top" sf:diffuse="true"/>
`);
    expect(after(text, (d) => make(d, "b"))).toBe(svg(`
  <g id="l" sf:diffuse="true">
    <path id="a" d="M0 0L9 9" sf:left="red"/>
    <!-- round -->
  </g>
  <g sf:diffuse="true">
    <circle id="b" cx="40" cy="40" r="9" sf:left='#123'  sf:right="#fc6, #f00" sf:left-opacity="0" sf:right-opacity="1"/>
  </g>
  <g id="top" sf:diffuse="true"/>
`));
  });

  test("stays where it is alone, and only gets the opacity", () => {
    const text = svg('<g id="l" sf:diffuse="true"><path id="a" d="M0 0V9H9Z" sf:left="red" sf:right="blue"/></g>');
    expect(after(text, (d) => make(d, "a"))).toBe(text.replace("/></g>", ' sf:right-opacity="0" sf:left-opacity="1"/></g>'));
  });

  test("is nothing new where it is one", () => {
    const d = openDrawing(svg('<g sf:diffuse="true"><path id="a" d="M0 0V9H9Z" sf:left="red" sf:right-opacity="0" sf:left-opacity="1"/></g>'));
    expect(make(d, "a")).toBeNull();
  });

  test("gets a colour inside if it has none, and keeps opacities that vary", () => {
    const text = svg('<g sf:diffuse="true"><path id="a" d="M0 0H9V9Z" sf:left="blue" sf:right-opacity="0, 1"/></g>');
    const now = after(text, (d) => make(d, "a"));
    expect(now).toContain('sf:right="#f00"');
    expect(now).toContain('sf:right-opacity="0, 1"');
    expect(now).toContain('sf:left-opacity="0"');
    const half = svg('<g sf:diffuse="true"><path id="a" d="M0 0H9V9Z" sf:right="blue" sf:left-opacity=".5"/></g>');
    expect(after(half, (d) => make(d, "a"))).toContain('sf:right="blue" sf:left-opacity="0" sf:right-opacity="1"');
  });

  test("of several: each gets its own layer, the lowest stays if all of a layer are chosen", () => {
    const curve = (id: string) => `<circle id="${id}" cx="40" cy="40" r="9" sf:right="#fc6"/>`;
    const d = openDrawing(svg(`<g id="l" sf:diffuse="true">${curve("a")}${curve("b")}${curve("c")}</g>`));
    const made = make(d, "c", "a", "b");
    d.apply(made?.patch ?? []);
    expect(d.items.map(({ children }) => children.map(({ name }) => name))).toEqual([["a"], ["b"], ["c"]]);
    expect(made?.select?.map(({ at }) => d.itemAt(at)?.name)).toEqual(expect.arrayContaining(["a", "b", "c"]));
  });

  test("looks the same in every frame, mirrored too", () => {
    const frames = ["translate(5 3)", "scale(2 1)", "scale(-1 1)", "rotate(40) scale(1 -2)"];
    for (const transform of frames) {
      const text = svg(`<g id="l" sf:diffuse="true" transform="${transform}">
        <path id="a" d="M0 0L9 9" sf:left="red"/><path id="b" d="M10 0H29V9Z" sf:left="#00f" sf:right="#0f0" transform="rotate(9)"/></g>`);
      const d = openDrawing(text);
      const before = boxOf(curveOf(d, "b"));
      const inside = curveOf(d, "b")[insideOf(curveOf(d, "b"))!].color;
      d.apply(make(d, "b")?.patch ?? []);
      const now = curveOf(d, "b");
      expect(now.parent?.name).not.toBe("l");
      expectBox(boxOf(now), before, 1e-3);
      const side = insideOf(now)!;
      expect(now[side].color).toEqual(inside);
      expect(now[side].opacity).toMatchObject({ stops: [{ value: 1 }] });
      expect(now[side === "left" ? "right" : "left"].opacity).toMatchObject({ stops: [{ value: 0 }] });
    }
  });

  test("needs a closed curve of a layer", () => {
    const d = openDrawing(SAMPLES[0].text);
    expect(closedCurves(d, [handle(d, "a")])).toEqual([]);
    expect(make(d, "a")).toBeNull();
    expect(make(d, "e")).toBeNull();
    expect(closedCurves(d, [handle(d, "far")]).map(({ name }) => name)).toEqual(["b", "c", "c2"]);
  });

  test("is undone byte for byte in the sample drawings", () => {
    for (const { text } of SAMPLES) {
      const d = openDrawing(text);
      const all = [...d.all()].map((item) => item.handle);
      const patch = shapesOfTheirOwn(d, all, RED)?.patch ?? [];
      const now = applied(text, patch);
      let shift = 0;
      const back = patch.map(({ at, removed, inserted }) => {
        const edit = { at: at + shift, removed: inserted, inserted: removed };
        shift += inserted.length - removed.length;
        return edit;
      });
      expect(applied(now, back)).toBe(text);
      expect(openDrawing(now).text).toBe(now);
    }
  });
});

test("the partner of a colour has its hue and another lightness", () => {
  for (const color of [RED, { r: 0.1, g: 0.2, b: 0.5 }, { r: 0.95, g: 0.9, b: 0.5 }, { r: 0.5, g: 0.5, b: 0.5 }]) {
    const [from, to] = [oklchFromRgb(color), oklchFromRgb(partnerOf(color))];
    expect(Math.abs(from.l - to.l)).toBeGreaterThan(0.2);
    if (from.c > 0.02) expect(Math.abs(from.h - to.h)).toBeLessThan(6);
  }
});
