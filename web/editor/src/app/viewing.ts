// Where the artboard lies on the stage.
import type { Affine, Box, Point } from "../geometry/affine.js";
import type { ViewState } from "./types.js";

/** Room around what is fitted, CSS pixels. */
const MARGIN = 32;
/** CSS pixels to a unit of an artboard of one unit: closest and farthest. */
const CLOSEST = 2 ** 21;
const FARTHEST = 16;

export interface Size {
  readonly width: number;
  readonly height: number;
}

export function stageFromArtboard({ x, y, zoom }: ViewState, { width, height }: Size): Affine {
  return [zoom, 0, 0, zoom, width / 2 - zoom * x, height / 2 - zoom * y];
}

export function artboardFromStage({ x, y, zoom }: ViewState, { width, height }: Size): Affine {
  return [1 / zoom, 0, 0, 1 / zoom, x - width / 2 / zoom, y - height / 2 / zoom];
}

/** What of the plane is seen. */
export function seenBox({ x, y, zoom }: ViewState, { width, height }: Size): Box {
  const [dx, dy] = [width / 2 / zoom, height / 2 / zoom];
  return [x - dx, y - dy, x + dx, y + dy];
}

export function limitedZoom(zoom: number, artboard: Box): number {
  const side = Math.max(artboard[2] - artboard[0], artboard[3] - artboard[1]) || 1;
  return Math.min(CLOSEST / side, Math.max(Math.min(1, FARTHEST / side), zoom));
}

/** The view that shows a box as large as it fits. */
export function fitted(box: Box, { width, height }: Size): ViewState {
  const [x0, y0, x1, y1] = box;
  const room = (length: number) => Math.max(16, length - 2 * Math.min(MARGIN, length / 8));
  const zoom = Math.min(room(width) / (x1 - x0 || 1), room(height) / (y1 - y0 || 1));
  return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, zoom };
}

/** The view after zooming about a point of the stage, which stays where it is. */
export function zoomed(view: ViewState, factor: number, at: Point, size: Size, artboard: Box): ViewState {
  const zoom = limitedZoom(view.zoom * factor, artboard);
  const [dx, dy] = [at[0] - size.width / 2, at[1] - size.height / 2];
  return { x: view.x + dx / view.zoom - dx / zoom, y: view.y + dy / view.zoom - dy / zoom, zoom };
}
