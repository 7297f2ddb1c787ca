// Refines chords where that is visible: splits edges on smooth curves at points of a curve through their vertices,
// until the error is too small to see.

import { NO_MATE } from "./mesh.js";
import { previousEdge } from "./exact_fields.js";

/** @import { ExactMesh } from "./exact_mesh.js" */

/** Limit for the distance between a chord and its curve, pixels. */
export const MOST_STRAY = 0.15;
/** How far chords of a smooth curve may stray, relative to their tolerance. */
const SMOOTH_STRAY = 2.5;
/** Cosine of the largest turn between chords of a smooth curve. */
const LEAST_COSINE = 0.5;
/** Limit for the curves at a vertex that are examined. */
const MOST_AT_VERTEX = 64;
/** Limit for the edges that refinement makes. */
const MOST_SPLITS = 1 << 17;

/** @typedef {number[]} Vector */

/** @param {Vector} v */
function unit([x, y]) {
  const length = Math.hypot(x, y) || 1;
  return [x / length, y / length];
}

export class Refiner {
  /**
   * @param {ExactMesh} mesh
   * @param {number} tolerance of its edges, layer units
   */
  constructor(mesh, tolerance) {
    this.mesh = mesh;
    this.tolerance = tolerance;
    this.left = MOST_SPLITS;
  }

  /**
   * Refines visible edges.
   * @param {number[]} box the visible area, relative to the mesh's origin
   * @param {number} scale pixels per layer unit, where it is largest
   */
  refine(box, scale) {
    const { mesh } = this;
    const stray = MOST_STRAY / scale;
    if (this.tolerance <= stray) return;
    const edges = [];
    for (let h = 0; h < mesh.vertex.length; ++h) {
      const isFirst = mesh.twin[h] === NO_MATE || h < mesh.twin[h];
      if (!isFirst || !mesh.isCurve(h) || !this.isSeen(h, box)) continue;
      const from = this.tangent(h),
        back = this.tangentBack(h);
      // If only one end has a direction, the curve bends evenly.
      const start = from ?? (back && this.mirrored(h, back));
      const end = back ?? (from && this.mirrored(h, from));
      if (start && end) edges.push({ h, start, end });
    }
    for (const { h, start, end } of edges)
      this.split(mesh.placeOf(h), start, end, stray, box);
  }

  /** @param {number} h @returns {Vector} */
  chord(h) {
    const { x, y, vertex } = this.mesh;
    const a = vertex[h],
      b = this.mesh.target(h);
    return [x[b] - x[a], y[b] - y[a]];
  }

  /**
   * Returns whether the edge, or its curve, may touch the box.
   * @param {number} h
   * @param {number[]} box
   */
  isSeen(h, box) {
    const { x, y, vertex } = this.mesh;
    const a = vertex[h],
      b = this.mesh.target(h);
    const room = SMOOTH_STRAY * this.tolerance;
    return (
      Math.max(x[a], x[b]) + room >= box[0] &&
      Math.min(x[a], x[b]) - room <= box[2] &&
      Math.max(y[a], y[b]) + room >= box[1] &&
      Math.min(y[a], y[b]) - room <= box[3]
    );
  }

  /**
   * Returns the tangent of the curve of h at its origin, as a unit vector along h; null unless the curve continues
   * there smoothly.
   * @param {number} h
   * @returns {Vector | null}
   */
  tangent(h) {
    const before = this.straightBehind(h);
    if (before === null || this.straightBehind(before) !== h) return null;
    const out = this.chord(h),
      [bx, by] = this.chord(before);
    const back = [-bx, -by];
    const [near, far] = [Math.hypot(...out), Math.hypot(...back)];
    const [ux, uy] = unit(out),
      [vx, vy] = unit(back);
    const turn = Math.acos(Math.max(-1, Math.min(1, ux * vx + uy * vy)));
    const isSmooth = (Math.max(near, far) * turn) / 8 <= SMOOTH_STRAY * this.tolerance;
    // The tangent of the circle through the three points.
    return isSmooth ? unit([ux * far + vx * near, uy * far + vy * near]) : null;
  }

  /** Returns the same at the target of h. @param {number} h @returns {Vector | null} */
  tangentBack(h) {
    const found = this.tangentFrom(h);
    return found && [-found[0], -found[1]];
  }

  /**
   * Returns tangent() of the edge turned around.
   * @param {number} h
   */
  tangentFrom(h) {
    const across = this.mesh.twin[h];
    return across === NO_MATE ? null : this.tangent(across);
  }

  /**
   * Returns, among the curve edges that leave the origin of h, the one that continues h most straight backwards.
   * @param {number} h
   * @returns {number | null}
   */
  straightBehind(h) {
    const { twin } = this.mesh;
    const [ux, uy] = unit(this.chord(h));
    let best = null,
      least = -LEAST_COSINE;
    let g = h;
    for (let i = 0; i < MOST_AT_VERTEX; ++i) {
      g = twin[previousEdge(g)];
      if (g === NO_MATE || g === h) break;
      if (!this.mesh.isCurve(g)) continue;
      const [vx, vy] = unit(this.chord(g));
      const cosine = ux * vx + uy * vy;
      if (cosine >= least) continue;
      least = cosine;
      best = g;
    }
    return g === h ? best : null;
  }

  /**
   * Returns a direction mirrored to the other end of an arc.
   * @param {number} h
   * @param {Vector} direction
   */
  mirrored(h, [x, y]) {
    const [ux, uy] = unit(this.chord(h));
    const along = x * ux + y * uy,
      across = ux * y - uy * x;
    return [along * ux + across * uy, along * uy - across * ux];
  }

  /**
   * @param {number} h
   * @param {Vector} start direction of the curve at its origin
   * @param {Vector} end the same at its target
   * @param {number} stray
   * @param {number[]} box
   */
  split(h, start, end, stray, box) {
    const { mesh } = this;
    const [cx, cy] = this.chord(h);
    const length = Math.hypot(cx, cy);
    const bend = [start[0] - end[0], start[1] - end[1]].map((v) => (length / 8) * v);
    if (Math.hypot(...bend) <= stray || this.left === 0 || !this.isSeen(h, box)) return;
    const a = mesh.vertex[h];
    const x = mesh.x[a] + 0.5 * cx + bend[0],
      y = mesh.y[a] + 0.5 * cy + bend[1];
    const across = mesh.twin[h];
    if (!mesh.hasRoom(h, x, y) || (across !== NO_MATE && !mesh.hasRoom(across, x, y))) return;
    const middle = unit([
      1.5 * cx - 0.25 * length * (start[0] + end[0]),
      1.5 * cy - 0.25 * length * (start[1] + end[1]),
    ]);
    this.left -= 1;
    const rest = mesh.split(h, x, y, 0.5);
    this.split(h, start, middle, stray, box);
    this.split(rest, middle, end, stray, box);
  }
}
