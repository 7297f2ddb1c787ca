// SVG of other programs as curves.
import type { Engine } from "../engine/types.js";
import { warningText } from "../engine/complaint.js";
import { pageHost } from "../engine/page-host.js";
import { importedSvg, type Watch } from "../engine/other-text.js";
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

/**
 * Converts SVG of another program.
 * @param beside files that the text names
 * @throws the signal's reason; Error, in words, where nothing becomes a curve
 */
export async function converted(
  engine: Pick<Engine, "images">,
  pictures: Pictures,
  text: string,
  beside: Beside,
  watch: Watch,
): Promise<Converted> {
  const before = pictures.begin(beside);
  await pictures.take(text).finally(() => void pictures.begin(before));
  const made = await importedSvg(pageHost, text, engine.images, watch);
  const curves = curvesIn(openDrawing(made.text));
  const leftOut = made.warnings.map(warningText);
  if (curves === 0) throw new Error([en.page.nothingConverted, ...leftOut].join("\n"));
  return { text: made.text, curves, leftOut };
}
