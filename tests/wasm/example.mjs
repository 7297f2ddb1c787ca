// The program of docs/wasm.md.
import { Attribute, Kind, loadSfumato, Side } from "../../web/wasm/sfumato.mjs";

/** Its picture's pixels, 400 by 300. */
export async function drawExample(bytes) {
  const sfumato = await loadSfumato(bytes); // of sfumato.wasm
  const context = sfumato.context({ "max-time": 10 });
  const document = context.newDocument({ artboard: "0,0,400,300" });
  const horizon = [-20, 210, 130, 180, 270, 240, 420, 210];
  document.insertCurve(0, null, horizon);
  const sky = [
    [0, 0.97, 0.8, 0.85], // offset, red, green, blue
    [1, 1, 0.6, 0.4],
  ];
  const land = [[0, 0.11, 0.17, 0.12]];
  document.setStops(0, 0, Side.left, Attribute.color, { kind: Kind.stops, rows: sky });
  document.setStops(0, 0, Side.right, Attribute.color, { kind: Kind.stops, rows: land });
  const picture = context.solve(document, { width: 400 });
  const pixels = context.raster(picture, { width: 400, height: 300 });
  return pixels;
}
