// SVG's basic shapes as curves, by the engine's rules (src/formats/svg/shapes/shapes.cpp): they begin
// where SVG says, and run clockwise on the screen.
import type { Box, Point } from "./affine.js";
import type { CubicPath } from "./cubic.js";
import { PathBuilder } from "./pathbuilder.js";
import { readPathText } from "./pathreader.js";
import { distance, isSame } from "./vector.js";

/** Shorter sides, as a share of the coordinates, are none. */
const NO_SIDE = 1e-12;
const LARGEST = 1e7;
const PIXELS: Record<string, number> = {
  "": 1,
  px: 1,
  pt: 96 / 72,
  pc: 16,
  mm: 96 / 25.4,
  cm: 96 / 2.54,
  in: 96,
};
const LENGTH = /^[ \t\n\r\f]*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)([a-zA-Z]*|%)[ \t\n\r\f]*$/;
const NUMBER = /[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/y;
const SEPARATOR = /[ \t\n\r\f]*,?[ \t\n\r\f]*/y;

/** The value of an attribute without a namespace, or what stands for none. */
export type AttributeOf = (name: string) => string | null | undefined;
type Axis = "x" | "y" | "diagonal";

/** Marks an error in the shape. The engine reports it; here nothing is drawn. */
class Mistake extends Error {}

class Shape {
  readonly builder = new PathBuilder();

  constructor(
    readonly attribute: AttributeOf,
    readonly viewBox: Box,
  ) {}

  length(name: string, axis: Axis): number {
    const text = this.attribute(name);
    if (text === null || text === undefined) return 0;
    const [, number, unit] = LENGTH.exec(text) ?? [];
    const factor = unit === "%" ? this.#extent(axis) / 100 : PIXELS[(unit ?? "?").toLowerCase()];
    const value = Number(number) * factor;
    if (!(Math.abs(value) <= LARGEST)) throw new Mistake();
    return value;
  }

  radius(name: string, axis: Axis): number {
    const value = this.length(name, axis);
    if (value < 0) throw new Mistake();
    return value;
  }

  /** Returns rx and ry; "auto" takes the other's value. */
  radii(): Point {
    const isAuto = (name: string) => (this.attribute(name) ?? "auto") === "auto";
    const x = isAuto("rx") ? null : this.radius("rx", "x");
    const y = isAuto("ry") ? null : this.radius("ry", "y");
    return [x ?? y ?? 0, y ?? x ?? 0];
  }

  ellipse(cx: number, cy: number, rx: number, ry: number): void {
    if (rx === 0 || ry === 0) return;
    const { builder } = this;
    builder.moveTo([cx + rx, cy]);
    for (const [x, y] of [
      [0, ry],
      [-rx, 0],
      [0, -ry],
      [rx, 0],
    ]) {
      builder.arcTo([rx, ry], 0, false, true, [cx + x, cy + y]);
    }
    builder.close();
  }

  rectangle(x0: number, y0: number, x1: number, y1: number, rx: number, ry: number): void {
    const { builder } = this;
    const extent = Math.max(...[x0, x1, y0, y1].map(Math.abs));
    const side = (point: Point) => {
      if (distance(point, builder.current) > NO_SIDE * extent) builder.lineTo(point);
    };
    const corner = (point: Point) => {
      if (rx > 0 && ry > 0) builder.arcTo([rx, ry], 0, false, true, point);
    };
    builder.moveTo([x0 + rx, y0]);
    side([x1 - rx, y0]);
    corner([x1, y0 + ry]);
    side([x1, y1 - ry]);
    corner([x1 - rx, y1]);
    side([x0 + rx, y1]);
    corner([x0, y1 - ry]);
    side([x0, y0 + ry]);
    corner([x0 + rx, y0]);
    builder.close();
  }

  roundedRectangle(): void {
    const [x, y] = [this.length("x", "x"), this.length("y", "y")];
    const [width, height] = [this.radius("width", "x"), this.radius("height", "y")];
    let [rx, ry] = this.radii();
    if (width === 0 || height === 0) return;
    if (rx === 0 || ry === 0) rx = ry = 0;
    this.rectangle(x, y, x + width, y + height, Math.min(rx, width / 2), Math.min(ry, height / 2));
  }

  polyline(): void {
    pointsOf(this.attribute("points") ?? "").forEach((point, i) => {
      if (i === 0) this.builder.moveTo(point);
      else this.builder.lineTo(point);
    });
  }

  #extent(axis: Axis): number {
    const [x0, y0, x1, y1] = this.viewBox;
    if (axis === "x") return x1 - x0;
    if (axis === "y") return y1 - y0;
    return Math.hypot(x1 - x0, y1 - y0) / Math.SQRT2;
  }
}

function pointsOf(text: string): Point[] {
  const end = text.trimEnd().length;
  const numbers: number[] = [];
  let at = text.length - text.trimStart().length;
  while (at < end) {
    NUMBER.lastIndex = at;
    const [number] = NUMBER.exec(text) ?? [""];
    if (number === "" || Math.abs(Number(number)) > LARGEST) throw new Mistake();
    numbers.push(Number(number));
    SEPARATOR.lastIndex = at + number.length;
    SEPARATOR.test(text);
    at = SEPARATOR.lastIndex;
  }
  if (numbers.length % 2 === 1) throw new Mistake();
  return Array.from({ length: numbers.length / 2 }, (_, i) => [numbers[2 * i], numbers[2 * i + 1]]);
}

function draw(shape: Shape, local: string): void {
  const { builder } = shape;
  switch (local) {
    case "line":
      builder.moveTo([shape.length("x1", "x"), shape.length("y1", "y")]);
      return builder.lineTo([shape.length("x2", "x"), shape.length("y2", "y")]);
    case "circle": {
      const r = shape.radius("r", "diagonal");
      return shape.ellipse(shape.length("cx", "x"), shape.length("cy", "y"), r, r);
    }
    case "ellipse":
      return shape.ellipse(shape.length("cx", "x"), shape.length("cy", "y"), ...shape.radii());
    case "rect":
      return shape.roundedRectangle();
    default:
      shape.polyline();
      if (local === "polygon") builder.close();
  }
}

/** Attributes of a shape that say where it is: what `d` takes the place of. */
export function geometryAttributes(local: string): readonly string[] {
  return (
    {
      path: ["d"],
      line: ["x1", "y1", "x2", "y2"],
      circle: ["cx", "cy", "r"],
      ellipse: ["cx", "cy", "rx", "ry"],
      rect: ["x", "y", "width", "height", "rx", "ry"],
      polyline: ["points"],
      polygon: ["points"],
    }[local] ?? []
  );
}

export const hasLength = (path: CubicPath): boolean =>
  path.points.some((p) => !isSame(p, path.points[0]));

/**
 * Returns the subpaths that an element draws, without subpaths of length 0; none if an attribute has an error or
 * the element is not a shape. Percentages refer to `viewBox`.
 * @param local path, line, polyline, polygon, circle, ellipse or rect
 */
export function shapePaths(local: string, attribute: AttributeOf, viewBox: Box): CubicPath[] {
  if (local === "path") return readPath(attribute("d") ?? "");
  if (geometryAttributes(local).length === 0) return [];
  const shape = new Shape(attribute, viewBox);
  try {
    draw(shape, local);
  } catch (error) {
    if (error instanceof Mistake) return [];
    throw error;
  }
  shape.builder.finish();
  return shape.builder.done.filter(hasLength);
}

/**
 * Path data that draws what an element draws, with the same segments: its own, or commands of lines
 * and arcs in the place of a basic shape.
 */
export function shapeData(local: string, attribute: AttributeOf, viewBox: Box): string {
  if (local === "path") return attribute("d") ?? "";
  const radii = local === "rect" || local === "ellipse" || local === "circle";
  return shapePaths(local, attribute, viewBox)
    .map((path) => dataOf(path, radii))
    .join(" ");
}

/** Segments of several pieces are quarters of ellipses whose axes are upright. */
function dataOf({ points, closed, segments }: CubicPath, hasArcs: boolean): string {
  const text = (p: Point) => `${p[0]} ${p[1]}`;
  const parts = [`M${text(points[0])}`];
  const pieces = (points.length - 1) / 3;
  const firsts = segments ?? Array.from({ length: pieces + 1 }, (_, i) => i);
  for (let i = 0; i + 1 < firsts.length; ++i) {
    const [from, to] = [points[3 * firsts[i]], points[3 * firsts[i + 1]]];
    const isArc = hasArcs && firsts[i + 1] - firsts[i] > 1;
    const isClosing = closed && !isArc && i > 0 && i + 2 === firsts.length && !isSame(from, to);
    const radii = `${Math.abs(to[0] - from[0])} ${Math.abs(to[1] - from[1])}`;
    if (isArc) parts.push(`A${radii} 0 0 1 ${text(to)}`);
    else if (!isClosing) parts.push(`L${text(to)}`);
  }
  if (closed) parts.push("Z");
  return parts.join(" ");
}

/** Returns the subpaths of path data, without subpaths of length 0; none if the data has an error. */
export function readPath(d: string): CubicPath[] {
  return (readPathText(d)?.paths ?? []).filter(hasLength);
}
