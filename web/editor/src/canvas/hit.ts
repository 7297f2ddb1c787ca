// Hit testing: marks first, then curves, then the topmost layer at the point.
import { mapped, composed, type Affine, type Box, type Point } from "../geometry/affine.js";
import { split, type Cubic, type CubicPath } from "../geometry/cubic.js";
import { distanceToBox, flatten, nearestOn } from "../geometry/nearest.js";
import type { PathEnd } from "../model/commands/index.js";
import type { Handle, Item } from "../model/types.js";
import type { Mark } from "./marks.js";
import type { Place } from "./places.js";

/** Cells of the grid, CSS pixels. */
const CELL = 32;
/** How far a chord may be from its curve, CSS pixels. */
const TOLERANCE = 0.25;
/** A part that is larger than this is cut, CSS pixels. */
const LARGEST = 2 * CELL;
const DEEPEST = 24;

/** How far from the pointer an object is hit, CSS pixels. */
export const REACH = {
  mouse: { mark: 12, curve: 6 },
  pen: { mark: 12, curve: 8 },
  touch: { mark: 22, curve: 14 },
} as const;
export type PointerKind = keyof typeof REACH;

/** Marks whose distances differ by less are alike: what they are decides. */
const ALIKE = 4;

/** An end of an open curve, on the stage. */
export interface EndHit {
  readonly point: Point;
  readonly place: Place;
  readonly path: number;
  readonly end: PathEnd;
}

export interface CurveHit {
  readonly place: Place;
  readonly path: number;
  /** Piece and its parameter. */
  readonly at: number;
  /** The nearest point of the curve, on the stage, and how far it is. */
  readonly point: Point;
  readonly distance: number;
}

/** A stretch of a piece, on the stage. */
interface Part {
  readonly cubic: Cubic;
  /** Piece and its parameter where it begins and ends. */
  readonly from: number;
  readonly to: number;
  readonly place: number;
  readonly path: number;
}

/** The curves on a stage, cut into parts that lie in square cells. */
export class CurveGrid {
  private readonly cells = new Map<number, Part[]>();
  private readonly columns: number;
  private readonly ends: EndHit[] = [];

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
    if (!closed) {
      const of = { place: this.places[place], path };
      this.ends.push({ ...of, point: stage[0], end: "start" });
      this.ends.push({ ...of, point: stage[stage.length - 1], end: "end" });
    }
    for (let k = 0; k + 3 < stage.length; k += 3) {
      const cubic: Cubic = [stage[k], stage[k + 1], stage[k + 2], stage[k + 3]];
      this.addPart({ cubic, from: k / 3, to: k / 3 + 1, place, path }, 0);
    }
  }

  /** Cuts only curves on the stage, and only as finely as the cells need. */
  private addPart(part: Part, depth: number): void {
    const [x0, y0, x1, y1] = hullBox(part.cubic);
    // Comparisons that numbers which are none fail.
    const isSeen =
      x1 >= -CELL && y1 >= -CELL && x0 <= this.width + CELL && y0 <= this.height + CELL;
    if (!isSeen) return;
    if (Math.max(x1 - x0, y1 - y0) <= LARGEST || depth >= DEEPEST) {
      this.addTo(part, this.column(x0), this.column(x1), y0, y1);
    } else if (isStraight(part.cubic)) this.addChord(part);
    else for (const half of halves(part)) this.addPart(half, depth + 1);
  }

  /** A long chord lies in few of the cells of its box. */
  private addChord(part: Part): void {
    const [[ax, ay], , , [bx, by]] = part.cubic;
    const slope = bx === ax ? 0 : (by - ay) / (bx - ax);
    const [left, right] = [Math.min(ax, bx), Math.max(ax, bx)];
    for (let column = this.column(left); column <= this.column(right); column += 1) {
      // Heights at which the chord enters and leaves this column.
      const from = Math.max(left, (column - 1) * CELL);
      const to = Math.min(right, column * CELL);
      const heights = bx === ax ? [ay, by] : [ay + slope * (from - ax), ay + slope * (to - ax)];
      this.addTo(part, column, column, Math.min(...heights) - 1, Math.max(...heights) + 1);
    }
  }

  private addTo(part: Part, first: number, last: number, top: number, bottom: number): void {
    for (let row = this.row(top); row <= this.row(bottom); row += 1) {
      for (let column = first; column <= last; column += 1) {
        const cell = row * this.columns + column;
        const list = this.cells.get(cell);
        if (list) list.push(part);
        else this.cells.set(cell, [part]);
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

  /** The parts that may come near a rectangle, each once. */
  private partsIn(x0: number, y0: number, x1: number, y1: number): Set<Part> {
    const found = new Set<Part>();
    for (let row = this.row(y0); row <= this.row(y1); row += 1) {
      for (let column = this.column(x0); column <= this.column(x1); column += 1) {
        for (const part of this.cells.get(row * this.columns + column) ?? []) found.add(part);
      }
    }
    return found;
  }

  /**
   * Curves within `reach` of a point, each once for each subpath: the nearest first, of those equally
   * near the one on top.
   * @param isWanted leaves out curves
   */
  near(at: Point, reach: number, isWanted?: (place: Place) => boolean): CurveHit[] {
    const best = new Map<string, CurveHit & { readonly order: number }>();
    const [x, y] = at;
    for (const part of this.partsIn(x - reach, y - reach, x + reach, y + reach)) {
      const place = this.places[part.place];
      if (distanceToBox(at, hullBox(part.cubic)) > reach || (isWanted && !isWanted(place)))
        continue;
      const key = `${part.place}/${part.path}`;
      const within = best.get(key)?.distance ?? reach * (1 + Number.EPSILON);
      const found = nearestOn({ points: part.cubic, closed: false }, at, within);
      if (!found) continue;
      const { point, distance } = found;
      const along = part.from + found.at * (part.to - part.from);
      best.set(key, { place, path: part.path, at: along, point, distance, order: part.place });
    }
    return [...best.values()].sort((a, b) => a.distance - b.distance || b.order - a.order);
  }

  /** Returns the places whose curve crosses a rectangle of the stage, each once. */
  within(low: Point, high: Point): Set<Place> {
    const found = new Set<Place>();
    for (const part of this.partsIn(low[0], low[1], high[0], high[1])) {
      const place = this.places[part.place];
      if (!found.has(place) && crosses(part.cubic, low, high)) found.add(place);
    }
    return found;
  }

  /** Ends of open curves within `reach` of a point, on the stage. */
  endsNear(
    [x, y]: Point,
    reach: number,
    isWanted: (place: Place) => boolean,
  ): readonly EndHit[] {
    return this.ends.filter(
      ({ point, place }) => Math.hypot(point[0] - x, point[1] - y) <= reach && isWanted(place),
    );
  }
}

function halves({ cubic, from, to, place, path }: Part): [Part, Part] {
  const [first, second] = split(cubic, 0.5);
  const middle = (from + to) / 2;
  return [
    { cubic: first, from, to: middle, place, path },
    { cubic: second, from: middle, to, place, path },
  ];
}

/** Whether a curve has a point in a rectangle. */
function crosses(cubic: Cubic, low: Point, high: Point): boolean {
  const { points } = flatten({ points: cubic, closed: false }, TOLERANCE);
  return points.some((point, k) => k > 0 && chordCrosses(points[k - 1], point, low, high));
}

/** Returns whether a chord crosses the rectangle: the part of it that is left after each of the four cuts. */
function chordCrosses(a: Point, b: Point, low: Point, high: Point): boolean {
  let [from, to] = [0, 1];
  for (const axis of [0, 1] as const) {
    const way = b[axis] - a[axis];
    if (way === 0) {
      if (a[axis] < low[axis] || a[axis] > high[axis]) return false;
      continue;
    }
    const [p, q] = [(low[axis] - a[axis]) / way, (high[axis] - a[axis]) / way];
    [from, to] = [Math.max(from, Math.min(p, q)), Math.min(to, Math.max(p, q))];
  }
  return from <= to;
}

/** Whether the chord is within the tolerance of the curve. */
function isStraight([a, b, c, d]: Cubic): boolean {
  const bend = (p: Point, q: Point, r: Point) =>
    Math.hypot(p[0] - 2 * q[0] + r[0], p[1] - 2 * q[1] + r[1]);
  return 0.75 * Math.max(bend(a, b, c), bend(b, c, d)) <= TOLERANCE;
}

/** The box of the control points, within which the curve lies. */
function hullBox([p0, p1, p2, p3]: Cubic): Box {
  return [
    Math.min(p0[0], p1[0], p2[0], p3[0]),
    Math.min(p0[1], p1[1], p2[1], p3[1]),
    Math.max(p0[0], p1[0], p2[0], p3[0]),
    Math.max(p0[1], p1[1], p2[1], p3[1]),
  ];
}

const ORDER: readonly Mark["kind"][] = ["turn", "scale", "bracket", "stop", "paint", "node", "handle"];

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
 * Returns the topmost layer whose curves surround a point of the artboard, by the box of their points; null:
 * there is none. For a layer that a <use> shows it returns the <use>.
 */
export function layerAt(places: readonly Place[], [x, y]: Point): Item | null {
  const boxes = new Map<Handle, { owner: Item; box: [number, number, number, number] }>();
  for (const { item, owner, artboardFromItem } of places) {
    const top = outermostLayer(owner);
    const known = boxes.get(top.handle) ?? {
      owner: top,
      box: [Infinity, Infinity, -Infinity, -Infinity],
    };
    // Later places are on top: a map keeps keys in the order of their last insertion.
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
