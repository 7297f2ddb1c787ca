// A user's program in TypeScript, which tsc --strict checks and nobody runs.
import { create, importSvg, load, read, SfumatoError, Status, Side, Attribute, Kind, Table } from "sfumato";
import type { Format, Pixels, SfumatoPicture } from "sfumato";
import { SfumatoPicture as PictureElement, type PictureView } from "sfumato/element";

export async function use(text: string): Promise<Pixels> {
  const drawing = await read(text, { name: "a.svg", load: () => null, base: "https://example.org/" });
  drawing.setStops(0, 0, Side.left, Attribute.color, { kind: Kind.stops, rows: [[0, 1, 0, 0]] });
  const picture: SfumatoPicture = drawing.solve({ maxError: 1 });
  const imported: { warnings: readonly string[] } = await importSvg(text, { name: "a.svg" });
  const format: Format = "pdf";
  const file: Uint8Array = picture.export(format, "title=a");
  const vertices = picture.table(0, Table.vertices).data;
  const image = picture.raster({ width: 200, background: "none" });
  const shown: ImageData = new ImageData(image.data, image.width, image.height);
  // @ts-expect-error no such format
  picture.export("jpg");
  // @ts-expect-error a word is not a width
  picture.raster({ width: "200" });
  // @ts-expect-error only the module makes pictures
  new PictureElement.prototype.constructor.SfumatoPicture();
  return { width: file.length, height: vertices.length + imported.warnings.length, data: shown.data };
}

export async function contexts(): Promise<number> {
  const sfumato = await load();
  const context = sfumato.context({ maxMemory: 500 });
  context.onProgress = (stage: string, fraction: number) => void (stage + fraction);
  const wide: Uint16Array = context.raster((await create(3, 2)).solve(), { width: 3, height: 2, format: "rgb16" });
  context.free();
  return wide.length;
}

export function reasonOf(error: unknown): string {
  if (error instanceof SfumatoError && error.code === Status.badInput) return `${error.line}: ${error.reason}`;
  throw error;
}

export async function element(): Promise<PictureView | null> {
  const picture = document.createElement("sfumato-picture");
  picture.src = "a.svg";
  picture.interactive = true;
  picture.view = { zoom: 3 };
  picture.fit();
  await picture.ready;
  PictureElement.workerUrl = "/worker.js";
  PictureElement.words.wheel = () => "Strg + Rad";
  return document.querySelector("sfumato-picture")?.view ?? picture.view;
}
