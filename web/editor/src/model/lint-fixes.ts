// Fixes for hints of `sfumato lint`, each one step of undo.
import { composed, inverted, mapped, mappedVector } from "../geometry/affine.js";
import type { Point } from "../geometry/affine.js";
import { endsOf, isOpen, type CubicPath } from "../geometry/cubic.js";
import { nodePath } from "../geometry/natural.js";
import { nearestOn } from "../geometry/nearest.js";
import { distance } from "../geometry/vector.js";
import { deleteItems, moveNodes, setBoth, setColor, setNumbers, setPath, swapSides } from "./commands/index.js";
import { layerOf } from "./commands/structure/items.js";
import { finestStep } from "./commands/mapping.js";
import { together } from "./commands/structure/together.js";
import { atOutline, broughtIn, curvesWithin, withoutInvisible } from "./lint-items.js";
import { closedBy, endOffset, meets } from "./seams.js";
import type { CurveItem, Drawing, Handle, Item, Outcome, Side, SideValue } from "./types.js";

/** The fields of a hint that fixes use: its rule, and the place of its curve's element in the text. */
export interface FixableHint {
  readonly rule: string;
  readonly offset: number | null;
  /** The side, for a hint about one side. */
  readonly side?: Side | null;
  /** The item that the hint is about, if that is not a curve of a layer. */
  readonly handle?: Handle | null;
}

/** The effect of a fix; the words are in strings/en.ts, `lintFixes`. */
export type FixLabel =
  | "closeCurve"
  | "swapSides"
  | "deleteCurve"
  | "deleteHidden"
  | "deleteEmptyLayers"
  | "removeBlur"
  | "addBarrier"
  | "matchEnds"
  | "joinToCurve"
  | "openSide"
  | "endAtOutline"
  | "deleteInvisible"
  | "bringIn";

export interface Fix {
  readonly label: FixLabel;
  readonly outcome: Outcome;
}

type Mend = (d: Drawing, curve: CurveItem, side: Side | null) => Outcome | null;

const SIDES: readonly Side[] = ["left", "right"];
/** An end that misses a curve by less was meant to meet it: pixels of an artboard of 512, as in lint. */
const MISS_PX = 4;
const OPEN = { kind: "open" } as const;

const OF_CURVES: Readonly<Record<string, readonly [FixLabel, Mend]>> = {
  "open-loop": ["closeCurve", closed],
  "inside-empty": ["swapSides", (d, { handle }) => swapSides(d, [handle])],
  "no-attribute": ["deleteCurve", (d, { handle }) => deleteItems(d, [handle])],
  outside: ["deleteCurve", (d, { handle }) => deleteItems(d, [handle])],
  duplicate: ["deleteHidden", withoutHidden],
  "blur-without-shader": ["removeBlur", withoutIdleBlur],
  "stroke-blur": ["removeBlur", (d, { handle }) => setBoth(d, handle, "blur", OPEN)],
  seam: ["matchEnds", withoutSeam],
  gap: ["joinToCurve", ended],
  overshoot: ["joinToCurve", ended],
  "unseen-side": ["openSide", withoutUnseen],
};

const OF_DRAWINGS: Readonly<Record<string, readonly [FixLabel, (d: Drawing) => Outcome | null]>> = {
  flood: ["addBarrier", withBarriers],
  "empty-layer": ["deleteEmptyLayers", withoutEmptyLayers],
};

const OF_ITEMS: Readonly<Record<string, readonly [FixLabel, (d: Drawing, item: Item) => Outcome | null]>> = {
  leak: ["endAtOutline", atOutline],
  invisible: ["deleteInvisible", withoutInvisible],
  "instance-outside": ["bringIn", broughtIn],
};

/** The rules that may have a fix. */
export const FIXABLE_RULES: readonly string[] = [
  ...Object.keys(OF_CURVES),
  ...Object.keys(OF_ITEMS),
  ...Object.keys(OF_DRAWINGS),
];

/** The fix of a hint about the present text; null where there is none. */
export function fixOf(d: Drawing, { rule, offset, side = null, handle = null }: FixableHint): Fix | null {
  if (Object.hasOwn(OF_DRAWINGS, rule)) {
    const [label, fix] = OF_DRAWINGS[rule];
    return made(label, fix(d));
  }
  const item = handle !== null ? d.item(handle) : offset === null ? undefined : d.itemAt(offset);
  if (!item) return null;
  if (Object.hasOwn(OF_ITEMS, rule)) {
    const [label, fix] = OF_ITEMS[rule];
    return made(label, fix(d, item));
  }
  if (!Object.hasOwn(OF_CURVES, rule) || (item.kind !== "curve" && item.kind !== "stroke")) return null;
  const [label, fix] = OF_CURVES[rule];
  return made(label, fix(d, item, side));
}

function made(label: FixLabel, outcome: Outcome | null): Fix | null {
  return outcome && { label, outcome };
}

/** Artboard units of a pixel of an artboard of 512. */
function pixelOf({ artboard: [x0, y0, x1, y1] }: Drawing): number {
  return Math.max(x1 - x0, y1 - y0) / 512;
}

/** The subpath whose ends are nearest to each other is closed, its last node moved onto the first. */
function closed(d: Drawing, curve: CurveItem): Outcome | null {
  const gapOf = (path: CubicPath) => (isOpen(path) ? distance(...endsOf(path)) : Infinity);
  const gaps = curve.paths.map(gapOf);
  const index = gaps.indexOf(Math.min(...gaps));
  if (!curve.paths[index] || !isOpen(curve.paths[index])) return null;
  const path = nodePath(curve.paths[index]);
  const [begin, end] = endsOf(path);
  const [x, y] = path.points[path.points.length - 2];
  const control: Point = [x + begin[0] - end[0], y + begin[1] - end[1]];
  const points = [...path.points.slice(0, -2), control, begin];
  return setPath(d, curve.handle, index, { ...path, points, closed: true }, finestStep(d));
}

/** Other curves through a point of the artboard, of the layer that a curve is in. */
export function curvesThrough(d: Drawing, curve: Item, at: Point): readonly Item[] {
  const layer = layerOf(curve);
  const isNear = (other: CurveItem) => {
    const back = inverted(other.artboardFromItem);
    return other.paths.some((path) => {
      const met = back && mapped(other.artboardFromItem, nearestOn(path, mapped(back, at)).point);
      return met !== null && distance(met, at) < MISS_PX * pixelOf(d);
    });
  };
  return (layer ? curvesWithin(layer) : []).filter((other) => other !== curve && isNear(other));
}

function pointsInLayer({ paths, layerFromItem }: CurveItem): Point[] {
  return paths.flatMap(({ points }) => points.map((p) => mapped(layerFromItem, p)));
}

/** Deletes the last curve before this one that lies exactly below it. */
function withoutHidden(d: Drawing, curve: CurveItem): Outcome | null {
  const layer = layerOf(curve);
  const own = pointsInLayer(curve);
  const isSame = (points: readonly Point[]) =>
    points.length === own.length && points.every((p, i) => distance(p, own[i]) === 0);
  const before = layer ? curvesWithin(layer) : [];
  const hidden = before.slice(0, before.indexOf(curve)).filter((other) => {
    const points = pointsInLayer(other);
    return isSame(points) || isSame([...points].reverse());
  });
  const last = hidden.at(-1);
  return last ? deleteItems(d, [last.handle]) : null;
}

function bears({ kind }: SideValue<unknown>): boolean {
  return kind === "paint" || kind === "stops";
}

/** A side that nothing sees lets colours and opacity pass. */
function withoutUnseen(d: Drawing, { handle }: CurveItem, side: Side | null): Outcome | null {
  if (!side) return null;
  return together([setColor(d, handle, side, OPEN), setNumbers(d, handle, side, "opacity", OPEN)]);
}

/** Takes the blur of sides away that have nothing to blur. */
function withoutIdleBlur(d: Drawing, curve: CurveItem): Outcome | null {
  const idle = SIDES.filter((side) => !bears(curve[side].color) && !bears(curve[side].opacity));
  if (idle.length === 2) return setBoth(d, curve.handle, "blur", OPEN);
  return idle.length === 0 ? null : setNumbers(d, curve.handle, idle[0], "blur", OPEN);
}

/** Each side ends with the colour that it begins with; no colour before the end is lost. */
function withoutSeam(d: Drawing, curve: CurveItem): Outcome | null {
  return together(
    SIDES.map((side) => {
      const { color } = curve[side];
      if (color.kind !== "stops" || meets(color.stops)) return null;
      const stops = closedBy(color.stops, endOffset(curve, color.space));
      return setColor(d, curve.handle, side, { ...color, stops });
    }),
  );
}

/** The vector of a curve's own coordinates from a point of it to the nearest other curve of its layer. */
function towardsOthers(d: Drawing, curve: CurveItem, point: Point): Point | null {
  const layer = layerOf(curve);
  const back = inverted(curve.layerFromItem);
  if (!layer || !back) return null;
  let best: Point | null = null;
  let least = MISS_PX * pixelOf(d);
  for (const other of curvesWithin(layer)) {
    if (other === curve) continue;
    const hereFromOther = composed(back, other.layerFromItem);
    const otherFromHere = inverted(hereFromOther);
    if (!otherFromHere) continue;
    for (const path of other.paths) {
      const met = mapped(hereFromOther, nearestOn(path, mapped(otherFromHere, point)).point);
      const by: Point = [met[0] - point[0], met[1] - point[1]];
      const length = Math.hypot(...mappedVector(curve.artboardFromItem, by));
      if (length >= least) continue;
      least = length;
      best = by;
    }
  }
  return best;
}

/** Moves the ends of open subpaths that nearly meet another curve onto it. */
function ended(d: Drawing, curve: CurveItem): Outcome | null {
  for (const [index, path] of curve.paths.map(nodePath).entries()) {
    if (!isOpen(path)) continue;
    const last = (path.points.length - 1) / 3;
    for (const node of [0, last]) {
      const by = towardsOthers(d, curve, path.points[3 * node]);
      if (!by || Math.hypot(...by) < finestStep(d)) continue;
      return moveNodes(d, curve.handle, new Map([[index, [node]]]), by, finestStep(d));
    }
  }
  return null;
}

/** The open sides of closed curves in the lowest layer stop colours. */
function withBarriers(d: Drawing): Outcome | null {
  const lowest = [...d.all()].find(({ kind, hidden }) => kind === "layer" && !hidden);
  const isClosed = (path: CubicPath) => !isOpen(path);
  return together(
    (lowest ? curvesWithin(lowest) : []).map((curve) => {
      const [left, right] = SIDES.map((side) => bears(curve[side].color));
      if (left === right || !curve.paths.every(isClosed)) return null;
      const other = left ? "right" : "left";
      if (curve[other].color.kind !== "open") return null;
      return setColor(d, curve.handle, other, { kind: "barrier" });
    }),
  );
}

function withoutEmptyLayers(d: Drawing): Outcome | null {
  const isEmpty = (item: Item) => item.kind === "layer" && item.children.length === 0;
  return deleteItems(d, [...d.all()].filter(isEmpty).map(({ handle }) => handle));
}
