// A side's menu of gradients and textures, for its colour or its opacity.
import type { Box } from "../../geometry/affine.js";
import { boundsOf, unionOf } from "../../geometry/cubic.js";
import { distance } from "../../geometry/vector.js";
import { setPaint, type NewPaint } from "../../model/commands/index.js";
import { definitionsOf, isSwatch } from "../../model/swatches.js";
import type { CurveItem, Drawing, Outcome, PaintAttribute, Side } from "../../model/types.js";
import * as en from "../../strings/en.js";
import type { MenuItem } from "../controls/menu.js";
import type { Shell } from "../services.js";

const words = en.panels;

type NewGradient = Extract<NewPaint, { kind: "linear" | "radial" }>;
export type NewStop = NewGradient["stops"][number];
type Stops = (before: Drawing, item: CurveItem, side: Side) => readonly NewStop[];

/** Heights for a new gradient, as shares of the box, best first: an end must not lie on a node. */
const HEIGHTS = [1 / 2, 3 / 8, 5 / 8, 1 / 4];
/** Distance from an end to a node, as a share of the box. */
const APART = 0.05;

/** Returns the height at which no node of the curve is near the ends of a gradient across its box. */
function freeHeight({ paths }: CurveItem, [x0, y0, x1, y1]: Box): number {
  const nodes = paths.flatMap(({ points }) => points.filter((_, k) => k % 3 === 0));
  const isNear = (height: number) => {
    const y = y0 + height * (y1 - y0);
    return nodes.some((node) => [x0, x1].some((x) => distance(node, [x, y]) < APART * (x1 - x0)));
  };
  const height = HEIGHTS.find((one) => !isNear(one)) ?? HEIGHTS[0];
  return y0 + height * (y1 - y0);
}

/** Returns a gradient across the curve's box: a line from edge to edge, or a circle from the middle. */
function gradient(
  item: CurveItem,
  kind: "linear" | "radial",
  stops: readonly NewStop[],
): NewGradient {
  const box = unionOf(item.paths.map(boundsOf)) ?? [0, 0, 1, 1];
  const [x0, y0, x1, y1] = box;
  const y = kind === "linear" ? freeHeight(item, box) : (y0 + y1) / 2;
  return { kind, stops, from: [kind === "linear" ? x0 : (x0 + x1) / 2, y], to: [x1, y] };
}

/** A new gradient of the stops that are there. */
export function gradientItems(
  { editor }: Shell,
  item: CurveItem,
  side: Side,
  attribute: PaintAttribute,
  stops: Stops,
): readonly MenuItem[] {
  const make = (kind: "linear" | "radial"): Outcome | null => {
    const { drawing } = editor;
    const paint = gradient(item, kind, stops(drawing, item, side));
    return setPaint(drawing, item.handle, side, attribute, paint);
  };
  return (["linear", "radial"] as const).map((kind) => ({
    label: words[kind],
    run: () => void editor.run(words.setPaint, make(kind)),
  }));
}

/** Returns the menu item that asks for a picture file, which becomes the side's texture. */
export function textureItem(
  { editor, services }: Shell,
  { handle }: CurveItem,
  side: Side,
  attribute: PaintAttribute,
): MenuItem {
  const choose = async () => {
    const picture = await services.chooseTexture();
    if (!picture) return;
    const paint = { kind: "texture", ...picture } as const;
    editor.run(words.setTexture, setPaint(editor.drawing, handle, side, attribute, paint));
  };
  return { label: words.texture, run: () => void choose() };
}

/** Ids of gradients and patterns that the document has. */
function paintsOf(drawing: Drawing): readonly string[] {
  const isPaint = (element: Drawing["root"]) =>
    /^(linearGradient|radialGradient|pattern)$/.test(element.local) && !isSwatch(element);
  return [...definitionsOf(drawing)]
    .filter(isPaint)
    .flatMap(({ attributes }) => attributes.find(({ name }) => name === "id")?.value ?? []);
}

/** A submenu of the paints that the document has, or nothing. */
export function documentPaints(
  { editor }: Shell,
  item: CurveItem,
  side: Side,
  attribute: PaintAttribute,
): readonly MenuItem[] {
  const value = item[side][attribute];
  const items = paintsOf(editor.drawing).map((id) => ({
    label: id,
    checked: value.kind === "paint" && value.href.endsWith(`#${id}`),
    run: () => {
      const paint = { kind: "existing", id } as const;
      const made = setPaint(editor.drawing, item.handle, side, attribute, paint);
      editor.run(words.setPaint, made);
    },
  }));
  return items.length > 0 ? [{ label: words.paintOfDocument, items }] : [];
}
