// Colours that the picture has beside a curve: a new curve has few stops with them, so that little changes.
import type { Editor } from "../app/types.js";
import { determinant, inverted, lengthScale, mapped, type Point } from "../geometry/affine.js";
import { axesOf, clampedRgb, colorOfAxes, type MixSpace, type Rgb } from "../geometry/color.js";
import { isOpen, type CubicPath } from "../geometry/cubic.js";
import {
  parameterAtFraction,
  pathDirectionAt,
  pathLength,
  pathPointAt,
} from "../geometry/length.js";
import { nearestGraph } from "../geometry/simplify.js";
import { leftOf } from "../geometry/vector.js";
import type { CurveItem, Item, SideValue, Stop } from "../model/types.js";
import { pathInLayer } from "./along.js";
import { outermostLayer } from "./hit.js";
import { mixer, valueAt } from "./sides.js";

/** How far beside the curve colours are sampled, and how far apart, CSS pixels. */
const BESIDE = 1.5;
const APART = 4;
/** Places along a curve, whatever its length. */
const FEWEST = 8;
const MOST = 160;
/** Stops of a side; on a closed curve those at its start and its end count as one. */
const MOST_STOPS = 3;
/** How far stops may be from the colours that they stand for, if fewer would do: two code values. */
const TOLERANCE = 2 / 255;
/** Two sides that differ by less get stops at the same places, so that no line shows between them. */
const ALIKE = 8 / 255;
/** A smaller coverage counts as none. */
const NOTHING = 1 / 255;

interface Sides<V> {
  readonly left: V;
  readonly right: V;
}

/**
 * Returns points of a layer that the engine can evaluate: nothing is solved outside of the artboard, so the
 * nearest point of its edge replaces a point there.
 */
function withinArtboard(editor: Editor, layer: Item, points: readonly Point[]): readonly Point[] {
  const back = inverted(layer.artboardFromItem);
  if (!back) return points;
  const [x0, y0, x1, y1] = editor.drawing.artboard;
  // On the edge itself rounding decides what is within.
  const [dx, dy] = [(x1 - x0) * 1e-6, (y1 - y0) * 1e-6];
  const kept = (value: number, from: number, to: number) => Math.min(Math.max(value, from), to);
  return points.map((point) => {
    const [x, y] = mapped(layer.artboardFromItem, point);
    const held: Point = [kept(x, x0 + dx, x1 - dx), kept(y, y0 + dy, y1 - dy)];
    return held[0] === x && held[1] === y ? point : mapped(back, held);
  });
}

/** Colours at points of a layer, in its frame; null for a point where nothing is, or for all. */
async function colorsAt(
  editor: Editor,
  layer: Item,
  points: readonly Point[],
): Promise<(Rgb | null)[] | null> {
  const index = editor.engineLayer(layer);
  if (index === null) return null;
  try {
    const held = withinArtboard(editor, layer, points);
    const rgba = await editor.engine.colors(index, Float64Array.from(held.flat()));
    return points.map((_, k) => {
      const [r, g, b, opacity] = rgba.subarray(4 * k, 4 * k + 4);
      return opacity > NOTHING && Number.isFinite(r + g + b) ? inBytes({ r, g, b }) : null;
    });
  } catch {
    // Without the engine a curve can still be drawn.
    return null;
  }
}

/** A colour as files say it in short: half a code value at most from what it was. */
function inBytes(color: Rgb): Rgb {
  const { r, g, b } = clampedRgb(color);
  const byte = (channel: number) => Math.round(channel * 255) / 255;
  return { r: byte(r), g: byte(g), b: byte(b) };
}

function reachOf(editor: Editor, layer: Item): number {
  return BESIDE / (editor.view.peek().zoom * (lengthScale(layer.artboardFromItem) || 1));
}

/** The points at a distance left and right of a place on a path. */
function pointsBeside(path: CubicPath, at: number, distance: number): [Point, Point] {
  const [x, y] = pathPointAt(path, at);
  const [nx, ny] = leftOf(pathDirectionAt(path, at) ?? [1, 0]);
  return [
    [x + nx * distance, y + ny * distance],
    [x - nx * distance, y - ny * distance],
  ];
}

/**
 * Returns stops for both sides of a path to be added to a layer. A side with nothing beside it stays open.
 * null: the layer has no colours yet, or the engine does not answer.
 * @param path in the layer's frame
 */
export async function takenSides(
  editor: Editor,
  layer: Item,
  path: CubicPath,
): Promise<Sides<SideValue<Rgb>> | null> {
  const reach = reachOf(editor, layer);
  const length = pathLength(path) * (BESIDE / reach);
  const count = Math.min(MOST, Math.max(FEWEST, Math.ceil(length / APART)));
  const shares = Array.from({ length: count + 1 }, (_, k) => k / count);
  const beside = shares.map((share) => pointsBeside(path, parameterAtFraction(path, share), reach));
  const colors = await colorsAt(editor, layer, [
    ...beside.map(([left]) => left),
    ...beside.map(([, right]) => right),
  ]);
  if (!colors || colors.every((color) => color === null)) return null;
  const sides = [colors.slice(0, shares.length), colors.slice(shares.length)].map((list) =>
    shares.flatMap((offset, k): Stop<Rgb>[] => {
      const value = list[k];
      return value ? [{ offset, value }] : [];
    }),
  );
  const fitted = (lists: readonly (readonly Stop<Rgb>[])[]) =>
    fittedSides(lists, !isOpen(path), editor.drawing.interpolation);
  const [left, right] = areAlike(sides) ? fitted(sides) : sides.flatMap((one) => fitted([one]));
  return { left, right };
}

type Colors = readonly Stop<Rgb>[];

/** Returns whether sides have about the same colours at the same places. */
function areAlike([left, right]: readonly Colors[]): boolean {
  return (
    left.length === right.length &&
    left.every(({ offset, value }, k) => offset === right[k].offset && apart(value, right[k].value) <= ALIKE)
  );
}

/**
 * Returns the stops that are nearest to colours along sides, at the same places: as few as stay within the tolerance, at
 * most MOST_STOPS.
 */
function fittedSides(sides: readonly Colors[], isRing: boolean, space: MixSpace): readonly SideValue<Rgb>[] {
  if (sides[0].length === 0) return sides.map(() => ({ kind: "open" }));
  const known = sides.map((colors) => (isRing ? asRing(colors) : colors));
  const rows = known[0].map(({ offset }, k) => [offset, ...known.flatMap((colors) => axesOf(colors[k].value, space))]);
  const mix = mixer(space);
  let lists: readonly Colors[] = [];
  for (let count = 1; count <= MOST_STOPS; ++count) {
    const graph = nearestGraph(rows, count, isRing);
    lists = known.map((_, side) => {
      const color = (row: readonly number[]) => inBytes(colorOfAxes(row.slice(1 + 3 * side), space));
      return count === 1
        ? [{ offset: 0, value: color(graph[0]) }]
        : graph.map((row) => ({ offset: row[0], value: color(row) }));
    });
    const isNear = lists.every((stops, side) =>
      known[side].every(
        ({ offset, value }) => apart(valueAt({ space: "arc", stops }, offset, mix) as Rgb, value) <= TOLERANCE,
      ),
    );
    if (isNear) break;
  }
  return lists.map((stops) => ({ kind: "stops", space: "arc", stops }));
}

/** Returns colours that end as they begin. If the start has none, the first colour reaches back to it. */
function asRing(colors: Colors): Colors {
  const within = colors.filter(({ offset }) => offset > 0 && offset < 1);
  return [{ ...colors[0], offset: 0 }, ...within, { ...colors[0], offset: 1 }];
}

/** The largest difference between two colours' channels. */
function apart(a: Rgb, b: Rgb): number {
  return Math.max(Math.abs(a.r - b.r), Math.abs(a.g - b.g), Math.abs(a.b - b.b));
}

/** The colours beside one place of a curve; null: there are none. @param at piece + t */
export async function colorsBeside(
  editor: Editor,
  item: CurveItem,
  path: number,
  at: number,
): Promise<Sides<Rgb | null> | null> {
  const layer = outermostLayer(item);
  const inLayer = pathInLayer(item, item.paths[path]);
  const colors = await colorsAt(editor, layer, pointsBeside(inLayer, at, reachOf(editor, layer)));
  if (!colors) return null;
  // A map that mirrors exchanges the sides of the curve.
  const [left, right] = determinant(item.layerFromItem) < 0 ? [colors[1], colors[0]] : colors;
  return { left, right };
}

/** The colour of an item's layer at a point of the artboard; null: there is none. */
export async function colorAt(editor: Editor, item: Item, point: Point): Promise<Rgb | null> {
  const layer = outermostLayer(item);
  const back = inverted(layer.artboardFromItem);
  return back && ((await colorsAt(editor, layer, [mapped(back, point)]))?.[0] ?? null);
}
