// Gradients as sides show them: stops by their offsets, and what lies beyond the ends.
import type { Rgb } from "../geometry/color.js";
import { valueOf } from "../source/attributes.js";
import { parseColor, type Color } from "../source/colors.js";
import { keywordOf, shareOf } from "../source/css.js";
import { isSvg, Styles } from "../source/styles.js";
import type { ElementNode } from "../source/tree.js";
import { paintChain } from "./paint-frames.js";
import type { Drawing } from "./types.js";

/** A colour with its alpha. */
export interface Tint extends Rgb {
  readonly alpha: number;
}

export interface GradientStop {
  /** 0 to 1, not before the stop that it follows. */
  readonly offset: number;
  readonly value: Tint;
}

export const SPREADS = ["pad", "reflect", "repeat"] as const;
export type Spread = (typeof SPREADS)[number];

export interface Gradient {
  readonly id: string;
  readonly kind: "linear" | "radial";
  readonly spread: Spread;
  readonly stops: readonly GradientStop[];
}

/** The same, with where it stands in the text. */
export interface GradientNodes extends Gradient {
  readonly element: ElementNode;
  /** The gradient that bears the stops: this one, or the nearest that its href leads to. */
  readonly bearer: ElementNode;
  /** The element of each stop. */
  readonly elements: readonly ElementNode[];
  readonly styles: Styles;
}

const BLACK: Color = { rgb: { r: 0, g: 0, b: 0 }, alpha: 1 };

export const stopsWithin = (bearer: ElementNode): ElementNode[] =>
  bearer.children.filter((child) => child.local === "stop" && isSvg(child));

/** Returns `stop-color`, including its own alpha. */
export function stopColor(styles: Styles, stop: ElementNode): Color {
  const text = styles.value(stop, "stop-color");
  if (text === null) return BLACK;
  const said = keywordOf(text) === "currentcolor" ? (styles.value(stop, "color") ?? "") : text;
  return parseColor(said) ?? BLACK;
}

export const stopOpacity = (styles: Styles, stop: ElementNode): number =>
  shareOf(styles.value(stop, "stop-opacity") ?? "1") ?? 1;

/** The offset as it is written; a stop that goes back is drawn at the largest one so far. */
export const writtenOffset = (stop: ElementNode): number =>
  shareOf(valueOf(stop, "offset") ?? "0") ?? 0;

function readStops(styles: Styles, elements: readonly ElementNode[]): GradientStop[] {
  let largest = 0;
  return elements.map((element) => {
    largest = Math.max(largest, writtenOffset(element));
    const { rgb, alpha } = stopColor(styles, element);
    return { offset: largest, value: { ...rgb, alpha: alpha * stopOpacity(styles, element) } };
  });
}

/** @param href "#id"; null where that is no gradient with stops */
export function gradientNodes(d: Drawing, href: string): GradientNodes | null {
  const id = href.replace(/^#/, "");
  const ids = d.ids;
  const element = ids.get(id);
  const chain = element ? paintChain(element, ids) : [];
  const bearer = chain.find((one) => stopsWithin(one).length > 0);
  if (!element || !bearer) return null;
  const said = chain.map((one) => valueOf(one, "spreadMethod")?.trim()).find((word) => word);
  const styles = new Styles(d.text, d.root);
  const elements = stopsWithin(bearer);
  return {
    id,
    kind: element.local === "linearGradient" ? "linear" : "radial",
    spread: SPREADS.find((spread) => spread === said) ?? "pad",
    stops: readStops(styles, elements),
    element,
    bearer,
    elements,
    styles,
  };
}

export const gradientOf = (d: Drawing, href: string): Gradient | null => gradientNodes(d, href);

/** How many sides show a paint. */
export function sidesWithPaint(d: Drawing, href: string): number {
  let count = 0;
  for (const item of d.all()) {
    if (item.kind !== "curve") continue;
    for (const { color, opacity } of [item.left, item.right])
      for (const value of [color, opacity])
        if (value.kind === "paint" && value.href === href) count += 1;
  }
  return count;
}
