// A traced photo put into the drawing.
import { composed, type Affine } from "../../geometry/affine.js";
import { applied } from "../../source/patch.js";
import { openDrawing } from "../drawing.js";
import type { Drawing, Outcome } from "../types.js";
import { paste } from "./clipboard.js";
import { addReference } from "./create.js";
import { transform } from "./transform.js";

/** A photo to be kept with its drawing. */
export interface KeptPhoto {
  readonly href: string;
  readonly width: number;
  readonly height: number;
}

/** Decimals of a map that scales a whole artboard. */
const STEP = 1e-6;

/** From shares of 0 to 1 to the middle of the artboard, as large as a photo of that size fits. */
export function fitted(d: Drawing, width: number, height: number): Affine {
  const [x0, y0, x1, y1] = d.artboard;
  const scale = Math.min((x1 - x0) / width, (y1 - y0) / height);
  const [w, h] = [width * scale, height * scale];
  return [w, 0, 0, h, (x0 + x1 - w) / 2, (y0 + y1 - h) / 2];
}

/**
 * Puts the layers of another drawing, whose artboard begins at 0, on top of all.
 * @param artboardFromPhoto where its artboard goes, from shares of 0 to 1
 * @param photo goes above them as a reference, as large as the artboard
 */
export function insertTraced(
  d: Drawing,
  text: string,
  artboardFromPhoto: Affine,
  photo: KeptPhoto | null,
): Outcome | null {
  const traced = openDrawing(text);
  const kept = photo && addReference(traced, photo.href, photo.width, photo.height);
  const whole = kept ? openDrawing(applied(text, kept.patch)) : traced;
  const [, , width, height] = whole.artboard;
  const map = composed(artboardFromPhoto, [1 / width, 0, 0, 1 / height, 0, 0]);
  const moved = transform(whole, whole.items.map(({ handle }) => handle), map, STEP);
  return paste(d, moved ? applied(whole.text, moved.patch) : whole.text, null);
}
