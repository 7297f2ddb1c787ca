// Place, size and rotation of an item on the artboard.
import { turning, type Affine, type Box } from "../../geometry/affine.js";
import { transform } from "../../model/commands/index.js";
import { boxOf } from "../../model/item-boxes.js";
import type { Handle, Item } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { NumberField } from "../controls/field.js";
import { edits } from "../controls/sink.js";
import { useShell } from "../services.js";

const words = en.panels;

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

/** The angle of what has a transform of its own, an instance or a photo: about its middle. */
export function AngleField({ item }: { readonly item: Item }) {
  const { editor } = useShell();
  const box = boxOf([item]);
  if (!box) return null;
  const [a, b] = item.artboardFromItem;
  const angle = (Math.atan2(b, a) * 180) / Math.PI;
  const [x0, y0, x1, y1] = box;
  const turned = (to: number) =>
    turning([(x0 + x1) / 2, (y0 + y1) / 2], ((to - angle) * Math.PI) / 180);
  return (
    <div class="two">
      <NumberField
        label="∠"
        name={words.angle}
        value={angle}
        digits={1}
        unit="°"
        sink={edits(editor, words.turn, (to: number, before) =>
          transform(before, [item.handle], turned(to), editor.step(item)),
        )}
      />
    </div>
  );
}
