// Paths in the form in which their nodes are edited: an arc, which the engine draws with many pieces, has one
// piece for each quarter turn. An arc that an edit does not touch stays an arc.
import type { Point } from "./affine.js";
import { isSameCubic, pieceAt, pieceCount, type Cubic, type CubicPath } from "./cubic.js";
import type { Edited } from "./edited.js";
import { splitAt } from "./nodes.js";
import { add, distance, scaled, subtract } from "./vector.js";

interface Natural {
  readonly path: CubicPath;
  /** The first engine's piece of each of its pieces, then their number. */
  readonly firsts: readonly number[];
}

/** Tolerance of turns, radians. */
const SLACK = 1e-6;

/** An arc of an ellipse: middle + along cos(angle) + across sin(angle), angle from 0. */
interface Arc {
  readonly middle: Point;
  readonly along: Point;
  readonly across: Point;
  /** Turn of each of the engine's pieces, radians. */
  readonly turn: number;
}

/** Returns the handle length of a cubic for an arc, in units of its derivative by the angle. */
const handleOf = (turn: number): number => (4 / 3) * Math.tan(turn / 4);

/**
 * Returns the arc that a piece begins; null: none. The ends of the handles of a cubic with handles of 4/3
 * tan(turn / 4) are 1/3 + 2/3 tan²(turn / 4) of the chord apart, whichever affine map makes an ellipse of the
 * circle.
 */
function arcOf([p0, p1, p2, p3]: Cubic): Arc | null {
  const ratio = distance(p1, p2) / distance(p0, p3);
  const turn = 4 * Math.atan(Math.sqrt((3 * ratio - 1) / 2));
  const across = scaled(subtract(p1, p0), 1 / handleOf(turn));
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  const middle = scaled(
    subtract(subtract(p3, scaled(p0, cos)), scaled(across, sin)),
    1 / (1 - cos),
  );
  return middle.every(Number.isFinite) ? { middle, along: subtract(p0, middle), across, turn } : null;
}

function arcStretch({ middle, along, across }: Arc, from: number, to: number): Cubic {
  const handle = handleOf(to - from);
  const at = (angle: number) =>
    add(middle, add(scaled(along, Math.cos(angle)), scaled(across, Math.sin(angle))));
  const derivative = (angle: number) =>
    subtract(scaled(across, Math.cos(angle)), scaled(along, Math.sin(angle)));
  const [begin, end] = [at(from), at(to)];
  return [
    begin,
    add(begin, scaled(derivative(from), handle)),
    subtract(end, scaled(derivative(to), handle)),
    end,
  ];
}

/** Returns how many of the engine's pieces of a segment form one: a quarter turn at most. */
function groupSize(turn: number, pieces: number): number {
  const quarters = Math.ceil((turn * pieces) / (Math.PI / 2) - SLACK);
  // The number of pieces is a power of two: three quarters and a bit are four parts.
  let parts = 1;
  while (parts < Math.min(quarters, pieces)) parts *= 2;
  return pieces % parts === 0 ? pieces / parts : 1;
}

/** An arc's stretch with the very ends of the engine's pieces. */
function held([begin, , , end]: Cubic, [, control1, control2]: Cubic): Cubic {
  return [begin, control1, control2, end];
}

function made(path: CubicPath, segments: readonly number[]): Natural {
  const points: Point[] = [path.points[0]];
  const firsts: number[] = [];
  for (let s = 0; s + 1 < segments.length; ++s) {
    const [from, to] = [segments[s], segments[s + 1]];
    const arc = to - from > 1 ? arcOf(pieceAt(path, from)) : null;
    const size = arc ? groupSize(arc.turn, to - from) : 1;
    for (let piece = from; piece < to; piece += size) {
      const [first, last] = [pieceAt(path, piece), pieceAt(path, piece + size - 1)];
      const angle = (piece - from) * (arc?.turn ?? 0);
      const cubic =
        arc && size > 1 ? arcStretch(arc, angle, angle + size * arc.turn) : first;
      points.push(...held([first[0], first[0], last[3], last[3]], cubic).slice(1));
      firsts.push(piece);
    }
  }
  return { path: { points, closed: path.closed }, firsts: [...firsts, pieceCount(path)] };
}

/** Paths do not change, so each is analysed once. */
const known = new WeakMap<CubicPath, Natural>();

function naturalOf(path: CubicPath): Natural | null {
  if (!path.segments) return null;
  const natural = known.get(path) ?? made(path, path.segments);
  known.set(path, natural);
  return natural;
}

/** The path whose nodes and handles are shown and edited: with four nodes for a circle. */
export function nodePath(path: CubicPath): CubicPath {
  return naturalOf(path)?.path ?? path;
}

/** A place on a path as one on its nodePath(). */
export function placeOnNodePath(path: CubicPath, at: number): number {
  const natural = naturalOf(path);
  return natural ? mappedPlace(at, natural.firsts, null) : at;
}

/** A place by pieces that begin at `from`, as one by pieces that begin at `to`; null: at 0, 1, 2, … */
function mappedPlace(
  at: number,
  from: readonly number[] | null,
  to: readonly number[] | null,
): number {
  const count = (from ?? to)!.length - 1;
  const [begins, becomes] = [from, to].map((firsts) => (i: number) => firsts?.[i] ?? i);
  let i = 0;
  while (i < count - 1 && begins(i + 1) <= at) ++i;
  const share = (at - begins(i)) / (begins(i + 1) - begins(i));
  return becomes(i) + Math.min(Math.max(share, 0), 1) * (becomes(i + 1) - becomes(i));
}

const keyOf = ([x, y]: Point): string => `${x} ${y}`;

/** Segments of several engine's pieces by where they begin: their first and last natural piece. */
function arcsOf({ segments = [] }: CubicPath, { path, firsts }: Natural) {
  const arcs = new Map<string, { readonly from: number; readonly to: number }>();
  for (let s = 0; s + 1 < segments.length; ++s) {
    if (segments[s + 1] - segments[s] < 2) continue;
    const [from, to] = [firsts.indexOf(segments[s]), firsts.indexOf(segments[s + 1])];
    arcs.set(keyOf(path.points[3 * from]), { from, to });
  }
  return arcs;
}

/** Returns an edited natural path in which untouched arcs have the engine's pieces again. */
function withArcs(path: CubicPath, natural: Natural, edited: CubicPath): Natural {
  const arcs = arcsOf(path, natural);
  const points: Point[] = [edited.points[0]];
  const segments: number[] = [];
  const firsts: number[] = [];
  const count = pieceCount(edited);
  const here = () => (points.length - 1) / 3;
  for (let i = 0; i < count;) {
    segments.push(here());
    const arc = arcs.get(keyOf(edited.points[3 * i]));
    const length = arc ? arc.to - arc.from : 0;
    const isArc =
      arc !== undefined &&
      i + length <= count &&
      Array.from({ length }, (_, k) => k).every((k) =>
        isSameCubic(pieceAt(edited, i + k), pieceAt(natural.path, arc.from + k)),
      );
    if (!isArc) {
      firsts.push(here());
      points.push(...pieceAt(edited, i).slice(1));
      i += 1;
      continue;
    }
    const [from, to] = [natural.firsts[arc.from], natural.firsts[arc.to]];
    for (let k = arc.from; k < arc.to; ++k) firsts.push(here() + natural.firsts[k] - from);
    points.push(...path.points.slice(3 * from + 1, 3 * to + 1));
    i += length;
  }
  const pieces = here();
  const all = [...segments, pieces];
  const plain = { points, closed: edited.closed };
  return {
    path: all.length === pieces + 1 ? plain : { ...plain, segments: all },
    firsts: [...firsts, pieces],
  };
}

/** Returns the path itself after an edit of its nodePath(). */
export function editedByNodes<Other>(
  path: CubicPath,
  edit: (nodes: CubicPath, path: CubicPath) => Edited | Other,
): Edited | Other {
  const natural = naturalOf(path);
  const change = edit(natural?.path ?? path, path);
  if (!natural || !isEdited(change)) return change;
  const after = withArcs(path, natural, change.path);
  const follow = (place: number) =>
    mappedPlace(change.follow(mappedPlace(place, natural.firsts, null)), null, after.firsts);
  const bends = change.bends.map((bend) => mappedPlace(bend, null, natural.firsts));
  const all = [...bends, ...speedChanges(natural.firsts, follow)];
  return { ...change, path: after.path, follow, bends: [...new Set(all)].sort((a, b) => a - b) };
}

/** Where an arc that is fewer pieces now meets one that is not, places are followed otherwise. */
function speedChanges(firsts: readonly number[], follow: (place: number) => number): number[] {
  const speed = (i: number) =>
    (follow(firsts[i + 1]) - follow(firsts[i])) / (firsts[i + 1] - firsts[i]);
  const inner = Array.from({ length: firsts.length - 2 }, (_, i) => i + 1);
  return inner.filter((i) => Math.abs(speed(i) - speed(i - 1)) > 1e-9).map((i) => firsts[i]);
}

/** A new node on piece `piece` of nodePath() at t: of an arc both parts are what stands for arcs. */
export function splitNodes(path: CubicPath, piece: number, t: number): Edited {
  const natural = naturalOf(path);
  const nodes = natural?.path ?? path;
  const change = splitAt(nodes, piece, t);
  const [from, to] = natural ? [natural.firsts[piece], natural.firsts[piece + 1]] : [0, 1];
  const arc = to - from > 1 ? arcOf(pieceAt(path, from)) : null;
  if (!arc) return change;
  const whole = (to - from) * arc.turn;
  const [first, second] = [arcStretch(arc, 0, t * whole), arcStretch(arc, t * whole, whole)];
  const points = [...change.path.points];
  points.splice(3 * piece + 1, 5, first[1], first[2], first[3], second[1], second[2]);
  return { ...change, path: { ...change.path, points } };
}

function isEdited(change: unknown): change is Edited {
  return typeof change === "object" && change !== null && "follow" in change;
}
