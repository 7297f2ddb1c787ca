// Path data walked the other way, segment by segment.
import type { Point } from "./affine.js";
import { segmentsOf, type CubicPath } from "./cubic.js";
import { readPathText, type Command } from "./pathreader.js";
import { numberText } from "./pathwriter.js";
import { lerp } from "./vector.js";

/** Sums of decimals are written as the decimals that they are. */
const FINER = 1000;

/**
 * Returns path data in which each subpath runs backwards, with the same segments in reverse order: lines,
 * curves and arcs keep their kind, and a closed subpath keeps its beginning. null: the data has an error.
 */
export function reversedData(d: string, step: number): string | null {
  const text = readPathText(d);
  if (!text) return null;
  const write = (value: number) => numberText(value, step / FINER);
  return text.paths
    .map((path, i) => {
      const drawing = text.commands.filter((command) => command.drawn?.subpath === i);
      return backwards(path, drawing, write);
    })
    .join(" ");
}

function backwards(
  path: CubicPath,
  drawing: readonly Command[],
  write: (value: number) => string,
): string {
  const segments = segmentsOf(path);
  const { points } = path;
  const text = (...list: readonly Point[]) => list.map((p) => p.map(write).join(" ")).join(" ");
  const parts = [`M${text(points[points.length - 1])}`];
  for (let i = drawing.length - 1; i >= 0; --i) {
    const { op, numbers } = drawing[i];
    const begin = 3 * segments[i];
    const from = points[begin];
    const [control1, control2, to] = points.slice(begin + 1, begin + 4);
    if (op === "A") {
      const [rx, ry, turn, large, sweep] = numbers;
      parts.push(`A${[rx, ry, turn].map(write).join(" ")} ${large} ${1 - sweep} ${text(from)}`);
    } else if (op === "C" || op === "S") {
      parts.push(`C${text(control2, control1, from)}`);
    } else if (op === "Q" || op === "T") {
      parts.push(`Q${text(lerp(to, control2, 1.5), from)}`);
    } else {
      parts.push(`L${text(from)}`);
    }
  }
  if (path.closed) parts.push("Z");
  return parts.join(" ");
}
