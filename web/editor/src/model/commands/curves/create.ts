// New curves, layers and pictures to trace over.
import { lengthScale } from "../../../geometry/affine.js";
import { writePath } from "../../../geometry/path.js";
import { declare, INKSCAPE, nameWithin, prefixOf, SFUMATO, sfName, SODIPODI, XLINK } from "../../../source/attributes.js";
import { COLORS, RADII, SHARES, sideText } from "../../../source/stops.js";
import type { ElementNode } from "../../../source/tree.js";
import type { CubicPath } from "../../../geometry/cubic.js";
import type { Rgb } from "../../../geometry/color.js";
import type { FilledSides } from "../../sides.js";
import type { Drawing, Handle, Item, Outcome, SideValue } from "../../types.js";
import { Draft } from "./draft.js";
import { fallback } from "../paint/fallback.js";
import { innerFrame, layerOf } from "../structure/items.js";
import { insertion } from "../structure/layout.js";
import { opening, svgName } from "../markup.js";
import type { WrittenAttributes } from "../markup.js";
import { innerPlace, newLayer, outerPlace } from "../structure/places.js";
import { freeId } from "../structure/references.js";

export interface NewCurve {
  readonly path: CubicPath;
  /** The unit of the last decimal of its ends, where it is another than that of its points. */
  readonly endStep?: number;
  readonly left: SideValue<Rgb>;
  readonly right: SideValue<Rgb>;
  /** Absent: the curve has no influence on opacity. */
  readonly opacity?: FilledSides["opacity"];
  readonly blur?: SideValue<number>;
  /** A local curve, with these radii. */
  readonly radius?: SideValue<number>;
}

function curveMarkup(
  d: Drawing,
  parent: ElementNode,
  curve: NewCurve,
  scale: number,
  step: number,
): string {
  const { path, endStep, blur, radius } = curve;
  const radii = (side: SideValue<number> | undefined) => (side ? sideText(side, RADII) : null);
  const attributes: WrittenAttributes = [
    ["d", writePath(path, step, endStep)],
    ...sideAttributes(parent, curve),
    [sfName(parent, "blur"), radii(blur)],
    [sfName(parent, "radius"), radii(radius)],
    ...fallback(d, [curve.left, curve.right], scale),
  ];
  return `${opening(parent, "path", attributes)}/>`;
}

/** Returns the attributes for colours and opacities of both sides. */
export function sideAttributes(
  parent: ElementNode,
  { left, right, opacity }: Pick<NewCurve, "left" | "right" | "opacity">,
): WrittenAttributes {
  const share = (value: number | undefined) => (value === undefined ? null : SHARES.write(value));
  return [
    [sfName(parent, "left"), sideText(left, COLORS)],
    [sfName(parent, "right"), sideText(right, COLORS)],
    [sfName(parent, "left-opacity"), share(opacity?.left)],
    [sfName(parent, "right-opacity"), share(opacity?.right)],
  ];
}

/**
 * Adds curves of one kind: diffusion curves into a layer, or behind a curve of it, else into a new
 * layer on top; local curves into a group, or behind what is not one. Their points count in the
 * coordinates of the container; of a new layer, of what it stands in.
 */
export function addCurves(
  d: Drawing,
  into: Handle | null,
  curves: readonly NewCurve[],
  step: number,
): Outcome | null {
  if (curves.length === 0) return null;
  const target = into === null ? null : (d.item(into) ?? null);
  const isLocal = curves[0].radius !== undefined;
  const draft = new Draft(d.text);
  draft.add(declare(d.text, d.root, SFUMATO));
  const pieces = (parent: ElementNode, item: Item | null) => {
    const scale = lengthScale(innerFrame(d, item));
    return curves.map((curve) => curveMarkup(d, parent, curve, scale, step));
  };
  const isInner = !isLocal && target !== null && layerOf(target) !== null;
  const place = isInner ? innerPlace(target) : outerPlace(d, target);
  if (!place) return null;
  const { parent, after, item } = place;
  if (isInner || isLocal) {
    const { edit, starts } = insertion(d.text, parent, after, pieces(parent, item));
    draft.add([edit]);
    for (const start of starts) draft.selectWithin(edit, start);
  } else {
    newLayer(d, draft, place, pieces(parent, item));
  }
  return draft.outcome();
}

/** An empty layer above an item, or on top; the name stands in its id, and whole in Inkscape's label. */
export function addLayer(d: Drawing, above: Handle | null, name: string): Outcome | null {
  const target = above === null ? null : (d.item(above) ?? null);
  const place = outerPlace(d, target);
  if (!place) return null;
  const { parent, after } = place;
  const draft = new Draft(d.text);
  draft.add(declare(d.text, d.root, SFUMATO));
  const wish = name.trim().replace(/[^\p{L}\p{N}_.-]+/gu, "-").replace(/^[^\p{L}_]+/u, "");
  const id = wish === "" ? null : freeId(wish, new Set(d.ids.keys()));
  const inkscape = prefixOf(parent, INKSCAPE);
  const markup = opening(parent, "g", [
    ["id", id],
    [`${inkscape}:label`, inkscape === null || name === "" ? null : name],
    [sfName(parent, "diffuse"), "true"],
  ]);
  const close = `</${svgName(parent, "g")}>`;
  const { edit, starts } = insertion(d.text, parent, after, [`${markup}>${close}`]);
  draft.add([edit]);
  draft.selectWithin(edit, starts[0]);
  return draft.outcome();
}

/**
 * A picture to trace over, on top of everything, as large as it fits in the middle of the artboard,
 * and locked.
 */
export function addReference(
  d: Drawing,
  href: string,
  width: number,
  height: number,
  opacity = 1,
): Outcome | null {
  if (!(width > 0 && height > 0)) return null;
  const { root, text } = d;
  const [x0, y0, x1, y1] = d.artboard;
  const scale = Math.min((x1 - x0) / width, (y1 - y0) / height);
  const [w, h] = [width * scale, height * scale];
  const short = (value: number) => String(Number(value.toFixed(3)));
  const xlink = prefixOf(root, XLINK);
  const markup = opening(root, "image", [
    [sfName(root, "reference"), "true"],
    ["x", short((x0 + x1 - w) / 2)],
    ["y", short((y0 + y1 - h) / 2)],
    ["width", short(w)],
    ["height", short(h)],
    ["opacity", opacity === 1 ? null : short(opacity)],
    [nameWithin(root, SODIPODI, "insensitive"), "true"],
    [xlink === null ? "href" : `${xlink}:href`, href],
  ]);
  const draft = new Draft(text);
  draft.add([...declare(text, root, SFUMATO), ...declare(text, root, SODIPODI)]);
  const { edit, starts } = insertion(text, root, root.children.at(-1) ?? null, [`${markup}/>`]);
  draft.add([edit]);
  draft.selectWithin(edit, starts[0]);
  return draft.outcome();
}
