// The work of the dialog that traces photos: files and workers on one side, the drawing on the other.
import type { DrawingEditor } from "../app/editor.js";
import type { TracedPhoto } from "../app/types.js";
import { referenceAt } from "../canvas/photo.js";
import { pageHost } from "../engine/page-host.js";
import { TracePreviews, tracePhoto, type PreviewWish } from "../engine/photo-trace.js";
import type { PhotoPixels, TraceOptions, TraceRound } from "../engine/types.js";
import { bytesOfDataUri } from "../files/images.js";
import { pickFile } from "../files/open.js";
import { photoPixels } from "../files/photo.js";
import { composed, translation } from "../geometry/affine.js";
import { fitted, insertTraced, replaceByTraced, type TracedDrawing } from "../model/commands/index.js";
import { blankText } from "../model/drawing.js";
import type { Drawing, Outcome } from "../model/types.js";
import type { Traced, Tracing } from "../panels/services.js";
import * as en from "../strings/en.js";
import type { Documents } from "./documents.js";
import { dataUri } from "./files.js";

const words = en.trace;
/** The photo that lies on the drawing; null: there is none. */
function photoOn(drawing: Drawing): TracedPhoto | null {
  const reference = referenceAt(drawing, null);
  const bytes = reference && bytesOfDataUri(reference.href);
  if (!bytes) return null;
  const [x0, y0, x1, y1] = reference.box;
  const itemFromPhoto = composed(translation(x0, y0), [x1 - x0, 0, 0, y1 - y0, 0, 0]);
  return {
    blob: new Blob([bytes]),
    name: reference.name,
    artboardFromPhoto: composed(reference.artboardFromItem, itemFromPhoto),
  };
}

/** Opens the dialog, with the photo that lies on the drawing where there is one. */
export function askToTrace(editor: DrawingEditor): void {
  const photo = editor.welcome.peek() ? null : photoOn(editor.drawing);
  editor.dialog.value = { kind: "trace", photo };
}

/** With the photo, where it is to be kept. */
async function drawingOf({ photo, pixels, text, keepsPhoto }: Traced): Promise<TracedDrawing> {
  const { width, height } = pixels;
  const kept = keepsPhoto ? { href: await dataUri(photo.blob), width, height } : null;
  return { text, name: photo.name.replace(/\.[^.]+$/, ""), photo: kept };
}

export class PhotoTracing implements Tracing {
  readonly #previews = new TracePreviews(pageHost);

  constructor(
    private readonly editor: DrawingEditor,
    private readonly documents: Documents,
  ) {}

  async choose(): Promise<TracedPhoto | null> {
    const opened = await pickFile((text) => this.editor.engine.convert(text), "photo");
    if (!opened) return null;
    if (opened.kind !== "photo") {
      throw new Error(opened.kind === "problem" ? opened.reason : en.page.noPicture);
    }
    return { blob: opened.blob, name: opened.name, artboardFromPhoto: null };
  }

  pixels({ blob, name }: TracedPhoto): Promise<PhotoPixels> {
    return photoPixels(blob, name);
  }

  run(
    photo: PhotoPixels,
    options: TraceOptions,
    heard: (round: TraceRound) => void,
    signal: AbortSignal,
  ): Promise<string> {
    return tracePhoto(pageHost, { photo, options }, heard, signal);
  }

  draw(wish: PreviewWish, show: (pixels: PhotoPixels) => void): void {
    this.#previews.draw(wish, show);
  }

  async openAsNew(traced: Traced): Promise<void> {
    const { editor } = this;
    const { width, height } = traced.pixels;
    const drawing = await drawingOf(traced);
    await this.documents.begin(blankText(width, height, null), `${words.name(drawing.name)}.svg`);
    this.#put(traced, replaceByTraced(editor.drawing, drawing));
  }

  async insert(traced: Traced): Promise<void> {
    const { editor } = this;
    const { width, height } = traced.pixels;
    const drawing = await drawingOf(traced);
    const place = traced.photo.artboardFromPhoto ?? fitted(editor.drawing, width, height);
    this.#put(traced, insertTraced(editor.drawing, drawing, place));
  }

  /** As a step of undo. */
  #put({ curves }: Traced, outcome: Outcome | null): void {
    const { editor } = this;
    if (!editor.run(words.insert, outcome)) return;
    // The drawing is to be seen, not the photo above it.
    editor.showReference.value = false;
    editor.say(words.opened(curves.toLocaleString("en")));
  }

  end(): void {
    this.#previews.end();
  }
}
