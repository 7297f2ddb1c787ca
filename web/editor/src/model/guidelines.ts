// The guides of a document, in the form that Inkscape gives them: <sodipodi:guide> in <sodipodi:namedview>.
//
// Source: Inkscape reads a guide in SPGuide::set(), src/object/sp-guide.cpp, and the attributes of <namedview> in the
// class SPNamedView. position="x,y" is a point of the guide in units of the viewBox, counted from the lower left
// corner of the page, and y points up. Inkscape multiplies each coordinate by the page's size over the viewBox's, so
// that x and y of the viewBox do not count. orientation="a,b" is the normal, where y points up too; without a
// readable one the guide is vertical.
import type { Box, Point } from "../geometry/affine.js";
import { INKSCAPE, SODIPODI, valueOf } from "../source/attributes.js";
import { LARGEST, parseNumber } from "../source/lengths.js";
import type { ElementNode } from "../source/tree.js";
import { readArtboard } from "./artboard.js";
import type { Drawing, Handle } from "./types.js";

/** The coordinate that a guide holds: 0, x, of a vertical guide; 1, y, of a horizontal one. */
export type GuideAxis = 0 | 1;

export interface Guideline {
  readonly handle: Handle;
  readonly element: ElementNode;
  /** A point of the guide, and its normal, a unit vector: on the artboard. */
  readonly point: Point;
  readonly normal: Point;
  /** null: it is slanted. */
  readonly axis: GuideAxis | null;
  readonly locked: boolean;
}

export interface Guidelines {
  /** The element that holds them, or null. */
  readonly view: ElementNode | null;
  readonly shown: boolean;
  readonly all: readonly Guideline[];
}

/** Attributes of Inkscape's that hide and lock guides. */
export const SHOW_GUIDES = "showguides";
export const LOCK_GUIDES = { namespace: INKSCAPE, local: "lockguides" } as const;
export const LOCKED = { namespace: INKSCAPE, local: "locked" } as const;

/** A normal that is nearer to an axis than this is the axis's. */
const STRAIGHT = 1e-6;

const isSodipodi = (element: ElementNode, local: string) =>
  element.namespace === SODIPODI && element.local === local;

function isTrue(value: string | undefined, otherwise: boolean): boolean {
  return value === undefined ? otherwise : ["true", "yes", "y", "1"].includes(value);
}

/** Maps coordinates of a guide's position to the artboard, and back. */
export class GuideFrame {
  private readonly scale: Point;
  private readonly box: Box;
  /** The unit of the last decimal that is written. */
  readonly step: number;

  constructor(root: ElementNode) {
    const { viewBox, box } = readArtboard(root);
    const size = (of: Box): Point => [of[2] - of[0], of[3] - of[1]];
    const [width, height] = size(box);
    this.scale = [width / size(viewBox)[0], height / size(viewBox)[1]];
    this.box = box;
    this.step = 10 ** (Math.floor(Math.log10(Math.max(width, height))) - 9);
  }

  toArtboard([x, y]: Point): Point {
    return [this.box[0] + x * this.scale[0], this.box[3] - y * this.scale[1]];
  }

  /** Returns the coordinate of a position for a place along an axis of the artboard; not finite: it has none. */
  coordinate(axis: GuideAxis, at: number): number {
    return axis === 0 ? (at - this.box[0]) / this.scale[0] : (this.box[3] - at) / this.scale[1];
  }
}

/** Returns the coordinates of a position as written. Inkscape before 0.46 wrote only the one that counts. */
export const coordinatesOf = (element: ElementNode) => (valueOf(element, "position") ?? "").split(",");

/** Returns the normal on the artboard. */
function normalOf(said = ""): Point {
  if (said === "horizontal") return [0, 1];
  const [a, b] = said.split(",").map((text) => parseNumber(text) ?? NaN);
  const length = Math.hypot(a, b ?? NaN);
  const isReadable = length > STRAIGHT && length < Infinity;
  return isReadable ? [a / length, -b / length] : [1, 0];
}

function axisOf([x, y]: Point): GuideAxis | null {
  if (Math.abs(y) < STRAIGHT) return 0;
  return Math.abs(x) < STRAIGHT ? 1 : null;
}

function readGuide(element: ElementNode, frame: GuideFrame, isLocked: boolean): Guideline | null {
  const [x, y = x] = coordinatesOf(element).map(parseNumber);
  if (x === null || y === null) return null;
  const point = frame.toArtboard([x, y]);
  if (!point.every((value) => Math.abs(value) <= LARGEST)) return null;
  const normal = normalOf(valueOf(element, "orientation"));
  const locked = isLocked || isTrue(valueOf(element, LOCKED), false);
  return { handle: element.handle, element, point, normal, axis: axisOf(normal), locked };
}

/** Returns whether there are guides, and none of them may be moved. */
export function areLocked(all: readonly Guideline[]): boolean {
  return all.length > 0 && all.every(({ locked }) => locked);
}

/** Returns the guides in the order of the text. Unreadable ones are left out; they stay in the file. */
export function guidelinesOf({ root }: Drawing): Guidelines {
  const view = root.children.find((child) => isSodipodi(child, "namedview")) ?? null;
  if (!view) return { view, shown: true, all: [] };
  const frame = new GuideFrame(root);
  const isLocked = isTrue(valueOf(view, LOCK_GUIDES), false);
  const all = view.children
    .filter((child) => isSodipodi(child, "guide"))
    .flatMap((child) => readGuide(child, frame, isLocked) ?? []);
  return { view, shown: isTrue(valueOf(view, SHOW_GUIDES), true), all };
}
