// contract: what panels, tools and the engine's side know of a drawing.
import type { Affine, Box } from "../geometry/affine.js";
import type { MixSpace, Rgb } from "../geometry/color.js";
import type { CubicPath } from "../geometry/cubic.js";
import type { Patch } from "../source/patch.js";
import type { SideValue } from "../source/stops.js";
import type { ElementNode } from "../source/tree.js";

export type { SideValue, Stop, StopSpace } from "../source/stops.js";

export type Handle = number;
export type Side = "left" | "right";
export type Attribute = "color" | "opacity" | "blur";
/** The attributes that a gradient or a texture can supply. */
export type PaintAttribute = Exclude<Attribute, "blur">;
/**
 * Where a paint is taken hold of. A line: its ends. A circle: its middle, its radius, its other radius
 * where it is an ellipse, and where its colours begin. A tile: its corner and the two beside it.
 */
export type PaintGrip = "start" | "end" | "across" | "focus";

export interface SideValues {
  readonly color: SideValue<Rgb>;
  readonly opacity: SideValue<number>;
  /** Radii in units of the element. */
  readonly blur: SideValue<number>;
}

interface ItemBase {
  readonly handle: Handle;
  readonly element: ElementNode;
  readonly parent: Item | null;
  /** In the order of the text: the last is on top. */
  readonly children: readonly Item[];
  /** inkscape:label, else the id, else what it is with a number. */
  readonly name: string;
  /** Map from the coordinates of the element's attributes, its transform included, to the artboard's. */
  readonly artboardFromItem: Affine;
  readonly hidden: boolean;
  readonly locked: boolean;
  readonly opacity: number;
  /** A word of mix-blend-mode. */
  readonly blend: string;
}

export interface ContainerItem extends ItemBase {
  readonly kind: "layer" | "group";
}

export interface UseItem extends ItemBase {
  readonly kind: "use";
  /** The item that it copies, or null where there is none. */
  readonly target: Item | null;
}

/** A shape: in a layer a diffusion curve for each subpath, elsewhere with sf:radius a local one. */
export interface CurveItem extends ItemBase {
  readonly kind: "curve" | "stroke";
  /** Subpaths in the element's coordinates, without subpaths of length 0. */
  readonly paths: readonly CubicPath[];
  /** Whether it stands in the text as `<path>`; other shapes become one when a node is edited. */
  readonly isPath: boolean;
  readonly left: SideValues;
  readonly right: SideValues;
  /** For a local curve, the radii of influence. */
  readonly radius: SideValue<number>;
  /** Map from the element's coordinates to its layer's; for a local curve, to its own. */
  readonly layerFromItem: Affine;
  /** How many places of the picture show it: 1, or more by <use>. */
  readonly copies: number;
}

/** A picture to trace over: `<image sf:reference="true">`. */
export interface ReferenceItem extends ItemBase {
  readonly kind: "reference";
  readonly href: string;
  /** x, y, x + width, y + height in the element's coordinates. */
  readonly box: Box;
}

export type Item = ContainerItem | UseItem | CurveItem | ReferenceItem;

/** The parts that a change of the text touched. */
export interface Change {
  /** Elements came, went or moved, or a style changed: nothing is as it was. */
  readonly isStructural: boolean;
  /** Elements whose attributes changed, and names of these attributes (local names). */
  readonly touched: ReadonlyMap<Handle, ReadonlySet<string>>;
}

/** A part of a curve that can be chosen alone. */
export type Part =
  | { readonly kind: "whole" }
  /** Node `index` of a subpath: control point 3 index. */
  | { readonly kind: "node"; readonly path: number; readonly index: number }
  /** A control point that is no node: its index in CubicPath.points. */
  | { readonly kind: "handle"; readonly path: number; readonly index: number }
  | {
      readonly kind: "stop";
      readonly side: Side;
      readonly attribute: Attribute | "radius";
      readonly index: number;
    }
  | {
      readonly kind: "paint";
      readonly side: Side;
      readonly attribute: PaintAttribute;
      readonly grip: PaintGrip;
    };

export interface Selected {
  readonly handle: Handle;
  readonly part: Part;
}

/** The last is the primary one. */
export type Selection = readonly Selected[];

/** The result of a command: a patch of the present text, and the selection afterwards. */
export interface Outcome {
  readonly patch: Patch;
  /** The selection in the text after the patch, elements by their place there; absent: the selection stays. */
  readonly select?: readonly { readonly at: number; readonly part?: Part }[];
}

/** The document: a text, and what it says. Changed by apply() alone. */
export interface Drawing {
  readonly text: string;
  /** Grows with each change. */
  readonly revision: number;
  readonly root: ElementNode;
  /** The visible or selectable items of the outermost level, the last on top. */
  readonly items: readonly Item[];
  readonly artboard: Box;
  readonly interpolation: MixSpace;
  /** null: not given. */
  readonly background: Rgb | null;
  /** Why it may not be edited, or null: a DOCTYPE that defines entities. */
  readonly readOnly: string | null;
  /** The first element of each id. */
  readonly ids: ReadonlyMap<string, ElementNode>;
  item(handle: Handle): Item | undefined;
  /** The item whose element begins at a place of the text. */
  itemAt(offset: number): Item | undefined;
  /** All items, parents before children. */
  all(): Iterable<Item>;
  /**
   * Changes the text. A patch within attributes of one element costs little, however long the text.
   * @throws RangeError where the patch is for another text; SourceError where what comes out is no
   *   XML. The drawing is as before then.
   */
  apply(patch: Patch): Change;
}
