// SVG of other programs as curves.
import type { Engine } from "../engine/types.js";
import { warningText } from "../engine/complaint.js";
import type { Beside } from "../files/images.js";
import { openDrawing } from "../model/drawing.js";
import type { Drawing } from "../model/types.js";
import * as en from "../strings/en.js";
import type { Pictures } from "./pictures.js";

/** Shapes of an ordinary SVG as a drawing. */
export interface Converted {
  readonly text: string;
  readonly curves: number;
  /** Parts that were left out, in words. */
  readonly leftOut: readonly string[];
}

export function curvesIn(drawing: Drawing): number {
  return [...drawing.all()].filter(({ kind }) => kind === "curve" || kind === "stroke").length;
}

/** @param beside files that the text names @throws Error, in words, where nothing becomes a curve */
export async function converted(engine: Engine, pictures: Pictures, text: string, beside: Beside): Promise<Converted> {
  const before = pictures.begin(beside);
  await pictures.take(text);
  const made = await engine.importSvg(text).finally(() => void pictures.begin(before));
  const curves = curvesIn(openDrawing(made.text));
  const leftOut = made.warnings.map(warningText);
  if (curves === 0) throw new Error([en.page.nothingConverted, ...leftOut].join("\n"));
  return { text: made.text, curves, leftOut };
}
