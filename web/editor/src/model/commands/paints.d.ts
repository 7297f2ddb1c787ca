// contract
import type { Point } from "../../geometry/affine.js";
import type { Rgb } from "../../geometry/color.js";
import type { Drawing, Handle, Outcome, Side } from "../types.js";

/** A gradient or a pattern in <defs>, and its use as a side's colour or opacity. */
export function setPaint(d: Drawing, h: Handle, side: Side, attribute: "color" | "opacity", paint: NewPaint): Outcome | null;
export type NewPaint =
  | { readonly kind: "linear" | "radial"; readonly stops: readonly { offset: number; color: Rgb; opacity: number }[]; readonly from: Point; readonly to: Point }
  | { readonly kind: "texture"; readonly href: string; readonly width: number; readonly height: number }
  | { readonly kind: "existing"; readonly id: string };
