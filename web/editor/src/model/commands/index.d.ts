// contract: every edit, as a patch of the present text. null: nothing would change.
import type { Affine, Point } from "../../geometry/affine.js";
import type { Rgb } from "../../geometry/color.js";
import type { CubicPath } from "../../geometry/cubic.js";
import type { Attribute, Drawing, Handle, Item, Outcome, Selection, Side, SideValue } from "../types.js";

// Shapes. `digits`: the unit of the last decimal, in the element's coordinates (1/1000 of a pixel).

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

// Attributes of curves.

export function setColor(d: Drawing, h: Handle, side: Side, to: SideValue<Rgb>): Outcome | null;
export function setNumbers(d: Drawing, h: Handle, side: Side, attribute: "opacity" | "blur", to: SideValue<number>): Outcome | null;
/** The same on both sides. */
export function setBoth(d: Drawing, h: Handle, attribute: "opacity" | "blur", to: SideValue<number>): Outcome | null;
export function setRadius(d: Drawing, h: Handle, to: SideValue<number>): Outcome | null;
/** sf:alpha of a local curve, sf:weight of a diffusion curve; null takes it away. */
export function setNumber(d: Drawing, handles: readonly Handle[], name: "alpha" | "weight", to: number | null): Outcome | null;
export function swapSides(d: Drawing, handles: readonly Handle[]): Outcome | null;
/** Exchanges one colour for another everywhere in these curves. */
export function recolor(d: Drawing, handles: readonly Handle[], from: Rgb, to: Rgb): Outcome | null;

// New things.

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
/** A gradient or a pattern in <defs>, and its use as a side's colour or opacity. */
export function setPaint(d: Drawing, h: Handle, side: Side, attribute: "color" | "opacity", paint: NewPaint): Outcome | null;
export type NewPaint =
  | { readonly kind: "linear" | "radial"; readonly stops: readonly { offset: number; color: Rgb; opacity: number }[]; readonly from: Point; readonly to: Point }
  | { readonly kind: "texture"; readonly href: string; readonly width: number; readonly height: number }
  | { readonly kind: "existing"; readonly id: string };

// Structure.

export function deleteItems(d: Drawing, handles: readonly Handle[]): Outcome | null;
/** SVG text of items, with what they refer to, that paste() takes. */
export function copyItems(d: Drawing, handles: readonly Handle[]): string;
/** @throws SourceError where the text is none of that kind */
export function paste(d: Drawing, text: string, into: Handle | null): Outcome | null;
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

/** Maps items by a map of the artboard: curves' points, or the transform of layers, groups, uses. */
export function transform(d: Drawing, handles: readonly Handle[], map: Affine, step: number): Outcome | null;
export function rename(d: Drawing, h: Handle, name: string): Outcome | null;
export function setHidden(d: Drawing, handles: readonly Handle[], hidden: boolean): Outcome | null;
export function setLocked(d: Drawing, handles: readonly Handle[], locked: boolean): Outcome | null;
export function setOpacity(d: Drawing, h: Handle, opacity: number): Outcome | null;
export function setBlend(d: Drawing, h: Handle, blend: string): Outcome | null;
export function setArtboard(d: Drawing, box: readonly [number, number, number, number]): Outcome | null;
export function setInterpolation(d: Drawing, to: "srgb" | "linear" | "oklab"): Outcome | null;
export function setBackground(d: Drawing, color: Rgb | null): Outcome | null;

/** Patches of one text, side by side, as one. @throws RangeError where they overlap */
export function together(outcomes: readonly (Outcome | null)[]): Outcome | null;
/** Handles of curves that a selection means: of containers all within. */
export function curvesOf(d: Drawing, selection: Selection): readonly Handle[];
export function isContainer(item: Item): boolean;
export type { Attribute };
