// Affine maps as [a, b, c, d, e, f] of SVG's matrix(): (x, y) -> (a x + c y + e, b x + d y + f).
export type Affine = readonly number[];
export type Point = readonly [number, number];
/** Minimum x, y, maximum x, y. */
export type Box = readonly [number, number, number, number];

export const IDENTITY: Affine = [1, 0, 0, 1, 0, 0];

/** First `inner`, then `outer`. */
export function composed(outer: Affine, inner: Affine): Affine {
  const [a, b, c, d, e, f] = outer;
  const [p, q, r, s, t, u] = inner;
  return [
    a * p + c * q,
    b * p + d * q,
    a * r + c * s,
    b * r + d * s,
    a * t + c * u + e,
    b * t + d * u + f,
  ];
}

export function translation(x: number, y: number): Affine {
  return [1, 0, 0, 1, x, y];
}

export function determinant([a, b, c, d]: Affine): number {
  return a * d - b * c;
}

/** The map back; null where there is none. */
export function inverted(map: Affine): Affine | null {
  const k = 1 / determinant(map);
  if (!Number.isFinite(k)) return null;
  const [a, b, c, d, e, f] = map;
  const back = [d * k, -b * k, -c * k, a * k, (c * f - d * e) * k, (b * e - a * f) * k];
  return back.every(Number.isFinite) ? back : null;
}

export function mapped([a, b, c, d, e, f]: Affine, [x, y]: Point): Point {
  return [a * x + c * y + e, b * x + d * y + f];
}

/** A direction or a distance: without the map's translation. */
export function mappedVector([a, b, c, d]: Affine, [x, y]: Point): Point {
  return [a * x + c * y, b * x + d * y];
}

/** The box around the image of a box. */
export function mappedBox(map: Affine, [x0, y0, x1, y1]: Box): Box {
  const corners = ([[x0, y0], [x1, y0], [x0, y1], [x1, y1]] as const).map((p) => mapped(map, p));
  const xs = corners.map((p) => p[0]);
  const ys = corners.map((p) => p[1]);
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

/** The factor by which the map makes radii of blur grow: √|determinant|, as the format says. */
export function lengthScale(map: Affine): number {
  return Math.sqrt(Math.abs(determinant(map)));
}
