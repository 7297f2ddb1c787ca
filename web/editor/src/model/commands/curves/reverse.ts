// Curves that run the other way, and look as before.
import { readPath, reversedData } from "../../../geometry/path.js";
import { attributeOf, patchOf, sf } from "../../../source/attributes.js";
import { encodeValue } from "../../../source/entities.js";
import type { Edit } from "../../../source/patch.js";
import type { ElementNode } from "../../../source/tree.js";
import type { CurveItem, Drawing, Handle, Outcome } from "../../types.js";
import { dataEdits } from "../data-edits.js";
import { onlySubpaths, partedElement } from "../structure/parting.js";
import { curveOf, dataOf } from "./shape-edit.js";
import { editedLists, segmentCount, type ListEdit } from "../paint/stop-follow.js";

const OTHER_SIDE: Readonly<Record<string, string>> = {
  left: "right",
  right: "left",
  "left-opacity": "right-opacity",
  "right-opacity": "left-opacity",
  "left-blur": "right-blur",
  "right-blur": "left-blur",
};

/** Offsets counted from the other end. */
const mirroredIn =
  (segments: number): ListEdit =>
  (side) => {
    const end = side.space === "arc" ? 1 : segments;
    const stops = side.stops.map((stop) => ({ ...stop, offset: end - stop.offset })).reverse();
    return side.stops.length > 1 ? { ...side, stops } : null;
  };

/** Exchanges the attributes of the two sides, in place. */
function sideEdits(text: string, element: ElementNode, lists: ReadonlyMap<string, string>): Edit[] {
  const names = [...Object.keys(OTHER_SIDE), "opacity", "blur", "radius"];
  return names.flatMap((name) => {
    const attribute = attributeOf(element, sf(name));
    if (!attribute) return [];
    const { start } = attribute.range;
    const edits: Edit[] = [];
    const other = OTHER_SIDE[name];
    if (other) {
      const prefix = attribute.name.slice(0, attribute.name.length - name.length);
      edits.push({ at: start, removed: attribute.name, inserted: prefix + other });
    }
    const list = lists.get(name);
    if (list !== undefined && list !== attribute.value) {
      const { start: at, end } = attribute.valueRange;
      const removed = text.slice(at, end);
      edits.push({ at, removed, inserted: encodeValue(list, attribute.quote) });
    }
    return edits;
  });
}

function reversed(drawing: Drawing, { element, paths }: CurveItem, step: number): Edit[] {
  const data = reversedData(dataOf(drawing, element), step);
  if (data === null || readPath(data).length !== paths.length) return [];
  const counts = paths.map(segmentCount);
  const [first] = counts;
  const lists = new Map(
    counts.map(
      (count) => [count, editedLists(drawing, element, count, mirroredIn(count))] as const,
    ),
  );
  const listsOf = (count: number) => lists.get(count) ?? new Map<string, string>();
  // Offsets "@" from the other end are others where a subpath has more segments.
  const odd = [...lists.keys()].filter((count) => !isSameFor(listsOf(count), listsOf(first)));
  const part = (count: number, isIn: (index: number) => boolean) => ({
    data: onlySubpaths(data, isIn, step),
    edits: sideEdits(drawing.text, element, listsOf(count)),
  });
  const own = part(first, (i) => !odd.includes(counts[i]));
  if (odd.length === 0) return [...dataEdits(drawing.text, element, own.data, true), ...own.edits];
  const others = odd.map((count) => part(count, (i) => counts[i] === count));
  return partedElement(drawing, element, own, others).edits;
}

function isSameFor(a: ReadonlyMap<string, string>, b: ReadonlyMap<string, string>): boolean {
  return [...a].every(([name, text]) => b.get(name) === text);
}

/**
 * Reverses the direction of curves: sides change places and offsets run backwards, so that the
 * picture stays.
 */
export function reverseCurves(
  drawing: Drawing,
  handles: readonly Handle[],
  step: number,
): Outcome | null {
  const curves = [...new Set(handles)].flatMap((handle) => curveOf(drawing, handle) ?? []);
  const edits = curves.flatMap((item) =>
    item.paths.length > 0 ? reversed(drawing, item, step) : [],
  );
  return edits.length > 0 ? { patch: patchOf(edits) } : null;
}
