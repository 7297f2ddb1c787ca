// Edits of what is chosen on the canvas: stops, nodes, and moves by the keyboard.
import type { Editor } from "../app/types.js";
import {
  inverted,
  mappedVector,
  translation,
  type Affine,
  type Point,
} from "../geometry/affine.js";
import type { Rgb } from "../geometry/color.js";
import {
  deleteNodes,
  moveNodes,
  movePaint,
  setBoth,
  setColor,
  setNodeKind,
  setNumbers,
  setSideOpacity,
  setPath,
  setRadius,
  together,
  transform,
  type NodeKind,
  type NodesBySubpath,
} from "../model/commands/index.js";
import type {
  CurveItem,
  Drawing,
  Handle,
  Outcome,
  Part,
  Selected,
  Side,
  SideValue,
} from "../model/types.js";
import { gripPlace } from "../model/paint-frames.js";
import { takeInHandle } from "../app/handles.js";
import { deleteStop, withoutStops } from "../app/stops.js";
import * as en from "../strings/en.js";
import { pathInLayer } from "./along.js";
import { movable } from "./box.js";
import { withHandle } from "./nodes.js";
import { isCurve, isOutOfReach, type Reach } from "./places.js";
import { sideValue, stopsOf, withOffset, type StopKind, type Value } from "./sides.js";
import { mappedPath } from "../geometry/cubic.js";
import { nodePath } from "../geometry/natural.js";
import { offsetOfPlace, pathLength, placeOfOffset } from "../geometry/length.js";

/** Gives a side a value; of blur, to both sides at once where `isBoth`. */
export function setSide(
  drawing: Drawing,
  item: CurveItem,
  side: Side,
  kind: StopKind,
  value: SideValue<Value>,
  isBoth = false,
): Outcome | null {
  const { handle } = item;
  if (kind === "color") return setColor(drawing, handle, side, value as SideValue<Rgb>);
  const numbers = value as SideValue<number>;
  if (kind === "radius") return setRadius(drawing, handle, numbers);
  // Only sf:blur serves the sides of a local curve.
  if (isBoth || item.kind === "stroke") return setBoth(drawing, handle, kind, numbers);
  if (kind === "opacity") return setSideOpacity(drawing, handle, side, numbers);
  return setNumbers(drawing, handle, side, kind, numbers);
}

/** Chosen nodes by curve and subpath. */
function nodesOf(selection: readonly Selected[]): Map<Handle, Map<number, number[]>> {
  const nodes = new Map<Handle, Map<number, number[]>>();
  for (const { handle, part } of selection) {
    if (part.kind !== "node") continue;
    const paths = nodes.get(handle) ?? new Map<number, number[]>();
    nodes.set(handle, paths.set(part.path, [...(paths.get(part.path) ?? []), part.index]));
  }
  return nodes;
}

/** A command for the chosen nodes of each curve, as one outcome. */
function forNodes(
  reach: Reach,
  selection: readonly Selected[],
  make: (item: CurveItem, nodes: NodesBySubpath) => Outcome | null,
): Outcome | null {
  const outcomes: (Outcome | null)[] = [];
  for (const [handle, nodes] of nodesOf(selection)) {
    const item = reach.drawing.item(handle);
    if (isCurve(item) && !isOutOfReach(reach, item)) outcomes.push(make(item, nodes));
  }
  return outcomes.length > 0 ? together(outcomes) : null;
}

/** Moves the chosen nodes, with their handles. @param by artboard units */
export function movedNodes(
  reach: Reach,
  selection: readonly Selected[],
  by: Point,
  step: (item: CurveItem) => number,
): Outcome | null {
  return forNodes(reach, selection, (item, nodes) => {
    const back = inverted(item.artboardFromItem);
    return back && moveNodes(reach.drawing, item.handle, nodes, mappedVector(back, by), step(item));
  });
}

export function setKinds(editor: Editor, kind: NodeKind): boolean {
  const made = forNodes(editor, editor.selection.peek(), (item, nodes) =>
    setNodeKind(editor.drawing, item.handle, nodes, kind, editor.step(item)),
  );
  return editor.run(en.tools.undo.kind, made);
}

/**
 * Takes away chosen stops, else chosen nodes; a handle goes back into its node.
 * @returns false where the whole of something is meant
 */
export function deleteParts(editor: Editor): boolean {
  const selection = editor.selection.peek();
  const primary = selection.at(-1);
  // A gradient has its ends wherever they are.
  if (primary?.part.kind === "paint") return isShown(editor, primary.handle, primary.part);
  if (primary?.part.kind === "handle") {
    const item = editor.drawing.item(primary.handle);
    if (item && !isOutOfReach(editor, item)) takeInHandle(editor, primary.handle, primary.part);
    return true;
  }
  const stops = selection.filter(({ part }) => part.kind === "stop");
  if (stops.length > 0) {
    const handle = stops[stops.length - 1].handle;
    deleteStops(
      editor,
      handle,
      stops.filter((one) => one.handle === handle).map(({ part }) => part),
    );
    return true;
  }
  if (!selection.some(({ part }) => part.kind === "node")) return false;
  const whole = selection.map(({ handle }): Selected => ({ handle, part: { kind: "whole" } }));
  const made = forNodes(editor, selection, (item, nodes) =>
    deleteNodes(editor.drawing, item.handle, nodes, editor.step(item)),
  );
  if (editor.run(en.tools.undo.deleteNodes, made)) {
    const alive = new Map(
      whole.filter(({ handle }) => editor.drawing.item(handle)).map((one) => [one.handle, one]),
    );
    editor.selection.value = [...alive.values()];
  }
  return true;
}

/** Whether there is a grip: what the side shows may have changed since it was chosen. */
function isShown(editor: Editor, handle: Handle, part: Part & { kind: "paint" }): boolean {
  const item = editor.drawing.item(handle);
  return isCurve(item) && gripPlace(editor.drawing, item, part.side, part.attribute, part.grip) !== null;
}

function deleteStops(editor: Editor, handle: Handle, parts: readonly Part[]): void {
  const item = editor.drawing.item(handle);
  const primary = parts[parts.length - 1];
  if (!isCurve(item) || isOutOfReach(editor, item) || primary?.kind !== "stop") return;
  const { side, attribute } = primary;
  const list = stopsOf(item, side, attribute);
  const taken = (outcome: Outcome | null) => {
    if (editor.run(en.tools.undo.deleteStops, outcome))
      editor.selection.value = [{ handle, part: { kind: "whole" } }];
  };
  // The stop belongs to a gradient, whose stops are not on the canvas.
  if (!list) return taken(deleteStop(editor.drawing, item, primary));
  const gone = parts.flatMap((part) =>
    part.kind === "stop" && part.side === side && part.attribute === attribute ? [part.index] : [],
  );
  const value = withoutStops(item, sideValue(item, side, attribute), gone);
  // A local curve without a radius would be none.
  if (!value || (attribute === "radius" && value.kind === "open")) return;
  taken(setSide(editor.drawing, item, side, attribute, value));
}

/**
 * Moves the chosen part by pixels of the stage: a stop along its curve, a handle, a grip of a paint, nodes,
 * or whole items. Steps that follow each other quickly are one step of undo.
 * @returns false where nothing can be moved
 */
export function nudge(editor: Editor, [dx, dy]: Point): boolean {
  const selection = editor.selection.peek();
  const primary = selection[selection.length - 1];
  if (!primary) return false;
  const { zoom } = editor.view.peek();
  const by: Point = [dx / zoom, dy / zoom];
  const item = editor.drawing.item(primary.handle);
  const { part } = primary;
  if (part.kind === "stop" || part.kind === "handle") {
    if (!isCurve(item) || isOutOfReach(editor, item)) return false;
    const made =
      part.kind === "stop"
        ? nudgedStop(editor, item, part, dx - dy)
        : nudgedHandle(editor, item, part, by);
    return editor.run(
      part.kind === "stop" ? en.tools.undo.moveStop : en.tools.undo.moveHandle,
      made,
      "nudge",
    );
  }
  if (part.kind === "paint") {
    if (!isCurve(item) || isOutOfReach(editor, item)) return false;
    return editor.run(en.tools.undo.movePaint, nudgedPaint(editor, item, part, by), "nudge");
  }
  if (part.kind === "node") {
    const made = movedNodes(editor, selection, by, (curve) => editor.step(curve));
    return editor.run(en.tools.undo.moveNodes, made, "nudge");
  }
  const handles = movable(editor).map(({ handle }) => handle);
  if (handles.length === 0) return false;
  const made = transform(editor.drawing, handles, translation(...by), editor.step(null));
  return editor.run(en.tools.undo.move, made, "nudge");
}

/** Right and up lead on along the curve. @param pixels of the stage */
function nudgedStop(
  editor: Editor,
  item: CurveItem,
  part: Part & { kind: "stop" },
  pixels: number,
): Outcome | null {
  const list = stopsOf(item, part.side, part.attribute);
  const path = item.paths[0];
  if (!list || !list.stops[part.index] || !path) return null;
  const inLayer = pathInLayer(item, path);
  const length = pathLength(mappedPath(item.artboardFromItem, path)) * editor.view.peek().zoom;
  const share = offsetOfPlace(
    inLayer,
    "arc",
    placeOfOffset(inLayer, list.space, list.stops[part.index].offset),
  );
  const at = placeOfOffset(
    inLayer,
    "arc",
    Math.min(1, Math.max(0, share + pixels / Math.max(length, 1))),
  );
  const value = withOffset(list, part.index, offsetOfPlace(inLayer, list.space, at), null);
  return setSide(editor.drawing, item, part.side, part.attribute, value);
}

function nudgedHandle(
  editor: Editor,
  item: CurveItem,
  part: Part & { kind: "handle" },
  by: Point,
): Outcome | null {
  const path = item.paths[part.path] && nodePath(item.paths[part.path]);
  const back = inverted(item.artboardFromItem);
  const from = path?.points[part.index];
  if (!back || !from) return null;
  const to = plus(from, mappedVector(back, by));
  return setPath(
    editor.drawing,
    item.handle,
    part.path,
    withHandle(path, part.index, to, false),
    editor.step(item),
  );
}

function nudgedPaint(
  editor: Editor,
  item: CurveItem,
  { side, attribute, grip }: Part & { kind: "paint" },
  by: Point,
): Outcome | null {
  const { drawing } = editor;
  const from = gripPlace(drawing, item, side, attribute, grip);
  const back = inverted(item.artboardFromItem);
  if (!back || !from) return null;
  const to = plus(from, mappedVector(back, by));
  return movePaint(drawing, item.handle, side, attribute, grip, to, editor.step(item));
}

export function plus(a: Point, b: Point): Point {
  return [a[0] + b[0], a[1] + b[1]];
}

/** A vector of the stage in an item's coordinates. */
export function itemVector(item: CurveItem, stageFromArtboard: Affine, by: Point): Point | null {
  const zoom = stageFromArtboard[0];
  const back = inverted(item.artboardFromItem);
  return back && mappedVector(back, [by[0] / zoom, by[1] / zoom]);
}
