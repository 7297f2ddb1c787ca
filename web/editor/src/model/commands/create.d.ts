// contract
import type { Rgb } from "../../geometry/color.js";
import type { CubicPath } from "../../geometry/cubic.js";
import type { Drawing, Handle, Outcome, SideValue } from "../types.js";

export interface NewCurve {
  readonly path: CubicPath;
  readonly left: SideValue<Rgb>;
  readonly right: SideValue<Rgb>;
  readonly blur?: SideValue<number>;
  /** A local curve, with these radii. */
  readonly radius?: SideValue<number>;
}
/** Into a layer or group (for local curves), at the end, or behind a curve of it; null: a new layer on top. */
export function addCurves(d: Drawing, into: Handle | null, curves: readonly NewCurve[], step: number): Outcome | null;
export function addLayer(d: Drawing, above: Handle | null, name: string): Outcome | null;
export function addReference(d: Drawing, href: string, width: number, height: number): Outcome | null;
