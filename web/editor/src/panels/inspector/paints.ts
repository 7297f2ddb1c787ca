// A side's menu of gradients and textures, for its colour or its opacity.
import { boundsOf } from "../../geometry/cubic.js";
import { setPaint, type NewPaint } from "../../model/commands/index.js";
import type { CurveItem, Drawing, Outcome, PaintAttribute, Side } from "../../model/types.js";
import { en } from "../../strings/en.js";
import type { MenuItem } from "../controls/menu.js";
import type { Shell } from "../services.js";

const words = en.panels;

type NewGradient = Extract<NewPaint, { kind: "linear" | "radial" }>;
export type NewStop = NewGradient["stops"][number];
type Stops = (before: Drawing, item: CurveItem, side: Side) => readonly NewStop[];

/** Distance of a new gradient's ends from the box, as a share of its width: on the box they would lie on nodes. */
const INSET = 0.1;

/** Across the curve's box. */
function gradient(
  item: CurveItem,
  kind: "linear" | "radial",
  stops: readonly NewStop[],
): NewGradient {
  const box = item.paths
    .map(boundsOf)
    .reduce((a, b) => [
      Math.min(a[0], b[0]),
      Math.min(a[1], b[1]),
      Math.max(a[2], b[2]),
      Math.max(a[3], b[3]),
    ]);
  const middle = (box[1] + box[3]) / 2;
  const inset = INSET * (box[2] - box[0]);
  return {
    kind,
    stops,
    from: kind === "linear" ? [box[0] + inset, middle] : [(box[0] + box[2]) / 2, middle],
    to: [box[2] - inset, middle],
  };
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
  const found: string[] = [];
  const look = (element: Drawing["root"]) => {
    if (/^(linearGradient|radialGradient|pattern)$/.test(element.local)) {
      const id = element.attributes.find(({ name }) => name === "id")?.value;
      if (id) found.push(id);
    }
    element.children.forEach(look);
  };
  for (const child of drawing.root.children) if (child.local !== "g") look(child);
  return found;
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
