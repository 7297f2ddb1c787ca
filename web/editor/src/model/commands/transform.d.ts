// contract
import type { Affine } from "../../geometry/affine.js";
import type { Drawing, Handle, Outcome } from "../types.js";

/** Maps items by a map of the artboard: curves' points, or the transform of layers, groups, uses. */
export function transform(d: Drawing, handles: readonly Handle[], map: Affine, step: number): Outcome | null;
