// A layer's curves as rays meet them, in a triangulation that can be refined where it is visible.

import { NO_MATE } from "./mesh.js";
import { nextEdge, OPEN, previousEdge, SIDE } from "./exact_fields.js";

/** @import { ExactField, ExactLayer } from "./exact_fields.js" */

/** One attribute of an ExactMesh: the tables of an ExactField, some of which can grow. */
export class MeshField {
  /** @param {ExactField} field */
  constructor(field) {
    this.channelCount = field.channelCount;
    this.ends = field.ends;
    this.edge = Array.from(field.edge);
    this.sideOf = Array.from(field.sideOf);
    this.from = Array.from(field.from);
    this.to = Array.from(field.to);
    this.blurFrom = Array.from(field.blurFrom);
    this.blurTo = Array.from(field.blurTo);
    this.weight = Array.from(field.weight);
  }

  get sideCount() {
    return this.weight.length;
  }

  /**
   * Splits half-edge h at share u: h becomes the first part, `rest` the second.
   * @param {number} h
   * @param {number} rest
   * @param {number} u
   */
  cut(h, rest, u) {
    this.edge[rest] = this.edge[h];
    this.sideOf[rest] = this.sideCount;
    if (this.edge[h] !== SIDE) return;
    const side = this.sideOf[h];
    for (let c = 0; c < this.channelCount; ++c) {
      const i = this.channelCount * side + c;
      const middle = this.from[i] + u * (this.to[i] - this.from[i]);
      this.from.push(middle);
      this.to.push(this.to[i]);
      this.to[i] = middle;
    }
    const radius = this.blurFrom[side] + u * (this.blurTo[side] - this.blurFrom[side]);
    this.blurFrom.push(radius);
    this.blurTo.push(this.blurTo[side]);
    this.blurTo[side] = radius;
    this.weight.push(this.weight[side]);
  }

  /**
   * Renames half-edge h to `to`. Rays meet nothing between the parts of a triangle.
   * @param {number} h
   * @param {number} to
   */
  move(h, to) {
    this.edge[to] = this.edge[h];
    this.sideOf[to] = this.sideOf[h];
    this.edge[h] = OPEN;
  }
}

export class ExactMesh {
  /** @param {ExactLayer} layer */
  constructor(layer) {
    const count = layer.positions.length / 2;
    this.origin = layer.origin;
    this.x = Array.from({ length: count }, (_, i) => layer.positions[2 * i]);
    this.y = Array.from({ length: count }, (_, i) => layer.positions[2 * i + 1]);
    this.vertex = Array.from(layer.triangleVertex);
    this.twin = Array.from(layer.twin);
    this.fields = layer.fields.map((field) => new MeshField(field));
    /** The new places of half-edges that were renamed. @type {Map<number, number>} */
    this.moved = new Map();
  }

  /** Returns the present place of a half-edge that was h when the mesh was made. @param {number} h */
  placeOf(h) {
    for (let next = this.moved.get(h); next !== undefined; next = this.moved.get(h)) h = next;
    return h;
  }

  get triangleCount() {
    return this.vertex.length / 3;
  }

  /** @param {number} h */
  target(h) {
    return this.vertex[nextEdge(h)];
  }

  /** @param {number} h */
  apex(h) {
    return this.vertex[previousEdge(h)];
  }

  /** Returns whether rays meet something at h, in any field. @param {number} h */
  isCurve(h) {
    return this.fields.some((field) => field.edge[h] !== OPEN);
  }

  /**
   * Returns twice the area of a triangle, positive for the orientation of all triangles.
   * @param {number} a vertex
   * @param {number} b vertex
   * @param {number} x x of the third corner
   * @param {number} y
   */
  area(a, b, x, y) {
    const { x: xs, y: ys } = this;
    return (xs[b] - xs[a]) * (y - ys[a]) - (ys[b] - ys[a]) * (x - xs[a]);
  }

  /**
   * Returns whether the triangle of h keeps its orientation with (x, y) between the ends of h.
   * @param {number} h
   * @param {number} x
   * @param {number} y
   */
  hasRoom(h, x, y) {
    const from = this.vertex[h],
      to = this.target(h),
      apex = this.apex(h);
    const least = 1e-3 * this.area(from, to, this.x[apex], this.y[apex]);
    return this.area(to, apex, x, y) > least && this.area(apex, from, x, y) > least;
  }

  /**
   * Puts a vertex between the ends of h, on both sides; hasRoom() must have allowed it. Returns the second part of
   * h.
   * @param {number} h
   * @param {number} x
   * @param {number} y
   * @param {number} u share of the way along h
   */
  split(h, x, y, u) {
    const middle = this.x.length;
    this.x.push(x);
    this.y.push(y);
    const across = this.twin[h];
    const rest = this.part(h, middle, u);
    if (across === NO_MATE) return rest;
    const restAcross = this.part(across, middle, 1 - u);
    this.join(h, restAcross);
    this.join(rest, across);
    return rest;
  }

  /**
   * Cuts the triangle of h in two. Returns the second part of h.
   * @param {number} h
   * @param {number} middle vertex
   * @param {number} u
   */
  part(h, middle, u) {
    const { vertex, twin } = this;
    const next = nextEdge(h);
    const first = vertex.length;
    const beyond = twin[next];
    vertex.push(middle, vertex[next], this.apex(h));
    vertex[next] = middle;
    twin.push(NO_MATE, beyond, NO_MATE);
    if (beyond !== NO_MATE) twin[beyond] = first + 1;
    this.moved.set(next, first + 1);
    for (const field of this.fields) {
      field.cut(h, first, u);
      field.move(next, first + 1);
      field.edge[first + 2] = OPEN;
      field.sideOf[first + 2] = 0;
    }
    twin[h] = NO_MATE;
    this.join(next, first + 2);
    return first;
  }

  /**
   * @param {number} a
   * @param {number} b half-edge on the other side of a
   */
  join(a, b) {
    this.twin[a] = b;
    this.twin[b] = a;
  }
}
