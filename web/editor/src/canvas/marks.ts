// Everything on the picture that can be taken hold of, in its place on the stage.
import { nameOfSide } from "../app/side-names.js";
import { composed, lengthScale, mapped, type Affine, type Point } from "../geometry/affine.js";
import { nodeCount, pieceCount, type CubicPath } from "../geometry/cubic.js";
import type { Rgb } from "../geometry/color.js";
import { hexOf } from "../geometry/colortext.js";
import { nodePath } from "../geometry/natural.js";
import { nodeOfHandle } from "../geometry/nodes.js";
import type {
  Attribute,
  CurveItem,
  Handle,
  Part,
  Selected,
  Selection,
  Side,
} from "../model/types.js";
import { shownStops } from "../model/seams.js";
import type { PaintKind } from "../model/paint-frames.js";
import * as en from "../strings/en.js";
import { pathInLayer, placesOfStops, standing } from "./along.js";
import { percent, shown } from "./format.js";
import { handlesOf } from "./nodes.js";
import { isSamePart } from "./part.js";
import { kindOn, SIDES, stopsOf, type StopKind, type Stops, type Value } from "./sides.js";

interface MarkBase {
  /** Its middle, and where its stem begins: on the stage, CSS pixels. */
  readonly at: Point;
  readonly foot: Point;
  readonly handle: Handle;
  readonly part: Part;
  readonly isChosen: boolean;
  readonly label: string;
}

export interface NodeMark extends MarkBase {
  readonly kind: "node" | "handle";
}

export interface StopMark extends MarkBase {
  readonly kind: "stop" | "bracket";
  readonly path: number;
  readonly side: Side;
  readonly attribute: StopKind;
  readonly index: number;
  /** Away from the curve, of length 1. */
  readonly normal: Point;
  readonly value: Value;
}

/** A mark of the selection's box: which corner or edge, -1 to 1 across and down. */
export interface BoxMark extends MarkBase {
  readonly kind: "scale" | "turn";
  readonly grip: readonly [number, number];
}

/** A grip of a gradient or a texture. */
export interface PaintMark extends MarkBase {
  readonly kind: "paint";
  readonly part: Part & { readonly kind: "paint" };
  readonly paint: PaintKind;
}

export type Mark = NodeMark | StopMark | BoxMark | PaintMark;

/** How far a stop stands off its curve, and how far apart two at one place are, CSS pixels. */
const STOP_OFF = 18;
const STOP_APART = 16;
/** A bracket of radius 0 is still to be found. */
const BRACKET_OFF = 9;
/** Points of a band for each piece, and for all of a path. */
const ON_BAND = 24;
const MOST_ON_BAND = 480;

export function stageFromItem(stageFromArtboard: Affine, item: CurveItem): Affine {
  return composed(stageFromArtboard, item.artboardFromItem);
}

export function chosenParts(selection: Selection, handle: Handle): readonly Part[] {
  return selection.filter((one) => one.handle === handle).map((one) => one.part);
}

/** Nodes of a curve, and the handles of those chosen and of their pieces. */
export function nodeMarks(item: CurveItem, map: Affine, parts: readonly Part[]): NodeMark[] {
  return item.paths.map(nodePath).flatMap((path, k) => {
    const stage = path.points.map((point) => mapped(map, point));
    return [...handleMarks(item, path, k, stage, parts), ...nodesOnly(item, path, k, stage, parts)];
  });
}

function nodesOnly(
  item: CurveItem,
  path: CubicPath,
  k: number,
  stage: readonly Point[],
  parts: readonly Part[],
): NodeMark[] {
  return Array.from({ length: nodeCount(path) }, (_, index) => {
    const part: Part = { kind: "node", path: k, index };
    const at = stage[3 * index];
    const isChosen = parts.some((one) => isSamePart(one, part));
    return {
      kind: "node",
      at,
      foot: at,
      handle: item.handle,
      part,
      isChosen,
      label: en.canvas.node(index + 1, item.name),
    };
  });
}

/** Control points of handles to show: of each node that is chosen, and the far ones of its pieces. */
function shownHandles(path: CubicPath, k: number, parts: readonly Part[]): Set<number> {
  const shownOnes = new Set<number>();
  for (const part of parts) {
    if ((part.kind !== "node" && part.kind !== "handle") || part.path !== k) continue;
    const node = part.kind === "node" ? part.index : nodeOfHandle(path, part.index);
    const { before, after } = handlesOf(path, node);
    if (before !== null) shownOnes.add(before).add(before - 1);
    if (after !== null) shownOnes.add(after).add(after + 1);
  }
  return shownOnes;
}

function handleMarks(
  item: CurveItem,
  path: CubicPath,
  k: number,
  stage: readonly Point[],
  parts: readonly Part[],
): NodeMark[] {
  return [...shownHandles(path, k, parts)].flatMap((index): NodeMark[] => {
    const node = nodeOfHandle(path, index);
    const [at, foot] = [stage[index], stage[3 * node]];
    // A handle that lies on its node cannot be seen, nor taken.
    if (!at || Math.hypot(at[0] - foot[0], at[1] - foot[1]) < 1) return [];
    const part: Part = { kind: "handle", path: k, index };
    const isChosen = parts.some((one) => isSamePart(one, part));
    const label = en.canvas.handle(node + 1, index % 3 === 2 ? "start" : "end");
    return [{ kind: "handle", at, foot, handle: item.handle, part, isChosen, label }];
  });
}

/** The stops of a curve for an attribute, on both sides of each of its subpaths. */
export function stopMarks(
  item: CurveItem,
  map: Affine,
  attribute: Attribute,
  parts: readonly Part[],
): StopMark[] {
  const kind = kindOn(item, attribute);
  if (!kind) return [];
  return SIDES.flatMap((side) => {
    const list = stopsOf(item, side, kind);
    return list
      ? item.paths.flatMap((path, k) => sideMarks(item, path, k, map, side, kind, list, parts))
      : [];
  });
}

function sideMarks(
  item: CurveItem,
  path: CubicPath,
  k: number,
  map: Affine,
  side: Side,
  kind: StopKind,
  list: Stops<Value>,
  parts: readonly Part[],
): StopMark[] {
  const places = placesOfStops(pathInLayer(item, path), list);
  const isBracket = kind === "blur" || kind === "radius";
  return list.stops.slice(0, shownStops(item, list)).map(({ value }, index) => {
    const { foot, normal } = standing(path, map, places[index], side === "left" ? 1 : -1);
    const off = isBracket ? Math.max(BRACKET_OFF, Number(value) * lengthScale(map)) : STOP_OFF;
    // Two at one place, a hard step, stand side by side.
    const slide = isBracket ? 0 : slideOf(list, index);
    const sign = side === "left" ? -1 : 1;
    const along: Point = [normal[1] * sign, -normal[0] * sign];
    const part: Part = { kind: "stop", side, attribute: kind, index };
    return {
      kind: isBracket ? "bracket" : "stop",
      at: [
        foot[0] + normal[0] * off + along[0] * slide,
        foot[1] + normal[1] * off + along[1] * slide,
      ],
      foot,
      normal,
      path: k,
      side,
      attribute: kind,
      index,
      value,
      handle: item.handle,
      part,
      isChosen: parts.some((one) => isSamePart(one, part)),
      label: stopLabel(item, side, kind, list, index),
    };
  });
}

function slideOf(list: Stops<Value>, index: number): number {
  const { offset } = list.stops[index];
  if (list.stops[index + 1]?.offset === offset) return -STOP_APART / 2;
  return list.stops[index - 1]?.offset === offset ? STOP_APART / 2 : 0;
}

function stopLabel(item: CurveItem, side: Side, kind: StopKind, list: Stops<Value>, index: number): string {
  const { offset, value } = list.stops[index];
  const name = nameOfSide(item, side);
  const place =
    list.space === "arc" ? en.canvas.offset(percent(offset)) : en.canvas.segment(shown(offset));
  if (kind === "blur" || kind === "radius")
    return en.canvas.bracket(kind, name, shown(Number(value)), place);
  const said = kind === "color" ? hexOf(value as Rgb) : en.canvas.opacity(percent(Number(value)));
  return en.canvas.stop(name, index + 1, shownStops(item, list), said, place);
}

/** The blur's or radius's edge along a side of a path, as points of the stage. */
export function bandOf(
  item: CurveItem,
  path: CubicPath,
  map: Affine,
  side: Side,
  list: Stops<Value>,
): Point[] {
  const at = placesOfStops(pathInLayer(item, path), list);
  const scale = lengthScale(map);
  const samples = Math.min(MOST_ON_BAND, ON_BAND * pieceCount(path));
  return Array.from({ length: samples + 1 }, (_, k) => {
    const here = (k / samples) * pieceCount(path);
    const after = at.findIndex((one) => one > here);
    const radius = radiusAt(list, at, after, here) * scale;
    const { foot, normal } = standing(path, map, here, side === "left" ? 1 : -1);
    return [foot[0] + normal[0] * radius, foot[1] + normal[1] * radius] as const;
  });
}

function radiusAt(list: Stops<Value>, at: readonly number[], after: number, here: number): number {
  const value = (k: number) => Number(list.stops[k].value);
  if (after < 0) return value(list.stops.length - 1);
  if (after === 0) return value(0);
  return (
    value(after - 1) +
    ((value(after) - value(after - 1)) * (here - at[after - 1])) / (at[after] - at[after - 1])
  );
}

/** Returns the selection that results from selecting a mark. */
export function selectedOf(mark: Mark): Selected {
  return { handle: mark.handle, part: mark.part };
}
