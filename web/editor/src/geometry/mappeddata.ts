// Path data under an affine map: command for command, so that segments and how they are written stay.
import { readPathText } from "./pathreader.js";
import { determinant, mapped } from "./affine.js";
import type { Affine, Point } from "./affine.js";
import type { Command } from "./pathreader.js";
import { numberText } from "./pathwriter.js";

const CLOSE = 1e-9;

function isTranslation([a, b, c, d]: Affine): boolean {
  return a === 1 && b === 0 && c === 0 && d === 1;
}

/** Whether it keeps shapes, and so arcs of circles. */
function isSimilarity([a, b, c, d]: Affine): boolean {
  const scale = Math.max(Math.abs(a), Math.abs(b), Math.abs(c), Math.abs(d));
  const [s, t] = [a * d - b * c < 0 ? -1 : 1, CLOSE * scale];
  return Math.abs(a - s * d) <= t && Math.abs(c + s * b) <= t;
}

/** Radii, turn and sweep of an arc; the map is a similarity. */
function arcNumbers(map: Affine, n: readonly number[], step: number): string[] {
  const scale = Math.sqrt(Math.abs(determinant(map)));
  const mirrors = determinant(map) < 0;
  const turn = (Math.atan2(map[1], map[0]) * 180) / Math.PI;
  const angle = n[0] === n[1] ? 0 : turn + (mirrors ? -n[2] : n[2]);
  const sweep = mirrors ? 1 - n[4] : n[4];
  const radii = [n[0] * scale, n[1] * scale].map((r) => numberText(r, step));
  return [...radii, numberText(angle, 1e-6), String(n[3]), String(sweep)];
}

/** The points that a command's numbers are, absolute. */
function pointsOf({ op, isRelative, numbers, before }: Command): Point[] {
  const [x, y] = before.current;
  const [ox, oy] = isRelative ? [x, y] : [0, 0];
  if (op === "H") return [[ox + numbers[0], y]];
  if (op === "V") return [[x, oy + numbers[0]]];
  const from = op === "A" ? 5 : 0;
  const points: Point[] = [];
  for (let i = from; i < numbers.length; i += 2) points.push([ox + numbers[i], oy + numbers[i + 1]]);
  return points;
}

class Mapper {
  /** Where the pen stands in what was written: relative numbers count from there. */
  #written: Point = [0, 0];
  #begin: Point = [0, 0];

  constructor(
    readonly map: Affine,
    readonly step: number,
  ) {}

  command(command: Command): string {
    const { op, isRelative } = command;
    if (op === "Z") {
      this.#written = this.#begin;
      return isRelative ? "z" : "Z";
    }
    const from = isRelative ? this.#written : ([0, 0] as const);
    const numbers = op === "A" ? arcNumbers(this.map, command.numbers, this.step) : [];
    let end = this.#written;
    const pairs = pointsOf(command).map((point) => {
      const [x, y] = mapped(this.map, point);
      const texts = [numberText(x - from[0], this.step), numberText(y - from[1], this.step)];
      end = [from[0] + Number(texts[0]), from[1] + Number(texts[1])];
      return texts;
    });
    const written = this.#axis(op, pairs[0]) ?? [...numbers, ...pairs.flat()];
    if (op === "H" && written.length === 1) end = [end[0], this.#written[1]];
    if (op === "V" && written.length === 1) end = [this.#written[0], end[1]];
    this.#written = end;
    if (op === "M") this.#begin = end;
    const letter = "HV".includes(op) && written.length === 2 ? "L" : op;
    return (isRelative ? letter.toLowerCase() : letter) + written.join(" ");
  }

  /** H and V where the map keeps the axes. */
  #axis(op: string, [x, y]: readonly string[]): string[] | null {
    if (op !== "H" && op !== "V") return null;
    if (this.map[1] !== 0 || this.map[2] !== 0) return null;
    return [op === "H" ? x : y];
  }
}

/** Numbers may follow each other without a blank where a sign or a dot parts them: no more here. */
function joined(out: string, next: string): string {
  return /[\d.]$/.test(out) && /^[\d.]/.test(next) ? `${out} ${next}` : out + next;
}

/** Translates a path. Relative commands keep their text, except the first, which counts from the origin. */
function translated(d: string, commands: readonly Command[], map: Affine, step: number): string {
  let out = "";
  let at = 0;
  commands.forEach(({ op, isRelative, start, end, numbers, hasLetter }, i) => {
    if (op === "Z" || (isRelative && i > 0)) return;
    const isY = (k: number) => op === "V" || (op === "A" ? k === 6 : op !== "H" && k % 2 === 1);
    const texts = numbers.map((number, k) =>
      op === "A" && k < 5 ? numberText(number, 0) : numberText(number + map[isY(k) ? 5 : 4], step),
    );
    out = joined(out, d.slice(at, start) + (hasLetter ? d[start] : ""));
    out = joined(out, texts.join(" "));
    at = end;
  });
  return joined(out, d.slice(at));
}

/**
 * Path data under a map, numbers at a step. Absolute commands stay absolute, relative ones relative.
 * null: the data has a mistake, or an arc that the map makes one of another shape.
 */
export function mappedData(d: string, map: Affine, step: number): string | null {
  const text = readPathText(d);
  if (!text || text.commands.length === 0) return null;
  if (isTranslation(map)) return translated(d, text.commands, map, step);
  const hasArcs = text.commands.some(({ op }) => op === "A");
  if (hasArcs && !isSimilarity(map)) return null;
  const mapper = new Mapper(map, step);
  return text.commands.map((command) => mapper.command(command)).join(" ");
}
