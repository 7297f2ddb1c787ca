// Small pictures of layers and groups. The renderer draws those that have changed and are requested while it
// is idle.
import { effect, signal, untracked, type Signal } from "@preact/signals";
import type { Editor } from "../app/types.js";
import { mappedBox, type Box } from "../geometry/affine.js";
import { boundsOf } from "../geometry/cubic.js";
import { isHidden } from "../model/standing.js";
import type { Drawing, Handle, Item } from "../model/types.js";
import type { PictureCanvas } from "./renderer.js";
import { lookOf, partsOf, type Part } from "./stack-parts.js";

/** CSS pixels of the frame in a row. */
const WIDTH = 28;
const HEIGHT = 21;
/** Sharp on screens of twice the pixels. */
const RATIO = 2;
/** Around curves, as a share of their box. */
const ROOM = 0.08;

/** The content of a thumb; a different key means different content. */
interface Shown {
  readonly part: Part;
  readonly view: Box;
  readonly key: string;
}

/** After other work, or soon where the browser has no such hour. */
function whenIdle(act: () => void): void {
  if ("requestIdleCallback" in globalThis) requestIdleCallback(act, { timeout: 2000 });
  else setTimeout(act, 100);
}

async function addressOf(pixels: Uint8ClampedArray<ArrayBuffer>, size: readonly number[]) {
  const canvas = new OffscreenCanvas(size[0], size[1]);
  canvas.getContext("2d")!.putImageData(new ImageData(pixels, size[0], size[1]), 0, 0);
  return URL.createObjectURL(await canvas.convertToBlob());
}

export class Thumbs {
  readonly #editor: Editor;
  readonly #picture: PictureCanvas;
  #drawing: Drawing | null = null;
  /** Addresses of pictures; null: there is none yet, or none can be made. */
  readonly #addresses = new Map<Handle, Signal<string | null>>();
  readonly #keys = new Map<Handle, string>();
  /** The parts of this stack and of the present document. */
  #parts: { readonly of: readonly unknown[]; readonly parts: ReadonlyMap<Item, Part> | null } | null = null;
  #isWaiting = false;

  constructor(editor: Editor, picture: PictureCanvas) {
    this.#editor = editor;
    this.#picture = picture;
    effect(() => {
      if (editor.status.value.kind === "exact") this.#wait();
    });
  }

  /** The address for a row; within components, reading it subscribes. */
  of(handle: Handle): string | null {
    this.#meet(untracked(() => this.#editor.drawing));
    let address = this.#addresses.get(handle);
    if (!address) {
      address = signal(null);
      this.#addresses.set(handle, address);
      this.#wait();
    }
    return address.value;
  }

  #wait() {
    if (this.#isWaiting) return;
    this.#isWaiting = true;
    whenIdle(() => void this.#work());
  }

  /** One thumb at a time: between them the page is free. */
  async #work() {
    this.#isWaiting = false;
    const { status, isInGesture } = this.#editor;
    // While something changes or moves, wait: this runs again once it rests.
    if (isInGesture || status.peek().kind !== "exact") return;
    const drawing = untracked(() => this.#editor.drawing);
    this.#meet(drawing);
    if (this.#picture.isDrawing) return this.#wait();
    const parts = this.#partsNow(drawing);
    // The stack belongs to another text: thumbs stay until the picture is that of this one.
    if (!parts) return;
    for (const [handle, address] of this.#addresses) {
      const item = drawing.item(handle);
      if (!item) {
        this.#drop(handle);
        continue;
      }
      // A hidden item is not drawn: its thumb stays as it was.
      if (isHidden(item)) continue;
      const part = parts.get(item);
      const shown = part ? this.#shownOf(drawing, item, part) : null;
      if ((shown?.key ?? "") === this.#keys.get(handle)) continue;
      // Near by, a part of the picture is made: what is beyond waits until it is made again.
      if (shown && !this.#isMade(drawing, shown.view)) continue;
      this.#keys.set(handle, shown?.key ?? "");
      await this.#show(handle, address, shown);
      return this.#wait();
    }
  }

  #isMade(drawing: Drawing, [x0, y0, x1, y1]: Box): boolean {
    const [left, top, right, bottom] = drawing.artboard;
    const [x, y, endX, endY] = this.#picture.viewport;
    const isAcross = x <= Math.max(x0, left) && endX >= Math.min(x1, right);
    return isAcross && y <= Math.max(y0, top) && endY >= Math.min(y1, bottom);
  }

  async #show(handle: Handle, address: Signal<string | null>, shown: Shown | null) {
    const before = address.peek();
    const size = [WIDTH * RATIO, HEIGHT * RATIO];
    const pixels = shown && this.#picture.small(shown.part.items, size, fitting(shown.view, size));
    const made = pixels ? await addressOf(pixels, size) : null;
    // Another drawing may have been opened in the meantime.
    if (this.#addresses.get(handle) !== address) return void (made && URL.revokeObjectURL(made));
    address.value = made;
    if (before) URL.revokeObjectURL(before);
  }

  #shownOf(drawing: Drawing, item: Item, part: Part): Shown {
    const versions = part.layers.map((layer) => this.#picture.version(layer));
    // A layer without opacity fills the plane.
    const isShape = part.layers.every((layer) => this.#picture.isShape(layer));
    const view = (isShape && curvesBox(item)) || drawing.artboard;
    return { part, view, key: JSON.stringify([versions, view, lookOf(part.items)]) };
  }

  #partsNow(drawing: Drawing): ReadonlyMap<Item, Part> | null {
    const { stack } = this.#picture;
    if (!stack) return null;
    const { serial } = this.#editor.engine.index;
    const of = [stack, drawing, drawing.revision, serial];
    if (this.#parts?.of.some((one, k) => one !== of[k]) ?? true)
      this.#parts = { of, parts: partsOf(this.#editor, stack) };
    return this.#parts!.parts;
  }

  /** Forgets the pictures of the previous drawing, because another drawing numbers its handles from the start. */
  #meet(drawing: Drawing) {
    if (drawing === this.#drawing) return;
    this.#drawing = drawing;
    for (const handle of [...this.#addresses.keys()]) this.#drop(handle);
  }

  #drop(handle: Handle) {
    const address = this.#addresses.get(handle)?.peek();
    if (address) URL.revokeObjectURL(address);
    this.#addresses.delete(handle);
    this.#keys.delete(handle);
  }
}

/** Around the curves within, with some room; null: there are none, or they have no extent. */
function curvesBox(item: Item): Box | null {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  const add = (one: Item) => {
    if (one.kind !== "curve" && one.kind !== "stroke") return one.children.forEach(add);
    for (const path of one.paths) {
      const box = mappedBox(one.artboardFromItem, boundsOf(path));
      [x0, y0] = [Math.min(x0, box[0]), Math.min(y0, box[1])];
      [x1, y1] = [Math.max(x1, box[2]), Math.max(y1, box[3])];
    }
  };
  add(item);
  const room = ROOM * Math.max(x1 - x0, y1 - y0);
  return room > 0 ? [x0 - room, y0 - room, x1 + room, y1 + room] : null;
}

/** All of a box in the middle of a picture. */
function fitting([x0, y0, x1, y1]: Box, [width, height]: readonly number[]): number[] {
  const scale = Math.min(width / (x1 - x0 || 1), height / (y1 - y0 || 1));
  const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
  return [scale, 0, 0, scale, width / 2 - scale * x, height / 2 - scale * y];
}
