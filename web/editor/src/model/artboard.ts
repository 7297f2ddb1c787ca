// The <svg> element's attributes of the whole picture, by the engine's rules
// (src/formats/svg/paint/picture_size.cpp).
import { IDENTITY, inverted, mapped } from "../geometry/affine.js";
import type { Affine, Box } from "../geometry/affine.js";
import type { Rgb } from "../geometry/color.js";
import { sf, valueOf } from "../source/attributes.js";
import { parseOpaque } from "../source/colors.js";
import { fitted, isStretched, parseLength, parseViewBox } from "../source/lengths.js";
import type { ElementNode } from "../source/tree.js";
import type { Drawing } from "./types.js";

export interface Artboard {
  /** The box that 100% refers to, and that the document's numbers count in. */
  readonly viewBox: Box;
  /** The visible part: the viewBox; more or less of the plane where the aspect ratios differ. */
  readonly box: Box;
  /** Stretches where preserveAspectRatio="none" does, else the identity. */
  readonly artboardFromUser: Affine;
}

/** Default size where no readable attribute exists; the engine reports the error. */
const DEFAULT_SIZE = 100;
const SAME_ASPECT = 1e-9;

function sideLength(root: ElementNode, name: string, whole: number): number | null {
  const length = parseLength(valueOf(root, name) ?? "", whole);
  return length !== null && length > 0 ? length : null;
}

function isShare(root: ElementNode, name: string): boolean {
  return (valueOf(root, name) ?? "").trim().endsWith("%");
}

/** The picture's size in pixels, or null where nothing says one. */
function pictureSize(root: ElementNode, [x0, y0, x1, y1]: Box): [number, number] | null {
  const areShares = isShare(root, "width") && isShare(root, "height");
  const side = (name: string, whole: number) =>
    isShare(root, name) && !areShares ? null : sideLength(root, name, whole);
  const width = side("width", x1 - x0);
  const height = side("height", y1 - y0);
  const aspect = (x1 - x0) / (y1 - y0);
  if (width === null && height === null) return null;
  return [width ?? (height as number) * aspect, height ?? (width as number) / aspect];
}

function viewBoxOf(root: ElementNode): Box {
  const said = parseViewBox(valueOf(root, "viewBox") ?? "");
  if (said) return said;
  const width = sideLength(root, "width", NaN) ?? DEFAULT_SIZE;
  const height = sideLength(root, "height", NaN) ?? DEFAULT_SIZE;
  return [0, 0, width, height];
}

export function readArtboard(root: ElementNode): Artboard {
  const viewBox = viewBoxOf(root);
  const plain = { viewBox, box: viewBox, artboardFromUser: IDENTITY };
  const size = pictureSize(root, viewBox);
  if (!size) return plain;
  const [x0, y0, x1, y1] = viewBox;
  const stretch = size[1] / (y1 - y0) / (size[0] / (x1 - x0));
  if (Math.abs(stretch - 1) <= SAME_ASPECT) return plain;
  const ratio = valueOf(root, "preserveAspectRatio") ?? "";
  if (isStretched(ratio)) {
    const box: Box = [x0, stretch * y0, x1, stretch * y1];
    return { viewBox, box, artboardFromUser: [1, 0, 0, stretch, 0, 0] };
  }
  const userFromPixels = inverted(fitted(viewBox, [0, 0, ...size], ratio));
  if (!userFromPixels) return plain;
  const box: Box = [...mapped(userFromPixels, [0, 0]), ...mapped(userFromPixels, size)];
  return { viewBox, box, artboardFromUser: IDENTITY };
}

export function readInterpolation(root: ElementNode): Drawing["interpolation"] {
  const said = valueOf(root, sf("interpolation"));
  return said === "linear" || said === "oklab" ? said : "srgb";
}

/** sf:background: a colour; null for none; undefined where it is not said. */
export function saidBackground(root: ElementNode): Rgb | null | undefined {
  const said = valueOf(root, sf("background"));
  return said === undefined ? undefined : parseOpaque(said.trim());
}
