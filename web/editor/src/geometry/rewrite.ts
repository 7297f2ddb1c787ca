// A subpath exchanged within path data: what did not change keeps how it is written.
import type { Point } from "./affine.js";
import { pieceAt, pieceCount, segmentsOf, isLine, type CubicPath } from "./cubic.js";
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
  /** Of each segment; the last may be the Z. */
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

/** The number among all subpaths of one that is counted among those that have a length. */
function numberOf(text: PathText, index: number): number {
  const numbers = text.paths.map((_, i) => i).filter((i) => hasLength(text.paths[i]));
  if (numbers[index] === undefined) throw new RangeError("there is no such subpath");
  return numbers[index];
}

function isSamePiece(a: CubicPath, i: number, b: CubicPath, j: number): boolean {
  const [p, q] = [pieceAt(a, i), pieceAt(b, j)];
  return p.every((point, k) => isSame(point, q[k]));
}

/** A stretch of the new path: a segment as it was, or one piece, in the place of one or none. */
interface Stretch {
  readonly piece: number;
  readonly pieces: number;
  readonly kept: number | null;
  readonly like: number | null;
}

/** Whether a segment is as it was, in pieces that stand `shift` further on. */
function keeps(
  before: CubicPath,
  after: CubicPath,
  segments: readonly number[],
  segment: number,
  shift: number,
): boolean {
  const [from, to] = [segments[segment], segments[segment + 1]];
  if (from + shift < 0 || to + shift > pieceCount(after)) return false;
  for (let i = from; i < to; ++i) if (!isSamePiece(before, i, after, i + shift)) return false;
  return true;
}

/** Segments before and behind what was exchanged for another number of pieces. */
function commonEnds(before: CubicPath, after: CubicPath): { head: number; tail: number } {
  const segments = segmentsOf(before);
  const shift = pieceCount(after) - pieceCount(before);
  let head = 0;
  while (head < segments.length - 1 && keeps(before, after, segments, head, 0)) ++head;
  let tail = segments.length - 1;
  const isFree = (segment: number) => segments[segment] + shift >= segments[head];
  while (tail > head && isFree(tail - 1) && keeps(before, after, segments, tail - 1, shift)) --tail;
  return { head, tail };
}

function stretchesOf(before: CubicPath, after: CubicPath): Stretch[] {
  const segments = segmentsOf(before);
  const count = segments.length - 1;
  const shift = pieceCount(after) - pieceCount(before);
  const single = (piece: number, like: number | null): Stretch => ({
    piece,
    pieces: 1,
    kept: null,
    like,
  });
  const sameOf = (from: number, to: number, by: number): Stretch[] =>
    Array.from({ length: to - from }, (_, i) => from + i).flatMap((segment) => {
      const piece = segments[segment] + by;
      const pieces = segments[segment + 1] - segments[segment];
      if (keeps(before, after, segments, segment, by))
        return [{ piece, pieces, kept: segment, like: segment }];
      return Array.from({ length: pieces }, (_, i) => single(piece + i, segment));
    });
  if (shift === 0) return sameOf(0, count, 0);
  const { head, tail } = commonEnds(before, after);
  const first = segments[head];
  const middle = Array.from({ length: segments[tail] + shift - first }, (_, i) =>
    single(first + i, i === 0 && head < tail ? head : null),
  );
  return [...sameOf(0, head, 0), ...middle, ...sameOf(tail, count, shift)];
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

  /** What parts a command, that of a segment, from the one before it. */
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

/** What follows the subpath, so that it draws what it drew. `pen` stands where it begins now. */
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
 * Path data in which one subpath is another; null takes it away. Segments whose points are as
 * before keep their text, relative or absolute; the others are written like what they take the
 * place of. What comes out reads back as `after` within half a step.
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
  const pen = new Rewriter(d, region, before, after, step, styleOf(d)).run();
  const result = put(pen.text, pen.current, pen.begin);
  if (draws(result, wanted, step)) return result;
  const whole = writePath(after, step);
  const [path] = readPathText(whole)?.paths ?? [after];
  return put(whole, path.points[path.closed ? 0 : path.points.length - 1], path.points[0]);
}
