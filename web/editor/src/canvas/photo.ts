// The pixels of a picture to trace over.
import type { Editor } from "../app/types.js";
import {
  composed,
  inverted,
  mapped,
  translation,
  type Affine,
  type Point,
} from "../geometry/affine.js";
import type { Photo } from "../geometry/photo.js";
import { isLowest } from "../model/commands/structure/items.js";
import { isHidden } from "../model/standing.js";
import type { Drawing, ReferenceItem } from "../model/types.js";
import { isOutOfReach, type Reach } from "./places.js";

/** A photo in its place. */
export interface PlacedPhoto extends Photo {
  readonly artboardFromPixel: Affine;
}

/** Pixels of the photos that were read last: they are large. */
const MOST_KEPT = 2;
const kept = new Map<string, Promise<ImageData | null>>();

/** The topmost picture to trace over that is seen, at a point or at all; null: there is none. */
export function referenceAt(drawing: Drawing, point: Point | null): ReferenceItem | null {
  const seen = [...drawing.all()].flatMap((item) =>
    item.kind === "reference" && !isHidden(item) ? [item] : [],
  );
  return seen.filter((item) => point === null || isWithin(item, point)).at(-1) ?? null;
}

/** The one under the pointer that a point's colour is taken of; null: there is none, or all are put away. */
export function photoInSight({ drawing, showReference }: Editor, point: Point): ReferenceItem | null {
  return showReference.peek() ? referenceAt(drawing, point) : null;
}

/** The one that curves are traced along at a point, also while it is put away. */
export function photoToTrace(drawing: Drawing, point: Point): ReferenceItem | null {
  return referenceAt(drawing, point) ?? referenceAt(drawing, null);
}

/** Photos that are seen, below the picture or above it. */
export function photosOf(drawing: Drawing, below: boolean): ReferenceItem[] {
  return [...drawing.all()].flatMap((item) =>
    item.kind === "reference" && !isHidden(item) && isLowest(drawing, item) === below ? [item] : [],
  );
}

/** Whether the stage shows through the picture: it has no background, or a photo lies below it. */
export function isSeenThrough({ drawing, showReference }: Editor): boolean {
  return drawing.background === null || (showReference.value && photosOf(drawing, true).length > 0);
}

/** The topmost photo that may be moved, at a point of the artboard. */
export function loosePhotoAt(reach: Reach, point: Point): ReferenceItem | null {
  const { drawing } = reach;
  const loose = [...photosOf(drawing, true), ...photosOf(drawing, false)].filter(
    (item) => !isOutOfReach(reach, item) && isWithin(item, point),
  );
  return loose.at(-1) ?? null;
}

function isWithin(item: ReferenceItem, point: Point): boolean {
  const back = inverted(item.artboardFromItem);
  if (!back) return false;
  const [x, y] = mapped(back, point);
  const [x0, y0, x1, y1] = item.box;
  return x >= x0 && x <= x1 && y >= y0 && y <= y1;
}

/** Its pixels; null where no browser decodes it. */
export async function photoOf(item: ReferenceItem): Promise<PlacedPhoto | null> {
  const image = await pixelsOf(item.href);
  const [x0, y0, x1, y1] = item.box;
  if (!image || !(x1 > x0 && y1 > y0)) return null;
  const { width, height, data } = image;
  const itemFromPixel = composed(translation(x0, y0), [
    (x1 - x0) / width,
    0,
    0,
    (y1 - y0) / height,
    0,
    0,
  ]);
  return { width, height, data, artboardFromPixel: composed(item.artboardFromItem, itemFromPixel) };
}

function pixelsOf(href: string): Promise<ImageData | null> {
  const known = kept.get(href);
  const pixels = known ?? decoded(href).catch(() => null);
  kept.delete(href);
  kept.set(href, pixels);
  for (const old of [...kept.keys()].slice(0, -MOST_KEPT)) kept.delete(old);
  return pixels;
}

async function decoded(href: string): Promise<ImageData | null> {
  const image = new Image();
  image.src = href;
  await image.decode();
  const { naturalWidth: width, naturalHeight: height } = image;
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  if (!context) return null;
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, width, height);
}
