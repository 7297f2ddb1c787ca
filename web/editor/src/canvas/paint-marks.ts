// Grips of the gradients and textures that the chosen curve's sides show, and the lines between them.
import { nameOfSide } from "../app/side-names.js";
import { composed, mapped, type Affine, type Point } from "../geometry/affine.js";
import { distance } from "../geometry/vector.js";
import { paintFrame, placeInFrame, type PaintFrame } from "../model/paint-frames.js";
import type { CurveItem, Drawing, PaintAttribute, PaintGrip, Part, Side } from "../model/types.js";
import * as en from "../strings/en.js";
import type { PaintMark } from "./marks.js";
import { SIDES } from "./sides.js";
import { isSamePart } from "./part.js";

/** A focus that is nearer to the middle cannot be taken apart from it, CSS pixels. */
const APART = 9;

interface ShownPaint extends PaintFrame {
  readonly side: Side;
  readonly attribute: PaintAttribute;
}

/** Returns the paints that the sides show for an attribute; a paint of both sides once. */
export function shownPaints(d: Drawing, item: CurveItem, attribute: PaintAttribute): ShownPaint[] {
  const found: ShownPaint[] = [];
  for (const side of SIDES) {
    const frame = paintFrame(d, item, side, attribute);
    if (frame && found.every(({ element }) => element !== frame.element))
      found.push({ ...frame, side, attribute });
  }
  return found;
}

/** @param apart how far the focus is from the middle, CSS pixels */
function gripsOf({ kind }: ShownPaint, apart: number): readonly PaintGrip[] {
  if (kind === "linear") return ["start", "end"];
  const hasFocus = kind === "radial" && apart > APART;
  return hasFocus ? ["start", "end", "across", "focus"] : ["start", "end", "across"];
}

/** @param map to the stage from the curve's coordinates */
export function paintMarks(
  d: Drawing,
  item: CurveItem,
  map: Affine,
  attribute: PaintAttribute,
  parts: readonly Part[],
): PaintMark[] {
  return shownPaints(d, item, attribute).flatMap((paint) => {
    const { kind, side } = paint;
    const stage = composed(map, paint.itemFromFrame);
    const place = (grip: PaintGrip) => mapped(stage, placeInFrame(paint, grip));
    const start = place("start");
    const mark = (grip: PaintGrip): PaintMark => {
      const part = { kind: "paint", side, attribute, grip } as const;
      const isChosen = parts.some((one) => isSamePart(one, part));
      const label = en.canvas.paint(kind, grip, nameOfSide(item, side));
      const at = place(grip);
      return { kind: "paint", at, foot: start, handle: item.handle, part, paint: kind, isChosen, label };
    };
    return gripsOf(paint, distance(place("focus"), start)).map(mark);
  });
}

/** A circle of four cubics, by the usual length of their handles. */
const ARC = 0.5522847498;
const CIRCLE: readonly Point[] = [
  [1, 0], [1, ARC], [ARC, 1], [0, 1], [-ARC, 1], [-1, ARC], [-1, 0],
  [-1, -ARC], [-ARC, -1], [0, -1], [ARC, -1], [1, -ARC], [1, 0],
];
const SQUARE: readonly Point[] = [[0, 0], [1, 0], [1, 1], [0, 1]];

/** Path data of the circle or the tile on the stage; of a line none, which its grips' line shows. */
export function paintOutline({ kind, itemFromFrame }: ShownPaint, map: Affine): string {
  if (kind === "linear") return "";
  const stage = composed(map, itemFromFrame);
  const text = (point: Point) => mapped(stage, point).map((k) => k.toFixed(2)).join(" ");
  const points = kind === "radial" ? CIRCLE : SQUARE;
  return `M${text(points[0])}${kind === "radial" ? "C" : "L"}${points.slice(1).map(text).join(" ")}Z`;
}
