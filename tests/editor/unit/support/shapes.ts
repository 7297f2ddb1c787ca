// Drawings and helpers for the tests of curve edits.
import { expect } from "vitest";
import { mixed, type Rgb } from "../../../../web/editor/src/geometry/color.js";
import { pieceCount, type CubicPath } from "../../../../web/editor/src/geometry/cubic.js";
import {
  fractionAtParameter,
  leftNormalAt,
  pathPointAt,
  placeOfOffset,
} from "../../../../web/editor/src/geometry/length.js";
import { farthestFrom, nearestOn } from "../../../../web/editor/src/geometry/nearest.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type {
  CurveItem,
  Drawing,
  Outcome,
  Side,
  SideValue,
} from "../../../../web/editor/src/model/types.js";
import { Random } from "../random.js";

export const STEP = 0.001;

export const documentOf = (...shapes: string[]) =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 200 100" sf:version="1">
  <g sf:diffuse="true" id="layer">
    ${shapes.join("\n    ")}
  </g>
</svg>`;

export function curvesIn(drawing: Drawing): CurveItem[] {
  return [...drawing.all()].filter(
    (item): item is CurveItem => item.kind === "curve" || item.kind === "stroke",
  );
}

/** Returns the drawing after an outcome. */
export function after(drawing: Drawing, outcome: Outcome | null): Drawing {
  expect(outcome).not.toBeNull();
  const next = openDrawing(drawing.text);
  next.apply(outcome!.patch);
  return next;
}

/** Returns the value of a list at a place (piece + t), by the engine's rules. */
export function valueAt<Value>(
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
  // In arc-length lists, values are interpolated by arc length, so the stops' places do not suffice.
  const measure = side.space === "arc" ? fractionAtParameter(path, place) : place;
  const marks = side.space === "arc" ? side.stops.map((s) => s.offset) : stops.map((s) => s.at);
  const behind = marks.findIndex((mark) => mark > measure);
  if (behind === 0) return stops[0].value;
  if (behind < 0) return stops[stops.length - 1].value;
  const [a, b] = [marks[behind - 1], marks[behind]];
  return mix(stops[behind - 1].value, stops[behind].value, (measure - a) / (b - a));
}

export const mixRgb = (a: Rgb, b: Rgb, t: number) => mixed(a, b, t, "srgb");
export const mixNumber = (a: number, b: number, t: number) => a + (b - a) * t;

/** Returns the values that a curve shows beside points of it, on the side that faces a direction. */
export function shownAt(
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

/** Expects the same picture of the curve: shape, and values on both sides. */
export function expectSamePicture(
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

export function expectNear(p: unknown, q: unknown, tolerance: number, hint: string): void {
  if (typeof p === "number" && typeof q === "number")
    expect(Math.abs(p - q), hint).toBeLessThan(tolerance);
  else if (p && q && typeof p === "object" && typeof q === "object") {
    expect(Object.keys(q), hint).toEqual(Object.keys(p));
    for (const [key, value] of Object.entries(p))
      expectNear(value, (q as Record<string, unknown>)[key], tolerance, hint);
  } else expect(q, hint).toBe(p);
}

/** Returns smooth paths that do not come near themselves, so that nearest points are unique places. */
export function wave(random: Random, pieces: number, closed: boolean): string {
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

export const COLORS = ["red", "#12f", "gold", "rgb(20% 30% 90%)", "#0a8", "white"];

export function listOf(random: Random, segments: number, value: () => string): string {
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

export function attributesOf(random: Random, segments: number): string {
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

export function randomCurve(seed: number) {
  const random = new Random(seed);
  const pieces = 3 + random.below(4);
  const closed = random.chance(0.4);
  const element = `<path id="c" ${random.chance(0.5) ? 'transform="translate(3 4)" ' : ""}d="${wave(random, pieces, closed)}"${attributesOf(random, pieces)} class="keep"/>`;
  const drawing = openDrawing(documentOf("<!-- before -->", element));
  const [curve] = curvesIn(drawing);
  // Rounding may leave a line for Z.
  return { random, pieces: pieceCount(curve.paths[0]), closed, drawing, curve };
}
