// Curves that are cut at their nodes.
import { mappedPath, pieceCount, type CubicPath } from "../../../geometry/cubic.js";
import { parameterAtSegment } from "../../../geometry/length.js";
import { nodePath, placeOnNodePath } from "../../../geometry/natural.js";
import { writePath } from "../../../geometry/path.js";
import { partOf, shareAtNode, stretchesOf, type Stretch } from "../../../geometry/stretches.js";
import { setAttribute, sf } from "../../../source/attributes.js";
import type { CurveItem, Drawing, Handle, Outcome, Stop } from "../../types.js";
import { Draft } from "./draft.js";
import { editedLists, segmentCount, type ListEdit, type Mix } from "../paint/stop-follow.js";
import { onlySubpaths, partedElement, type ElementPart } from "../structure/parting.js";
import { curveOf, dataOf, type NodesBySubpath } from "./shape-edit.js";

/** Returns the value at a place: behind a hard step there, or before it. */
function valueAt<Value>(
  stops: readonly Stop<Value>[],
  at: number,
  isBehind: boolean,
  mix: Mix<Value>,
): Value {
  const next = stops.findIndex(({ offset }) => (isBehind ? offset > at : offset >= at));
  const [a, b] = [stops[next - 1], stops[next]];
  if (next < 0) return stops[stops.length - 1].value;
  return a ? mix(a.value, b.value, (at - a.offset) / (b.offset - a.offset)) : b.value;
}

const isAlike = (a: unknown, b: unknown) => JSON.stringify(a) === JSON.stringify(b);

/**
 * Returns the stops of a part, from 0 to 1.
 * @param period the offset of the end, where a closed curve begins again
 */
function cutStops<Value>(
  stops: readonly Stop<Value>[],
  { from, to }: Stretch,
  period: number,
  mix: Mix<Value>,
): Stop<Value>[] {
  const lap = [
    { offset: 0, value: stops[0].value },
    ...stops,
    { offset: period, value: stops[stops.length - 1].value },
  ];
  const all = [...lap, ...lap.map(({ offset, value }) => ({ offset: offset + period, value }))];
  const list = [
    { offset: from, value: valueAt(all, from, true, mix) },
    ...all.filter(({ offset }) => offset > from && offset < to),
    { offset: to, value: valueAt(all, to, false, mix) },
  ].map(({ offset, value }) => ({ offset: (offset - from) / (to - from), value }));
  if (list.every(({ value }) => isAlike(value, list[0].value))) return list.slice(0, 1);
  // A stop between two of its value says nothing.
  const isNeeded = ({ value }: Stop<Value>, i: number) =>
    i === 0 || i === list.length - 1 || !isAlike(value, list[i - 1].value) || !isAlike(value, list[i + 1].value);
  return list.filter(isNeeded);
}

/** A part of a subpath as an element: its data, and its lists. */
function elementPart(
  drawing: Drawing,
  { element, layerFromItem }: CurveItem,
  path: CubicPath,
  stretch: Stretch,
  step: number,
): ElementPart {
  const nodes = nodePath(path);
  const inLayer = mappedPath(layerFromItem, nodes);
  const pieces = stretch.to - stretch.from;
  const shares = { from: shareAtNode(inLayer, stretch.from), to: shareAtNode(inLayer, stretch.to) };
  const edit: ListEdit = (side, mix) => {
    if (side.space === "arc") return { ...side, stops: cutStops(side.stops, shares, 1, mix) };
    const places = side.stops.map((stop) => ({
      ...stop,
      offset: placeOnNodePath(path, parameterAtSegment(path, stop.offset)),
    }));
    const cut = cutStops(places, stretch, pieceCount(nodes), mix);
    return { ...side, stops: cut.map((stop) => ({ ...stop, offset: stop.offset * pieces })) };
  };
  const texts = editedLists(drawing, element, segmentCount(path), edit);
  return {
    data: writePath(partOf(nodes, stretch), step),
    edits: [...texts].flatMap(([name, text]) => setAttribute(drawing.text, element, sf(name), text)),
  };
}

/**
 * Cuts a curve at nodes. A closed subpath with one cut becomes open there. Otherwise each part becomes a
 * curve, with its part of the colours, and all of them are selected. null: no node cuts it.
 */
export function cutCurve(d: Drawing, h: Handle, nodes: NodesBySubpath, step: number): Outcome | null {
  const item = curveOf(d, h);
  if (!item) return null;
  const { element, paths } = item;
  const parts: ElementPart[] = [];
  const whole = new Set(paths.keys());
  for (const [index, cuts] of nodes) {
    const path = paths[index];
    const stretches = path ? stretchesOf(nodePath(path), cuts) : [];
    if (stretches.length > 0) whole.delete(index);
    parts.push(...stretches.map((stretch) => elementPart(d, item, path, stretch, step)));
  }
  const [first, ...rest] = parts;
  if (!first) return null;
  const isKept = whole.size > 0;
  const kept = { data: onlySubpaths(dataOf(d, element), (i) => whole.has(i), step), edits: [] };
  const made = partedElement(d, element, isKept ? kept : first, isKept ? parts : rest);
  const draft = new Draft(d.text);
  draft.add(made.edits);
  const behind = made.edits[made.edits.length - 1];
  if (!isKept) draft.selectAt(element.range.start);
  for (const offset of made.copyOffsets) draft.selectWithin(behind, offset);
  return draft.outcome();
}
