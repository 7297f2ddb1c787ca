// Commands that align, distribute and flip what is selected.
import type { Affine, Box } from "../geometry/affine.js";
import { together, transform } from "../model/commands/index.js";
import { boxOf } from "../model/item-boxes.js";
import type { Item, Outcome } from "../model/types.js";
import * as en from "../strings/en.js";
import type { DrawingEditor } from "./editor.js";
import { chosen, chosenItems } from "./selected.js";

type Axis = 0 | 1;
type Command = (editor: DrawingEditor) => void;

const words = en.commands;

const shift = (axis: Axis, by: number): Affine =>
  axis === 0 ? [1, 0, 0, 1, by, 0] : [1, 0, 0, 1, 0, by];

/** Items that have an extent, with their boxes on the artboard. */
function boxedItems(editor: DrawingEditor): { readonly item: Item; readonly box: Box }[] {
  return chosenItems(editor).flatMap((item) => {
    const box = boxOf([item]);
    return box ? [{ item, box }] : [];
  });
}

function moved(editor: DrawingEditor, item: Item, axis: Axis, by: number): Outcome | null {
  return by === 0 ? null : transform(editor.drawing, [item.handle], shift(axis, by), editor.step(item));
}

/**
 * Moves each item so that an edge or the middle of its box lies where that of all lies: of the artboard for
 * a single item, or if the settings say so.
 * @param share 0: the first edge, 0.5: the middle, 1: the last edge
 */
function align(axis: Axis, share: number): Command {
  return (editor) => {
    const items = boxedItems(editor);
    const toArtboard = items.length === 1 || editor.settings.alignToArtboard.value;
    const all = toArtboard ? editor.drawing.artboard : boxOf(items.map(({ item }) => item));
    if (!all || items.length === 0) return;
    const placeOf = (box: Box) => box[axis] + share * (box[axis + 2] - box[axis]);
    const made = items.map(({ item, box }) =>
      moved(editor, item, axis, placeOf(all) - placeOf(box)),
    );
    editor.run(words.align, together(made));
  };
}

/** Makes the gaps between three or more items equal; the outermost ones stay. */
function distribute(axis: Axis): Command {
  return (editor) => {
    const items = boxedItems(editor).sort((a, b) => a.box[axis] - b.box[axis]);
    if (items.length < 3) return editor.say(words.distributeWantsThree);
    const size = (box: Box) => box[axis + 2] - box[axis];
    const begin = items[0].box[axis];
    const end = Math.max(...items.map(({ box }) => box[axis + 2]));
    const filled = items.reduce((sum, { box }) => sum + size(box), 0);
    const gap = (end - begin - filled) / (items.length - 1);
    let at = begin;
    const made = items.map(({ item, box }) => {
      const by = at - box[axis];
      at += size(box) + gap;
      return moved(editor, item, axis, by);
    });
    editor.run(words.distribute, together(made));
  };
}

function flip(axis: Axis): Command {
  return (editor) => {
    const box = boxOf(chosenItems(editor));
    if (!box) return;
    const twice = box[axis] + box[axis + 2];
    const map: Affine = axis === 0 ? [-1, 0, 0, 1, twice, 0] : [1, 0, 0, -1, 0, twice];
    editor.run(words.flip, transform(editor.drawing, chosen(editor), map, editor.step(null)));
  };
}

export const arranging: readonly (readonly [string, Command])[] = [
  ["align-left", align(0, 0)],
  ["align-center", align(0, 0.5)],
  ["align-right", align(0, 1)],
  ["align-top", align(1, 0)],
  ["align-middle", align(1, 0.5)],
  ["align-bottom", align(1, 1)],
  ["align-to-artboard", ({ settings: { alignToArtboard } }) => void (alignToArtboard.value = !alignToArtboard.value)],
  ["distribute-horizontally", distribute(0)],
  ["distribute-vertically", distribute(1)],
  ["flip-horizontal", flip(0)],
  ["flip-vertical", flip(1)],
];
