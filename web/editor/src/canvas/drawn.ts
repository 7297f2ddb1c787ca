// New curves: what was drawn becomes part of the document, in its layer, with colours.
import { currentColor } from "../app/colors.js";
import type { Editor } from "../app/types.js";
import { IDENTITY, inverted, lengthScale, mapped, type Affine } from "../geometry/affine.js";
import { mappedPath, type CubicPath } from "../geometry/cubic.js";
import { addCurves } from "../model/commands/index.js";
import { isFreeLayer } from "../model/commands/structure/places.js";
import { filledSides, insideOf, type FilledSides } from "../model/sides.js";
import type { Drawing, Handle, Item, Outcome, SideValue } from "../model/types.js";
import { placesOf } from "./places.js";
import { SAME_PX, WELD_FINER } from "./snap.js";
import { takenSides } from "./taken.js";

/** Colours of the first curve of a drawing: warm and cool, so that one sees what sides are. */
const FIRST = {
  left: one({ r: 244 / 255, g: 216 / 255, b: 165 / 255 }),
  right: one({ r: 74 / 255, g: 109 / 255, b: 140 / 255 }),
} as const;

/** Sides of the first curve of a layer: a colour would fill all of it, and hide the picture below. */
const OPEN = { left: { kind: "open" }, right: { kind: "open" } } as const;

function one<V>(value: V): SideValue<V> {
  return { kind: "stops", space: "arc", stops: [{ offset: 0, value }] };
}

/**
 * Adds a diffusion curve to the layer that is at work, with the colours that the picture has beside
 * it, so that the picture stays as it is, or with the current colour, if the settings say so. A closed curve in an empty layer becomes a filled shape.
 * @param path artboard units
 * @returns whether it came into being
 */
export async function addCurve(editor: Editor, path: CubicPath, label: string): Promise<boolean> {
  const { activeLayer: layer, drawing } = editor;
  const back = layer ? inverted(layer.artboardFromItem) : IDENTITY;
  if (!back) return false;
  const inLayer = mappedPath(back, path);
  const sides = shapeSides(editor, layer, inLayer) ?? (await curveSides(editor, layer, inLayer));
  // While its colours were fetched, another drawing may have been opened, and the layer deleted.
  if (editor.drawing !== drawing) return false;
  const into = layer && editor.drawing.item(layer.handle) ? layer.handle : null;
  const step = editor.step(layer);
  const endStep = meetsEnd(editor, path) ? step / WELD_FINER : step;
  const curve = { path: into === null ? path : inLayer, endStep, ...sides };
  return editor.run(label, addCurves(editor.drawing, into, [curve], step));
}

/** Returns the sides of a closed path that is the first one of its layer: a filled shape. null: it is none. */
function shapeSides(editor: Editor, layer: Item | null, inLayer: CubicPath): FilledSides | null {
  const inside = insideOf({ paths: [inLayer] });
  const isFirst = layer ? isFreeLayer(layer) : isBlank(editor);
  return inside && isFirst ? filledSides(inside, currentColor(editor.settings)) : null;
}

async function curveSides(editor: Editor, layer: Item | null, inLayer: CubicPath) {
  const { settings } = editor;
  if (settings.ownColor.peek()) {
    const color = one(currentColor(settings));
    return { left: color, right: color };
  }
  const taken = layer && (await takenSides(editor, layer, inLayer));
  return taken ?? (isBlank(editor) ? FIRST : OPEN);
}

/** Whether an end of a path lies on an end of a curve: to where it snapped. */
function meetsEnd(editor: Editor, { points }: CubicPath): boolean {
  const near = SAME_PX / editor.view.peek().zoom;
  const ends = [points[0], points[points.length - 1]];
  return placesOf(editor).some(({ item, artboardFromItem }) =>
    item.paths.some(
      (path) =>
        !path.closed &&
        [path.points[0], path.points[path.points.length - 1]].some((point) => {
          const [x, y] = mapped(artboardFromItem, point);
          return ends.some((end) => Math.hypot(end[0] - x, end[1] - y) <= near);
        }),
    ),
  );
}

function isBlank({ drawing }: Editor): boolean {
  return ![...drawing.all()].some(({ kind }) => kind === "curve" || kind === "stroke");
}

/** Where a local stroke goes: on top of the selected stroke, or into the group that is selected, else isolated. */
function strokeParent(editor: Editor): { into: Handle | null; map: Affine } {
  const handle = editor.selection.peek().at(-1)?.handle ?? editor.isolated.peek();
  const item = handle === null ? undefined : editor.drawing.item(handle);
  if (item?.kind === "stroke")
    return { into: item.handle, map: item.parent?.artboardFromItem ?? IDENTITY };
  if (item?.kind === "group" && !isInLayer(item))
    return { into: item.handle, map: item.artboardFromItem };
  return { into: null, map: IDENTITY };
}

function isInLayer(item: Item): boolean {
  return item.kind === "layer" || (item.parent !== null && isInLayer(item.parent));
}

/** A stroke of the local kind. @param radii by the share of its length, artboard units */
export function strokeOutcome(
  editor: Editor,
  drawing: Drawing,
  path: CubicPath,
  radii: readonly { readonly offset: number; readonly value: number }[],
): Outcome | null {
  const { into, map } = strokeParent(editor);
  const back = inverted(map);
  if (!back) return null;
  const scale = lengthScale(back);
  const color = one(currentColor(editor.settings));
  const radius: SideValue<number> = {
    kind: "stops",
    space: "arc",
    stops: radii.map(({ offset, value }) => ({ offset, value: value * scale })),
  };
  const curve = { path: mappedPath(back, path), left: color, right: color, radius };
  return addCurves(drawing, into, [curve], editor.step(null));
}
