// Affine maps as [a, b, c, d, e, f] of SVG's matrix(): (x, y) -> (a x + c y + e, b x + d y + f).

/** @typedef {readonly number[]} Affine */

/**
 * Returns the map that applies `inner` first, then `outer`.
 * @param {Affine} outer
 * @param {Affine} inner
 * @returns {Affine}
 */
export function composed(outer, inner) {
  const [a, b, c, d, e, f] = outer,
    [p, q, r, s, t, u] = inner;
  return [
    a * p + c * q,
    b * p + d * q,
    a * r + c * s,
    b * r + d * s,
    a * t + c * u + e,
    b * t + d * u + f,
  ];
}

/**
 * @param {Affine} map whose determinant is not 0
 * @returns {Affine}
 */
export function inverted([a, b, c, d, e, f]) {
  const k = 1 / (a * d - b * c);
  const linear = [d * k, -b * k, -c * k, a * k];
  return [...linear, -(linear[0] * e + linear[2] * f), -(linear[1] * e + linear[3] * f)];
}

/**
 * @param {number} x
 * @param {number} y
 * @returns {Affine}
 */
export function translation(x, y) {
  return [1, 0, 0, 1, x, y];
}

/**
 * @param {Affine} map
 * @param {number} x
 * @param {number} y
 * @returns {number[]}
 */
export function mapped(map, x, y) {
  return [map[0] * x + map[2] * y + map[4], map[1] * x + map[3] * y + map[5]];
}

/**
 * Returns the box around the image of a box; boxes are minimum x, y, maximum x, y.
 * @param {Affine} map
 * @param {readonly number[]} box
 * @returns {[number, number, number, number]}
 */
export function mappedBox(map, [x0, y0, x1, y1]) {
  const corners = [
    mapped(map, x0, y0),
    mapped(map, x1, y0),
    mapped(map, x0, y1),
    mapped(map, x1, y1),
  ];
  const xs = corners.map((p) => p[0]),
    ys = corners.map((p) => p[1]);
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

/**
 * Returns the map as the two rows that shaders take.
 * @param {Affine} map
 */
export function rowsOf([a, b, c, d, e, f]) {
  return new Float32Array([a, c, e, b, d, f]);
}
