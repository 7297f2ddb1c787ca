// Stops of gradients: each edit changes the attributes, or the one element, that it is about.
import { numberText } from "../../../geometry/path.js";
import { setAttribute, valueOf } from "../../../source/attributes.js";
import { colorText } from "../../../source/colors.js";
import type { Edit } from "../../../source/patch.js";
import { setStyles } from "../../../source/set-style.js";
import type { Property } from "../../../source/styles.js";
import type { ElementNode } from "../../../source/tree.js";
import {
  gradientNodes,
  stopColor,
  stopOpacity,
  writtenOffset,
  type GradientNodes,
  type GradientStop,
  type Spread,
  type Tint,
} from "../../gradients.js";
import { paintChain } from "../../paint-frames.js";
import type { Drawing, Outcome } from "../../types.js";
import { Draft } from "../curves/draft.js";
import { insertion, removalsOf } from "../structure/layout.js";
import { opening } from "../markup.js";
import { outcomeOf } from "../structure/together.js";

/** Finer than an eye. */
const FINE = 1e-4;

const isSameTint = (a: Tint, b: Tint) =>
  a.r === b.r && a.g === b.g && a.b === b.b && a.alpha === b.alpha;
const isSame = (a: GradientStop, b: GradientStop) =>
  a.offset === b.offset && isSameTint(a.value, b.value);

/** Which stop of before each of now is; null: a new one. */
type Origins = readonly (number | null)[];

/** Pairs [before, now] of the longest run of stops, in order, that are the same in both. */
function unchanged(before: readonly GradientStop[], now: readonly GradientStop[]) {
  const [rows, columns] = [before.length, now.length];
  const longest = Array.from({ length: rows + 1 }, () => new Uint32Array(columns + 1));
  for (let i = rows - 1; i >= 0; i -= 1) {
    for (let j = columns - 1; j >= 0; j -= 1) {
      longest[i][j] = isSame(before[i], now[j])
        ? longest[i + 1][j + 1] + 1
        : Math.max(longest[i + 1][j], longest[i][j + 1]);
    }
  }
  const pairs: [number, number][] = [];
  for (let i = 0, j = 0; i < rows && j < columns; ) {
    if (isSame(before[i], now[j])) pairs.push([i++, j++]);
    else if (longest[i + 1][j] >= longest[i][j + 1]) i += 1;
    else j += 1;
  }
  return pairs;
}

/** Leaves equal stops at the beginning and the end out of the comparison, which is quadratic. */
function originsOf(before: readonly GradientStop[], now: readonly GradientStop[]): Origins {
  const shorter = Math.min(before.length, now.length);
  let head = 0;
  while (head < shorter && isSame(before[head], now[head])) head += 1;
  let tail = 0;
  const isTail = () => isSame(before[before.length - 1 - tail], now[now.length - 1 - tail]);
  while (tail < shorter - head && isTail()) tail += 1;
  const middle = unchanged(
    before.slice(head, before.length - tail),
    now.slice(head, now.length - tail),
  );
  const origins: (number | null)[] = now.map(() => null);
  for (let k = 0; k < head; k += 1) origins[k] = k;
  for (let k = 1; k <= tail; k += 1) origins[now.length - k] = before.length - k;
  for (const [i, j] of middle) origins[head + j] = head + i;
  // The others are the same stops with other values, in their order.
  const known = new Set(origins);
  const others = [...before.keys()].filter((index) => !known.has(index));
  return origins.map((origin) => origin ?? others.shift() ?? null);
}

/** Returns the stops that keep the order of before; the others are moved in the text. */
function inOrder(origins: Origins): ReadonlySet<number> {
  const best: number[][] = [];
  for (const origin of origins.filter((one) => one !== null)) {
    const longer = best.findIndex((run) => run[run.length - 1] >= origin);
    const length = longer < 0 ? best.length : longer;
    best[length] = [...(best[length - 1] ?? []), origin];
  }
  return new Set(best.at(-1) ?? []);
}

function offsetText(offset: number, like: ElementNode | undefined): string {
  const isPercentage = (like && valueOf(like, "offset")?.trim().endsWith("%")) ?? false;
  return isPercentage ? `${numberText(100 * offset, 100 * FINE)}%` : numberText(offset, FINE);
}

/** Edits of a stop that stays. */
function restopped(
  d: Drawing,
  { styles }: GradientNodes,
  element: ElementNode,
  { offset, value }: GradientStop,
): Edit[] {
  const edits: Edit[] = [];
  if (writtenOffset(element) !== offset)
    edits.push(...setAttribute(d.text, element, "offset", offsetText(offset, element)));
  const color = stopColor(styles, element);
  const { rgb } = color;
  const isColor = rgb.r === value.r && rgb.g === value.g && rgb.b === value.b;
  const opacity = stopOpacity(styles, element);
  if (isColor && color.alpha * opacity === value.alpha) return edits;
  const values: Partial<Record<Property, string>> = {};
  // A colour that has an alpha of its own gives it to the opacity.
  const isOpaque = color.alpha === 1;
  if (!isColor || !isOpaque) values["stop-color"] = colorText(value);
  if (opacity !== value.alpha) values["stop-opacity"] = numberText(value.alpha, FINE);
  return [...edits, ...setStyles(d.text, styles, element, values)];
}

/** A new stop, written as one near by. */
function stopMarkup(
  { bearer, styles }: GradientNodes,
  { offset, value }: GradientStop,
  like: ElementNode | undefined,
): string {
  const color = colorText(value);
  const opacity = value.alpha < 1 ? numberText(value.alpha, FINE) : null;
  const isStyled = like && (styles.inStyle(like, "stop-color") || styles.inSheets(like, "stop-color"));
  const said: [string, string | null][] = isStyled
    ? [["style", `stop-color:${color}${opacity === null ? "" : `;stop-opacity:${opacity}`}`]]
    : [["stop-color", color], ["stop-opacity", opacity]];
  return `${opening(bearer, "stop", [["offset", offsetText(offset, like)], ...said])}/>`;
}

/**
 * Sets the stops of a gradient, at least one. Does not touch unchanged stops; the others change in place if
 * they keep their order.
 */
export function setGradientStops(
  d: Drawing,
  href: string,
  to: readonly GradientStop[],
): Outcome | null {
  const nodes = gradientNodes(d, href);
  if (!nodes || to.length === 0) return null;
  const { elements, bearer } = nodes;
  const origins = originsOf(nodes.stops, to);
  const staying = inOrder(origins);
  if (to.length === elements.length && to.every((stop, k) => isSame(stop, nodes.stops[k]))) return null;
  const draft = new Draft(d.text);
  const going = elements.filter((_, index) => !staying.has(index));
  for (const range of removalsOf(d.text, going)) draft.replace(range, "");
  let anchor: ElementNode | null = null;
  let pieces: string[] = [];
  const insert = () => {
    if (pieces.length > 0) draft.add([insertion(d.text, bearer, anchor, pieces).edit]);
    pieces = [];
  };
  to.forEach((stop, k) => {
    const origin = origins[k];
    const element: ElementNode | null = origin === null ? null : elements[origin];
    if (element && staying.has(origin as number)) {
      insert();
      anchor = element;
      draft.add(restopped(d, nodes, element, stop));
    } else if (element) {
      pieces.push(draft.rewritten(element, restopped(d, nodes, element, stop)));
    } else {
      pieces.push(stopMarkup(nodes, stop, anchor ?? elements[0]));
    }
  });
  insert();
  return draft.outcome();
}

/** Sets how a gradient continues beyond its ends. Writes the default "pad" only where it is necessary. */
export function setSpread(d: Drawing, href: string, spread: Spread): Outcome | null {
  const nodes = gradientNodes(d, href);
  if (!nodes || nodes.spread === spread) return null;
  const [element, ...inherited] = paintChain(nodes.element, d.ids);
  const isInherited = inherited.some((one) => valueOf(one, "spreadMethod") !== undefined);
  const value = spread === "pad" && !isInherited ? null : spread;
  return outcomeOf(setAttribute(d.text, element, "spreadMethod", value));
}
