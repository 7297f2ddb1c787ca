// Writes commands of a path one behind the other, and knows what a reader makes of them.
import type { Point } from "./affine.js";
import { isLine, type Cubic } from "./cubic.js";
import { PathBuilder, closesWithoutLine } from "./pathbuilder.js";
import { drawCommand, type Command, type Pen } from "./pathreader.js";
import { numberText } from "./pathwriter.js";
import { distance, lerp } from "./vector.js";

/** Points that stay where they are are written finer, so that many edits do not let them drift. */
const FINER = 1000;

/** How the numbers of a path are written: what to imitate. */
export interface Style {
  readonly comma: boolean;
  readonly blankBehindLetter: boolean;
}

export function styleOf(d: string): Style {
  return { comma: /\d,[-+.\d]/.test(d), blankBehindLetter: /[a-zA-Z]\s/.test(d) };
}

/** The command that a new command resembles, and the one that follows it. */
export interface Wish {
  /** Letter of the command that it replaces. */
  readonly op: string;
  readonly isRelative: boolean;
  readonly gap: string;
  readonly hasLetter: boolean;
  /** Its end has not moved: it is written finer. */
  readonly endStays: boolean;
  /** S follows: the last control point is written finer too. */
  readonly isMirrored: boolean;
  /** Z follows, and must draw no line. */
  readonly closes: boolean;
}

export class PathPen {
  text = "";
  #pen: Pen;
  /** The letter that numbers without one continue. */
  #letter = "";
  #isVerbatim = false;

  constructor(
    before: Pen,
    readonly step: number,
    readonly style: Style,
  ) {
    this.#pen = before;
  }

  get current(): Point {
    return this.#pen.current;
  }

  get begin(): Point {
    return this.#pen.begin;
  }

  /** A command as it stands in `d`, where it draws these points now; else nothing, and false. */
  keep(
    d: string,
    gap: string,
    command: Command,
    points: readonly Point[],
    closes: boolean,
  ): boolean {
    const { op, isRelative, numbers } = command;
    const [drawn, pen] = this.#drawnBy(op, isRelative, numbers);
    const slack = 0.5 * this.step * (1 + 1e-6);
    if (drawn.length !== points.length) return false;
    if (!drawn.every((p, i) => distance(p, points[i]) <= Math.max(slack, roundingOf(p))))
      return false;
    if (closes && !closesWithoutLine(pen.current, this.begin)) return false;
    this.#put(gap, d.slice(command.start, command.end), command);
    this.#pen = pen;
    this.#isVerbatim = true;
    return true;
  }

  moveTo(point: Point, isRelative: boolean, endStays: boolean): void {
    this.#write(" ", "M", isRelative, true, [point], endStays ? 1 : 0);
  }

  /** One piece, as a command as near to the wish as its shape allows. */
  draw(cubic: Cubic, wish: Wish): void {
    const op = this.#opFor(cubic, wish);
    const [, control1, control2, end] = cubic;
    const points = {
      L: [end],
      H: [end],
      V: [end],
      Q: [quadraticControl(cubic), end],
      S: [control2, end],
      C: [control1, control2, end],
    }[op];
    const { gap, hasLetter, isRelative } = wish;
    const fine = wish.isMirrored ? 2 : wish.endStays ? 1 : 0;
    const before = { text: this.text, pen: this.#pen, letter: this.#letter };
    this.#write(gap, op, isRelative, hasLetter, points, fine);
    if (!wish.closes || closesWithoutLine(this.current, this.begin)) return;
    // Rounding left a gap, which Z would fill with a line: the very numbers of the beginning do
    // not.
    this.text = before.text;
    this.#pen = before.pen;
    this.#letter = before.letter;
    const closing = op === "H" || op === "V" ? [this.begin] : [...points.slice(0, -1), this.begin];
    this.#write(gap, op === "H" || op === "V" ? "L" : op, false, true, closing, 0, true);
  }

  close(gap: string, letter: string): void {
    this.text += gap + letter;
    this.#pen = { current: this.begin, begin: this.begin, cubic: null, quadratic: null };
    this.#letter = "";
  }

  #opFor(cubic: Cubic, wish: Wish): "L" | "H" | "V" | "Q" | "S" | "C" {
    const [, control1, , end] = cubic;
    const { current, cubic: last } = this.#pen;
    if ("LHVZ".includes(wish.op) && isLine(cubic)) {
      const slack = 0.5 * this.step;
      if (wish.closes) return "L";
      if (wish.op === "H" && Math.abs(end[1] - current[1]) <= slack) return "H";
      return wish.op === "V" && Math.abs(end[0] - current[0]) <= slack ? "V" : "L";
    }
    if ("QT".includes(wish.op) && isQuadratic(cubic)) return "Q";
    const mirrored: Point = last ? [2 * current[0] - last[0], 2 * current[1] - last[1]] : current;
    return wish.op === "S" && distance(mirrored, control1) <= 0.5 * this.step ? "S" : "C";
  }

  /** @param finePoints how many of the last points are written finer */
  #write(
    gap: string,
    op: string,
    isRelative: boolean,
    hasLetter: boolean,
    points: readonly Point[],
    finePoints: number,
    isExact = false,
  ): void {
    const [ox, oy] = isRelative ? this.current : [0, 0];
    const texts = points.map(([x, y], i) => {
      const step = i >= points.length - finePoints ? this.step / FINER : this.step;
      const write = (value: number) => (isExact ? plainText(value) : numberText(value, step));
      return [write(x - ox), write(y - oy)] as const;
    });
    const pairs = op === "H" ? [texts[0][0]] : op === "V" ? [texts[0][1]] : this.#joined(texts);
    const letter = isRelative ? op.toLowerCase() : op;
    const written = hasLetter || this.#letter !== letter;
    const blank = this.style.blankBehindLetter ? " " : "";
    this.#isVerbatim = false;
    this.#put(gap, (written ? letter + blank : "") + pairs.join(" "), {
      op,
      isRelative,
      hasLetter: written,
    });
    const numbers = op === "H" ? [texts[0][0]] : op === "V" ? [texts[0][1]] : texts.flat();
    this.#pen = this.#drawnBy(op, isRelative, numbers.map(Number))[1];
  }

  #joined(texts: readonly (readonly [string, string])[]): string[] {
    return texts.map((pair) => pair.join(this.style.comma ? "," : " "));
  }

  /** Adds text behind a gap, with the letter and the blank that it needs where it stands now. */
  #put(gap: string, text: string, as: Pick<Command, "op" | "isRelative" | "hasLetter">): void {
    const letter = as.isRelative ? as.op.toLowerCase() : as.op;
    const needsLetter = !as.hasLetter && this.#letter !== letter;
    const begins = as.hasLetter || needsLetter;
    let parted = begins ? gap.replaceAll(",", " ") : gap;
    const mayTouch = begins || this.#isVerbatim || /^[-+]/.test(text);
    if (parted === "" && !mayTouch) parted = " ";
    this.text += parted + (needsLetter ? letter : "") + text;
    this.#letter = { M: "L", m: "l" }[letter] ?? letter;
  }

  /** The points behind the current one that a command draws, and the pen afterwards. */
  #drawnBy(op: string, isRelative: boolean, numbers: readonly number[]): [readonly Point[], Pen] {
    const builder = new PathBuilder();
    builder.moveTo(this.current);
    const { cubic, quadratic } = drawCommand(builder, op, isRelative, numbers, this.#pen);
    const { current } = builder;
    builder.finish();
    const begin = op === "M" ? current : this.begin;
    return [builder.done[0]?.points.slice(1) ?? [current], { current, begin, cubic, quadratic }];
  }
}

/** How far sums of decimals may stray. */
function roundingOf(point: Point): number {
  return 1e-12 * Math.max(Math.abs(point[0]), Math.abs(point[1]));
}

/** A number that reads back to the bit, without an exponent where it has few decimals. */
function plainText(value: number): string {
  return Object.is(value, -0) ? "0" : String(value);
}

function quadraticControl([p0, p1]: Cubic): Point {
  return lerp(p0, p1, 1.5);
}

/** Whether a quadratic curve, raised by a degree, is the piece. */
function isQuadratic(cubic: Cubic): boolean {
  const [p0, , p2, p3] = cubic;
  const slack = 1e-9 * Math.max(...cubic.flat().map(Math.abs));
  return distance(lerp(p3, p2, 1.5), quadraticControl(cubic)) <= slack && distance(p0, p3) > 0;
}
