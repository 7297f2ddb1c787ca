// Edits of curves by their nodes: what they change in the text, and what the picture keeps.
import { describe, expect, test } from "vitest";
import { mapped } from "../../../web/editor/src/geometry/affine.js";
import { mixed, type Rgb } from "../../../web/editor/src/geometry/color.js";
import { pieceCount, segmentsOf, type CubicPath } from "../../../web/editor/src/geometry/cubic.js";
import {
  fractionAtParameter,
  leftNormalAt,
  pathPointAt,
  placeOfOffset,
} from "../../../web/editor/src/geometry/length.js";
import { farthestFrom, nearestOn } from "../../../web/editor/src/geometry/nearest.js";
import { distance } from "../../../web/editor/src/geometry/vector.js";
import {
  deleteNodes,
  joinCurves,
  moveNodes,
  reverseCurves,
  setClosed,
  setNodeKind,
  setPath,
  splitPiece,
} from "../../../web/editor/src/model/commands/shapes.js";
import { kindOf } from "../../../web/editor/src/geometry/nodes.js";
import { openDrawing } from "../../../web/editor/src/model/drawing.js";
import type {
  CurveItem,
  Drawing,
  Outcome,
  Side,
  SideValue,
} from "../../../web/editor/src/model/types.js";
import { Random } from "./random.js";

const STEP = 0.001;

const documentOf = (...shapes: string[]) =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 200 100" sf:version="1">
  <g sf:diffuse="true" id="layer">
    ${shapes.join("\n    ")}
  </g>
</svg>`;

function curvesIn(drawing: Drawing): CurveItem[] {
  return [...drawing.all()].filter(
    (item): item is CurveItem => item.kind === "curve" || item.kind === "stroke",
  );
}

/** The drawing afterwards. */
function after(drawing: Drawing, outcome: Outcome | null): Drawing {
  expect(outcome).not.toBeNull();
  const next = openDrawing(drawing.text);
  next.apply(outcome!.patch);
  return next;
}

/** The value of a list at a place (piece + t), by the engine's rules. */
function valueAt<Value>(
  path: CubicPath,
  side: SideValue<Value>,
  place: number,
  mix: (a: Value, b: Value, t: number) => Value,
): Value | string {
  if (side.kind !== "stops") return side.kind;
  const stops = side.stops.map(({ offset, value }) => ({
    at: placeOfOffset(path, side.space, offset),
    value,
  }));
  // Arc length is interpolated in arc length: places of its stops are not enough.
  const measure = side.space === "arc" ? fractionAtParameter(path, place) : place;
  const marks = side.space === "arc" ? side.stops.map((s) => s.offset) : stops.map((s) => s.at);
  const behind = marks.findIndex((mark) => mark > measure);
  if (behind === 0) return stops[0].value;
  if (behind < 0) return stops[stops.length - 1].value;
  const [a, b] = [marks[behind - 1], marks[behind]];
  return mix(stops[behind - 1].value, stops[behind].value, (measure - a) / (b - a));
}

const mixRgb = (a: Rgb, b: Rgb, t: number) => mixed(a, b, t, "srgb");
const mixNumber = (a: number, b: number, t: number) => a + (b - a) * t;

/** What a curve shows beside points of it: the side that faces a direction. */
function shownAt(
  item: CurveItem,
  index: number,
  point: readonly [number, number],
  facing: readonly [number, number],
) {
  const path = item.paths[index];
  const { at } = nearestOn(path, point);
  const normal = leftNormalAt(path, at)!;
  const side: Side = normal[0] * facing[0] + normal[1] * facing[1] > 0 ? "left" : "right";
  const values = item[side];
  return {
    color: valueAt(path, values.color, at, mixRgb),
    opacity: valueAt(path, values.opacity, at, mixNumber),
    blur: values.blur.kind === "open" ? 0 : valueAt(path, values.blur, at, mixNumber),
    radius: valueAt(path, item.radius, at, mixNumber),
  };
}

/** The picture's curve is the same: shape, and what it shows on both sides. */
function expectSamePicture(
  a: CurveItem,
  b: CurveItem,
  hint: string,
  tolerance = 0.02,
  shift = 2 * STEP,
): void {
  expect(b.paths.length, hint).toBe(a.paths.length);
  a.paths.forEach((path, i) => {
    expect(farthestFrom(path, b.paths[i], 6), hint).toBeLessThan(shift);
    expect(farthestFrom(b.paths[i], path, 6), hint).toBeLessThan(shift);
    for (let k = 1; k < 20; ++k) {
      const at = (k / 20.3) * pieceCount(path);
      const normal = leftNormalAt(path, at);
      if (!normal) continue;
      const point = pathPointAt(path, at);
      for (const facing of [normal, [-normal[0], -normal[1]] as const]) {
        const [p, q] = [shownAt(a, i, point, facing), shownAt(b, i, point, facing)];
        expectNear(p, q, tolerance, `${hint}, subpath ${i}, place ${at}`);
      }
    }
  });
}

function expectNear(p: unknown, q: unknown, tolerance: number, hint: string): void {
  if (typeof p === "number" && typeof q === "number")
    expect(Math.abs(p - q), hint).toBeLessThan(tolerance);
  else if (p && q && typeof p === "object" && typeof q === "object") {
    expect(Object.keys(q), hint).toEqual(Object.keys(p));
    for (const [key, value] of Object.entries(p))
      expectNear(value, (q as Record<string, unknown>)[key], tolerance, hint);
  } else expect(q, hint).toBe(p);
}

/** Smooth paths that do not come near to themselves, so that nearest points are the same places. */
function wave(random: Random, pieces: number, closed: boolean): string {
  const point = (i: number) => {
    const angle = (i / pieces) * (closed ? 2 * Math.PI : 3);
    return [100 + 60 * Math.cos(angle), 50 + 40 * Math.sin(angle)];
  };
  const relative = random.chance(0.5);
  let [x, y] = point(0);
  let d = `M ${x.toFixed(3)},${y.toFixed(3)}`;
  for (let i = 0; i < pieces; ++i) {
    const [fx, fy] = point(i);
    const [tx, ty] = closed && i === pieces - 1 ? point(0) : point(i + 1);
    const at = (t: number): [number, number] => [fx + (tx - fx) * t, fy + (ty - fy) * t];
    const bulge = random.between(0.5, 4);
    const [a, b] = [at(random.between(0.2, 0.45)), at(random.between(0.55, 0.8))];
    const out = (p: [number, number]) => {
      const [dx, dy] = [p[0] - 100, p[1] - 50];
      const size = Math.hypot(dx, dy);
      return [p[0] + (bulge * dx) / size, p[1] + (bulge * dy) / size];
    };
    const points = random.chance(0.3) ? [[tx, ty]] : [out(a), out(b), [tx, ty]];
    const letter = points.length === 1 ? "L" : "C";
    const shift = relative ? [x, y] : [0, 0];
    d +=
      ` ${relative ? letter.toLowerCase() : letter} ` +
      points
        .map((p) => `${(p[0] - shift[0]).toFixed(3)},${(p[1] - shift[1]).toFixed(3)}`)
        .join(" ");
    [x, y] = [tx, ty];
  }
  return d + (closed ? " Z" : "");
}

const COLORS = ["red", "#12f", "gold", "rgb(20% 30% 90%)", "#0a8", "white"];

function listOf(random: Random, segments: number, value: () => string): string {
  const style = random.below(4);
  const count = style === 0 ? 1 : 2 + random.below(3);
  const offsets = Array.from({ length: count }, () => random.next()).sort((a, b) => a - b);
  return offsets
    .map((offset, i) => {
      if (style <= 1 || (style === 2 && random.chance(0.3))) return value();
      return style === 2
        ? `${value()} ${(100 * offset).toFixed(1)}%`
        : `${value()} @${(segments * offset).toFixed(2)}${i % 2 ? "0" : ""}`;
    })
    .join(", ");
}

function attributesOf(random: Random, segments: number): string {
  const color = () => random.pick(COLORS);
  const number = (most: number) => () => random.between(0, most).toFixed(2);
  const list = (name: string, value: () => string) =>
    random.chance(0.6) ? ` sf:${name}="${listOf(random, segments, value)}"` : "";
  return [
    list("left", color),
    random.chance(0.1) ? ' sf:right="none"' : list("right", color),
    list("left-opacity", number(1)),
    list("opacity", number(1)),
    list("blur", number(5)),
    list("right-blur", number(5)),
  ].join("");
}

function randomCurve(seed: number) {
  const random = new Random(seed);
  const pieces = 3 + random.below(4);
  const closed = random.chance(0.4);
  const element = `<path id="c" ${random.chance(0.5) ? 'transform="translate(3 4)" ' : ""}d="${wave(random, pieces, closed)}"${attributesOf(random, pieces)} class="keep"/>`;
  const drawing = openDrawing(documentOf("<!-- before -->", element));
  const [curve] = curvesIn(drawing);
  // Rounding may leave a line for Z.
  return { random, pieces: pieceCount(curve.paths[0]), closed, drawing, curve };
}

describe("splitting", () => {
  test("keeps the picture, and adds one node", () => {
    for (let seed = 0; seed < 30; ++seed) {
      const { random, pieces, drawing, curve } = randomCurve(seed);
      const piece = random.below(pieces);
      const next = after(
        drawing,
        splitPiece(drawing, curve.handle, 0, piece, random.between(0.1, 0.9), STEP),
      );
      const [now] = curvesIn(next);
      expect(pieceCount(now.paths[0])).toBe(pieces + 1);
      expectSamePicture(curve, now, `seed ${seed}\n${drawing.text}\n${next.text}`);
    }
  });

  test("leaves lists by arc length alone, and @ ones follow", () => {
    const drawing = openDrawing(
      documentOf(
        '<path d="M0 0L10 0L10 10" sf:left="red, blue 40%, gold" sf:right="red @0, blue @1.5, gold @2"/>',
      ),
    );
    const [curve] = curvesIn(drawing);
    const { text } = after(drawing, splitPiece(drawing, curve.handle, 0, 0, 0.5, STEP));
    expect(text).toContain('sf:left="red, blue 40%, gold"');
    expect(text).toMatch(/d="M0 0L5 0[ L]10 0L10 10"/);
    expect(text).toMatch(/sf:right="red @0, .* @2, blue @2\.5, gold @3"/);
  });

  test("of nothing is nothing", () => {
    const { drawing, curve } = randomCurve(1);
    for (const [piece, t] of [
      [-1, 0.5],
      [99, 0.5],
      [0, 0],
      [0, 1],
      [0, NaN],
    ]) {
      expect(splitPiece(drawing, curve.handle, 0, piece, t, STEP)).toBeNull();
    }
    expect(splitPiece(drawing, curve.handle, 7, 0, 0.5, STEP)).toBeNull();
    expect(splitPiece(drawing, 12345, 0, 0, 0.5, STEP)).toBeNull();
  });
});

describe("reversing", () => {
  test("keeps the picture", () => {
    for (let seed = 0; seed < 30; ++seed) {
      const { drawing, curve } = randomCurve(seed);
      const next = after(drawing, reverseCurves(drawing, [curve.handle], STEP));
      const [now] = curvesIn(next);
      expect(
        distance(now.paths[0].points[1], curve.paths[0].points[curve.paths[0].points.length - 2]),
      ).toBeLessThan(STEP);
      expectSamePicture(curve, now, `seed ${seed}\n${drawing.text}\n${next.text}`);
    }
  });

  test("twice leads back to the same values", () => {
    for (let seed = 0; seed < 20; ++seed) {
      const { drawing, curve } = randomCurve(seed);
      const once = after(drawing, reverseCurves(drawing, [curve.handle], STEP));
      const twice = after(once, reverseCurves(once, [curvesIn(once)[0].handle], STEP));
      const [now] = curvesIn(twice);
      now.paths[0].points.forEach((p, i) =>
        expect(distance(p, curve.paths[0].points[i])).toBeLessThan(STEP),
      );
      for (const side of ["left", "right"] as const) {
        for (const key of ["color", "opacity", "blur"] as const)
          expectNear(curve[side][key], now[side][key], 1e-5, `seed ${seed}`);
      }
    }
  });

  test("a circle, an arc and subpaths keep their segments", () => {
    const drawing = openDrawing(
      documentOf(
        '<circle cx="50" cy="50" r="20" sf:left="red @0, blue @1, gold @2.5" sf:right="#000"/>',
        '<path d="M0 0A9 7 30 0 1 20 4q3 3 9 1t5 5M50 0h9v4h3z" sf:right="#111, #999" sf:left="#000"/>',
      ),
    );
    const curves = curvesIn(drawing);
    const next = after(
      drawing,
      reverseCurves(
        drawing,
        curves.map((c) => c.handle),
        STEP,
      ),
    );
    curvesIn(next).forEach((now, i) => {
      expectSamePicture(curves[i], now, next.text);
      now.paths.forEach((path, k) =>
        expect(segmentsOf(path).length).toBe(segmentsOf(curves[i].paths[k]).length),
      );
    });
    expect(next.text).toContain("<path d=");
    expect(next.text).not.toContain("circle");
  });
});

describe("shapes that become paths", () => {
  test.each([
    '<circle id="a" cx="50" cy="50" r="20" class="x" sf:left="red @0, blue @1.5, gold @4"/>',
    '<ellipse sf:left="red @0, blue @1.5, gold @4" cx="50%" cy="5mm" rx="20" ry="10"></ellipse>',
    "<rect x='3' y='4' width='50' height='20' rx='5' sf:left='red @0, blue @1.5, gold @7'/>",
    '<rect x="3" y="4" width="50" height="20" sf:left="red @0, blue @1.5, gold @4"/>',
    '<line x1="3" y1="4" x2="50" y2="20" sf:left="red @0, blue @.5"/>',
    '<polyline points="1,2 30,4 50,60" sf:left="red @0, blue @1.5"/>',
    '<polygon points="1,2 30,4 50,60" sf:left="red @0, blue @1.5, gold @3"><title>&lt;kept&gt;</title></polygon>',
  ])("%s keeps its picture and its other attributes when a node is added", (shape) => {
    const drawing = openDrawing(documentOf(shape));
    const [curve] = curvesIn(drawing);
    const next = after(drawing, splitPiece(drawing, curve.handle, 0, 0, 0.25, STEP));
    const [now] = curvesIn(next);
    expect(now.handle).toBe(curve.handle);
    expect(now.isPath).toBe(true);
    expectSamePicture(curve, now, next.text);
    expect(next.text).not.toMatch(/<\/?(circle|ellipse|rect|line|polyline|polygon)\b/);
    expect(next.text).not.toMatch(/ (cx|cy|r|rx|ry|x|y|width|height|points|x1|y2)=/);
    if (shape.includes("title")) expect(next.text).toContain("<title>&lt;kept&gt;</title></path>");
    if (shape.includes("class")) expect(next.text).toContain('<path id="a" d="M70 50');
  });

  test("Inkscape's own words for a shape go, others stay", () => {
    const text = documentOf(
      '<path sodipodi:type="star" sodipodi:nodetypes="ccc" inkscape:label="s" d="M0 0L9 0L9 9" sf:left="red"/>',
    ).replace(
      "<svg ",
      '<svg xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" ',
    );
    const drawing = openDrawing(text);
    const [curve] = curvesIn(drawing);
    const moved = after(drawing, moveNodes(drawing, curve.handle, 0, [1], [1, 1], STEP));
    expect(moved.text).toContain(
      '<path sodipodi:nodetypes="ccc" inkscape:label="s" d="M0 0L10 1L9 9" sf:left="red"/>',
    );
    const split = after(drawing, splitPiece(drawing, curve.handle, 0, 0, 0.5, STEP));
    expect(split.text).toContain('<path inkscape:label="s" d="M0 0L');
  });
});

describe("moving nodes", () => {
  test("changes d alone, moves handles along, and keeps lines straight", () => {
    const drawing = openDrawing(
      documentOf('<path d="m 0,0 10,0 0,10 c 1,1 2,2 3,3 z" sf:left="red @0, gold @3"/>'),
    );
    const [curve] = curvesIn(drawing);
    const { text } = after(drawing, moveNodes(drawing, curve.handle, 0, [1], [2, 3], STEP));
    expect(text).toBe(drawing.text.replace("m 0,0 10,0 0,10 c", "m 0,0 12,3 -2,7 c"));
    const first = after(drawing, moveNodes(drawing, curve.handle, 0, [0], [2, 3], STEP));
    const [now] = curvesIn(first);
    expect(now.paths[0].points[0]).toEqual([2, 3]);
    expect(now.paths[0].closed).toBe(true);
    expect(pieceCount(now.paths[0])).toBe(4);
  });

  test("of an arc's node lets stops on it stay at their places", () => {
    const drawing = openDrawing(
      documentOf(
        '<circle cx="50" cy="50" r="20" sf:left="red @0, blue @1.5, gold @4" sf:right="#000"/>',
      ),
    );
    const [curve] = curvesIn(drawing);
    const next = after(drawing, moveNodes(drawing, curve.handle, 0, [2], [0.001, 0], 1e-6));
    const [now] = curvesIn(next);
    expect(segmentsOf(now.paths[0]).length).toBeGreaterThan(segmentsOf(curve.paths[0]).length);
    expectSamePicture(curve, now, next.text);
  });

  test("one subpath of several leaves the others' text", () => {
    const drawing = openDrawing(
      documentOf('<path d="M0 0L9 0L9 9M20,20c1,1 2,2 3,9Zm5 5h9" sf:left="red"/>'),
    );
    const [curve] = curvesIn(drawing);
    const { text } = after(drawing, moveNodes(drawing, curve.handle, 1, [1], [1, 1], STEP));
    expect(text).toContain('d="M0 0L9 0L9 9M20,20c');
    expect(text).toContain('Zm5 5h9"');
  });

  test("that go nowhere changes nothing, nor does a missing subpath", () => {
    const { drawing, curve } = randomCurve(3);
    expect(moveNodes(drawing, curve.handle, 0, [1], [0, 0], STEP)).toBeNull();
    expect(moveNodes(drawing, curve.handle, 5, [1], [1, 0], STEP)).toBeNull();
  });
});

describe("setting a path", () => {
  test("writes it, and never one of no length", () => {
    const { drawing, curve } = randomCurve(4);
    const to: CubicPath = {
      points: [
        [0, 0],
        [1, 5],
        [8, 5],
        [9, 0],
      ],
      closed: false,
    };
    const [now] = curvesIn(after(drawing, setPath(drawing, curve.handle, 0, to, STEP)));
    expect(now.paths[0].points).toEqual(to.points);
    const point: CubicPath = {
      points: [
        [3, 3],
        [3, 3],
        [3, 3],
        [3, 3],
      ],
      closed: false,
    };
    expect(setPath(drawing, curve.handle, 0, point, STEP)).toBeNull();
  });
});

describe("deleting nodes", () => {
  test("stays near the shape, and stops near their places", () => {
    for (let seed = 0; seed < 30; ++seed) {
      const { random, pieces, closed, drawing, curve } = randomCurve(seed);
      const node = closed ? random.below(pieces) : 1 + random.below(pieces - 1);
      const next = after(drawing, deleteNodes(drawing, curve.handle, 0, [node], STEP));
      const [now] = curvesIn(next);
      expect(pieceCount(now.paths[0])).toBe(pieces - 1);
      expect(farthestFrom(now.paths[0], curve.paths[0]), next.text).toBeLessThan(60);
    }
  });

  test("a node that a split added goes without a trace but rounding", () => {
    for (let seed = 0; seed < 20; ++seed) {
      const { pieces, drawing, curve } = randomCurve(seed);
      const split = after(drawing, splitPiece(drawing, curve.handle, 0, 1, 0.4, STEP));
      const [between] = curvesIn(split);
      const next = after(split, deleteNodes(split, between.handle, 0, [2], STEP));
      const [now] = curvesIn(next);
      expect(pieceCount(now.paths[0])).toBe(pieces);
      expectSamePicture(curve, now, `seed ${seed}\n${drawing.text}\n${next.text}`, 0.2, 0.15);
    }
  });

  test("ends cut, corners leave lines, and too few nodes leave nothing", () => {
    const drawing = openDrawing(
      documentOf(
        '<path d="M0 0L10 0L10 10L0 10Z" sf:left="red"/>',
        '<path d="M0 0L5 5C6 6 7 6 8 5" sf:left="red"/>',
      ),
    );
    const [square, open] = curvesIn(drawing);
    expect(after(drawing, deleteNodes(drawing, square.handle, 0, [2], STEP)).text).toContain(
      'd="M0 0L10 0L0 10Z"',
    );
    expect(after(drawing, deleteNodes(drawing, square.handle, 0, [0], STEP)).text).toMatch(
      /d="M10 0L10 10[ L]0 10Z"/,
    );
    expect(after(drawing, deleteNodes(drawing, open.handle, 0, [2], STEP)).text).toContain(
      'd="M0 0L5 5"',
    );
    const gone = after(drawing, deleteNodes(drawing, open.handle, 0, [0, 1], STEP));
    expect(curvesIn(gone).length).toBe(1);
    expect(gone.text).toContain('sf:left="red"/>\n  </g>');
  });

  test("a subpath goes alone", () => {
    const drawing = openDrawing(documentOf('<path d="M0 0L9 0M20 20L30 30m1 1h5" sf:left="red"/>'));
    const [curve] = curvesIn(drawing);
    const [now] = curvesIn(after(drawing, deleteNodes(drawing, curve.handle, 1, [0, 1], STEP)));
    expect(now.paths.map((path) => path.points[0])).toEqual([
      [0, 0],
      [31, 31],
    ]);
  });
});

describe("subpaths that share a list with @", () => {
  const shape =
    '<path id="p" d="M0 0L20 0L20 20M40 40h20v20h-20zm50 0h30" class="k" sf:left="red @0, blue @1.5, gold @2" sf:right="#000, #fff"/>';

  /** Of all curves, the one that draws a place. */
  const shownBy = (
    curves: readonly CurveItem[],
    point: readonly [number, number],
    facing: readonly [number, number],
  ) => {
    const near = curves.flatMap((item) =>
      item.paths.map((path, i) => ({ item, i, miss: nearestOn(path, point).distance })),
    );
    near.sort((a, b) => a.miss - b.miss);
    expect(near[0].miss).toBeLessThan(2 * STEP);
    const { item, i } = near[0];
    // What the drawing says is by the first subpath's segments; lists that part are for their own.
    return shownAt(item, i, point, facing);
  };

  test.each([
    ["split", (d: Drawing, c: CurveItem) => splitPiece(d, c.handle, 1, 1, 0.25, STEP)],
    ["reversed", (d: Drawing, c: CurveItem) => reverseCurves(d, [c.handle], STEP)],
  ])("keep their picture when one is %s, and part", (_, edit) => {
    const drawing = openDrawing(documentOf(shape));
    const [curve] = curvesIn(drawing);
    const outcome = edit(drawing, curve);
    const next = after(drawing, outcome);
    const curves = curvesIn(next);
    expect(curves.length).toBeGreaterThan(1);
    expect(curves.flatMap((item) => item.paths).length).toBe(3);
    expect(new Set(next.text.match(/ id="p[^"]*"/g)).size).toBe(curves.length);
    expect(next.text.match(/class="k"/g)?.length).toBe(curves.length);
    if (outcome!.select) expect(next.itemAt(outcome!.select[0].at)).toBe(curves[1]);
    curve.paths.forEach((path, i) => {
      for (let k = 1; k < 20; ++k) {
        const at = (k / 20.3) * pieceCount(path);
        const [point, normal] = [pathPointAt(path, at), leftNormalAt(path, at)!];
        for (const facing of [normal, [-normal[0], -normal[1]] as const]) {
          expectNear(
            shownAt(curve, i, point, facing),
            shownBy(curves, point, facing),
            0.02,
            `${i} ${at}\n${next.text}`,
          );
        }
      }
    });
  });

  test("stay together where nothing of the list changes", () => {
    const drawing = openDrawing(documentOf(shape));
    const [curve] = curvesIn(drawing);
    expect(
      curvesIn(after(drawing, moveNodes(drawing, curve.handle, 1, [1], [1, 1], STEP))).length,
    ).toBe(1);
  });
});

describe("kinds of nodes", () => {
  test("are what was asked for", () => {
    for (let seed = 0; seed < 100; ++seed) {
      const { random, pieces, drawing, curve } = randomCurve(seed);
      const node = 1 + random.below(pieces - 1);
      for (const kind of ["smooth", "symmetric", "corner"] as const) {
        const outcome = setNodeKind(drawing, curve.handle, 0, [node], kind, 1e-6);
        const [now] = outcome ? curvesIn(after(drawing, outcome)) : [curve];
        const found = kindOf(now.paths[0], node);
        if (kind === "smooth") expect(["smooth", "symmetric"], `seed ${seed}`).toContain(found);
        else expect(found, `seed ${seed} ${kind}`).toBe(kind);
      }
    }
  });
});

describe("closing", () => {
  test("draws a line where the ends differ, and opening keeps the shape", () => {
    const drawing = openDrawing(
      documentOf('<path d="M0 0L10 0L10 10" sf:left="red @0, gold @2"/>'),
    );
    const [curve] = curvesIn(drawing);
    const closed = after(drawing, setClosed(drawing, curve.handle, 0, true, STEP));
    expect(closed.text).toContain('d="M0 0L10 0L10 10 Z"');
    expect(closed.text).toContain('sf:left="red @0, gold @2"');
    const opened = after(closed, setClosed(closed, curvesIn(closed)[0].handle, 0, false, STEP));
    const [now] = curvesIn(opened);
    expect(now.paths[0].closed).toBe(false);
    expect(now.paths[0].points[9]).toEqual([0, 0]);
    expect(setClosed(drawing, curve.handle, 0, false, STEP)).toBeNull();
  });
});

describe("joining", () => {
  const straight = (d: string, rest: string) => `<path d="${d}" ${rest}/>`;

  test("lays stops behind each other by shares of the length", () => {
    const drawing = openDrawing(
      documentOf(
        straight("M0 0H30", 'sf:left="red, blue" sf:blur="1"'),
        straight("M30 0H40", 'sf:left="gold" sf:blur="1"'),
      ),
    );
    const [a, b] = curvesIn(drawing);
    const outcome = joinCurves(drawing, a.handle, b.handle, STEP);
    const next = after(drawing, outcome);
    expect(curvesIn(next).length).toBe(1);
    expect(next.text).toContain('sf:left="red, blue 75%, gold 75%"');
    expect(next.text).toContain('sf:blur="1"');
    expect(next.itemAt(outcome!.select![0].at)?.kind).toBe("curve");
  });

  test("keeps the picture in every order and direction", () => {
    for (let seed = 0; seed < 30; ++seed) {
      const random = new Random(seed);
      // Halves of a wave; the second perhaps backwards, mirrored, and in a frame of its own.
      const pieces = ["M10 50 C20 40 40 70 60 50", "M60 50 C80 30 90 60 120 50 L150 40"];
      const shapes = pieces.map((d, i) => {
        const segments = i + 1;
        const lists = ["left", "right"].map(
          (side) => `sf:${side}="${listOf(random, segments, () => random.pick(COLORS))}"`,
        );
        const radius = `sf:left-blur="${listOf(random, segments, () => random.between(0, 5).toFixed(2))}"`;
        return straight(
          d,
          [...lists, random.chance(0.5) ? radius : 'sf:blur="2"', 'sf:opacity=".5"'].join(" "),
        );
      });
      let drawing = openDrawing(documentOf(...(random.chance(0.5) ? shapes : shapes.reverse())));
      for (const { handle } of curvesIn(drawing)) {
        const outcome = random.chance(0.5) ? reverseCurves(drawing, [handle], STEP) : null;
        if (outcome) drawing.apply(outcome.patch);
      }
      drawing = openDrawing(drawing.text);
      const [a, b] = curvesIn(drawing);
      const [first, second] = random.chance(0.5) ? [a, b] : [b, a];
      const next = after(drawing, joinCurves(drawing, first.handle, second.handle, STEP));
      const [now] = curvesIn(next);
      expect(pieceCount(now.paths[0])).toBe(3);
      for (const half of [a, b]) {
        const path = half.paths[0];
        for (let k = 1; k < 20; ++k) {
          const at = (k / 20) * pieceCount(path);
          const [point, normal] = [pathPointAt(path, at), leftNormalAt(path, at)!];
          for (const facing of [normal, [-normal[0], -normal[1]] as const]) {
            const isInParameters = /@/.test(drawing.text);
            const [p, q] = [shownAt(half, 0, point, facing), shownAt(now, 0, point, facing)];
            expectNear(
              p,
              q,
              isInParameters ? 5 : 0.03,
              `seed ${seed}, ${at}\n${drawing.text}\n${next.text}`,
            );
          }
        }
      }
    }
  });

  test("brings the second into the first's frame: radii grow, a mirror image changes sides", () => {
    const drawing = openDrawing(
      documentOf(
        straight("M0 0H30", 'sf:left="red" sf:right="blue" sf:blur="1"'),
        straight("M15 0H30", 'transform="scale(2 -2)" sf:left="red" sf:right="blue" sf:blur="1"'),
      ),
    );
    const [a, b] = curvesIn(drawing);
    const { text } = after(drawing, joinCurves(drawing, a.handle, b.handle, STEP));
    expect(text).toContain('sf:left="red, red 50%, blue 50%"');
    expect(text).toContain('sf:right="blue, blue 50%, red 50%"');
    expect(text).toContain('sf:blur="1, 1 50%, 2 50%"');
  });

  test("bridges far ends by a line, closes a curve with itself, and refuses others", () => {
    const drawing = openDrawing(
      documentOf(
        straight("M0 0H30", 'sf:left="red"'),
        straight("M80 0H120", 'sf:left="red"'),
        straight("M0 9H9V20Z", 'sf:left="red"'),
      ).replace("</svg>", '<g sf:diffuse="true"><path d="M0 0H5" sf:left="red"/></g></svg>'),
    );
    const [a, b, loop, elsewhere] = curvesIn(drawing);
    const { text } = after(drawing, joinCurves(drawing, a.handle, b.handle, STEP));
    expect(text).toMatch(/d="M0 0H30 L80 0[ L]120 0" sf:left="red"/);
    expect(after(drawing, joinCurves(drawing, a.handle, a.handle, STEP)).text).toContain("Z");
    expect(joinCurves(drawing, a.handle, loop.handle, STEP)).toBeNull();
    expect(joinCurves(drawing, a.handle, elsewhere.handle, STEP)).toBeNull();
    expect(mapped([1, 0, 0, 1, 0, 0], [1, 2])).toEqual([1, 2]);
  });
});
