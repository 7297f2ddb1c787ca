// The programs of docs/npm.md and of the package's README. node.mjs runs them in a project with the package.
import { readFile, writeFile } from "node:fs/promises";
import { create, read, SfumatoError, Side, Attribute, Kind } from "sfumato";

/** Reads one file and writes others. */
export async function convert() {
  const drawing = await read(await readFile("drawing.svg"), { name: "drawing.svg" });
  const picture = drawing.solve({ maxError: 1 });
  await writeFile("drawing.pdf", picture.export("pdf", { title: "Two halves" }));
  await writeFile("drawing.png", picture.export("png", { width: 1200 }));
  const { width, height, data } = picture.raster({ width: 600 }); // RGBA, as ImageData has it
  return { width, height, data };
}

/** Draws from nothing. */
export async function draw() {
  const drawing = await create(400, 300, { background: "#222233" });
  drawing.insertCurve(0, null, [-20, 210, 130, 180, 270, 240, 420, 210]);
  const sky = [
    [0, 0.97, 0.8, 0.85], // offset, red, green, blue
    [1, 1, 0.6, 0.4],
  ];
  drawing.setStops(0, 0, Side.left, Attribute.color, { kind: Kind.stops, rows: sky });
  const text = drawing.write(); // SVG
  return text;
}

/** Reports what is wrong with a drawing. */
export async function complain(text) {
  try {
    await read(text, { name: "broken.svg" });
  } catch (error) {
    if (!(error instanceof SfumatoError)) throw error;
    return `line ${error.line}: ${error.reason}`;
  }
}

/** Solves once, for pages to show without solving. */
export async function prepare() {
  const drawing = await read(await readFile("drawing.svg"));
  await writeFile("drawing.sfv", drawing.solve().viewerPayload());
}
