// How fine the picture is to be made for what is seen of it.
import type { Box } from "../geometry/affine.js";
import type { SolveOptions } from "./session.js";

/** Longer side of a picture that is made whole, pixels; nearer, a part of it is made. */
const WHOLE = 4096;
/** The least size: a smaller one would show chords of the paper's mesh. */
const LEAST = 512;
/** How much nearer a picture may be seen than it was made for: its chords then stray by 0.08 pixels. */
const NEARER = 2;

/** The settings of the last picture. */
export interface Detail {
  /** Pixels to an artboard unit. */
  readonly pixelsPerUnit: number;
  /** Part of the artboard; null: all. */
  readonly part: Box | null;
  /** The box that `part` and the options' width refer to. */
  readonly artboard: Box;
  readonly options: SolveOptions;
}

const widthOf = ([x0, , x1]: Box) => x1 - x0;
const heightOf = ([, y0, , y1]: Box) => y1 - y0;
const sideOf = (box: Box) => Math.max(widthOf(box), heightOf(box));

function holds(outer: Box, inner: Box): boolean {
  return outer[0] <= inner[0] && outer[1] <= inner[1] && outer[2] >= inner[2] && outer[3] >= inner[3];
}

function cut(a: Box, b: Box): Box {
  return [Math.max(a[0], b[0]), Math.max(a[1], b[1]), Math.min(a[2], b[2]), Math.min(a[3], b[3])];
}

/** Returns the next power of two, so that a small zoom needs no new picture. */
function rounded(pixelsPerUnit: number): number {
  return 2 ** Math.ceil(Math.log2(pixelsPerUnit) - 1e-9);
}

/** @param known what there is; it comes back where it will do */
export function detailFor(
  pixelsPerUnit: number,
  seen: Box,
  artboard: Box,
  known: Detail | null,
): Detail {
  const before = known?.artboard.every((k, i) => k === artboard[i]) ? known : null;
  const side = sideOf(artboard) || 1;
  const wanted = Math.max(rounded(pixelsPerUnit), LEAST / side);
  const visible = cut(seen, artboard);
  const isEmpty = !(visible[0] < visible[2] && visible[1] < visible[3]);
  const isFineEnough = before !== null && NEARER * before.pixelsPerUnit >= pixelsPerUnit;
  const isNotTooFine = before !== null && before.pixelsPerUnit <= 4 * wanted;
  const isThere = before?.part === null || (before && holds(before.part, visible));
  if (before && isThere && (isEmpty || (isFineEnough && isNotTooFine))) return before;
  if (wanted * side <= WHOLE || isEmpty) {
    const fine = Math.min(wanted, WHOLE / side);
    const width = Math.max(1, Math.round(widthOf(artboard) * fine));
    return { pixelsPerUnit: fine, part: null, artboard, options: { width } };
  }
  return partDetail(wanted, visible, artboard);
}

/** Returns the visible part, grown by half of it on each side, so that a pan stays inside. */
function partDetail(pixelsPerUnit: number, visible: Box, artboard: Box): Detail {
  const [dx, dy] = [widthOf(visible) / 2, heightOf(visible) / 2];
  const part = cut([visible[0] - dx, visible[1] - dy, visible[2] + dx, visible[3] + dy], artboard);
  const viewport = [part[0], part[1], widthOf(part), heightOf(part)].join(",");
  const width = Math.max(1, Math.round(widthOf(part) * pixelsPerUnit));
  return { pixelsPerUnit, part, artboard, options: { viewport, width } };
}
