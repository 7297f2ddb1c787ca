// Inserts the layers of another drawing.
import { composed, translation, type Affine } from "../../../geometry/affine.js";
import { applied } from "../../../source/patch.js";
import { openDrawing } from "../../drawing.js";
import type { Drawing, Handle, Outcome } from "../../types.js";
import { transform } from "../curves/transform.js";
import { paste } from "./paste.js";

/** Decimals of a map that scales a whole artboard. */
const STEP = 1e-6;

/**
 * Puts all layers of a drawing on top of an item, or of everything.
 * @param map from that drawing's artboard to this one's
 */
export function insertAt(d: Drawing, from: Drawing, map: Affine, above: Handle | null): Outcome | null {
  const moved = transform(from, from.items.map(({ handle }) => handle), map, STEP);
  return paste(d, moved ? applied(from.text, moved.patch) : from.text, above);
}

/** Puts the layers of a drawing into the middle of the artboard: in their own size, or smaller until they fit. */
export function insertCentred(d: Drawing, text: string, above: Handle | null): Outcome | null {
  const from = openDrawing(text);
  const [ours, theirs] = [d.artboard, from.artboard].map(([x0, y0, x1, y1]) => ({
    size: [x1 - x0, y1 - y0],
    middle: [(x0 + x1) / 2, (y0 + y1) / 2],
  }));
  const scale = Math.min(1, ours.size[0] / theirs.size[0], ours.size[1] / theirs.size[1]);
  const toMiddle = translation(ours.middle[0], ours.middle[1]);
  const fromMiddle = translation(-theirs.middle[0], -theirs.middle[1]);
  const map = composed(toMiddle, composed([scale, 0, 0, scale, 0, 0], fromMiddle));
  return insertAt(d, from, map, above);
}
