// contract
import type { Point } from "../../geometry/affine.js";
import type { Drawing, Handle, Outcome } from "../types.js";

export function deleteItems(d: Drawing, handles: readonly Handle[]): Outcome | null;
export function duplicate(d: Drawing, handles: readonly Handle[], by: Point): Outcome | null;
export function group(d: Drawing, handles: readonly Handle[]): Outcome | null;
export function ungroup(d: Drawing, handles: readonly Handle[]): Outcome | null;
/** Steps among its siblings: +1 up (on top), -1 down; ±Infinity to the end. */
export function restack(d: Drawing, handles: readonly Handle[], steps: number): Outcome | null;
/** Puts items before (below) child `index` of a container, or of the outermost level (null); they stay where they are seen. */
export function moveInto(d: Drawing, handles: readonly Handle[], parent: Handle | null, index: number): Outcome | null;
/** A <use> of a layer or group. */
export function makeInstance(d: Drawing, h: Handle, by: Point): Outcome | null;
/** A <use> becomes a copy of its own. */
export function makeUnique(d: Drawing, h: Handle): Outcome | null;
