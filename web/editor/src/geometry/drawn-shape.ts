// Rectangles, ellipses and polygons as a pointer draws them: from corner to corner of a box.
import type { Box, Point } from "./affine.js";
import type { CubicPath } from "./cubic.js";
import { shapePaths } from "./shape.js";

export type ShapeKind = "rectangle" | "ellipse" | "polygon";

/** A shape that fills a box. */
export interface DrawnShape {
  readonly kind: ShapeKind;
  readonly box: Box;
  /** The sides of a polygon. */
  readonly sides: number;
}

/** Returns the corners of a regular polygon around the origin, clockwise on the screen, from the top. */
function regular(sides: number): Point[] {
  return Array.from({ length: sides }, (_, k) => {
    const angle = (2 * Math.PI * k) / sides;
    return [Math.sin(angle), -Math.cos(angle)];
  });
}

function spanOf(points: readonly Point[], axis: 0 | 1): readonly [number, number] {
  const values = points.map((point) => point[axis]);
  return [Math.min(...values), Math.max(...values)];
}

/** Returns the width of a shape's box, divided by its height, where the shape is regular. */
export function regularRatio({ kind, sides }: Omit<DrawnShape, "box">): number {
  if (kind !== "polygon") return 1;
  const [[x0, x1], [y0, y1]] = [spanOf(regular(sides), 0), spanOf(regular(sides), 1)];
  return (x1 - x0) / (y1 - y0);
}

/** Returns the corners of a rectangle or a polygon, clockwise on the screen. */
export function cornersOf({ kind, box, sides }: DrawnShape): readonly Point[] {
  const [x0, y0, x1, y1] = box;
  if (kind === "rectangle") return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
  const points = regular(sides);
  const [[left, right], [top, bottom]] = [spanOf(points, 0), spanOf(points, 1)];
  return points.map(([x, y]) => [
    x0 + ((x - left) / (right - left)) * (x1 - x0),
    y0 + ((y - top) / (bottom - top)) * (y1 - y0),
  ]);
}

/** Returns the outline of a shape. */
export function outlineOf(shape: DrawnShape): CubicPath | null {
  const { local, attributes } = elementOf(shape, String);
  return shapePaths(local, (name) => attributes.find(([own]) => own === name)?.[1], shape.box)[0] ?? null;
}

/** SVG's element for a shape. @param text writes a number */
export function elementOf(
  shape: DrawnShape,
  text: (value: number) => string,
): { readonly local: string; readonly attributes: readonly (readonly [string, string])[] } {
  const [x0, y0, x1, y1] = shape.box;
  const numbers = (values: Record<string, number>) =>
    Object.entries(values).map(([name, value]) => [name, text(value)] as const);
  switch (shape.kind) {
    case "rectangle":
      return { local: "rect", attributes: numbers({ x: x0, y: y0, width: x1 - x0, height: y1 - y0 }) };
    case "ellipse": {
      const [rx, ry] = [(x1 - x0) / 2, (y1 - y0) / 2];
      return { local: "ellipse", attributes: numbers({ cx: x0 + rx, cy: y0 + ry, rx, ry }) };
    }
    case "polygon":
      return polygonOf(cornersOf(shape), text);
  }
}

/** Returns SVG's element for a polygon of these corners. */
export function polygonOf(corners: readonly Point[], text: (value: number) => string) {
  const points = corners.map(([x, y]) => `${text(x)},${text(y)}`).join(" ");
  return { local: "polygon", attributes: [["points", points] as const] };
}

interface Spread {
  /** The width divided by the height; null: free. */
  readonly ratio: number | null;
  /** Whether `from` is the middle of the box, not a corner. */
  readonly isCentred: boolean;
}

/** Returns the box that a drag makes. */
export function boxOfDrag(from: Point, to: Point, { ratio, isCentred }: Spread): Box {
  let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  if (ratio !== null) {
    const height = Math.max(Math.abs(dx) / ratio, Math.abs(dy));
    [dx, dy] = [(dx < 0 ? -1 : 1) * height * ratio, (dy < 0 ? -1 : 1) * height];
  }
  const begin: Point = isCentred ? [from[0] - dx, from[1] - dy] : from;
  const end: Point = [from[0] + dx, from[1] + dy];
  return [
    Math.min(begin[0], end[0]),
    Math.min(begin[1], end[1]),
    Math.max(begin[0], end[0]),
    Math.max(begin[1], end[1]),
  ];
}
