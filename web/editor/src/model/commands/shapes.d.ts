// contract
import type { Point } from "../../geometry/affine.js";
import type { CubicPath } from "../../geometry/cubic.js";
import type { Drawing, Handle, Outcome } from "../types.js";

/** Replaces one subpath; segments whose points are as before keep how they are written. */
export function setPath(d: Drawing, h: Handle, path: number, to: CubicPath, step: number): Outcome | null;
/** Moves nodes by a vector of the element's coordinates, their handles with them. */
export function moveNodes(d: Drawing, h: Handle, path: number, nodes: readonly number[], by: Point, step: number): Outcome | null;
/** Adds a node on piece `piece` at t without changing the shape. Offsets "@" of stops follow. */
export function splitPiece(d: Drawing, h: Handle, path: number, piece: number, t: number, step: number): Outcome | null;
/** Takes nodes away and fits what is left to the shape; a curve without two nodes goes. */
export function deleteNodes(d: Drawing, h: Handle, path: number, nodes: readonly number[], step: number): Outcome | null;
export type NodeKind = "corner" | "smooth" | "symmetric";
export function setNodeKind(d: Drawing, h: Handle, path: number, nodes: readonly number[], kind: NodeKind, step: number): Outcome | null;
export function reverseCurves(d: Drawing, handles: readonly Handle[], step: number): Outcome | null;
export function setClosed(d: Drawing, h: Handle, path: number, closed: boolean, step: number): Outcome | null;
/** Joins the ends of two open curves of one layer to one curve. */
export function joinCurves(d: Drawing, a: Handle, b: Handle, step: number): Outcome | null;
