// A colour of the photo or the picture, by a click on it: where the browser has no eyedropper of its own.
import { mapped, type Point } from "../geometry/affine.js";
import type { DrawingEditor } from "../app/editor.js";
import { photoInSight, photoOf } from "../canvas/photo.js";
import { photoColor } from "../canvas/sampled.js";
import type { Rgb } from "../geometry/color.js";

/** Returns the colour of the photo over a point of the artboard, else of the picture. */
async function colorAt(editor: DrawingEditor, point: Point): Promise<Rgb | null> {
  const reference = photoInSight(editor, point);
  const photo = reference && (await photoOf(reference));
  return (photo && photoColor(photo, point)) ?? pictureColor(editor, point);
}

/**
 * Returns the colour that the command draws in the screen pixel at a point of the artboard; null: it is
 * transparent there, or cannot be drawn.
 */
async function pictureColor(editor: DrawingEditor, [x, y]: Point): Promise<Rgb | null> {
  const half = 0.5 / editor.view.value.zoom;
  const viewport = [x - half, y - half, x + half, y + half] as const;
  try {
    const [r, g, b, a] = await editor.engine.raster({ width: 1, height: 1, viewport, background: null, depth: 8 });
    return a === 0 ? null : { r: r / 255, g: g / 255, b: b / 255 };
  } catch {
    return null;
  }
}

/** The next click on the stage gives its colour; one elsewhere, Escape, or `stop` give none. */
export function pickColor(editor: DrawingEditor, stop: AbortSignal): Promise<Rgb | null> {
  return new Promise((resolve) => {
    const over = new AbortController();
    const end = (color: Rgb | null) => {
      over.abort();
      resolve(color);
    };
    const press = (event: PointerEvent) => {
      const stage = (event.target as Element).closest(".canvas-stage");
      if (!stage) return end(null);
      event.preventDefault();
      event.stopPropagation();
      const { left, top } = stage.getBoundingClientRect();
      const place = mapped(editor.artboardFromStage(), [event.clientX - left, event.clientY - top]);
      over.abort();
      void colorAt(editor, place).then(resolve);
    };
    const key = (event: KeyboardEvent) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      end(null);
    };
    document.addEventListener("pointerdown", press, { capture: true, signal: over.signal });
    document.addEventListener("keydown", key, { capture: true, signal: over.signal });
    stop.addEventListener("abort", () => end(null), { signal: over.signal });
  });
}
