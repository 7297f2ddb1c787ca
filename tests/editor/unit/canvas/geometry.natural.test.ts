// The visible nodes of arcs, and the results of editing them.
import { describe, expect, test } from "vitest";
import { kindOf } from "../../../../web/editor/src/geometry/nodes.js";
import { nodeCount, pieceCount, segmentsOf } from "../../../../web/editor/src/geometry/cubic.js";
import { pathPointAt } from "../../../../web/editor/src/geometry/length.js";
import { nodePath, placeOnNodePath } from "../../../../web/editor/src/geometry/natural.js";
import { farthestFrom } from "../../../../web/editor/src/geometry/nearest.js";
import { readPath, shapePaths } from "../../../../web/editor/src/geometry/path.js";
import { distance } from "../../../../web/editor/src/geometry/vector.js";
import {
  deleteNodes,
  moveNodes,
  setNodeKind,
  setPath,
  splitPiece,
} from "../../../../web/editor/src/model/commands/curves/shapes.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import { Random } from "../random.js";
import { after, curvesIn, documentOf, STEP } from "../support/shapes.js";

const shape = (local: string, attributes: Record<string, string>) =>
  shapePaths(local, (name) => attributes[name], [0, 0, 100, 100])[0];

describe("the nodes", () => {
  test("of a circle are its four", () => {
    const nodes = nodePath(shape("circle", { cx: "50", cy: "40", r: "20" }));
    expect(nodeCount(nodes)).toBe(4);
    const places = [[70, 40], [50, 60], [30, 40], [50, 20]] as const;
    places.forEach((place, i) => expect(distance(nodes.points[3 * i], place)).toBeLessThan(1e-12));
    for (let i = 0; i < 4; ++i) expect(kindOf(nodes, i)).toBe("symmetric");
  });

  test.each([
    ["ellipse", { cx: "50", cy: "40", rx: "40", ry: "3" }, 4],
    ["rect", { x: "1", y: "2", width: "30", height: "20" }, 4],
    ["rect", { x: "1", y: "2", width: "30", height: "20", rx: "4" }, 8],
    ["rect", { x: "1", y: "2", width: "30", height: "20", rx: "15", ry: "10" }, 4],
    ["line", { x1: "1", y1: "2", x2: "30", y2: "20" }, 2],
    ["polygon", { points: "1,2 30,4 50,60" }, 3],
  ])("of a shape are its natural ones: %s %o", (local, attributes, count) => {
    const path = shape(local, attributes);
    const nodes = nodePath(path);
    expect(nodeCount(nodes)).toBe(count);
    expect(nodes.closed).toBe(path.closed);
    expect(farthestFrom(nodes, path)).toBeLessThan(3e-4 * 40);
  });

  test("of arcs in a path are where they begin and after each quarter turn at most", () => {
    for (let seed = 0; seed < 200; ++seed) {
      const random = new Random(seed);
      const number = () => random.between(-50, 50).toFixed(2);
      const radius = () => random.between(1, 80).toFixed(2);
      const arc = () =>
        `A${radius()} ${radius()} ${number()} ${random.below(2)} ${random.below(2)} ${number()} ${number()}`;
      const d = `M${number()} ${number()}${arc()}L3 4${arc()}${arc()}`;
      const [path] = readPath(d);
      const nodes = nodePath(path);
      expect(pieceCount(nodes), d).toBeLessThanOrEqual(1 + 3 * 4);
      const extent = Math.max(...path.points.flat().map(Math.abs));
      expect(farthestFrom(nodes, path), d).toBeLessThan(1e-3 * extent);
      for (let k = 0; k <= 20; ++k) {
        const at = (k / 20) * pieceCount(path);
        const there = pathPointAt(nodes, placeOnNodePath(path, at));
        expect(distance(there, pathPointAt(path, at)), d).toBeLessThan(0.03 * extent);
      }
    }
  });

  test("of a path without arcs are its own", () => {
    const [path] = readPath("M0 0L5 5C1 2 3 4 5 6");
    expect(nodePath(path)).toBe(path);
    expect(placeOnNodePath(path, 1.25)).toBe(1.25);
  });
});

/** Returns the data of the first path, without the blanks between commands, and its lists. */
const dataOf = (text: string) => / d="([^"]*)"/.exec(text)![1].replace(/ ?([A-Z]) ?/g, "$1");
const leftOf = (text: string) => /sf:left="([^"]*)"/.exec(text)![1];

describe("a circle of which a node is edited", () => {
  const lists = 'sf:left="red @0, blue @1.5, gold @3" sf:right="#000 10%, #fff 60%"';
  const drawing = openDrawing(
    documentOf(`<circle id="a" cx="50" cy="50" r="20" ${lists}/>`),
  );
  const [circle] = curvesIn(drawing);

  test("becomes a path with the same parametrisation, and stays an arc elsewhere", () => {
    const next = after(drawing, moveNodes(drawing, circle.handle, new Map([[0, [1]]]), [0, 10], STEP));
    expect(next.text).toContain('<path id="a" d="');
    expect(dataOf(next.text)).toMatch(/^M70 50C[^A-Z]*(?:C[^A-Z]*)?A20 20 0 0 1 50 30A20 20 0 0 1 70 50Z$/);
    // A list by segments that passes the start of the new arc gets a stop there, so that nothing changes.
    expect(leftOf(next.text)).toMatch(/^red @0, blue @1.5, [^@,]* @2, gold @3$/);
    expect(next.text).toContain('sf:right="#000 10%, #fff 60%"');
    const [{ paths }] = curvesIn(next);
    expect(segmentsOf(paths[0]).length).toBe(5);
    expect(nodeCount(nodePath(paths[0]))).toBe(4);
    expect(nodePath(paths[0]).points[3]).toEqual([50, 70 + 10]);
  });

  test("at its beginning, is another there and behind it alone", () => {
    const next = after(drawing, moveNodes(drawing, circle.handle, new Map([[0, [0]]]), [5, 0], STEP));
    expect(dataOf(next.text)).toMatch(/^M75 50C[^A-Z]*A20 20 0 0 1 30 50A20 20 0 0 1 50 30C[^A-Z]* 75 50Z/);
    expect(leftOf(next.text)).toMatch(/^red @0, [^@,]* @1, blue @1.5, gold @3$/);
  });

  test("by a handle or by its kind, likewise", () => {
    const nodes = nodePath(circle.paths[0]);
    const points = nodes.points.map((p, i) => (i === 1 ? ([75, 60] as const) : p));
    const pulled = after(drawing, setPath(drawing, circle.handle, 0, { ...nodes, points }, STEP));
    expect(dataOf(pulled.text)).toMatch(/^M70 50C75 60 [^A-Z]*A20 20 0 0 1 30 50/);
    const corner = after(drawing, setNodeKind(drawing, circle.handle, new Map([[0, [2]]]), "corner", STEP));
    expect(dataOf(corner.text)).toMatch(/^M70 50A20 20 0 0 1 50 70C[^A-Z]*(?:C[^A-Z]*)?A20 20 0 0 1 70 50Z/);
  });

  test("has a fifth where one is added, within a thousandth of where it was", () => {
    for (const t of [0.1, 0.5, 0.8]) {
      const next = after(drawing, splitPiece(drawing, circle.handle, 0, 1, t, STEP));
      const [{ paths }] = curvesIn(next);
      expect(nodeCount(nodePath(paths[0]))).toBe(5);
      expect(farthestFrom(paths[0], circle.paths[0])).toBeLessThan(6e-3);
      expect(dataOf(next.text)).toMatch(/^M70 50A20 20 0 0 1 50 70C[^A-Z]*(?:C[^A-Z]*)?A20/);
      expect(next.text).toMatch(/sf:left="red @0, .*@4"/);
    }
  });

  test("has three where one is taken away", () => {
    const next = after(drawing, deleteNodes(drawing, circle.handle, new Map([[0, [2]]]), STEP));
    const [{ paths }] = curvesIn(next);
    expect(nodeCount(nodePath(paths[0]))).toBe(3);
    expect(dataOf(next.text)).toMatch(/^M70 50A20 20 0 0 1 50 70C[^A-Z]*A20 20 0 0 1 70 50Z/);
  });

  test("that is half a circle in a path, leaves the list its places", () => {
    const half = openDrawing(
      documentOf('<path d="M0 0A10 10 0 0 1 20 0L40 0" sf:left="red @0, blue @.5, gold @2"/>'),
    );
    const [curve] = curvesIn(half);
    expect(nodeCount(nodePath(curve.paths[0]))).toBe(4);
    const next = after(half, moveNodes(half, curve.handle, new Map([[0, [1]]]), [0, -5], STEP));
    expect(dataOf(next.text)).toMatch(/^M0 0C[^A-Z]*(?:C[^A-Z]*)?L40 0$/);
    expect(leftOf(next.text)).toMatch(/^red @0, blue @1, [^@]* @2, gold @3$/);
  });
});
