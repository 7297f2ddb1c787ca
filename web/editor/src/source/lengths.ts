// Numbers, lengths, boxes and transforms of SVG attributes. null: the text is none.
import { composed, IDENTITY, translation } from "../geometry/affine.js";
import type { Affine, Box } from "../geometry/affine.js";

/** Numbers of documents are no larger: limits::kCoordinate of the engine. */
export const LARGEST = 1e7;

const NUMBER = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?$/;
const LENGTH = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)([a-zA-Z]*|%)$/;
const PIXELS: Readonly<Record<string, number>> = {
  "": 1,
  px: 1,
  pt: 96 / 72,
  pc: 16,
  mm: 96 / 25.4,
  cm: 96 / 2.54,
  in: 96,
};

export function parseNumber(text: string): number | null {
  const trimmed = text.trim();
  const number = NUMBER.test(trimmed) ? Number(trimmed) : NaN;
  return Number.isFinite(number) ? number : null;
}

/** In user units. @param whole what 100% is; NaN where there are no percentages */
export function parseLength(text: string, whole: number): number | null {
  const [, number, unit] = LENGTH.exec(text.trim()) ?? [];
  if (number === undefined) return null;
  const factor = unit === "%" ? whole / 100 : PIXELS[unit.toLowerCase()];
  const value = Number(number) * factor;
  return Math.abs(value) <= LARGEST ? value : null;
}

/** The numbers of a list with blanks and commas. */
function numbersOf(text: string): number[] | null {
  const parts = text.match(/[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/g) ?? [];
  const rest = text.replace(/[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/g, "0").trim();
  if (rest !== "" && !/^0(?:\s*,?\s*0)*\s*,?$/.test(rest)) return null;
  const numbers = parts.map(Number);
  return numbers.every(Number.isFinite) ? numbers : null;
}

export function parseViewBox(text: string): Box | null {
  const numbers = numbersOf(text);
  if (numbers?.length !== 4) return null;
  const [x, y, width, height] = numbers;
  return width > 0 && height > 0 ? [x, y, x + width, y + height] : null;
}

function turned(degrees: number): readonly [sin: number, cos: number] {
  // Right angles are exact: a rotated rectangle stays one.
  const quarters = degrees / 90;
  if (Number.isInteger(quarters)) {
    return (
      [
        [0, 1],
        [1, 0],
        [0, -1],
        [-1, 0],
      ] as const
    )[((quarters % 4) + 4) % 4];
  }
  const angle = ((degrees % 360) * Math.PI) / 180;
  return [Math.sin(angle), Math.cos(angle)];
}

function rotation(degrees: number, x: number, y: number): Affine {
  const [sin, cos] = turned(degrees);
  return composed(translation(x, y), composed([cos, sin, -sin, cos, 0, 0], translation(-x, -y)));
}

function slope(degrees: number): number {
  const [sin, cos] = turned(degrees);
  return sin / cos;
}

/** How many arguments each function takes, and its map. */
const FUNCTIONS: Readonly<Record<string, readonly [readonly number[], (v: number[]) => Affine]>> = {
  matrix: [[6], (v) => v],
  translate: [[1, 2], ([x, y = 0]) => translation(x, y)],
  scale: [[1, 2], ([x, y = x]) => [x, 0, 0, y, 0, 0]],
  rotate: [[1, 3], ([angle, x = 0, y = 0]) => rotation(angle, x, y)],
  skewX: [[1], ([angle]) => [1, 0, slope(angle), 1, 0, 0]],
  skewY: [[1], ([angle]) => [1, slope(angle), 0, 1, 0, 0]],
};

const FUNCTION = /[\s,]*([a-zA-Z]+)\s*\(([^()]*)\)/y;

/** Returns the map of the attribute `transform`; all of SVG 1.1. */
export function parseTransform(text: string): Affine | null {
  let product: Affine = IDENTITY;
  let at = 0;
  const end = text.trimEnd().replace(/,$/, "").length;
  while (text.slice(at, end).trim() !== "") {
    FUNCTION.lastIndex = at;
    const [whole, name, list] = FUNCTION.exec(text) ?? [];
    if (whole === undefined || !Object.hasOwn(FUNCTIONS, name)) return null;
    const [counts, map] = FUNCTIONS[name];
    const numbers = numbersOf(list);
    if (!numbers || !counts.includes(numbers.length)) return null;
    product = composed(product, map(numbers));
    at += whole.length;
  }
  return product.every(Number.isFinite) ? product : null;
}

/** The map that fits a box into another by preserveAspectRatio; its default where it is wrong. */
export function fitted(content: Box, target: Box, ratio: string): Affine {
  const [, x, y, how] =
    /^(?:defer\s+)?x(min|mid|max)y(min|mid|max)(?:\s+(meet|slice))?$/.exec(
      ratio.trim().toLowerCase(),
    ) ?? [];
  const width = content[2] - content[0];
  const height = content[3] - content[1];
  let scaleX = (target[2] - target[0]) / width;
  let scaleY = (target[3] - target[1]) / height;
  if (!isStretched(ratio)) {
    scaleX = scaleY = how === "slice" ? Math.max(scaleX, scaleY) : Math.min(scaleX, scaleY);
  }
  const share = (word: string | undefined) => ({ min: 0, max: 1 })[word ?? "mid"] ?? 0.5;
  const spareX = target[2] - target[0] - scaleX * width;
  const spareY = target[3] - target[1] - scaleY * height;
  return [
    scaleX,
    0,
    0,
    scaleY,
    target[0] + share(x) * spareX - scaleX * content[0],
    target[1] + share(y) * spareY - scaleY * content[1],
  ];
}

export function isStretched(ratio: string): boolean {
  return /^(?:defer\s+)?none\b/.test(ratio.trim().toLowerCase());
}
