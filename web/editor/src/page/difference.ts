// Looks where the drawing is unlike the photo, while that is shown and the drawing rests.
import { effect } from "@preact/signals";
import type { DrawingEditor } from "../app/editor.js";
import type { Difference } from "../app/types.js";
import { pageHost } from "../engine/page-host.js";
import { TracePreviews } from "../engine/photo-trace.js";
import type { Drawing } from "../model/types.js";
import * as en from "../strings/en.js";
import { differenceOf, type DifferencePicture } from "../geometry/difference.js";
import { hasPhoto, laidPhoto } from "./laid-photo.js";

/** Pixels of the longer side. */
const SIDE = 800;
/** How long the exact picture stands before it is compared, milliseconds. */
const REST = 200;

async function addressOf({ width, height, data }: DifferencePicture): Promise<string> {
  const canvas = new OffscreenCanvas(width, height);
  canvas.getContext("2d")?.putImageData(new ImageData(data, width, height), 0, 0);
  return URL.createObjectURL(await canvas.convertToBlob());
}

class DifferenceWatch {
  #pictures: TracePreviews | null = null;
  #timer = 0;
  /** The drawing that was compared last. */
  #drawing: Drawing | null = null;

  constructor(private readonly editor: DrawingEditor) {}

  /** Whatever it reads says when to look again. */
  follow(): void {
    const { editor } = this;
    const isExact = editor.status.value.kind === "exact";
    const { drawing } = editor;
    clearTimeout(this.#timer);
    if (drawing !== this.#drawing) this.#forget();
    this.#drawing = drawing;
    if (!editor.showDifference.value) return this.#end();
    if (!hasPhoto(drawing)) {
      editor.showDifference.value = false;
    } else if (isExact && editor.difference.peek()?.revision !== drawing.revision) {
      this.#timer = window.setTimeout(() => void this.#look(), REST);
    }
  }

  async #look(): Promise<void> {
    const { editor } = this;
    const { drawing } = editor;
    const { revision, text, background } = drawing;
    const photo = await laidPhoto(drawing, SIDE);
    if (!photo) {
      editor.showDifference.value = false;
      return editor.say(en.tools.photoUnread);
    }
    const { width, height } = photo.pixels;
    const wish = { text, width, height, isDraft: false, images: editor.engine.images };
    this.#pictures ??= new TracePreviews(pageHost);
    this.#pictures.draw(background ? wish : { ...wish, background: "white" }, (pixels) => {
      const found = differenceOf(photo.pixels, pixels);
      void addressOf(found).then((href) => this.#show(drawing, { href, psnr: found.psnr, revision }));
    });
  }

  #show(of: Drawing, found: Difference): void {
    const isWanted = this.editor.showDifference.peek() && of === this.#drawing;
    if (!isWanted) return URL.revokeObjectURL(found.href);
    this.#forget();
    this.editor.difference.value = found;
  }

  #forget(): void {
    const shown = this.editor.difference.peek();
    if (shown) URL.revokeObjectURL(shown.href);
    this.editor.difference.value = null;
  }

  #end(): void {
    this.#forget();
    this.#pictures?.end();
    this.#pictures = null;
  }
}

export function watchDifference(editor: DrawingEditor): void {
  const watch = new DifferenceWatch(editor);
  effect(() => watch.follow());
}
