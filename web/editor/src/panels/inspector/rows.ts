// The rows of a curve's sides.
import { insideOf } from "../../model/sides.js";
import type { CurveItem } from "../../model/types.js";

/** Returns the class of a row: "Inside" and "Outside" need more room than "Left" and "Right". */
export const sideRow = (item: CurveItem): string => (insideOf(item) ? "side-row closed" : "side-row");
