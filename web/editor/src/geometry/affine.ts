// Affine maps as [a, b, c, d, e, f] of SVG's matrix(): (x, y) -> (a x + c y + e, b x + d y + f).
// The viewer's functions, typed for the editor, and what it asks beyond them.
export type Affine = readonly number[];
export type Point = readonly [number, number];
/** Minimum x, y, maximum x, y. */
export type Box = readonly [number, number, number, number];

export const IDENTITY: Affine = [1, 0, 0, 1, 0, 0];
