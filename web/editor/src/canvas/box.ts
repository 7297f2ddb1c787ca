// The box around what is selected, its handles, and the maps that dragging them makes.
import {
  about,
  mapped,
  mappedBox,
  type Affine,
  type Box,
  type Point,
} from "../geometry/affine.js";
import { boundsOf, mappedPath, unionOf, type CubicPath } from "../geometry/cubic.js";
import type { Editor } from "../app/types.js";
import { isHidden } from "../model/standing.js";
import type { Handle, Item, Selection } from "../model/types.js";
import * as en from "../strings/en.js";
import type { BoxMark } from "./marks.js";
import { isOutOfReach, placesOf, type Place } from "./places.js";

/** The box stands off what it holds, and the handle that turns it off the box, CSS pixels. */
export const BOX_OFF = 8;
const TURN_OFF = 26;
/** A box narrower than this has handles at its corners alone. */
const NARROW = 40;

const NOTHING: Box = [Infinity, Infinity, -Infinity, -Infinity];
/** In the coordinates of the element, by its paths. */
const kept = new WeakMap<readonly CubicPath[], Box>();

/** Around the curves of a place, artboard units. */
export function placeBounds({ item, artboardFromItem }: Place): Box {
  const { paths } = item;
  if (paths.length === 0) return NOTHING;
  const [, b, c] = artboardFromItem;
  // The box of a turned box would be too large.
  if (b !== 0 || c !== 0)
    return unionOf(paths.map((path) => boundsOf(mappedPath(artboardFromItem, path)))) ?? NOTHING;
  const box = kept.get(paths) ?? unionOf(paths.map(boundsOf)) ?? NOTHING;
  kept.set(paths, box);
  return mappedBox(artboardFromItem, box);
}

/** Handles of what is selected as a whole. */
export function wholes(selection: Selection): Handle[] {
  return selection.filter(({ part }) => part.kind === "whole").map(({ handle }) => handle);
}

/** Returns the selected items that may be moved: none that is out of reach or lies within another of them. */
export function movable(editor: Editor): Item[] {
  const chosen = new Set(wholes(editor.selection.value));
  const isInside = (item: Item | null): boolean =>
    item !== null && (chosen.has(item.handle) || isInside(item.parent));
  return [...chosen].flatMap((handle) => {
    const item = editor.drawing.item(handle);
    return item && !isOutOfReach(editor, item) && !isInside(item.parent) ? [item] : [];
  });
}

/** Around what is selected and seen, artboard units; null: nothing is. */
export function selectionBox(editor: Editor): Box | null {
  const chosen = new Set(wholes(editor.selection.value));
  if (chosen.size === 0) return null;
  const isChosen = (item: Item | null): boolean =>
    item !== null && (chosen.has(item.handle) || isChosen(item.parent));
  const boxes = placesOf(editor)
    .filter(({ owner }) => isChosen(owner))
    .map(placeBounds);
  for (const handle of chosen) {
    const item = editor.drawing.item(handle);
    if (item?.kind === "reference" && !isHidden(item))
      boxes.push(mappedBox(item.artboardFromItem, item.box));
  }
  const box = unionOf(boxes);
  return box && box[0] <= box[2] ? box : null;
}

const NAMES = {
  "-1,-1": "nw",
  "0,-1": "n",
  "1,-1": "ne",
  "1,0": "e",
  "1,1": "se",
  "0,1": "s",
  "-1,1": "sw",
  "-1,0": "w",
} as const;
export type GripName = (typeof NAMES)[keyof typeof NAMES];

export function gripName([x, y]: readonly [number, number]): GripName {
  return NAMES[`${x},${y}` as keyof typeof NAMES];
}

const GRIPS = Object.keys(NAMES).map((key) => key.split(",").map(Number) as [number, number]);

/** The box as it is drawn, on the stage. */
export function drawnBox(box: Box, stageFromArtboard: Affine): Box {
  const [x0, y0, x1, y1] = mappedBox(stageFromArtboard, box);
  return [x0 - BOX_OFF, y0 - BOX_OFF, x1 + BOX_OFF, y1 + BOX_OFF];
}

/** @param isChosen whether a handle has the keys: it is shown in however narrow a box */
export function boxMarks(
  box: Box,
  stageFromArtboard: Affine,
  handle: Handle,
  isChosen: (mark: BoxMark) => boolean,
): BoxMark[] {
  const [x0, y0, x1, y1] = drawnBox(box, stageFromArtboard);
  const base = { handle, part: { kind: "whole" }, isChosen: false } as const;
  // An edge has a handle where there is room, and something to scale.
  const hasRoom = ([x, y]: readonly [number, number]) =>
    (x !== 0 || (x1 - x0 > NARROW && box[3] > box[1])) &&
    (y !== 0 || (y1 - y0 > NARROW && box[2] > box[0]));
  const marks = GRIPS.map((grip): BoxMark => {
    const at: Point = [x0 + ((grip[0] + 1) / 2) * (x1 - x0), y0 + ((grip[1] + 1) / 2) * (y1 - y0)];
    return { ...base, kind: "scale", at, foot: at, grip, label: en.canvas.scale[gripName(grip)] };
  });
  const foot: Point = [(x0 + x1) / 2, y0];
  const turn: BoxMark = {
    ...base,
    kind: "turn",
    at: [foot[0], y0 - TURN_OFF],
    foot,
    grip: [0, -1],
    label: en.canvas.turn,
  };
  return [...marks, turn]
    .map((mark) => ({ ...mark, isChosen: isChosen(mark) }))
    .filter((mark) => mark.isChosen || mark.kind === "turn" || hasRoom(mark.grip));
}

/** The least factor of scaling: a smaller box could not be scaled back. */
const LEAST_FACTOR = 1e-3;

/**
 * Returns the map that moves a corner or edge of a box by a vector, artboard units.
 * @param keepsShape both directions by the same factor
 * @param aboutMiddle else the opposite corner or edge stays
 */
export function scaling(
  [x0, y0, x1, y1]: Box,
  [gx, gy]: readonly [number, number],
  by: Point,
  keepsShape: boolean,
  aboutMiddle: boolean,
): Affine {
  const fixed = (grip: number, low: number, high: number) =>
    aboutMiddle || grip === 0 ? (low + high) / 2 : grip > 0 ? low : high;
  const cx = fixed(gx, x0, x1);
  const cy = fixed(gy, y0, y1);
  const factor = (grip: number, low: number, high: number, delta: number) => {
    const extent = (aboutMiddle ? 0.5 : 1) * (high - low);
    if (grip === 0 || !(extent > 0)) return 1;
    const raw = 1 + (grip * delta) / extent;
    return Math.abs(raw) < LEAST_FACTOR ? Math.sign(raw || 1) * LEAST_FACTOR : raw;
  };
  let sx = factor(gx, x0, x1, by[0]);
  let sy = factor(gy, y0, y1, by[1]);
  if (keepsShape) {
    const most = gx === 0 ? sy : gy === 0 ? sx : Math.abs(sx - 1) > Math.abs(sy - 1) ? sx : sy;
    [sx, sy] = [most, most];
  }
  return about([cx, cy], [sx, 0, 0, sy, 0, 0]);
}

/** Fifteen degrees, to which Shift holds angles. */
const STEP = Math.PI / 12;

export function toStep(angle: number): number {
  return Math.round(angle / STEP) * STEP;
}

/** The corners of a box after a map, as a box: for the announcement at the end. */
export function middleOf(box: Box, map: Affine): Point {
  return mapped(map, [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2]);
}
