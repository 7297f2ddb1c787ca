// Colours that the picture has beside a curve: what a new curve bears, so that nothing changes.
import type { Editor } from "../app/types.js";
import { determinant, inverted, lengthScale, mapped, type Point } from "../geometry/affine.js";
import { clampedRgb, oklabFromRgb, type Rgb } from "../geometry/color.js";
import type { CubicPath } from "../geometry/cubic.js";
import {
  parameterAtFraction,
  pathDirectionAt,
  pathLength,
  pathPointAt,
} from "../geometry/length.js";
import { simplifiedGraph } from "../geometry/simplify.js";
import { leftOf } from "../geometry/vector.js";
import type { CurveItem, Item, SideValue, Stop } from "../model/types.js";
import { pathInLayer } from "./along.js";
import { outermostLayer } from "./hit.js";

/** How far beside the curve colours are sampled, and how far apart, CSS pixels. */
const BESIDE = 1.5;
const APART = 4;
/** Places along a curve, whatever its length. */
const FEWEST = 8;
const MOST = 160;
/** How far stops may be from the colours that they stand for, in OKLab: hardly seen. */
const TOLERANCE = 0.008;
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
  return {
    left: sideOf(shares, colors.slice(0, shares.length)),
    right: sideOf(shares, colors.slice(shares.length)),
  };
}

/** As few stops as stand for colours along a side. */
function sideOf(shares: readonly number[], colors: readonly (Rgb | null)[]): SideValue<Rgb> {
  const stops = shares.flatMap((offset, k): Stop<Rgb>[] => {
    const value = colors[k];
    return value ? [{ offset, value }] : [];
  });
  if (stops.length === 0) return { kind: "open" };
  const rows = stops.map(({ offset, value }) => {
    const { l, a, b } = oklabFromRgb(value);
    return [offset, l, a, b];
  });
  const kept = simplifiedGraph(rows, TOLERANCE).map((k) => stops[k]);
  const isEven = kept.length <= 2 && distance(rows[0], rows[rows.length - 1]) < TOLERANCE;
  return { kind: "stops", space: "arc", stops: isEven ? [{ ...kept[0], offset: 0 }] : kept };
}

function distance(a: readonly number[], b: readonly number[]): number {
  return Math.hypot(a[1] - b[1], a[2] - b[2], a[3] - b[3]);
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
