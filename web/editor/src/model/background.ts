// The <rect> that is the background, by the engine's rules (src/formats/svg/paint/background.cpp).
import { mappedBox } from "../geometry/affine.js";
import type { Affine, Box } from "../geometry/affine.js";
import type { Rgb } from "../geometry/color.js";
import { valueOf } from "../source/attributes.js";
import { parseOpaque } from "../source/colors.js";
import { keywordOf, shareOf } from "../source/css.js";
import { parseLength } from "../source/lengths.js";
import type { Styles } from "../source/styles.js";
import type { ElementNode } from "../source/tree.js";

/** Tolerance as a share of the artboard's size: rectangles smaller by this still cover it. */
const SLACK = 1e-6;

/** x, y, x + width, y + height of an element; null where they are no lengths. */
export function boxOf(element: ElementNode, [x0, y0, x1, y1]: Box): Box | null {
  const length = (name: string, whole: number) => parseLength(valueOf(element, name) ?? "0", whole);
  const x = length("x", x1 - x0);
  const y = length("y", y1 - y0);
  const width = length("width", x1 - x0);
  const height = length("height", y1 - y0);
  if (x === null || y === null || width === null || height === null) return null;
  return width < 0 || height < 0 ? null : [x, y, x + width, y + height];
}

/** The colour of the background where a shape is it. */
export function backgroundOf(
  element: ElementNode,
  styles: Styles,
  artboardFromUser: Affine,
  viewBox: Box,
): Rgb | null {
  if (element.local !== "rect") return null;
  const box = boxOf(element, viewBox);
  const [a, b, c, d] = artboardFromUser;
  const isUpright = (b === 0 && c === 0) || (a === 0 && d === 0);
  if (!box || !isUpright) return null;
  const [x0, y0, x1, y1] = mappedBox(artboardFromUser, box);
  const slack = SLACK * Math.max(viewBox[2] - viewBox[0], viewBox[3] - viewBox[1]);
  const covers =
    x0 - slack <= viewBox[0] &&
    y0 - slack <= viewBox[1] &&
    x1 + slack >= viewBox[2] &&
    y1 + slack >= viewBox[3];
  const isOne = (property: "opacity" | "fill-opacity") =>
    shareOf(styles.value(element, property) ?? "1") === 1;
  if (!covers || !isOne("opacity") || !isOne("fill-opacity")) return null;
  const fill = styles.value(element, "fill") ?? "black";
  const isCurrent = keywordOf(fill) === "currentcolor";
  return parseOpaque(isCurrent ? (styles.value(element, "color") ?? "black") : fill);
}
