// Shapes that a gesture shows above the picture, besides the drawing itself.
import type { Point } from "../geometry/affine.js";
import type { Rgb } from "../geometry/color.js";
import type { CubicPath } from "../geometry/cubic.js";
import type { GuideAxis } from "../model/guidelines.js";
import type { Handle, Part } from "../model/types.js";
import type { PointerKind } from "./hit.js";

/** Lines to which something snapped, on the stage; where both ends are one point, a ring. */
export interface Guide {
  readonly from: Point;
  readonly to: Point;
}

/** The curve that pen, pencil or stroke is making, in artboard units. */
export interface Draft {
  readonly path: CubicPath;
  /** The piece that would come next, or null. */
  readonly rubber: CubicPath | null;
  /** Whether the next click closes it. */
  readonly closes: boolean;
  /** Nodes are shown for the pen alone. */
  readonly hasNodes: boolean;
  /** A colour of CSS that fills it; absent: it has no fill. */
  readonly fill?: string;
}

/** The pixels around the pointer, enlarged, and what is sampled there. */
export interface Loupe {
  /** Place of the pointer, on the stage. */
  readonly at: Point;
  readonly kind: PointerKind;
  /** RGBA, in rows. */
  readonly pixels: Uint8ClampedArray;
  /** The halves of its ring: new above old; beside a curve left and right of it. */
  readonly ring: readonly [Rgb | null, Rgb | null];
  /** Where the first half's middle is, radians from above, clockwise. */
  readonly turn: number;
  /** Where the sides are sampled, in pixels from the middle. */
  readonly spots: readonly Point[];
  readonly text: string;
}

export interface Sketch {
  readonly draft: Draft | null;
  /** Two corners on the stage. */
  readonly marquee: readonly [Point, Point] | null;
  readonly guides: readonly Guide[];
  readonly tag: { readonly at: Point; readonly text: string } | null;
  /** The part that is dragged keeps its strength while the other handles fade. */
  readonly dragged: { readonly handle: Handle; readonly part: Part } | null;
  readonly isFaded: boolean;
  /** A circle at the pointer, CSS pixels: the brush. */
  readonly brush: { readonly at: Point; readonly radius: number } | null;
  /** The magnified view at the pointer. */
  readonly loupe: Loupe | null;
  /** The guide that is dragged, at its place on the stage; null in `of`: it is new. null in `at`: it would go. */
  readonly guide: { readonly axis: GuideAxis; readonly at: number | null; readonly of: Handle | null } | null;
}

export const NO_SKETCH: Sketch = {
  draft: null,
  marquee: null,
  guides: [],
  tag: null,
  dragged: null,
  isFaded: false,
  brush: null,
  loupe: null,
  guide: null,
};
