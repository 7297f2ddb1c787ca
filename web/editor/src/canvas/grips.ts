// The handles of the selection's box by the keyboard: arrows scale by one, and turn by another.
import { signal, type ReadonlySignal, type Signal } from "@preact/signals";
import { turning, type Affine, type Box, type Point } from "../geometry/affine.js";
import type { Editor } from "../app/types.js";
import { transform } from "../model/commands/index.js";
import type { Handle } from "../model/types.js";
import * as en from "../strings/en.js";
import { movable, scaling, selectionBox } from "./box.js";
import { shown } from "./format.js";
import type { BoxMark, Mark } from "./marks.js";
import { keyOf } from "./walk.js";

/** Steps of an arrow key, and with Shift: degrees for the handle that rotates, CSS pixels for the others. */
const TURN = { plain: 1, shift: 15 } as const;
const SCALE = { plain: 1, shift: 10 } as const;

/** The parts of the canvas that the handles use. */
export interface GripCanvas {
  readonly editor: Editor;
  readonly marks: ReadonlySignal<readonly Mark[]>;
}

export interface GripKeys {
  readonly shift: boolean;
  /** From the middle, as for a drag. */
  readonly alt: boolean;
  /** In proportion, as Shift is for a drag. */
  readonly ctrl: boolean;
}

/** A run of turns: the box of what is turned changes, what it is turned about does not. */
interface Turning {
  readonly key: string;
  readonly revision: number;
  readonly middle: Point;
  /** All of it, degrees. */
  readonly angle: number;
}

export class Grips {
  /** The handle that is chosen, of the box around what ends with this item. */
  private readonly chosen: Signal<{ readonly key: string; readonly of: Handle } | null> =
    signal(null);
  private turned: Turning | null = null;

  constructor(private readonly canvas: GripCanvas) {}

  /** Reading it in a computation subscribes. @param of what is selected last */
  isChosen(of: Handle, key: string): boolean {
    return this.chosen.value?.of === of && this.chosen.value.key === key;
  }

  private marks(): BoxMark[] {
    const isBox = (mark: Mark): mark is BoxMark => mark.kind === "scale" || mark.kind === "turn";
    return this.canvas.marks.peek().filter(isBox);
  }

  private current(): BoxMark | null {
    return this.marks().find(({ isChosen }) => isChosen) ?? null;
  }

  choose(mark: BoxMark): void {
    this.chosen.value = { key: keyOf(mark), of: mark.handle };
  }

  /** What a screen reader has put its focus on. */
  focused(key: string): void {
    const mark = this.marks().find((one) => keyOf(one) === key);
    if (mark && !mark.isChosen) this.choose(mark);
  }

  /** @returns whether one was chosen */
  letGo(): boolean {
    const was = this.current() !== null;
    this.chosen.value = null;
    return was;
  }

  /** From what is selected to the first handle of its box. @returns false: there is none */
  enter(): boolean {
    const [first] = this.marks();
    if (first) this.choose(first);
    return first !== undefined;
  }

  /** @returns whether a handle is chosen and has another beside it */
  walk(step: 1 | -1): boolean {
    const marks = this.marks();
    const at = marks.findIndex(({ isChosen }) => isChosen);
    const next = marks[at + step];
    if (at < 0 || !next) return false;
    this.choose(next);
    return true;
  }

  get isIn(): boolean {
    return this.current() !== null;
  }

  /** @returns whether a handle is chosen, and something that may be changed is selected */
  arrow([dx, dy]: Point, keys: GripKeys): boolean {
    const mark = this.current();
    const { editor } = this.canvas;
    const box = mark && selectionBox(editor);
    const handles = movable(editor).map(({ handle }) => handle);
    if (!mark || !box || handles.length === 0) return false;
    const key = `${keyOf(mark)} of ${handles.join()}`;
    if (mark.kind === "turn") this.turn(box, handles, key, (dx + dy) * TURN[size(keys)]);
    else {
      const by = SCALE[size(keys)] / editor.view.peek().zoom;
      const map = scaling(box, mark.grip, [dx * by, dy * by], keys.ctrl, keys.alt);
      if (this.apply(en.tools.undo.scale, handles, map, key)) this.tellSize();
    }
    return true;
  }

  private turn(box: Box, handles: readonly Handle[], key: string, degrees: number): void {
    const { editor } = this.canvas;
    const last = this.turned;
    const goesOn = last?.key === key && last.revision === editor.drawing.revision;
    const middle: Point = goesOn ? last.middle : [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2];
    const angle = (goesOn ? last.angle : 0) + degrees;
    const map = turning(middle, (degrees * Math.PI) / 180);
    if (!this.apply(en.tools.undo.turn, handles, map, key)) return;
    this.turned = { key, revision: editor.drawing.revision, middle, angle };
    editor.announcement.value = en.canvas.angle(shown(angle));
  }

  /** Steps that follow each other quickly are one step of undo. */
  private apply(label: string, handles: readonly Handle[], map: Affine, key: string): boolean {
    const { editor } = this.canvas;
    return editor.run(label, transform(editor.drawing, handles, map, editor.step(null)), key);
  }

  private tellSize(): void {
    const { editor } = this.canvas;
    const box = selectionBox(editor);
    if (box)
      editor.announcement.value = en.canvas.size(shown(box[2] - box[0]), shown(box[3] - box[1]));
  }
}

const size = ({ shift }: GripKeys) => (shift ? "shift" : "plain");
