// Where the paint of a side lies: of a gradient its line or its circle, of a texture its tile.
import {
  composed,
  IDENTITY,
  inverted,
  mapped,
  type Affine,
  type Box,
  type Point,
} from "../geometry/affine.js";
import { boundsOf } from "../geometry/cubic.js";
import { hrefOf, valueOf } from "../source/attributes.js";
import { parseLength, parseTransform } from "../source/lengths.js";
import { isSvg } from "../source/styles.js";
import type { ElementNode } from "../source/tree.js";
import { readArtboard } from "./artboard.js";
import type { CurveItem, Drawing, PaintAttribute, PaintGrip, Side } from "./types.js";

const LOCAL = { linearGradient: "linear", radialGradient: "radial", pattern: "texture" } as const;
type Local = keyof typeof LOCAL;
export type PaintKind = (typeof LOCAL)[Local];

/** Lengths by their attributes, in the units of the paint's own coordinates. */
export type Lengths = Readonly<Record<string, number>>;

export interface PaintFrame {
  readonly kind: PaintKind;
  readonly element: ElementNode;
  /** The axis x runs along the line; the circle is the unit circle; the tile is the unit square. */
  readonly itemFromFrame: Affine;
  /** For a circle: the point where its colours begin, within the frame. */
  readonly focus: Point | null;
  /** Map from the coordinates of the lengths to the coordinates of the curve. */
  readonly itemFromOwn: Affine;
  /** The same without the paint's transform: of a box's units the box, else the identity. */
  readonly itemFromBox: Affine;
  readonly transform: Affine;
  readonly lengths: Lengths;
  /** Whether it would have another transform without one of its own. */
  readonly inherits: boolean;
  /** Whether a length is said by the paint or by one that it inherits from. */
  readonly isSaid: (name: string) => boolean;
}

/** The default of a length as a share of the box or the artboard, and its axis. */
type Default = readonly [share: number, axis: "x" | "y" | "both"];
const LENGTHS: Readonly<Record<PaintKind, Readonly<Record<string, Default>>>> = {
  linear: { x1: [0, "x"], y1: [0, "y"], x2: [1, "x"], y2: [0, "y"] },
  radial: { cx: [0.5, "x"], cy: [0.5, "y"], r: [0.5, "both"], fx: [0.5, "x"], fy: [0.5, "y"] },
  texture: { x: [0, "x"], y: [0, "y"], width: [0, "x"], height: [0, "y"] },
};

const kindOf = (element: ElementNode): PaintKind | null =>
  isSvg(element) && Object.hasOwn(LOCAL, element.local) ? LOCAL[element.local as Local] : null;

/** Returns the paint and its ancestors by inheritance, the nearest first. Stops where they form a circle. */
export function paintChain(
  element: ElementNode,
  ids: ReadonlyMap<string, ElementNode>,
): readonly ElementNode[] {
  const isTexture = kindOf(element) === "texture";
  const chain = new Set<ElementNode>();
  for (let at: ElementNode | undefined = element; at && !chain.has(at); ) {
    const kind = kindOf(at);
    if (!kind || (kind === "texture") !== isTexture) break;
    chain.add(at);
    const href: string = hrefOf(at)?.value.trim() ?? "";
    at = href.startsWith("#") ? ids.get(href.slice(1)) : undefined;
  }
  return [...chain];
}

/** The box of a curve's subpaths in its own coordinates, or null: it has none with an area. */
function boxOf(item: CurveItem): Box | null {
  const boxes = item.paths.map(boundsOf);
  const [x0, y0] = [0, 1].map((k) => Math.min(...boxes.map((box) => box[k])));
  const [x1, y1] = [2, 3].map((k) => Math.max(...boxes.map((box) => box[k])));
  return x1 > x0 && y1 > y0 ? [x0, y0, x1, y1] : null;
}

/** Reads the lengths. A gradient inherits lengths only from its own kind, as in the engine. */
function readLengths(
  chain: readonly ElementNode[],
  kind: PaintKind,
  isInBox: boolean,
  [x0, y0, x1, y1]: Box,
) {
  const bearers = chain.filter((one) => kind === "texture" || kindOf(one) === kind);
  const said = (name: string) => bearers.map((one) => valueOf(one, name)).find((v) => v !== undefined);
  const [width, height] = isInBox ? [1, 1] : [x1 - x0, y1 - y0];
  const whole = { x: width, y: height, both: Math.hypot(width, height) / Math.SQRT2 };
  const lengths: Record<string, number> = {};
  for (const [name, [absent, axis]] of Object.entries(LENGTHS[kind])) {
    const text = said(name);
    const length = text === undefined ? absent * whole[axis] : parseLength(text, whole[axis]);
    if (length === null) return null;
    lengths[name] = length;
  }
  if (kind === "radial" && said("fx") === undefined) lengths.fx = lengths.cx;
  if (kind === "radial" && said("fy") === undefined) lengths.fy = lengths.cy;
  return { lengths, isSaid: (name: string) => said(name) !== undefined };
}

/** The frame in the paint's own coordinates; null: it has no extent. */
export function frameOf(kind: PaintKind, l: Lengths): Affine | null {
  const [dx, dy] = [l.x2 - l.x1, l.y2 - l.y1];
  const frame: Affine =
    kind === "linear"
      ? [dx, dy, -dy, dx, l.x1, l.y1]
      : kind === "radial"
        ? [l.r, 0, 0, l.r, l.cx, l.cy]
        : [l.width, 0, 0, l.height, l.x, l.y];
  return inverted(frame) && frame;
}

const unitsOf = { linear: "gradientUnits", radial: "gradientUnits", texture: "patternUnits" } as const;
export const transformOf = {
  linear: "gradientTransform",
  radial: "gradientTransform",
  texture: "patternTransform",
} as const;

/** null: the side shows no paint, or one that says nothing that can be moved. */
export function paintFrame(
  d: Drawing,
  item: CurveItem,
  side: Side,
  attribute: PaintAttribute,
): PaintFrame | null {
  const value = item[side][attribute];
  if (value.kind !== "paint") return null;
  const ids = d.ids;
  const element = ids.get(value.href.replace(/^#/, ""));
  const kind = element && kindOf(element);
  if (!kind) return null;
  const chain = paintChain(element, ids);
  const said = (name: string) => chain.map((one) => valueOf(one, name)?.trim()).find((v) => v !== undefined);
  const isInBox = (said(unitsOf[kind]) ?? "objectBoundingBox") === "objectBoundingBox";
  const box = isInBox ? boxOf(item) : null;
  const transform = parseTransform(said(transformOf[kind]) ?? "");
  const read = readLengths(chain, kind, isInBox, readArtboard(d.root).viewBox);
  if ((isInBox && !box) || !transform || !inverted(transform) || !read) return null;
  const itemFromBox: Affine = box ? [box[2] - box[0], 0, 0, box[3] - box[1], box[0], box[1]] : IDENTITY;
  const frame = frameOf(kind, read.lengths);
  if (!frame) return null;
  // A texture's transform comes after its tile's units, a gradient's before them.
  const itemFromOwn =
    kind === "texture" ? composed(transform, itemFromBox) : composed(itemFromBox, transform);
  const { fx, fy } = read.lengths;
  const back = inverted(frame) as Affine;
  return {
    kind,
    element,
    itemFromFrame: composed(itemFromOwn, frame),
    focus: kind === "radial" ? mapped(back, [fx, fy]) : null,
    itemFromOwn,
    itemFromBox,
    transform,
    inherits: chain.slice(1).some((one) => valueOf(one, transformOf[kind]) !== undefined),
    ...read,
  };
}

/** Where a grip is within its frame. */
export function placeInFrame({ focus }: PaintFrame, grip: PaintGrip): Point {
  if (grip === "end") return [1, 0];
  if (grip === "across") return [0, 1];
  return grip === "focus" && focus ? focus : [0, 0];
}

/** Where a grip is in the curve's coordinates, or null: there is none. */
export function gripPlace(
  d: Drawing,
  item: CurveItem,
  side: Side,
  attribute: PaintAttribute,
  grip: PaintGrip,
): Point | null {
  const frame = paintFrame(d, item, side, attribute);
  return frame && mapped(frame.itemFromFrame, placeInFrame(frame, grip));
}
