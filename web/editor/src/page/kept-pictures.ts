// Small pictures of stored drawings, for lists: made once the exact picture rests.
import { effect } from "@preact/signals";
import type { DrawingEditor } from "../app/editor.js";
import type { PictureCanvas } from "../canvas/renderer.js";
import { hexOf } from "../geometry/colortext.js";
import type { Documents } from "./documents.js";

/** The longer side, pixels. */
const SIDE = 240;
/** Bytes of a picture. */
const MOST = 20_000;
/** The shortest time from one picture to the next, milliseconds. */
const PAUSE = 2000;
/** The formats and qualities that are tried until a picture is small enough. */
const WAYS = [
  { type: "image/webp", quality: 0.85 },
  { type: "image/webp", quality: 0.5 },
  { type: "image/webp", quality: 0.1 },
] as const;

/** Returns the canvas as a file that is small enough; null: there is none. */
async function fileOf(canvas: OffscreenCanvas): Promise<Blob | null> {
  for (const way of WAYS) {
    // A browser that makes no WebP makes a PNG.
    const file = await canvas.convertToBlob(way);
    if (file.size <= MOST) return file;
  }
  return null;
}

function canvasOf(size: readonly number[]) {
  const canvas = new OffscreenCanvas(size[0], size[1]);
  return { canvas, context: canvas.getContext("2d")! };
}

/** Draws the picture that is shown, with its background, if there is one; null: it cannot be drawn now. */
function drawnSmall({ drawing }: DrawingEditor, picture: PictureCanvas, side: number): OffscreenCanvas | null {
  const [x0, y0, x1, y1] = drawing.artboard;
  const scale = side / Math.max(x1 - x0, y1 - y0);
  const size = [x1 - x0, y1 - y0].map((length) => Math.max(1, Math.round(length * scale)));
  const pixels = picture.whole(size);
  if (!pixels) return null;
  const content = canvasOf(size);
  content.context.putImageData(new ImageData(pixels, size[0], size[1]), 0, 0);
  if (!drawing.background) return content.canvas;
  const page = canvasOf(size);
  page.context.fillStyle = hexOf(drawing.background);
  page.context.fillRect(0, 0, size[0], size[1]);
  page.context.drawImage(content.canvas, 0, 0);
  return page.canvas;
}

async function pictureOf(editor: DrawingEditor, picture: PictureCanvas): Promise<Blob | null> {
  for (const side of [SIDE, SIDE / 2]) {
    const canvas = drawnSmall(editor, picture, side);
    const file = canvas && (await fileOf(canvas));
    if (file || !canvas) return file;
  }
  return null;
}

export class KeptPictures {
  /** The drawing and its revision that were drawn last. */
  #done = "";
  #timer = 0;

  constructor(
    private readonly editor: DrawingEditor,
    private readonly documents: Documents,
    private readonly picture: PictureCanvas,
  ) {
    effect(() => {
      if (editor.status.value.kind === "exact" && documents.stored.value !== null) this.#wait(0);
    });
  }

  #wait(pause: number) {
    if (this.#timer === 0) this.#timer = setTimeout(() => void this.#work(), Math.max(pause, 100)) as never;
  }

  async #work(): Promise<void> {
    const { editor, documents, picture } = this;
    this.#timer = 0;
    const [drawing, id] = [editor.drawing, documents.storedNow];
    const key = `${id} ${drawing.revision}`;
    // Runs again when the next picture is exact, or the next change is stored.
    if (id === null || key === this.#done || editor.isInGesture || editor.status.peek().kind !== "exact") return;
    if (picture.isDrawing) return this.#wait(PAUSE);
    this.#done = key;
    const file = await pictureOf(editor, picture).catch(() => null);
    // Another drawing may have been opened meanwhile.
    if (file && documents.storedNow === id) await documents.keepPicture(file);
    this.#wait(PAUSE);
  }
}
