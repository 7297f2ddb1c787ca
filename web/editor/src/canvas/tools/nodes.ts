// Nodes: nodes, handles, the curve itself, and the stops along it.
import { mapped, type Point } from "../../geometry/affine.js";
import { nodeCount } from "../../geometry/cubic.js";
import { locate } from "../../geometry/length.js";
import { nodePath, placeOnNodePath } from "../../geometry/natural.js";
import { nodeOfHandle } from "../../geometry/nodes.js";
import { atAngle } from "../../geometry/snap.js";
import { setPath, splitPiece } from "../../model/commands/index.js";
import type { CurveItem, Selected } from "../../model/types.js";
import * as en from "../../strings/en.js";
import type { Canvas } from "../canvas.js";
import { blurCursor, type CursorName } from "../cursors.js";
import { itemVector, plus, setKinds } from "../edits.js";
import { shown } from "../format.js";
import type { CurveHit } from "../hit.js";
import { selectedOf, stageFromItem, type Mark, type NodeMark } from "../marks.js";
import { bent, pulledHandle, withHandle } from "../nodes.js";
import { editedAt, isCurve, isOutOfReach } from "../places.js";
import { isSamePart } from "../part.js";
import { letGoOfParts } from "../walk.js";
import { dragNodes } from "./node-drag.js";
import { dragPaint } from "./paint-drag.js";
import { addStop, dragStop, inStrip } from "./stops.js";
import {
  EditDrag,
  MarqueeDrag,
  toggled,
  travelled,
  type Drag,
  type KeyPress,
  type Press,
  type Tool,
} from "./tool.js";

const KINDS = { c: "corner", s: "smooth", y: "symmetric" } as const;

export class NodesTool implements Tool {
  constructor(private readonly canvas: Canvas) {}

  hover(p: Press): CursorName {
    const { canvas } = this;
    const { mark, curve } = canvas.hover(p.at, p.kind);
    if (mark?.kind === "bracket") return blurCursor(Math.atan2(mark.normal[1], mark.normal[0]));
    if (mark?.kind === "stop") return "stop";
    if (mark) return "move";
    if (curve) return "bend";
    return inStrip(canvas, p) ? "copy" : "default";
  }

  press(p: Press): Drag | null {
    const { canvas } = this;
    const mark = canvas.markAt(p.at, p.kind);
    if (mark) return this.pressMark(mark, p);
    const hit = canvas.curveAt(p.at, p.kind);
    if (hit) return this.pressCurve(hit, p);
    return new MarqueeDrag(
      canvas,
      p,
      (low, high, end) => this.take(low, high, end.shift),
      (end) => this.click(end),
    );
  }

  key({ key, ctrl, alt }: KeyPress): boolean {
    const kind = KINDS[key.toLowerCase() as keyof typeof KINDS];
    return kind !== undefined && !ctrl && !alt && setKinds(this.canvas.editor, kind);
  }

  private pressMark(mark: Mark, p: Press): Drag | null {
    const { canvas } = this;
    const { editor } = canvas;
    const one = selectedOf(mark);
    if (mark.kind === "stop" || mark.kind === "bracket") {
      editor.selection.value = [one];
      return dragStop(canvas, mark, p);
    }
    if (mark.kind === "handle") {
      editor.selection.value = [one];
      return this.dragHandle(mark, p);
    }
    if (mark.kind === "paint") {
      editor.selection.value = [one];
      return dragPaint(canvas, mark, p);
    }
    if (mark.kind !== "node") return null;
    const nodes = editor.selection.peek().filter(({ part }) => part.kind === "node");
    if (!mark.isChosen) editor.selection.value = p.shift ? [...nodes, one] : [one];
    if (p.alt) return this.pullHandle(mark, p);
    // With Shift a chosen node is let go of by a click; a drag moves it straight.
    return dragNodes(canvas, mark, p, {
      click: () => {
        if (!p.shift) editor.selection.value = [one];
        else if (mark.isChosen)
          editor.selection.value = withoutWholes(toggled(nodes, one, isSame), one);
      },
      kept: () => this.tell(mark),
    });
  }

  /** A handle turns the other with it where the node is smooth; Alt breaks them. */
  private dragHandle(mark: NodeMark, start: Press): Drag {
    const { canvas } = this;
    const { editor } = canvas;
    return new EditDrag(canvas, start, {
      label: en.tools.undo.moveHandle,
      dragged: { handle: mark.handle, part: mark.part },
      cursor: "move",
      make: (p, before) => {
        const item = before.item(mark.handle);
        if (!isCurve(item) || mark.part.kind !== "handle" || !item.paths[mark.part.path])
          return null;
        const path = nodePath(item.paths[mark.part.path]);
        const raw = plus(mark.at, [p.at[0] - start.at[0], p.at[1] - start.at[1]]);
        const to = p.shift ? atAngle(mark.foot, raw) : raw;
        const by = itemVector(item, canvas.stageFromArtboard(), [
          to[0] - mark.at[0],
          to[1] - mark.at[1],
        ]);
        if (!by) return null;
        const { index, path: k } = mark.part;
        const changed = withHandle(path, index, plus(path.points[index], by), p.alt);
        return setPath(before, item.handle, k, changed, editor.step(item));
      },
      kept: () => this.tell(mark),
    });
  }

  /** With Alt a node gives a handle of its own: the one towards where it is pulled. */
  private pullHandle(mark: NodeMark, start: Press): Drag | null {
    const { canvas } = this;
    const { editor } = canvas;
    const { part } = mark;
    if (part.kind !== "node") return null;
    return new EditDrag(canvas, start, {
      label: en.tools.undo.moveHandle,
      dragged: { handle: mark.handle, part },
      cursor: "move",
      make: (p, before) => {
        const item = before.item(mark.handle);
        if (!isCurve(item)) return null;
        const path = nodePath(item.paths[part.path]);
        const by = itemVector(item, canvas.stageFromArtboard(), [
          p.at[0] - start.at[0],
          p.at[1] - start.at[1],
        ]);
        const handle = by && pulledHandle(path, part.index, by);
        if (handle === null || !by) return null;
        const to = plus(path.points[3 * part.index], by);
        return setPath(
          before,
          item.handle,
          part.path,
          withHandle(path, handle, to, true),
          editor.step(item),
        );
      },
      kept: () => this.tell(mark),
    });
  }

  /** The curve is bent so that it goes through the pointer; a double click adds a node. */
  private pressCurve(hit: CurveHit, p: Press): Drag | null {
    const { canvas } = this;
    const { editor } = canvas;
    const { item } = hit.place;
    const owner = editedAt(hit.place);
    const isIn = editor.selection.peek().some(({ handle }) => handle === owner.handle);
    if (!isIn || p.shift) {
      const one: Selected = { handle: owner.handle, part: { kind: "whole" } };
      editor.selection.value = p.shift
        ? toggled(editor.selection.peek(), one, (a, b) => a.handle === b.handle)
        : [one];
    }
    // A curve that a <use> shows is edited where it stands.
    if (owner !== item || p.shift) return null;
    if (p.clicks >= 2) {
      this.split(hit);
      return null;
    }
    const whole: Selected = { handle: owner.handle, part: { kind: "whole" } };
    return new EditDrag(canvas, p, {
      label: en.tools.undo.bend,
      dragged: { handle: item.handle, part: { kind: "whole" } },
      cursor: "bend",
      make: (moment, before) => {
        const now = before.item(item.handle);
        const path = isCurve(now) ? now.paths[hit.path] : undefined;
        const by = isCurve(now) && itemVector(now, canvas.stageFromArtboard(), travelled(p, moment));
        if (!isCurve(now) || !path || !by) return null;
        const to = bent(nodePath(path), placeOnNodePath(path, hit.at), by);
        return setPath(before, now.handle, hit.path, to, editor.step(now));
      },
      click: () => {
        editor.selection.value = [whole];
      },
    });
  }

  private split(hit: CurveHit): void {
    const { editor } = this.canvas;
    const item = editor.drawing.item(hit.place.item.handle);
    if (!isCurve(item) || isOutOfReach(editor, item)) return;
    const path = item.paths[hit.path];
    const { piece, t } = locate(nodePath(path), placeOnNodePath(path, hit.at));
    const made = splitPiece(editor.drawing, item.handle, hit.path, piece, t, editor.step(item));
    if (!editor.run(en.tools.undo.addNode, made)) return;
    editor.selection.value = [
      { handle: item.handle, part: { kind: "node", path: hit.path, index: piece + 1 } },
    ];
  }

  /** Beside the curve a click makes a stop; elsewhere it lets go: of parts, then of the curve. */
  private click(p: Press): void {
    const on = inStrip(this.canvas, p);
    if (on) {
      void addStop(this.canvas, on, this.canvas.attribute());
      return;
    }
    this.letGo();
  }

  private letGo(): void {
    const { editor } = this.canvas;
    if (!letGoOfParts(editor)) editor.selection.value = [];
  }

  /** The nodes of the chosen curves that are in a rectangle of the stage. */
  private take(low: Point, high: Point, adds: boolean): void {
    const { canvas } = this;
    const { editor } = canvas;
    const found = canvas.chosenCurves().flatMap((item) => this.nodesIn(item, low, high));
    const before = adds ? editor.selection.peek().filter(({ part }) => part.kind === "node") : [];
    const fresh = found.filter((one) => !before.some((other) => isSame(one, other)));
    if (before.length + fresh.length > 0) editor.selection.value = [...before, ...fresh];
    else this.letGo();
  }

  private nodesIn(item: CurveItem, [x0, y0]: Point, [x1, y1]: Point): Selected[] {
    const map = stageFromItem(this.canvas.stageFromArtboard(), item);
    return item.paths.map(nodePath).flatMap((path, k) =>
      Array.from({ length: nodeCount(path) }, (_, index) => index)
        .filter((index) => {
          const [x, y] = mapped(map, path.points[3 * index]);
          return x >= x0 && x <= x1 && y >= y0 && y <= y1;
        })
        .map((index) => ({ handle: item.handle, part: { kind: "node", path: k, index } as const })),
    );
  }

  /** Says where a node or handle has come to. */
  private tell(mark: NodeMark): void {
    const { editor } = this.canvas;
    const item = editor.drawing.item(mark.handle);
    const { part } = mark;
    if (!isCurve(item) || (part.kind !== "node" && part.kind !== "handle")) return;
    const shownPath = item.paths[part.path];
    const path = shownPath && nodePath(shownPath);
    const point = path?.points[part.kind === "node" ? 3 * part.index : part.index];
    if (!point) return;
    const [x, y] = mapped(item.artboardFromItem, point);
    const node = part.kind === "node" ? part.index : nodeOfHandle(path, part.index);
    editor.announcement.value = en.canvas.at(
      en.canvas.node(node + 1, item.name),
      shown(x),
      shown(y),
    );
  }
}

function isSame(a: Selected, b: Selected): boolean {
  return a.handle === b.handle && isSamePart(a.part, b.part);
}

/** A curve whose last node is let go stays chosen. */
function withoutWholes(nodes: readonly Selected[], last: Selected): readonly Selected[] {
  return nodes.length > 0 ? nodes : [{ handle: last.handle, part: { kind: "whole" } }];
}
