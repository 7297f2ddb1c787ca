// The pixels that are still to be gathered for a still picture, and how many to gather at a time.

import { intersected, isEmptyRect } from "./targets.js";

/** @import { Rect } from "./targets.js" */

/** Side of the squares that are processed one after another, pixels. */
export const TILE = 256;

/**
 * Target time of one frame's share, milliseconds; larger for software, where even a small share takes a while.
 */
const AIM = 6;
const SOFTWARE_AIM = 60;
const FIRST_SHARE = 256;
const LEAST_SHARE = 64;
/** In software one pixel may take 10 ms. */
const SOFTWARE_FIRST = 16;
const SOFTWARE_LEAST = 8;
const MOST_SHARE = 1 << 22;

/** Chooses how many pixels to gather in a frame, from the times of earlier frames. */
export class Pace {
  /** @param {boolean} isSoftware */
  constructor(isSoftware) {
    this.aim = isSoftware ? SOFTWARE_AIM : AIM;
    this.least = isSoftware ? SOFTWARE_LEAST : LEAST_SHARE;
    this.pixels = isSoftware ? SOFTWARE_FIRST : FIRST_SHARE;
  }

  /** @param {number} elapsed time of a share, milliseconds */
  learn(elapsed) {
    const { aim } = this;
    const factor = elapsed < 0.7 * aim ? 2 : elapsed > 1.3 * aim ? aim / elapsed : 1;
    const pixels = Math.round(this.pixels * Math.max(factor, 1 / 8));
    this.pixels = Math.min(MOST_SHARE, Math.max(this.least, pixels));
  }
}

/** The rest of some rectangles, cut into tiles; the middle comes first. */
export class Work {
  /** @param {Rect[]} rects */
  constructor(rects) {
    /** @type {Rect[]} */
    this.tiles = rects.flatMap(tilesOf);
    const whole = rects.length > 0 ? rects[0] : [0, 0, 0, 0];
    const middle = [whole[0] + whole[2] / 2, whole[1] + whole[3] / 2];
    const far = (/** @type {Rect} */ [x, y, width, height]) =>
      Math.hypot(x + width / 2 - middle[0], y + height / 2 - middle[1]);
    this.tiles.sort((a, b) => far(b) - far(a));
    /** Parts of the present tile. @type {Rect[]} */
    this.parts = [];
    this.left = this.tiles.reduce((sum, [, , width, height]) => sum + width * height, 0);
  }

  get isDone() {
    return this.left === 0;
  }

  /** Returns the next tile, or null while the last one is not finished. @returns {Rect | null} */
  nextTile() {
    if (this.parts.length > 0) return null;
    const tile = this.tiles.pop() ?? null;
    if (tile) this.parts.push(tile);
    return tile;
  }

  /**
   * Returns a part of the present tile.
   * @param {number} most limit for the pixels, above 0
   * @returns {Rect}
   */
  take(most) {
    const [x, y, width, height] = /** @type {Rect} */ (this.parts.pop());
    const rows = Math.min(height, Math.floor(most / width));
    if (rows < height) this.parts.push([x, y + Math.max(rows, 1), width, height - Math.max(rows, 1)]);
    const columns = rows > 0 ? width : Math.min(width, most);
    if (columns < width) this.parts.push([x + columns, y, width - columns, 1]);
    const taken = [x, y, columns, Math.max(rows, 1)];
    this.parts = this.parts.filter((part) => !isEmptyRect(part));
    this.left -= taken[2] * taken[3];
    return taken;
  }
}

/** @param {Rect} rect */
function tilesOf(rect) {
  const tiles = [];
  for (let y = rect[1]; y < rect[1] + rect[3]; y += TILE) {
    for (let x = rect[0]; x < rect[0] + rect[2]; x += TILE)
      tiles.push(intersected(rect, [x, y, TILE, TILE]));
  }
  return tiles;
}

/**
 * Returns the parts of `whole` outside `part`, as up to four rectangles.
 * @param {Rect} whole
 * @param {Rect} part
 * @returns {Rect[]}
 */
export function without(whole, part) {
  const [x, y, width, height] = whole;
  const inner = intersected(whole, part);
  if (isEmptyRect(inner)) return isEmptyRect(whole) ? [] : [whole];
  const right = x + width,
    bottom = y + height;
  const innerRight = inner[0] + inner[2],
    innerBottom = inner[1] + inner[3];
  return [
    [x, y, width, inner[1] - y],
    [x, innerBottom, width, bottom - innerBottom],
    [x, inner[1], inner[0] - x, inner[3]],
    [innerRight, inner[1], right - innerRight, inner[3]],
  ].filter((rect) => !isEmptyRect(rect));
}
