// Curves of a document fitted to a photo, in numbers that their text can take.
import type { SfumatoContext, SfumatoDocument } from "../../../wasm/sfumato.mjs";
import { isOpaque, layered } from "../geometry/photo.js";
import type { EngineCurve, FittedCurve, FitWish, PhotoPixels, RasterWish } from "./types.js";

const SIDES = [0, 1] as const;
const COLOR = 0;
const BLUR = 2;
const STOPS = 2;

type Rows = readonly (readonly number[])[];

/** Returns the mean over the curves of one element, which have the same stops. */
const mean = (lists: readonly Rows[]): Rows =>
  lists[0].map((row, i) =>
    row.map((_, k) => lists.reduce((sum, list) => sum + (list[i]?.[k] ?? row[k]), 0) / lists.length),
  );

const rowsOf = (document: SfumatoDocument, { layer, curve }: EngineCurve, side: number, attribute: number): Rows =>
  document.stops(layer, curve, side, attribute).rows;

const largest = (document: SfumatoDocument, curve: EngineCurve): number =>
  Math.max(0, ...SIDES.flatMap((side) => rowsOf(document, curve, side, BLUR).map(([, radius]) => radius)));

function began(document: SfumatoDocument, curves: readonly EngineCurve[], { radii }: FitWish): void {
  for (const { offset, side, space, rows } of radii) {
    for (const { layer, curve } of curves.filter((one) => one.offset === offset)) {
      document.setStops(layer, curve, side, BLUR, { kind: STOPS, space, rows });
    }
  }
}

/**
 * @param curves all of the document
 * @param draw what the document looks like
 * @throws SfumatoError
 */
export function fittedCurves(
  context: SfumatoContext,
  document: SfumatoDocument,
  curves: readonly EngineCurve[],
  wish: FitWish,
  draw: (wish: RasterWish) => PhotoPixels["data"],
): FittedCurve[] {
  const wanted = new Set(wish.offsets);
  const chosen = curves.filter(({ offset }) => wanted.has(offset));
  if (chosen.length === 0) return [];
  const { width, height } = wish.photo;
  const wholly: RasterWish = { width, height, viewport: null, background: null, depth: 8 };
  // Where there is no photo the drawing is as it should be.
  const photo = isOpaque(wish.photo)
    ? wish.photo
    : layered(wish.photo, { width, height, data: draw(wholly) });
  began(document, chosen, wish);
  const only = chosen.map(({ layer, curve }) => `${layer}:${curve}`).join(",");
  const how: Readonly<Record<string, string | boolean>> =
    wish.fits === "blur" ? { "keep-colors": true } : { blur: "off" };
  const fitted = context.fitColors(document, photo, { only, ...how });
  try {
    return [...wanted].flatMap((offset) => {
      const own = chosen.filter((curve) => curve.offset === offset);
      if (own.length === 0) return [];
      const colors = SIDES.map((side) => mean(own.map((curve) => rowsOf(fitted, curve, side, COLOR))));
      const factors = own.map((curve) => {
        const before = largest(document, curve);
        return before > 0 ? largest(fitted, curve) / before : 1;
      });
      const factor = factors.reduce((sum, one) => sum + one, 0) / factors.length;
      const radius = Math.max(...own.map((curve) => largest(fitted, curve)));
      return [{ offset, colors: [colors[0], colors[1]] as const, factor, radius }];
    });
  } finally {
    fitted.free();
  }
}
