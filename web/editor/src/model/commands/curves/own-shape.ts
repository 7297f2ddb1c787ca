// Makes shapes of closed curves: each alone in its layer, and transparent outside.
import { composed, determinant, inverted } from "../../../geometry/affine.js";
import type { Rgb } from "../../../geometry/color.js";
import type { Edit } from "../../../source/patch.js";
import { ownTransform } from "../../building.js";
import { filledSides, insideOf } from "../../sides.js";
import type { CurveItem, Drawing, Handle, Item, Outcome, SideValue } from "../../types.js";
import { setColor, setNumbers, setSideOpacity } from "../attributes.js";
import { finestStep, reframing, setTransform } from "../mapping.js";
import { innerFrame, isShown, layerOf, outerFrame } from "../structure/items.js";
import { removalsOf } from "../structure/layout.js";
import { newLayer, placeAbove, type Place } from "../structure/places.js";
import { curvesOf } from "../structure/together.js";
import { Draft } from "./draft.js";

const constant = (value: number): SideValue<number> => ({
  kind: "stops",
  space: "arc",
  stops: [{ offset: 0, value }],
});

/** Returns the closed curves of layers among these items and within them, in the order of the text. */
export function closedCurves(d: Drawing, handles: readonly Handle[]): readonly CurveItem[] {
  const selection = handles.map((handle) => ({ handle, part: { kind: "whole" } as const }));
  return curvesOf(d, selection)
    .map((handle) => d.item(handle))
    .filter((item): item is CurveItem => item?.kind === "curve" && insideOf(item) !== null)
    .sort((a, b) => a.element.range.start - b.element.range.start);
}

/** Returns the edits that make a closed curve transparent outside and opaque inside, with a colour there. */
function shapeEdits(d: Drawing, curve: CurveItem, fill: Rgb): Edit[] {
  const { handle } = curve;
  const inside = insideOf(curve) ?? "right";
  const outside = inside === "left" ? "right" : "left";
  const { color, opacity } = curve[inside];
  const hasColor = color.kind === "stops" || color.kind === "paint";
  const isHalf = opacity.kind === "open" && curve[outside].opacity.kind !== "open";
  const made = [
    hasColor ? null : setColor(d, handle, inside, filledSides(inside, fill)[inside]),
    setSideOpacity(d, handle, outside, constant(0)),
    isHalf ? setNumbers(d, handle, inside, "opacity", constant(1)) : null,
  ];
  return made.flatMap((outcome) => outcome?.patch ?? []);
}

/** Returns the edits that keep a curve in place in another container; null: that container flattens everything. */
function placeEdits(d: Drawing, curve: CurveItem, to: Item | null): Edit[] | null {
  const frame = innerFrame(d, to);
  const back = inverted(frame);
  if (!back) return null;
  const map = composed(back, outerFrame(curve));
  // A mirror stays a transform, so that the sides keep their names.
  if (determinant(map) > 0) return reframing(d, curve, frame);
  return setTransform(d, curve.element, composed(map, ownTransform(curve.element)), finestStep(d));
}

/** Returns the curves that need a new layer: all but the lowest if a layer has no others. */
function leaving(d: Drawing, curves: readonly CurveItem[]): ReadonlySet<CurveItem> {
  const layers = new Set(curves.map((curve) => layerOf(curve)));
  const found = [...layers].flatMap((layer) => {
    const own = curves.filter((curve) => layerOf(curve) === layer);
    const all = layer ? curvesOf(d, [{ handle: layer.handle, part: { kind: "whole" } }]).length : 0;
    return own.length === all ? own.slice(1) : own;
  });
  return new Set(found.filter((curve) => isShown(d, curve)));
}

/**
 * Makes each closed curve a shape of its own: on a new layer above its own, with its colours inside, transparent
 * outside. A curve that is alone in its layer stays there. Returns null if no curve is closed.
 * @param fill for a curve without a colour inside
 */
export function shapesOfTheirOwn(d: Drawing, handles: readonly Handle[], fill: Rgb): Outcome | null {
  const curves = closedCurves(d, handles);
  const going = leaving(d, curves);
  const draft = new Draft(d.text);
  const moves: { readonly place: Place; readonly piece: string }[] = [];
  const moved: CurveItem[] = [];
  for (const curve of curves) {
    const edits = shapeEdits(d, curve, fill);
    const place = going.has(curve) ? placeAbove(d, layerOf(curve)) : null;
    const placed = place && placeEdits(d, curve, place.item);
    if (place && placed) {
      moves.push({ place, piece: draft.rewritten(curve.element, [...placed, ...edits]) });
      moved.push(curve);
    } else {
      draft.add(edits);
      draft.selectAt(curve.element.range.start);
    }
  }
  for (const range of removalsOf(d.text, moved.map(({ element }) => element))) draft.replace(range, "");
  for (const { place, piece } of moves) newLayer(d, draft, place, [piece]);
  return draft.outcome();
}
