// The d attribute of a path, as the engine reads it (src/formats/svg/shapes/path_data.cpp), with the place
// of each command.
import type { Point } from "./affine.js";
import type { CubicPath } from "./cubic.js";
import { PathBuilder } from "./pathbuilder.js";

/** The largest magnitude of a number, as in the engine. */
const LARGEST = 1e7;
const BLANKS = /[ \t\n\r\f]*/y;
const NUMBER = /[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/y;
const LETTERS = "MZLHVCSQTA";

/** The state of a reader between two commands. */
export interface Pen {
  readonly current: Point;
  /** Where Z leads. */
  readonly begin: Point;
  /** The last control point of C or S, else null: what S mirrors. */
  readonly cubic: Point | null;
  /** That of Q or T. */
  readonly quadratic: Point | null;
}

/** A command with its numbers. */
export interface Command {
  /** In upper case; further pairs after M are L. */
  readonly op: string;
  readonly isRelative: boolean;
  /**
   * Where its letter stands, or its first number where it has none; up to behind the last number.
   */
  readonly start: number;
  readonly end: number;
  readonly hasLetter: boolean;
  readonly numbers: readonly number[];
  readonly before: Pen;
  /** Which subpath of `paths` it draws, and which of its segments; null: it draws nothing. */
  readonly drawn: { readonly subpath: number; readonly segment: number } | null;
}

export interface PathText {
  readonly commands: readonly Command[];
  /** The subpaths with a segment, including segments of length 0. */
  readonly paths: readonly CubicPath[];
}

class Mistake extends Error {}

class Reader {
  #at = 0;
  #builder = new PathBuilder();
  #cubic: Point | null = null;
  #quadratic: Point | null = null;
  #commands: Command[] = [];

  constructor(readonly text: string) {}

  read(): PathText {
    this.#skipBlanks();
    if (this.text.slice(this.#at) !== "none") {
      let letter = "";
      while (this.#at < this.text.length) {
        letter = this.#command(letter);
        this.#skipBlanks();
      }
      this.#builder.finish();
    }
    return { commands: this.#commands, paths: this.#builder.done };
  }

  /** @returns the letter that numbers after this command continue */
  #command(last: string): string {
    const c = this.text[this.#at];
    const hasLetter = LETTERS.includes(c.toUpperCase());
    let letter = hasLetter ? c : last;
    if (!hasLetter) {
      if (last === "" || /[Zz]/.test(last) || !/[\d.+,-]/.test(c)) throw new Mistake();
      this.#skipSeparator();
      letter = last === "M" ? "L" : last === "m" ? "l" : last;
    } else if (last === "" && !/[Mm]/.test(c)) {
      throw new Mistake();
    }
    const start = this.#at;
    if (hasLetter) ++this.#at;
    const op = letter.toUpperCase();
    const isRelative = letter !== op;
    const before = this.#pen();
    const numbers = this.#numbers(op);
    const subpath = this.#builder.done.length;
    const segment = this.#builder.openSegments;
    const draws = this.#draw(op, isRelative, numbers);
    const drawn = draws ? { subpath, segment } : null;
    this.#commands.push({
      op,
      isRelative,
      start,
      end: this.#at,
      hasLetter,
      numbers,
      before,
      drawn,
    });
    return letter;
  }

  #pen(): Pen {
    const { current, begin } = this.#builder;
    return { current, begin, cubic: this.#cubic, quadratic: this.#quadratic };
  }

  #numbers(op: string): number[] {
    const numbers: number[] = [];
    for (let i = 0; i < argumentCount(op); ++i) {
      if (i === 0) this.#skipBlanks();
      else this.#skipSeparator();
      numbers.push(op === "A" && (i === 3 || i === 4) ? this.#flag() : this.#number());
    }
    return numbers;
  }

  #draw(op: string, isRelative: boolean, numbers: readonly number[]): boolean {
    const controls = drawCommand(this.#builder, op, isRelative, numbers, this.#pen());
    this.#cubic = controls.cubic;
    this.#quadratic = controls.quadratic;
    return controls.draws;
  }

  #skipBlanks(): void {
    BLANKS.lastIndex = this.#at;
    BLANKS.test(this.text);
    this.#at = BLANKS.lastIndex;
  }

  #skipSeparator(): void {
    this.#skipBlanks();
    if (this.text[this.#at] !== ",") return;
    ++this.#at;
    this.#skipBlanks();
  }

  #flag(): number {
    const c = this.text[this.#at];
    if (c !== "0" && c !== "1") throw new Mistake();
    ++this.#at;
    return Number(c);
  }

  #number(): number {
    NUMBER.lastIndex = this.#at;
    const [text] = NUMBER.exec(this.text) ?? [""];
    const value = Number(text);
    if (text === "" || !(Math.abs(value) <= LARGEST)) throw new Mistake();
    this.#at += text.length;
    return value;
  }
}

export function argumentCount(op: string): number {
  return { M: 2, Z: 0, L: 2, H: 1, V: 1, C: 6, S: 4, Q: 4, T: 2, A: 7 }[op] ?? 0;
}

/** What a command leaves for the next, and whether it drew a segment. */
interface Drawn {
  readonly cubic: Point | null;
  readonly quadratic: Point | null;
  readonly draws: boolean;
}

/** Draws one command. `pen` is where the builder stands. */
export function drawCommand(
  builder: PathBuilder,
  op: string,
  isRelative: boolean,
  n: readonly number[],
  pen: Pick<Pen, "current" | "cubic" | "quadratic">,
): Drawn {
  const [x, y] = pen.current;
  const [ox, oy] = isRelative ? [x, y] : [0, 0];
  const point = (i: number): Point => [ox + n[i], oy + n[i + 1]];
  const mirrored = (control: Point | null): Point =>
    control ? [2 * x - control[0], 2 * y - control[1]] : [x, y];
  const plain = (draws: boolean): Drawn => ({ cubic: null, quadratic: null, draws });
  switch (op) {
    case "M":
      builder.moveTo(point(0));
      return plain(false);
    case "Z":
      return plain(builder.close());
    case "C":
    case "S": {
      const k = op === "C" ? 2 : 0;
      const control1 = op === "C" ? point(0) : mirrored(pen.cubic);
      builder.cubicTo(control1, point(k), point(k + 2));
      return { cubic: point(k), quadratic: null, draws: true };
    }
    case "Q":
    case "T": {
      const control = op === "Q" ? point(0) : mirrored(pen.quadratic);
      builder.quadraticTo(control, point(op === "Q" ? 2 : 0));
      return { cubic: null, quadratic: control, draws: true };
    }
    case "A":
      builder.arcTo([n[0], n[1]], n[2], n[3] === 1, n[4] === 1, point(5));
      return plain(true);
    case "H":
      builder.lineTo([ox + n[0], y]);
      return plain(true);
    case "V":
      builder.lineTo([x, oy + n[0]]);
      return plain(true);
    default:
      builder.lineTo(point(0));
      return plain(true);
  }
}

/** Reads path data with its commands. null: there is a mistake, and nothing of it is drawn. */
export function readPathText(d: string): PathText | null {
  try {
    return new Reader(d).read();
  } catch (error) {
    if (error instanceof Mistake) return null;
    throw error;
  }
}
