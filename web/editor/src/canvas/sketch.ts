// What a gesture shows above the picture beside the drawing itself.
import type { Point } from "../geometry/affine.js";
import type { CubicPath } from "../geometry/cubic.js";
import type { Handle, Part } from "../model/types.js";
import type { Loupe } from "./loupe.js";

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
}

export interface Sketch {
  readonly draft: Draft | null;
  /** Two corners on the stage. */
  readonly marquee: readonly [Point, Point] | null;
  readonly guides: readonly Guide[];
  readonly tag: { readonly at: Point; readonly text: string } | null;
  /** What is dragged keeps its strength while the other handles fade. */
  readonly dragged: { readonly handle: Handle; readonly part: Part } | null;
  readonly isFaded: boolean;
  /** A circle at the pointer, CSS pixels: the brush. */
  readonly brush: { readonly at: Point; readonly radius: number } | null;
  /** What is magnified at the pointer. */
  readonly loupe: Loupe | null;
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
};

export function isSamePart(a: Part, b: Part): boolean {
  const [mine, others] = [Object.entries(a), new Map(Object.entries(b))];
  return mine.length === others.size && mine.every(([name, value]) => others.get(name) === value);
}
