// A subpath exchanged within path data: what did not change keeps how it is written.
import type { Point } from "./affine.js";
import {
  isLine,
  isSameCubic,
  pieceAt,
  pieceCount,
  segmentsOf,
  type CubicPath,
} from "./cubic.js";
import { closesWithoutLine } from "./pathbuilder.js";
import { PathPen, styleOf, type Style } from "./pathpen.js";
import { readPathText, type Command, type PathText, type Pen } from "./pathreader.js";
import { writePath } from "./pathwriter.js";
import { hasLength } from "./shape.js";
import { distance, isSame } from "./vector.js";

const START: Pen = { current: [0, 0], begin: [0, 0], cubic: null, quadratic: null };

/** A subpath in the text: its M, what draws its segments, and its Z. */
interface Region {
  readonly move: Command | null;
  /** The command of each segment; the last may be the Z. */
  readonly drawing: readonly Command[];
  /** Z, also where it draws a line. */
  readonly close: Command | null;
  readonly next: Command | null;
  readonly start: number;
  readonly end: number;
}

function regionOf({ commands }: PathText, subpath: number): Region {
  const drawing = commands.filter((c) => c.drawn?.subpath === subpath);
  const first = commands.indexOf(drawing[0]);
  const last = drawing[drawing.length - 1];
  const behind = commands[commands.indexOf(last) + 1];
  const close = last.op === "Z" ? last : behind?.op === "Z" ? behind : null;
  const before = commands[first - 1];
  const move = before?.op === "M" ? before : null;
  const end = close ?? last;
  return {
    move,
    drawing,
    close,
    next: commands[commands.indexOf(end) + 1] ?? null,
    start: (move ?? drawing[0]).start,
    end: end.end,
  };
}

/** Returns a subpath's number among all, from its number among the subpaths with a length. */
function numberOf(text: PathText, index: number): number {
  const numbers = text.paths.map((_, i) => i).filter((i) => hasLength(text.paths[i]));
  if (numbers[index] === undefined) throw new RangeError("there is no such subpath");
  return numbers[index];
}

/** A stretch of the new path: a segment as it was, or one piece, in the place of one or none. */
interface Stretch {
  readonly piece: number;
  readonly pieces: number;
  readonly kept: number | null;
  readonly like: number | null;
}

/** Whether a segment of `after` draws what one of `before` drew. */
function isKept(
  before: CubicPath,
  [from, to]: readonly [number, number],
  after: CubicPath,
  [start, end]: readonly [number, number],
): boolean {
  if (to - from !== end - start) return false;
  for (let i = 0; i < to - from; ++i)
    if (!isSameCubic(pieceAt(before, from + i), pieceAt(after, start + i))) return false;
  return true;
}

/**
 * For each segment of `after` the one of `before` that it is; null: it is new. Where both have as
 * many, each stands in its place, else they are found by where they begin.
 */
function matches(before: CubicPath, after: CubicPath): (number | null)[] {
  const [old, now] = [segmentsOf(before), segmentsOf(after)];
  const isSameSegment = (j: number, i: number) =>
    isKept(before, [old[j], old[j + 1]], after, [now[i], now[i + 1]]);
  const indices = Array.from({ length: now.length - 1 }, (_, i) => i);
  if (old.length === now.length) return indices.map((i) => (isSameSegment(i, i) ? i : null));
  const key = ([x, y]: Point) => `${x} ${y}`;
  const starts = new Map<string, number[]>();
  for (let j = 0; j + 1 < old.length; ++j) {
    const at = key(before.points[3 * old[j]]);
    starts.set(at, [...(starts.get(at) ?? []), j]);
  }
  let next = 0;
  return indices.map((i) => {
    const candidates = starts.get(key(after.points[3 * now[i]])) ?? [];
    const found = candidates.find((j) => j >= next && isSameSegment(j, i));
    if (found === undefined) return null;
    next = found + 1;
    return found;
  });
}

function stretchesOf(before: CubicPath, after: CubicPath): Stretch[] {
  const now = segmentsOf(after);
  const hasSameCount = segmentsOf(before).length === now.length;
  const kept = matches(before, after);
  const stretches: Stretch[] = [];
  for (let i = 0; i + 1 < now.length; ++i) {
    const [piece, end] = [now[i], now[i + 1]];
    if (kept[i] !== null) {
      stretches.push({ piece, pieces: end - piece, kept: kept[i], like: kept[i] });
      continue;
    }
    const like = hasSameCount ? i : firstReplaced(before, kept, i);
    for (let k = piece; k < end; ++k) stretches.push({ piece: k, pieces: 1, kept: null, like });
  }
  return stretches;
}

/**
 * Returns the number of the first segment that a run of new ones replaces, which the first new one resembles;
 * null: none.
 */
function firstReplaced(
  before: CubicPath,
  kept: readonly (number | null)[],
  i: number,
): number | null {
  if (i > 0 && kept[i - 1] === null) return null;
  const next = i > 0 ? kept[i - 1]! + 1 : 0;
  const behind = kept.slice(i).find((one) => one !== null) ?? segmentsOf(before).length - 1;
  return next < behind ? next : null;
}

/** Segments of a path for which none are said: as many pieces as before are in the same ones. */
function withSegments(before: CubicPath, after: CubicPath): CubicPath {
  const isAlike = !after.segments && pieceCount(after) === pieceCount(before);
  return isAlike && before.segments ? { ...after, segments: before.segments } : after;
}

class Rewriter {
  readonly #pen: PathPen;
  readonly #isRelative: boolean;

  constructor(
    readonly d: string,
    readonly region: Region,
    readonly before: CubicPath,
    readonly after: CubicPath,
    step: number,
    style: Style,
  ) {
    const { move, drawing } = region;
    this.#pen = new PathPen((move ?? drawing[0]).before, step, style);
    this.#isRelative = drawing[0].isRelative;
  }

  run(): PathPen {
    this.#begin();
    const { after } = this;
    const stretches = stretchesOf(this.before, after);
    stretches.forEach((stretch, i) => this.#draw(stretch, stretches[i + 1]));
    if (after.closed) this.#close();
    return this.#pen;
  }

  #begin(): void {
    const { move, drawing } = this.region;
    const [begin] = this.after.points;
    const stays = isSame(begin, this.before.points[0]);
    if (!move && stays && isSame(drawing[0].before.begin, begin)) return;
    if (move && this.#pen.keep(this.d, "", move, [begin], false)) return;
    this.#pen.moveTo(begin, move?.isRelative ?? false, stays);
    this.#pen.text = this.#pen.text.trimStart();
  }

  #draw({ piece, pieces, kept, like }: Stretch, next: Stretch | undefined): void {
    const { after, region } = this;
    const command = like === null ? null : region.drawing[like];
    const isLast = next === undefined;
    const cubic = pieceAt(after, piece + pieces - 1);
    const byZ =
      isLast &&
      after.closed &&
      isLine(cubic) &&
      (command === null || command.op === "Z") &&
      pieceCount(after) > 1 &&
      !closesWithoutLine(this.#pen.current, this.#pen.begin);
    if (byZ) return;
    const closes = isLast && after.closed;
    const gap = command && command.op !== "Z" ? this.#gapBefore(command, like) : " ";
    const points = after.points.slice(3 * piece + 1, 3 * (piece + pieces) + 1);
    if (kept !== null && command && command.op !== "Z") {
      if (this.#pen.keep(this.d, gap, command, points, closes)) return;
    }
    for (let i = piece; i < piece + pieces; ++i) {
      this.#pen.draw(pieceAt(after, i), {
        op: command?.op ?? "L",
        isRelative: command && command.op !== "Z" ? command.isRelative : this.#isRelative,
        gap: i === piece ? gap : " ",
        hasLetter: (command?.hasLetter ?? false) && i === piece,
        endStays: isLast ? this.#endStays() : next.kept !== null,
        isMirrored: this.region.drawing[next?.kept ?? -1]?.op === "S",
        closes: closes && i === piece + pieces - 1,
      });
    }
  }

  #endStays(): boolean {
    const [old, now] = [this.before.points, this.after.points];
    return isSame(old[old.length - 1], now[now.length - 1]);
  }

  /** Returns the text that separates the command of a segment from the one before it. */
  #gapBefore(command: Command, segment: number | null): string {
    const { move, drawing } = this.region;
    const previous = drawing[(segment ?? 0) - 1] ?? move;
    return previous ? this.d.slice(previous.end, command.start) : "";
  }

  #close(): void {
    const { close, drawing } = this.region;
    const previous = drawing.at(close === drawing.at(-1) ? -2 : -1) ?? this.region.move;
    if (close && previous) {
      const gap = this.d.slice(previous.end, close.start);
      return this.#pen.close(gap, this.d.slice(close.start, close.end));
    }
    this.#pen.close(" ", this.#isRelative ? "z" : "Z");
  }
}

/**
 * Returns the text that follows the subpath, changed where it must be to draw the same. `pen` is where that
 * text begins now.
 */
function following(d: string, { next }: Region, pen: Pen, closed: boolean, step: number): string {
  if (!next) return "";
  const rest = d.slice(next.start);
  if (next.op !== "M") {
    if (closed && isSame(pen.begin, next.before.begin)) return rest;
    const [x, y] = next.before.begin;
    return `M${x} ${y} ${rest}`;
  }
  if (!next.isRelative || isSame(pen.current, next.before.current)) return rest;
  const [x, y] = next.before.current;
  const target: Point = [x + next.numbers[0], y + next.numbers[1]];
  const move = new PathPen(pen, step, styleOf(d));
  move.moveTo(target, true, true);
  const behind = d.slice(next.end);
  const parted = /^[\d.]/.test(behind) ? " " : "";
  return move.text.trimStart() + parted + behind;
}

function assembled(d: string, region: Region, middle: string, rest: string): string {
  const gap = region.next ? d.slice(region.end, region.next.start) : d.slice(region.end);
  const parted = rest !== "" && gap === "" && /\d$/.test(middle) && /^[\d.]/.test(rest) ? " " : "";
  return d.slice(0, region.start) + middle + gap + parted + rest;
}

/** Whether `d` draws these subpaths, within half a step. */
function draws(d: string, paths: readonly CubicPath[], step: number): boolean {
  const found = readPathText(d)?.paths ?? [];
  const isNear = (p: Point, q: Point) =>
    distance(p, q) <= 0.51 * Math.SQRT2 * step + 1e-12 * Math.max(...p.map(Math.abs));
  return (
    found.length === paths.length &&
    paths.every(
      ({ points, closed }, i) =>
        found[i].closed === closed &&
        found[i].points.length === points.length &&
        points.every((p, k) => isNear(p, found[i].points[k])),
    )
  );
}

/**
 * Returns path data in which one subpath is another; null removes it. Segments whose points are unchanged
 * keep their text, relative or absolute; the others are written like the segments that they replace. The
 * result reads back as `after` within half a step.
 * @param index among the subpaths that have a length, as readPath() gives them
 * @param before that subpath, as it was read
 * @throws RangeError where there is none
 */
export function rewritePath(
  d: string,
  index: number,
  before: CubicPath,
  after: CubicPath | null,
  step: number,
): string {
  const text = readPathText(d);
  if (!text) throw new RangeError("there is no such subpath");
  const number = numberOf(text, index);
  const region = regionOf(text, number);
  if (!after) {
    const pen = (region.move ?? region.drawing[0]).before;
    return assembled(d, region, "", following(d, region, pen, false, step)).trim();
  }
  const put = (middle: string, current: Point, begin: Point) => {
    const rest = following(d, region, { ...START, current, begin }, after.closed, step);
    return assembled(d, region, middle, rest);
  };
  const wanted = text.paths.map((path, i) => (i === number ? after : path));
  const pen = new Rewriter(d, region, before, withSegments(before, after), step, styleOf(d)).run();
  const result = put(pen.text, pen.current, pen.begin);
  if (draws(result, wanted, step)) return result;
  const whole = writePath(after, step);
  const [path] = readPathText(whole)?.paths ?? [after];
  return put(whole, path.points[path.closed ? 0 : path.points.length - 1], path.points[0]);
}
