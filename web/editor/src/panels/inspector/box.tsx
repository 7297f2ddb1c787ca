// Where a thing lies on the artboard and how large it is.
import { boundsOf, mappedPath, unionOf } from "../../geometry/cubic.js";
import type { Affine, Box } from "../../geometry/affine.js";
import { transform } from "../../model/commands/index.js";
import type { CurveItem, Handle, Item } from "../../model/types.js";
import { en } from "../../strings/en.js";
import { NumberField } from "../controls/field.js";
import { edits } from "../controls/sink.js";
import { curvesWithin } from "../layers/rows.js";
import { useShell } from "../services.js";

const words = en.panels;

/** A curve that changes, or is placed elsewhere, is another object. */
const boxes = new WeakMap<CurveItem, Box | null>();

function boxOfCurve(curve: CurveItem): Box | null {
  const known = boxes.get(curve);
  if (known !== undefined) return known;
  const { artboardFromItem, paths } = curve;
  const box = unionOf(paths.map((path) => boundsOf(mappedPath(artboardFromItem, path))));
  boxes.set(curve, box);
  return box;
}

/** The box around the curves of items, artboard units; null: there are none. */
export function boxOf(items: readonly Item[]): Box | null {
  const curves = items.flatMap((item) => curvesWithin(item)) as CurveItem[];
  return unionOf(curves.map(boxOfCurve).filter((box) => box !== null));
}

/** Scales about the box's corner; a box without extent keeps it. */
const scaled = ([x, y, right, bottom]: Box, width: number, height: number): Affine => {
  const a = right > x ? width / (right - x) : 1;
  const d = bottom > y ? height / (bottom - y) : 1;
  return [a, 0, 0, d, x - a * x, y - d * y];
};

interface BoxFieldsProps {
  readonly items: readonly Item[];
}

export function BoxFields({ items }: BoxFieldsProps) {
  const { editor } = useShell();
  const box = boxOf(items);
  if (!box) return null;
  const handles: readonly Handle[] = items.map(({ handle }) => handle);
  const step = editor.step(items[items.length - 1]);
  const [x, y, right, bottom] = box;
  const sink = (label: string, map: (value: number) => Affine) =>
    edits(editor, label, (value: number, before) => transform(before, handles, map(value), step));
  const move = (dx: number, dy: number): Affine => [1, 0, 0, 1, dx, dy];
  return (
    <div class="two">
      <NumberField
        label="X"
        name={words.left}
        value={x}
        digits={2}
        sink={sink(words.move, (to) => move(to - x, 0))}
      />
      <NumberField
        label="Y"
        name={words.top}
        value={y}
        digits={2}
        sink={sink(words.move, (to) => move(0, to - y))}
      />
      <NumberField
        label="W"
        name={words.width}
        value={right - x}
        digits={2}
        min={0.01}
        disabled={right === x}
        sink={sink(words.resize, (to) => scaled(box, to, bottom - y))}
      />
      <NumberField
        label="H"
        name={words.height}
        value={bottom - y}
        digits={2}
        min={0.01}
        disabled={bottom === y}
        sink={sink(words.resize, (to) => scaled(box, right - x, to))}
      />
    </div>
  );
}
