// Gradients and textures as what a side shows.
import type { Point } from "../../../geometry/affine.js";
import type { Rgb } from "../../../geometry/color.js";
import { numberText } from "../../../geometry/path.js";
import { prefixOf, setAttribute, sf, valueOf, XLINK } from "../../../source/attributes.js";
import { colorText } from "../../../source/colors.js";
import type { CurveItem, Drawing, Handle, Outcome, PaintAttribute, Side } from "../../types.js";
import { intoDefs } from "./defs.js";
import { Draft } from "../curves/draft.js";
import { finestStep } from "../mapping.js";
import { opening, svgName } from "../markup.js";
import { freeId } from "../structure/references.js";

export type NewPaint =
  | {
      readonly kind: "linear" | "radial";
      readonly stops: readonly { offset: number; color: Rgb; opacity: number }[];
      readonly from: Point;
      readonly to: Point;
    }
  | { readonly kind: "texture"; readonly href: string; readonly width: number; readonly height: number }
  | { readonly kind: "existing"; readonly id: string };

type New = Exclude<NewPaint, { kind: "existing" }>;

/**
 * A gradient or a pattern in <defs>, and its use as a side's colour or opacity; points count in the
 * curve's coordinates. The curve's stroke names it too: editors throw away what only attributes of
 * other namespaces name.
 */
export function setPaint(
  d: Drawing,
  h: Handle,
  side: Side,
  attribute: PaintAttribute,
  paint: NewPaint,
): Outcome | null {
  const item = d.item(h);
  if (item?.kind !== "curve") return null;
  const ids = d.ids;
  const isNew = paint.kind !== "existing";
  if (!isNew && !ids.has(paint.id)) return null;
  const draft = new Draft(d.text);
  const wish = paint.kind === "texture" ? "texture" : "gradient";
  const id = isNew ? freeId(wish, new Set(ids.keys())) : paint.id;
  if (isNew) intoDefs(d, draft, [paintMarkup(d, paint, id)]);
  const name = attribute === "color" ? side : `${side}-opacity`;
  draft.add(setAttribute(d.text, item.element, sf(name), `url(#${id})`));
  // As with numbers, the first opacity of a curve leaves its other side opaque.
  const other = side === "left" ? "right" : "left";
  const isFirst = [side, other].every((one) => item[one as Side].opacity.kind === "open");
  if (attribute === "opacity" && isFirst)
    draft.add(setAttribute(d.text, item.element, sf(`${other}-opacity`), "1"));
  if (attribute === "color" || !namesColor(item))
    draft.add(setAttribute(d.text, item.element, "stroke", `url(#${id})`));
  return draft.outcome();
}

/** Whether the stroke names a paint that a side shows as its colour: it is what other programs draw. */
function namesColor({ element, left, right }: CurveItem): boolean {
  const stroke = valueOf(element, "stroke")?.trim();
  return [left, right].some(({ color }) => color.kind === "paint" && stroke === `url(${color.href})`);
}

function paintMarkup(d: Drawing, paint: New, id: string): string {
  return paint.kind === "texture" ? patternMarkup(d, paint, id) : gradientMarkup(d, paint, id);
}

function gradientMarkup(
  d: Drawing,
  { kind, stops, from, to }: Extract<New, { kind: "linear" | "radial" }>,
  id: string,
): string {
  const number = (value: number) => numberText(value, finestStep(d) * 100);
  const radius = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const geometry: [string, string][] =
    kind === "linear"
      ? [["x1", number(from[0])], ["y1", number(from[1])], ["x2", number(to[0])], ["y2", number(to[1])]]
      : [["cx", number(from[0])], ["cy", number(from[1])], ["r", number(radius)]];
  const local = `${kind}Gradient`;
  const start = opening(d.root, local, [["id", id], ["gradientUnits", "userSpaceOnUse"], ...geometry]);
  const rows = stops.map(({ offset, color, opacity }) => {
    const stop = opening(d.root, "stop", [
      ["offset", numberText(offset, 1e-4)],
      ["stop-color", colorText(color)],
      ["stop-opacity", opacity < 1 ? numberText(opacity, 1e-4) : null],
    ]);
    return `${stop}/>`;
  });
  return `${start}>${rows.join("")}</${svgName(d.root, local)}>`;
}

function patternMarkup(
  d: Drawing,
  { href, width, height }: Extract<New, { kind: "texture" }>,
  id: string,
): string {
  const size: [string, string][] = [["width", String(width)], ["height", String(height)]];
  const xlink = prefixOf(d.root, XLINK);
  const start = opening(d.root, "pattern", [["id", id], ["patternUnits", "userSpaceOnUse"], ...size]);
  const image = opening(d.root, "image", [[xlink === null ? "href" : `${xlink}:href`, href], ...size]);
  return `${start}>${image}/></${svgName(d.root, "pattern")}>`;
}
