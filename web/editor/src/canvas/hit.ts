// What lies under the pointer: marks first, then curves, then the layer that is seen there.
import { mapped, composed, type Affine, type Point } from "../geometry/affine.js";
import type { CubicPath } from "../geometry/cubic.js";
import type { Handle, Item } from "../model/types.js";
import type { Mark } from "./marks.js";
import type { Place } from "./places.js";

/** Cells of the grid, CSS pixels. */
const CELL = 32;
/** How far a chord may be from its curve, CSS pixels. */
const TOLERANCE = 0.25;
const DEEPEST = 20;

/** How far from the pointer things are hit, CSS pixels. */
export const REACH = {
  mouse: { mark: 12, curve: 6 },
  pen: { mark: 12, curve: 8 },
  touch: { mark: 22, curve: 14 },
} as const;
export type PointerKind = keyof typeof REACH;

/** Marks whose distances differ by less are alike: what they are decides. */
const ALIKE = 4;

export interface CurveHit {
  readonly place: Place;
  readonly path: number;
  /** Piece and its parameter. */
  readonly at: number;
  /** The nearest point of the curve, on the stage, and how far it is. */
  readonly point: Point;
  readonly distance: number;
}

interface Segment {
  readonly place: number;
  readonly path: number;
  readonly at0: number;
  readonly at1: number;
  readonly x0: number;
  readonly y0: number;
  readonly x1: number;
  readonly y1: number;
}

type Quad = readonly [Point, Point, Point, Point];

/** The curves on a stage, cut into chords that lie in square cells. */
export class CurveGrid {
  private readonly cells = new Map<number, Segment[]>();
  private readonly columns: number;
  private readonly ends: { readonly point: Point; readonly place: Place }[] = [];

  constructor(
    private readonly places: readonly Place[],
    stageFromArtboard: Affine,
    private readonly width: number,
    private readonly height: number,
  ) {
    this.columns = Math.ceil(width / CELL) + 3;
    places.forEach((place, index) => {
      const map = composed(stageFromArtboard, place.artboardFromItem);
      place.item.paths.forEach((path, k) => this.addPath(path, map, index, k));
    });
  }

  private addPath({ points, closed }: CubicPath, map: Affine, place: number, path: number): void {
    const stage = points.map((point) => mapped(map, point));
    if (!closed)
      for (const k of [0, -1])
        this.ends.push({ point: stage.at(k) as Point, place: this.places[place] });
    for (let k = 0; k + 3 < stage.length; k += 3) {
      const quad: Quad = [stage[k], stage[k + 1], stage[k + 2], stage[k + 3]];
      this.addPiece(quad, k / 3, k / 3 + 1, 0, place, path);
    }
  }

  /** Only what is on the stage is cut: the work does not grow with the zoom. */
  private addPiece(
    quad: Quad,
    at0: number,
    at1: number,
    depth: number,
    place: number,
    path: number,
  ): void {
    if (this.isOutside(quad)) return;
    const [a, b, c, d] = quad;
    if (depth >= DEEPEST || isStraight(quad)) {
      this.addSegment({ place, path, at0, at1, x0: a[0], y0: a[1], x1: d[0], y1: d[1] });
      return;
    }
    const [ab, bc, cd] = [middle(a, b), middle(b, c), middle(c, d)];
    const [abc, bcd] = [middle(ab, bc), middle(bc, cd)];
    const half = middle(abc, bcd);
    const at = (at0 + at1) / 2;
    this.addPiece([a, ab, abc, half], at0, at, depth + 1, place, path);
    this.addPiece([half, bcd, cd, d], at, at1, depth + 1, place, path);
  }

  private isOutside(quad: Quad): boolean {
    const beyond = (axis: 0 | 1, extent: number) =>
      quad.every((p) => p[axis] < -CELL) || quad.every((p) => p[axis] > extent + CELL);
    return (
      beyond(0, this.width) ||
      beyond(1, this.height) ||
      !quad.every((p) => Number.isFinite(p[0] + p[1]))
    );
  }

  private addSegment(segment: Segment): void {
    const { x0, y0, x1, y1 } = segment;
    const [left, right] = x0 <= x1 ? [x0, x1] : [x1, x0];
    const slope = x1 === x0 ? 0 : (y1 - y0) / (x1 - x0);
    const last = this.column(right);
    for (let column = this.column(left); column <= last; column += 1) {
      // Heights at which the chord enters and leaves this column.
      const from = Math.max(left, (column - 1) * CELL);
      const to = Math.min(right, column * CELL);
      const ya = x1 === x0 ? y0 : y0 + slope * (from - x0);
      const yb = x1 === x0 ? y1 : y0 + slope * (to - x0);
      const end = this.row(Math.max(ya, yb));
      for (let row = this.row(Math.min(ya, yb)); row <= end; row += 1) {
        const cell = row * this.columns + column;
        const list = this.cells.get(cell);
        if (list) list.push(segment);
        else this.cells.set(cell, [segment]);
      }
    }
  }

  // One cell of margin on each side; what is farther out is outside.
  private column(x: number): number {
    return Math.min(this.columns - 1, Math.max(0, Math.floor(x / CELL) + 1));
  }

  private row(y: number): number {
    return Math.min(Math.ceil(this.height / CELL) + 2, Math.max(0, Math.floor(y / CELL) + 1));
  }

  /**
   * Curves within `reach` of a point, each once for each subpath: the nearest first, of those equally
   * near the one on top.
   * @param isWanted leaves out curves
   */
  near([x, y]: Point, reach: number, isWanted?: (place: Place) => boolean): CurveHit[] {
    const best = new Map<string, CurveHit & { readonly order: number }>();
    const end = [this.column(x + reach), this.row(y + reach)];
    for (let row = this.row(y - reach); row <= end[1]; row += 1) {
      for (let column = this.column(x - reach); column <= end[0]; column += 1) {
        for (const segment of this.cells.get(row * this.columns + column) ?? []) {
          const hit = this.onSegment(segment, x, y);
          if (hit.distance > reach || (isWanted && !isWanted(hit.place))) continue;
          const key = `${segment.place}/${segment.path}`;
          const known = best.get(key);
          if (!known || hit.distance < known.distance)
            best.set(key, { ...hit, order: segment.place });
        }
      }
    }
    return [...best.values()].sort((a, b) => a.distance - b.distance || b.order - a.order);
  }

  /** Places of which a chord crosses a rectangle of the stage, each once. */
  within([x0, y0]: Point, [x1, y1]: Point): Set<Place> {
    const found = new Set<Place>();
    for (let row = this.row(y0); row <= this.row(y1); row += 1) {
      for (let column = this.column(x0); column <= this.column(x1); column += 1) {
        for (const segment of this.cells.get(row * this.columns + column) ?? []) {
          if (crosses(segment, x0, y0, x1, y1)) found.add(this.places[segment.place]);
        }
      }
    }
    return found;
  }

  /** Ends of open curves within `reach` of a point, on the stage. */
  endsNear(
    [x, y]: Point,
    reach: number,
    isWanted: (place: Place) => boolean,
  ): readonly { readonly point: Point }[] {
    return this.ends.filter(
      ({ point, place }) => Math.hypot(point[0] - x, point[1] - y) <= reach && isWanted(place),
    );
  }

  private onSegment(segment: Segment, x: number, y: number): CurveHit {
    const { x0, y0, x1, y1, at0, at1 } = segment;
    const [dx, dy] = [x1 - x0, y1 - y0];
    const square = dx * dx + dy * dy;
    const share =
      square > 0 ? Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / square)) : 0;
    const point: Point = [x0 + share * dx, y0 + share * dy];
    return {
      place: this.places[segment.place],
      path: segment.path,
      at: at0 + share * (at1 - at0),
      point,
      distance: Math.hypot(point[0] - x, point[1] - y),
    };
  }
}

/** Whether a chord has a point in a rectangle: what is left of it after each of the four cuts. */
function crosses(
  { x0: ax, y0: ay, x1: bx, y1: by }: Segment,
  x0: number,
  y0: number,
  x1: number,
  y1: number,
): boolean {
  let [from, to] = [0, 1];
  for (const [start, way, low, high] of [
    [ax, bx - ax, x0, x1],
    [ay, by - ay, y0, y1],
  ]) {
    if (way === 0) {
      if (start < low || start > high) return false;
      continue;
    }
    const [near, far] = [(low - start) / way, (high - start) / way].sort((a, b) => a - b);
    [from, to] = [Math.max(from, near), Math.min(to, far)];
  }
  return from <= to;
}

function middle(a: Point, b: Point): Point {
  return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}

/** Whether the chord is within the tolerance, and goes at the pace of the curve. */
function isStraight([a, b, c, d]: Quad): boolean {
  const bend = (p: Point, q: Point, r: Point) =>
    Math.hypot(p[0] - 2 * q[0] + r[0], p[1] - 2 * q[1] + r[1]);
  return 0.75 * Math.max(bend(a, b, c), bend(b, c, d)) <= TOLERANCE;
}

const ORDER: readonly Mark["kind"][] = ["turn", "scale", "bracket", "stop", "node", "handle"];

/** The mark that a pointer means: a chosen one, then by kind, then the nearest. */
export function markAt(marks: readonly Mark[], [x, y]: Point, reach: number): Mark | null {
  const near = marks
    .map((mark) => ({ mark, distance: Math.hypot(mark.at[0] - x, mark.at[1] - y) }))
    .filter(({ distance }) => distance <= reach);
  const least = Math.min(...near.map(({ distance }) => distance));
  const alike = near.filter(({ distance }) => distance <= least + ALIKE);
  const rank = (mark: Mark) => (mark.isChosen ? -1 : ORDER.indexOf(mark.kind));
  alike.sort((a, b) => rank(a.mark) - rank(b.mark) || a.distance - b.distance);
  return alike[0]?.mark ?? null;
}

/**
 * The topmost layer whose curves go around a point of the artboard, by the box of their points; null:
 * none does. Of a <use> it is the <use>.
 */
export function layerAt(places: readonly Place[], [x, y]: Point): Item | null {
  const boxes = new Map<Handle, { owner: Item; box: [number, number, number, number] }>();
  for (const { item, owner, artboardFromItem } of places) {
    const top = outermostLayer(owner);
    const known = boxes.get(top.handle) ?? {
      owner: top,
      box: [Infinity, Infinity, -Infinity, -Infinity],
    };
    // Later places are on top: a map keeps the order in which keys came last.
    boxes.delete(top.handle);
    boxes.set(top.handle, known);
    for (const path of item.paths)
      for (const point of path.points) extend(known.box, mapped(artboardFromItem, point));
  }
  const around = [...boxes.values()].filter(
    ({ box }) => x >= box[0] && y >= box[1] && x <= box[2] && y <= box[3],
  );
  return around.at(-1)?.owner ?? null;
}

function extend(box: [number, number, number, number], [x, y]: Point): void {
  box[0] = Math.min(box[0], x);
  box[1] = Math.min(box[1], y);
  box[2] = Math.max(box[2], x);
  box[3] = Math.max(box[3], y);
}

/** The layer that an item belongs to, else the item itself. */
export function outermostLayer(item: Item): Item {
  for (let around: Item | null = item; around; around = around.parent) {
    if (around.kind === "layer") return around;
  }
  return item;
}
