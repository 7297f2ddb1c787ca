// A traced photo put into the drawing.
import { composed, type Affine } from "../../../geometry/affine.js";
import { applied } from "../../../source/patch.js";
import { openDrawing } from "../../drawing.js";
import type { Drawing, Outcome } from "../../types.js";
import { addReference } from "./create.js";
import { insertAt } from "../structure/inserted.js";
import { rename } from "../structure/naming.js";

/** A photo to be kept with its drawing. */
export interface KeptPhoto {
  readonly href: string;
  readonly width: number;
  readonly height: number;
}

/** From shares of 0 to 1 to the middle of the artboard, as large as a photo of that size fits. */
export function fitted(d: Drawing, width: number, height: number): Affine {
  const [x0, y0, x1, y1] = d.artboard;
  const scale = Math.min((x1 - x0) / width, (y1 - y0) / height);
  const [w, h] = [width * scale, height * scale];
  return [w, 0, 0, h, (x0 + x1 - w) / 2, (y0 + y1 - h) / 2];
}

/** The result of tracing a photo. */
export interface TracedDrawing {
  /** SVG, whose artboard begins at 0. */
  readonly text: string;
  /** Name of the photo, for its layer. */
  readonly name: string;
  /** Goes above the layer as a reference, as large as the artboard; null: does not. */
  readonly photo: KeptPhoto | null;
}

const changed = (d: Drawing, outcome: Outcome | null): Drawing =>
  outcome ? openDrawing(applied(d.text, outcome.patch)) : d;

function whole({ text, name, photo }: TracedDrawing): Drawing {
  const drawn = openDrawing(text);
  const [layer] = drawn.items;
  const named = layer ? changed(drawn, rename(drawn, layer.handle, name)) : drawn;
  return photo ? changed(named, addReference(named, photo.href, photo.width, photo.height)) : named;
}

/** A traced photo in the place of all that there is. */
export function replaceByTraced(d: Drawing, traced: TracedDrawing): Outcome {
  return { patch: [{ at: 0, removed: d.text, inserted: whole(traced).text }] };
}

/**
 * Puts the layers of a traced photo on top of all.
 * @param artboardFromPhoto where they go, from shares of 0 to 1
 */
export function insertTraced(
  d: Drawing,
  traced: TracedDrawing,
  artboardFromPhoto: Affine,
): Outcome | null {
  const from = whole(traced);
  const [, , width, height] = from.artboard;
  const map = composed(artboardFromPhoto, [1 / width, 0, 0, 1 / height, 0, 0]);
  return insertAt(d, from, map, null);
}
