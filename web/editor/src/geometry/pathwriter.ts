// Curves as path data.
import type { Point } from "./affine.js";
import { isLine, nodeCount, pieceAt, pieceCount, type CubicPath } from "./cubic.js";
import { closesWithoutLine } from "./pathbuilder.js";
import { isSame } from "./vector.js";

/** More decimals than this say nothing about a coordinate below 10^7. */
const MOST_DECIMALS = 12;

/** Returns the decimals that distinguish values one step apart. */
export function decimalsOf(step: number): number {
  if (!(step > 0)) return MOST_DECIMALS;
  // A step of 0.001 is no power of ten to the bit.
  return Math.min(Math.max(Math.ceil(-Math.log10(step) - 1e-9), 0), MOST_DECIMALS);
}

/** The shortest decimal within half a step of a value. */
export function numberText(value: number, step: number): string {
  const text = value.toFixed(decimalsOf(step));
  const short = text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  return short === "-0" ? "0" : short;
}

function pointText([x, y]: Point, step: number): string {
  return `${numberText(x, step)} ${numberText(y, step)}`;
}

/** Returns the point that the written numbers read back as. */
export function rounded([x, y]: Point, step: number): Point {
  return [Number(numberText(x, step)), Number(numberText(y, step))];
}

/**
 * Absolute commands: a line as L, or as Z where it closes the path, other pieces as C.
 * @param endStep of the ends of an open path: finer where they meet others
 */
export function writePath(path: CubicPath, step: number, endStep = step): string {
  const begin = rounded(path.points[0], step);
  const ends = path.closed ? step : endStep;
  const parts = [`M${pointText(path.points[0], ends)}`];
  for (let i = 0; i < pieceCount(path); ++i) {
    const cubic = pieceAt(path, i);
    const isLast = i === pieceCount(path) - 1;
    const [, control1, control2, written] = cubic;
    const end = path.closed && isLast ? path.points[0] : written;
    if (isLine(cubic)) {
      const previous = rounded(cubic[0], step);
      const drawnByZ = path.closed && isLast && i > 0 && !closesWithoutLine(previous, begin);
      if (!drawnByZ) parts.push(`L${pointText(end, isLast ? ends : step)}`);
    } else {
      const controls = [control1, control2].map((p) => pointText(p, step));
      parts.push(`C${[...controls, pointText(end, isLast ? ends : step)].join(" ")}`);
    }
  }
  if (path.closed) parts.push("Z");
  return parts.join(" ");
}

/** Whether two paths have the same nodes, pieces and ends: what stop offsets count. */
export function isSameShape(a: CubicPath, b: CubicPath): boolean {
  return (
    a.closed === b.closed &&
    nodeCount(a) === nodeCount(b) &&
    a.points.every((p, i) => isSame(p, b.points[i]))
  );
}
