// Pen: click for a corner, drag for a curve; the first node closes, Enter ends. A click on an open end
// continues that curve.
import { inverted, mapped, type Point } from "../../geometry/affine.js";
import { mappedPath, nodeCount, type CubicPath } from "../../geometry/cubic.js";
import { locate } from "../../geometry/length.js";
import { nodePath } from "../../geometry/natural.js";
import { atAngle, nearestTarget } from "../../geometry/snap.js";
import { deleteNodes, extendCurve, splitPiece } from "../../model/commands/index.js";
import * as en from "../../strings/en.js";
import { nearestAt } from "../along.js";
import type { Canvas } from "../canvas.js";
import type { CursorName } from "../cursors.js";
import { REACH, type EndHit } from "../hit.js";
import { stageFromItem } from "../marks.js";
import { editedAt } from "../places.js";
import { NO_SKETCH, type Guide } from "../sketch.js";
import { SNAP_REACH } from "../snap.js";
import { Caret } from "./caret.js";
import { Finished } from "./finished.js";
import { isBeyond, type Drag, type KeyPress, type Press, type Tool } from "./tool.js";

/** A node as it is set, artboard units; handles that lie on it are none. */
interface PenNode {
  readonly at: Point;
  readonly into: Point;
  readonly out: Point;
}

export function pathOf(nodes: readonly PenNode[], closed: boolean): CubicPath {
  const all = closed ? [...nodes, nodes[0]] : nodes;
  const points: Point[] = [all[0].at];
  for (let k = 1; k < all.length; k += 1) {
    const [from, to] = [all[k - 1], all[k]];
    // Without handles it is a line, whose handles stand at its thirds.
    const isLine = isSame(from.out, from.at) && isSame(to.into, to.at);
    points.push(
      isLine ? third(from.at, to.at) : from.out,
      isLine ? third(to.at, from.at) : to.into,
      to.at,
    );
  }
  return { points, closed };
}

function isSame(a: Point, b: Point): boolean {
  return a[0] === b[0] && a[1] === b[1];
}

function third(from: Point, to: Point): Point {
  return [from[0] + (to[0] - from[0]) / 3, from[1] + (to[1] - from[1]) / 3];
}

export class PenTool implements Tool {
  private nodes: readonly PenNode[] = [];
  /** Nodes that were taken back, the next to come again last. */
  private undone: readonly PenNode[] = [];
  /** The end of a curve that the nodes continue, or null. */
  private continued: EndHit | null = null;
  /** The drag of the node that is being set. */
  private drag: PenDrag | null = null;
  private readonly finished: Finished;
  private readonly caret: Caret;

  constructor(private readonly canvas: Canvas) {
    this.caret = new Caret(canvas, en.panels.tool.pen);
    this.finished = new Finished(canvas, en.tools.undo.pen);
  }

  /** Undo and redo go from node to node while there is any. */
  private keep(nodes: readonly PenNode[], undone: readonly PenNode[], drag: PenDrag | null): void {
    this.nodes = nodes;
    this.undone = undone;
    this.drag = drag;
    const label = (isThere: boolean) => (isThere ? en.tools.undo.penNode : null);
    const undoLabel = label(nodes.length > 0 || drag !== null);
    const redoLabel = label(undone.length > 0);
    this.canvas.editor.draft.value =
      undoLabel === null && redoLabel === null
        ? null
        : {
            undoLabel,
            redoLabel,
            undo: () => this.undo(),
            redo: () => this.redo(),
            finish: () => this.finish(false),
            drop: () => this.drop(),
          };
  }

  private undo(): void {
    const last = this.nodes[this.nodes.length - 1];
    if (this.drag) return this.drag.cancel();
    if (last) this.keep(this.nodes.slice(0, -1), [...this.undone, last], null);
    this.show(null, false, []);
  }

  private redo(): void {
    const next = this.undone[this.undone.length - 1];
    if (next) this.keep([...this.nodes, next], this.undone.slice(0, -1), this.drag);
    this.show(null, false, []);
  }

  private drop(): void {
    this.drag?.cancel();
    this.keep([], [], null);
    this.canvas.sketch.value = NO_SKETCH;
  }

  hover(p: Press): CursorName {
    const { canvas } = this;
    this.caret.hide();
    canvas.editor.hovered.value = null;
    if (this.nodes.length === 0) {
      if (p.alt) return this.onSelected(p)?.kind ?? "pen";
      canvas.draw({ guides: this.place(p).guides });
      return this.endAt(p) ? "pen-continue" : "pen";
    }
    const closes = this.closes(p);
    const { at, guides } = this.place(p);
    const next: PenNode = closes ? this.closing()! : { at, into: at, out: at };
    this.show(pathOf([this.nodes[this.nodes.length - 1], next], false), closes, guides);
    return closes ? "pen-close" : "pen";
  }

  press(p: Press): Drag | null {
    if (this.nodes.length === 0 && p.alt) {
      this.onSelected(p)?.run();
      return null;
    }
    if (p.clicks >= 2 && this.nodes.length > 1) {
      this.finish(false);
      return null;
    }
    const closes = this.closes(p);
    const at = closes ? this.closing()!.at : this.begins(p);
    const drag = new PenDrag(this.canvas, p, at, {
      show: (node) => this.showSet(node, closes),
      set: (node) => {
        if (closes) this.close(node);
        else this.keep([...this.nodes, node], [], null);
      },
      drop: () => {
        this.keep(this.nodes, this.undone, null);
        this.show(null, false, []);
      },
    });
    this.keep(this.nodes, this.undone, drag);
    return drag;
  }

  /** Arrows move a point where nothing is selected, Enter sets a node there; on a node it ends. */
  key({ key, shift, ctrl, alt }: KeyPress): boolean {
    const isFree = this.nodes.length > 0 || this.canvas.editor.selection.peek().length === 0;
    if (isFree && !ctrl && !alt && this.caret.move(key, shift)) return this.follow(this.caret.at!);
    const { at } = this.caret;
    const last = this.nodes[this.nodes.length - 1];
    if (key === "Enter" && at && !(last && isSame(last.at, at))) return this.setAt(at);
    if (this.nodes.length === 0) return false;
    if (key === "Enter" || key === "Escape") this.finish(false);
    else if (key === "Backspace" || key === "Delete") this.undo();
    else return false;
    return true;
  }

  private follow(at: Point): true {
    const last = this.nodes[this.nodes.length - 1];
    if (last) this.show(pathOf([last, { at, into: at, out: at }], false), false, []);
    return true;
  }

  private setAt(at: Point): true {
    if (this.nodes.length === 0) this.continued = null;
    this.keep([...this.nodes, { at, into: at, out: at }], [], null);
    this.show(null, false, []);
    return true;
  }

  leave(): void {
    this.caret.hide();
    if (this.nodes.length > 0) this.finish(false);
    else this.keep([], [], null);
  }

  /** Settles when what was drawn is in the document. */
  get isDone(): Promise<void> {
    return this.finished.isDone;
  }

  private closes(p: Press): boolean {
    const node = this.closing();
    return node !== null && !isBeyond(this.canvas.toStage(node.at), p.at, REACH[p.kind].mark);
  }

  /** Returns the node that closes the curve: its first one, or the other end of the continued curve. */
  private closing(): PenNode | null {
    if (this.nodes.length === 0) return null;
    if (!this.continued) return this.nodes.length > 1 ? this.nodes[0] : null;
    const { place, path, end } = this.continued;
    const { points } = place.item.paths[path];
    const at = mapped(place.artboardFromItem, points[end === "start" ? points.length - 1 : 0]);
    return { at, into: at, out: at };
  }

  /** Returns where a press sets a node, artboard units. The first one may be an end of a curve. */
  private begins(p: Press): Point {
    if (this.nodes.length > 0) return this.place(p).at;
    this.continued = this.endAt(p);
    return this.continued ? this.canvas.toArtboard(this.continued.point) : this.place(p).at;
  }

  /**
   * Returns the open end under the pointer that a click continues: of a selected curve, else the nearest one. null:
   * there is none, or ends of several curves meet there.
   */
  private endAt(p: Press): EndHit | null {
    const { canvas } = this;
    if (p.alt || p.ctrl) return null;
    const selected = new Set(canvas.editor.selection.peek().map(({ handle }) => handle));
    const ends = canvas
      .curves()
      .endsNear(p.at, SNAP_REACH, (place) => editedAt(place) === place.item);
    const chosen = nearestTarget(p.at, ends.filter(({ place }) => selected.has(place.item.handle)), SNAP_REACH);
    if (chosen) return chosen;
    const near = nearestTarget(p.at, ends, SNAP_REACH);
    const meets = (end: EndHit) => end !== near && near !== null && !isBeyond(end.point, near.point, 1);
    return ends.some(meets) ? null : near;
  }

  /** Where a node would be set, artboard units. */
  private place(p: Press): { at: Point; guides: readonly Guide[] } {
    const { canvas } = this;
    const last = this.nodes[this.nodes.length - 1];
    const held = p.shift && last ? atAngle(canvas.toStage(last.at), p.at) : p.at;
    const to =
      p.shift || p.ctrl ? { at: held, guides: [] } : canvas.snap(held, canvas.curves(), new Set());
    return { at: canvas.toArtboard(to.at), guides: to.guides };
  }

  private show(rubber: CubicPath | null, closes: boolean, guides: readonly Guide[]): void {
    const draft =
      this.nodes.length > 0
        ? { path: pathOf(this.nodes, false), rubber, closes, hasNodes: true }
        : null;
    this.canvas.draw({ draft, guides });
  }

  private showSet(node: PenNode, closes: boolean): void {
    const isRing = closes && !this.continued;
    const nodes = isRing ? this.ringed(node) : [...this.nodes, node];
    const rubber = pathOf([node, { at: node.out, into: node.out, out: node.out }], false);
    this.canvas.draw({
      draft: {
        path: pathOf(nodes, isRing),
        rubber: isSame(node.at, node.out) ? null : rubber,
        closes,
        hasNodes: true,
      },
    });
  }

  private close(node: PenNode): void {
    if (this.continued) this.finish(false, [...this.nodes, node]);
    else this.finish(true, this.ringed(node));
  }

  /** Returns the nodes of a closed curve; the last handle is the one that closes it. */
  private ringed({ into }: PenNode): readonly PenNode[] {
    return [{ ...this.nodes[0], into }, ...this.nodes.slice(1)];
  }

  /** Turns the nodes into a curve; a single node makes none. */
  private finish(closed: boolean, nodes = this.nodes): void {
    this.caret.hide();
    this.keep([], [], null);
    const path = nodes.length < 2 ? null : pathOf(nodes, closed);
    if (!path || this.extend(path)) this.canvas.sketch.value = NO_SKETCH;
    else this.finished.add(path);
  }

  /** Adds a path to the continued curve. Returns false if there is none, or if it is gone. */
  private extend(path: CubicPath): boolean {
    const end = this.continued;
    this.continued = null;
    const back = end && inverted(end.place.artboardFromItem);
    if (!back) return false;
    const { editor } = this.canvas;
    const { item } = end.place;
    const added = mappedPath(back, path);
    return editor.run(
      en.tools.undo.penContinued,
      extendCurve(editor.drawing, item.handle, end.path, end.end, added, editor.step(item)),
    );
  }

  /** With Alt: what a click does to the selected curve. */
  private onSelected(p: Press): { kind: "pen-add" | "pen-remove"; run: () => void } | null {
    const { canvas } = this;
    const { editor } = canvas;
    const item = canvas.primaryCurve();
    if (!item) return null;
    const map = stageFromItem(canvas.stageFromArtboard(), item);
    const reach = REACH[p.kind];
    for (const [k, path] of item.paths.map(nodePath).entries()) {
      for (let node = 0; node < nodeCount(path); node += 1) {
        const [x, y] = mapped(map, path.points[3 * node]);
        if (Math.hypot(x - p.at[0], y - p.at[1]) > reach.curve) continue;
        const run = () =>
          void editor.run(
            en.tools.undo.deleteNodes,
            deleteNodes(editor.drawing, item.handle, new Map([[k, [node]]]), editor.step(item)),
          );
        return { kind: "pen-remove", run };
      }
      const near = nearestAt(path, map, p.at);
      if (near.distance > reach.curve) continue;
      const { piece, t } = locate(path, near.at);
      const run = () =>
        void editor.run(
          en.tools.undo.addNode,
          splitPiece(editor.drawing, item.handle, k, piece, t, editor.step(item)),
        );
      return { kind: "pen-add", run };
    }
    return null;
  }
}

interface PenMoves {
  show(node: PenNode): void;
  set(node: PenNode): void;
  drop(): void;
}

/** Sets a node: a drag pulls its handles out, Alt only the one ahead, Space moves the node. */
class PenDrag implements Drag {
  readonly cursor = "pen";
  private node: PenNode;
  private last: Press;
  private isSpace = false;
  private isOver = false;

  constructor(
    private readonly canvas: Canvas,
    private readonly start: Press,
    at: Point,
    private readonly moves: PenMoves,
  ) {
    this.node = { at, into: at, out: at };
    this.last = start;
    moves.show(this.node);
  }

  space(isDown: boolean): void {
    this.isSpace = isDown;
  }

  move(p: Press): void {
    const { canvas } = this;
    if (this.isOver) return;
    if (this.isSpace) {
      const { zoom } = canvas.editor.view.peek();
      const [dx, dy] = [(p.at[0] - this.last.at[0]) / zoom, (p.at[1] - this.last.at[1]) / zoom];
      const shifted = ([x, y]: Point): Point => [x + dx, y + dy];
      this.node = {
        at: shifted(this.node.at),
        into: shifted(this.node.into),
        out: shifted(this.node.out),
      };
    } else if (isBeyond(this.start.at, p.at) || !isSame(this.node.out, this.node.at)) {
      const at = canvas.toStage(this.node.at);
      const out = canvas.toArtboard(p.shift ? atAngle(at, p.at) : p.at);
      const [x, y] = this.node.at;
      const into: Point = p.alt ? this.node.into : [2 * x - out[0], 2 * y - out[1]];
      this.node = { at: this.node.at, into, out };
    }
    this.last = p;
    this.moves.show(this.node);
  }

  keys(p: Press): void {
    this.move({ ...p, at: this.last.at });
  }

  end(): void {
    if (this.isOver) return;
    this.isOver = true;
    this.moves.set(this.node);
    this.canvas.draw({ guides: [] });
  }

  /** Undoes the press; undo does so too while the button is still down. */
  cancel(): void {
    if (this.isOver) return;
    this.isOver = true;
    this.moves.drop();
  }
}
