// Gestures with stops, which several tools share: along the curve, across it, new ones.
import { lengthScale, type Point } from "../../geometry/affine.js";
import { offsetOfPlace, placeOfOffset } from "../../geometry/length.js";
import { endOffset, isRing } from "../../model/seams.js";
import type { CurveItem, Drawing, Outcome, Side, SideValue, StopSpace } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { nearestAt, pathInLayer, standing } from "../along.js";
import type { Canvas } from "../canvas.js";
import { blurCursor } from "../cursors.js";
import { setSide } from "../edits.js";
import { colorsBeside } from "../taken.js";
import { shown } from "../format.js";
import { REACH } from "../hit.js";
import { stageFromItem, type StopMark } from "../marks.js";
import { isCurve } from "../places.js";
import {
  mixer,
  sideValue,
  stopsOf,
  valueAt,
  withOffset,
  withStop,
  withValue,
  type StopKind,
  type Value,
} from "../sides.js";
import { EditDrag, type Drag, type Press } from "./tool.js";

/** A stop of the drawing as it was when a gesture began. */
function curveOf(drawing: Drawing, mark: StopMark): CurveItem | null {
  const item = drawing.item(mark.handle);
  return isCurve(item) ? item : null;
}

/** Takes hold of a stop: along the curve it changes its offset; a bracket also its radius. */
export function dragStop(canvas: Canvas, mark: StopMark, start: Press): Drag {
  const { editor } = canvas;
  const isBracket = mark.kind === "bracket";
  return new EditDrag(canvas, start, {
    label: isBracket ? labelOf(mark.attribute) : en.tools.undo.moveStop,
    dragged: { handle: mark.handle, part: mark.part },
    cursor: isBracket ? blurCursor(Math.atan2(mark.normal[1], mark.normal[0])) : "stop",
    make: (p, before) =>
      isBracket ? pulledBracket(canvas, mark, p, before) : slidStop(canvas, mark, p, before),
    click: (p) => {
      if (p.clicks >= 2 && mark.attribute === "color") {
        editor.picker.value = { handle: mark.handle, side: mark.side, stops: [mark.index] };
      }
    },
    kept: () => {
      const now = canvas.marks
        .peek()
        .find((one) => one.handle === mark.handle && one.isChosen && one.kind === mark.kind);
      if (now) editor.announcement.value = now.label;
    },
  });
}

function labelOf(kind: StopKind): string {
  return kind === "radius" ? en.tools.undo.radius : en.tools.undo.blur;
}

function slidStop(canvas: Canvas, mark: StopMark, p: Press, before: Drawing): Outcome | null {
  const item = curveOf(before, mark);
  const list = item && stopsOf(item, mark.side, mark.attribute);
  if (!item || !list) return null;
  const offset = offsetUnder(canvas, item, mark.path, list.space, p.at);
  const value = withOffset(list, mark.index, offset, ringEnd(item, list.space));
  return setSide(before, item, mark.side, mark.attribute, value);
}

/** The offset of a closed curve's end; null: the curve is open. */
function ringEnd(item: CurveItem, space: StopSpace): number | null {
  return isRing(item) ? endOffset(item, space) : null;
}

/** The offset of the place on a subpath that is nearest to a point of the stage. */
function offsetUnder(
  canvas: Canvas,
  item: CurveItem,
  path: number,
  space: StopSpace,
  at: Point,
): number {
  const { at: place } = nearestAt(
    item.paths[path],
    stageFromItem(canvas.stageFromArtboard(), item),
    at,
  );
  return offsetOfPlace(pathInLayer(item, item.paths[path]), space, place);
}

/** Radii smaller than this many pixels of the stage are 0: sharp has to be easy to reach. */
const SHARP = 2;

/**
 * A bracket follows the pointer across the curve, which is its radius; with Alt along it as well.
 * With Shift both sides change.
 */
function pulledBracket(canvas: Canvas, mark: StopMark, p: Press, before: Drawing): Outcome | null {
  const item = curveOf(before, mark);
  const list = item && stopsOf(item, mark.side, mark.attribute);
  if (!item || !list) return null;
  const reach =
    (p.at[0] - mark.foot[0]) * mark.normal[0] + (p.at[1] - mark.foot[1]) * mark.normal[1];
  const radius = radiusFor(
    canvas,
    item,
    p.alt
      ? nearestAt(item.paths[mark.path], stageFromItem(canvas.stageFromArtboard(), item), p.at)
          .distance
      : reach,
  );
  let value = withValue(list, mark.index, radius);
  if (p.alt && value.kind === "stops") {
    const offset = offsetUnder(canvas, item, mark.path, list.space, p.at);
    value = withOffset(value, mark.index, offset, ringEnd(item, list.space));
  }
  tellRadius(canvas, mark.attribute, radius, p);
  return setSide(before, item, mark.side, mark.attribute, value, p.shift);
}

/** A reach on the stage as a radius of the element. */
function radiusFor(canvas: Canvas, item: CurveItem, reach: number): number {
  if (!(reach > SHARP)) return 0;
  const { editor } = canvas;
  const step = editor.step(item);
  const radius = reach / lengthScale(stageFromItem(canvas.stageFromArtboard(), item));
  return step > 0 ? Math.round(radius / step) * step : radius;
}

function tellRadius(canvas: Canvas, kind: StopKind, radius: number, p: Press): void {
  const text =
    kind === "radius" ? en.canvas.radiusTag(shown(radius)) : en.canvas.blurTag(shown(radius));
  canvas.draw({ tag: { at: p.at, text } });
}

/** A place on a curve, and on which side of it the pointer is. */
export interface OnSide {
  readonly item: CurveItem;
  readonly path: number;
  readonly at: number;
  readonly side: Side;
  readonly distance: number;
}

/** Where beside a chosen curve the pointer is. */
export function beside(canvas: Canvas, item: CurveItem, p: Press): OnSide {
  const map = stageFromItem(canvas.stageFromArtboard(), item);
  const all = item.paths.map((path, k) => ({ ...nearestAt(path, map, p.at), path: k }));
  const { at, path, distance } = all.reduce((best, one) =>
    one.distance < best.distance ? one : best,
  );
  const { foot, normal } = standing(item.paths[path], map, at, 1);
  const isLeft = (p.at[0] - foot[0]) * normal[0] + (p.at[1] - foot[1]) * normal[1] >= 0;
  return { item, path, at, side: isLeft ? "left" : "right", distance };
}

/**
 * Pulls the blur of a side away from the curve: a stop there, near or new, takes the radius; with Shift on
 * both sides. On a local curve it is the radius of influence.
 */
export function pullBlur(canvas: Canvas, from: OnSide, start: Press): Drag {
  const { item } = from;
  const kind: StopKind = item.kind === "stroke" ? "radius" : "blur";
  return new EditDrag(canvas, start, {
    label: labelOf(kind),
    dragged: { handle: item.handle, part: { kind: "whole" } },
    cursor: "stop",
    make: (p, before) => {
      const now = before.item(item.handle);
      return isCurve(now) ? pulledBlur(canvas, before, { ...from, item: now }, kind, p) : null;
    },
    kept: () => {
      canvas.editor.announcement.value =
        canvas.marks.peek().find((mark) => mark.handle === item.handle)?.label ?? "";
    },
  });
}

/** Pressed on the curve itself, the side is that to which it is pulled. */
function pulledBlur(
  canvas: Canvas,
  before: Drawing,
  { item, path, at, side, distance }: OnSide,
  kind: StopKind,
  p: Press,
): Outcome | null {
  const map = stageFromItem(canvas.stageFromArtboard(), item);
  const { foot, normal } = standing(item.paths[path], map, at, 1);
  const leftwards = (p.at[0] - foot[0]) * normal[0] + (p.at[1] - foot[1]) * normal[1];
  const isOnCurve = distance <= REACH[p.kind].curve;
  const pulled = isOnCurve ? (leftwards >= 0 ? "left" : "right") : side;
  const radius = radiusFor(canvas, item, pulled === "left" ? leftwards : -leftwards);
  tellRadius(canvas, kind, radius, p);
  const value = blurWith(canvas, item, path, pulled, kind, at, radius);
  return setSide(before, item, pulled, kind, value, p.shift);
}

/** A stop nearer than this along the curve is the one that is meant, CSS pixels. */
const SAME_STOP = 14;

function blurWith(
  canvas: Canvas,
  item: CurveItem,
  path: number,
  side: Side,
  kind: StopKind,
  at: number,
  radius: number,
): SideValue<Value> {
  const list = stopsOf(item, side, kind);
  // Where there was no blur, all of the side gets the radius.
  if (!list) return { kind: "stops", space: "arc", stops: [{ offset: 0, value: radius }] };
  const inLayer = pathInLayer(item, item.paths[path]);
  const map = stageFromItem(canvas.stageFromArtboard(), item);
  const [x, y] = standing(item.paths[path], map, at, 1).foot;
  if (list.stops.length === 1) return withValue(list, 0, radius);
  const near = list.stops.findIndex((stop) => {
    const foot = standing(
      item.paths[path],
      map,
      placeOfOffset(inLayer, list.space, stop.offset),
      1,
    ).foot;
    return Math.hypot(foot[0] - x, foot[1] - y) < SAME_STOP;
  });
  if (near >= 0) return withValue(list, near, radius);
  return withStop(list, offsetOfPlace(inLayer, list.space, at), radius).value;
}

/** Stops stand in a strip beside the curve: a click there makes one, CSS pixels. */
const STRIP = { from: 9, to: 27 };

/** Where in the strip beside the primary curve the pointer is, and a stop could be made; else null. */
export function inStrip(canvas: Canvas, p: Press): OnSide | null {
  const item = canvas.primaryCurve();
  const kind = item && stripKind(canvas, item);
  if (!item || !kind || item.paths.length === 0) return null;
  const on = beside(canvas, item, p);
  if (on.distance < STRIP.from || on.distance > STRIP.to) return null;
  const value = sideValue(item, on.side, kind);
  return value.kind === "stops" || value.kind === "open" ? on : null;
}

/** Blur stands at its radius, so that it has no strip. */
function stripKind(canvas: Canvas, item: CurveItem): "color" | "opacity" | null {
  const attribute = canvas.attribute();
  return attribute === "blur" || (attribute === "opacity" && item.kind === "stroke")
    ? null
    : attribute;
}

/** A new stop with the value that is there, so that the picture stays. */
export async function addStop(canvas: Canvas, on: OnSide, kind: StopKind): Promise<void> {
  const { editor } = canvas;
  const list = stopsOf(on.item, on.side, kind);
  const inLayer = pathInLayer(on.item, on.item.paths[on.path]);
  const offset = offsetOfPlace(inLayer, list?.space ?? "arc", on.at);
  const value = list
    ? valueAt(list, offset, mixer(editor.drawing.interpolation))
    : await newValue(canvas, on, kind);
  // The curve may have been deleted, or have got stops, while the colour was fetched.
  const item = editor.drawing.item(on.item.handle);
  if (!isCurve(item) || value === null) return;
  const now = stopsOf(item, on.side, kind) ?? { space: "arc" as const, stops: [] };
  const made = withStop(now, offset, value);
  if (!editor.run(en.tools.undo.addStop, setSide(editor.drawing, item, on.side, kind, made.value)))
    return;
  const part = { kind: "stop", side: on.side, attribute: kind, index: made.index } as const;
  editor.selection.value = [{ handle: item.handle, part }];
}

async function newValue(canvas: Canvas, on: OnSide, kind: StopKind): Promise<Value | null> {
  if (kind === "opacity") return 1;
  if (kind !== "color") return 0;
  return (await colorsBeside(canvas.editor, on.item, on.path, on.at))?.[on.side] ?? null;
}
