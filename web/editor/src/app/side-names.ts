// Names of a curve's sides, as panels, handles and announcements show them.
import { sideWord } from "../model/sides.js";
import type { CurveItem, Side } from "../model/types.js";
import * as en from "../strings/en.js";

/** Returns "Inside" or "Outside" for a closed curve, "Left" or "Right" for an open one. */
export function nameOfSide(item: Pick<CurveItem, "paths">, side: Side): string {
  return en.panels.sides[sideWord(item, side)];
}
