// Where a gradient or a texture lies: moved by one of its grips.
import {
  about,
  composed,
  inverted,
  mapped,
  translation,
  type Affine,
  type Point,
} from "../../../geometry/affine.js";
import { numberText } from "../../../geometry/path.js";
import { subtract } from "../../../geometry/vector.js";
import { setAttribute } from "../../../source/attributes.js";
import type { Edit } from "../../../source/patch.js";
import { paintFrame, transformOf, type Lengths, type PaintFrame } from "../../paint-frames.js";
import type { Drawing, Handle, Outcome, PaintAttribute, PaintGrip, Side } from "../../types.js";
import { finestStep, transformText } from "../mapping.js";
import { outcomeOf } from "../structure/together.js";

/** A frame is not made smaller than this share of itself at a time: it could not be made larger again. */
const LEAST = 1e-3;
/** A drag keeps the focus within this share of the radius. Outside of the circle the gradient is a cone. */
const FOCUS = 0.99;
/** Shares of a box: finer than an eye. */
const FINE = 1e-5;
/** How far two directions may be from a right angle, and two lengths from each other, of one. */
const SQUARE = 1e-6;

/** Whether circles stay circles, and keep their way round. */
function isSimilarity([a, b, c, d]: Affine): boolean {
  const slack = SQUARE * Math.hypot(a, b);
  return Math.abs(a - d) <= slack && Math.abs(b + c) <= slack;
}

const isUpright = (map: Affine) => isSimilarity(map) && map[0] > 0 && Math.abs(map[1]) <= SQUARE * map[0];

/** The map about a point that takes a vector to another. */
function turnedAndScaled(middle: Point, [fx, fy]: Point, [tx, ty]: Point): Affine {
  const square = fx * fx + fy * fy;
  const [a, b] = [(tx * fx + ty * fy) / square, (ty * fx - tx * fy) / square];
  return about(middle, [a, b, -b, a, 0, 0]);
}

const atLeast = (share: number) => Math.max(LEAST, share);

/** The frame with a grip elsewhere, in the curve's coordinates. */
function pulledFrame({ kind, itemFromFrame: map }: PaintFrame, grip: PaintGrip, to: Point): Affine {
  const [start, end, across] = [mapped(map, [0, 0]), mapped(map, [1, 0]), mapped(map, [0, 1])];
  if (kind === "linear") {
    const [from, until] = grip === "start" ? [to, end] : [start, to];
    const [dx, dy] = subtract(until, from);
    return [dx, dy, -dy, dx, from[0], from[1]];
  }
  if (grip === "start") return composed(translation(...subtract(to, start)), map);
  const axis = grip === "end" ? subtract(end, start) : subtract(across, start);
  const pull = subtract(to, start);
  if (grip === "across") {
    const share = (pull[0] * axis[0] + pull[1] * axis[1]) / (axis[0] ** 2 + axis[1] ** 2);
    return composed(map, [1, 0, 0, atLeast(share), 0, 0]);
  }
  const share = atLeast(Math.hypot(...pull) / Math.hypot(...axis));
  // Nobody sees a circle turn.
  if (kind === "radial" && isSimilarity(map)) return composed(map, [share, 0, 0, share, 0, 0]);
  return composed(turnedAndScaled(start, axis, pull), map);
}

/** Returns the lengths of a frame in the coordinates that they count in; null: it needs a transform. */
function lengthsOf({ kind, focus, isSaid }: PaintFrame, frame: Affine): Lengths | null {
  const [a, b, , , e, f] = frame;
  if (kind === "linear") return { x1: e, y1: f, x2: e + a, y2: f + b };
  if (kind === "texture" || !isUpright(frame)) return null;
  const hasFocus = isSaid("fx") || isSaid("fy");
  const [fx, fy] = mapped(frame, focus ?? [0, 0]);
  return { cx: e, cy: f, r: a, ...(hasFocus ? { fx, fy } : {}) };
}

/** Returns attributes for the lengths that differ from the present ones. */
function setLengths(d: Drawing, now: PaintFrame, lengths: Lengths, step: number): Edit[] {
  const { element, itemFromBox } = now;
  const size = Math.hypot(itemFromBox[0], itemFromBox[1]);
  const isInBox = itemFromBox[0] !== 1 || itemFromBox[3] !== 1;
  const fine = isInBox ? Math.min(FINE, step / size) : step;
  return Object.entries(lengths)
    .filter(([name, value]) => numberText(value, fine) !== numberText(now.lengths[name], fine))
    .flatMap(([name, value]) => setAttribute(d.text, element, name, numberText(value, fine)));
}

/** The paint's transform that leads its lengths, as they are, to a frame. */
function setPaintTransform(d: Drawing, now: PaintFrame, wanted: Affine): Edit[] {
  const { kind, element, itemFromBox, itemFromFrame, transform } = now;
  // From the frame that the lengths say to the curve: before, and as it is wanted.
  const change = composed(wanted, inverted(itemFromFrame) as Affine);
  const box = inverted(itemFromBox);
  if (!box) return [];
  const next =
    kind === "texture"
      ? composed(change, transform)
      : composed(box, composed(change, composed(itemFromBox, transform)));
  const extent = Math.max(1, ...d.artboard.map(Math.abs));
  const text = transformText(next, extent, finestStep(d));
  // Without one of its own it would have the one that it inherits.
  return setAttribute(d.text, element, transformOf[kind], text ?? (now.inherits ? "translate(0 0)" : null));
}

/** The focus at a point of the curve's coordinates, within the circle. */
function pulledFocus(d: Drawing, now: PaintFrame, to: Point, step: number): Edit[] {
  const back = inverted(now.itemFromFrame);
  if (!back || now.kind !== "radial") return [];
  const [x, y] = mapped(back, to);
  const share = Math.min(1, FOCUS / Math.max(Math.hypot(x, y), 1e-9));
  const { cx, cy, r } = now.lengths;
  return setLengths(d, now, { fx: cx + r * share * x, fy: cy + r * share * y }, step);
}

/**
 * Takes a grip of the paint that a side shows to a point. Lengths change where they can say it, else
 * the paint's transform does. The paint changes on all sides that show it.
 * @param to in the curve's coordinates
 * @param step what coordinates are rounded to
 */
export function movePaint(
  d: Drawing,
  handle: Handle,
  side: Side,
  attribute: PaintAttribute,
  grip: PaintGrip,
  to: Point,
  step: number,
): Outcome | null {
  const item = d.item(handle);
  if (item?.kind !== "curve" && item?.kind !== "stroke") return null;
  const now = paintFrame(d, item, side, attribute);
  if (!now) return null;
  if (grip === "focus") return outcomeOf(pulledFocus(d, now, to, step));
  const wanted = pulledFrame(now, grip, to);
  if (!inverted(wanted)) return null;
  const own = inverted(now.itemFromOwn);
  const lengths = own && lengthsOf(now, composed(own, wanted));
  return outcomeOf(lengths ? setLengths(d, now, lengths, step) : setPaintTransform(d, now, wanted));
}
