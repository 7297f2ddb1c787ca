// Draws the picture into the stage's canvas: at once where something has changed, then finer, then
// not at all until something changes.
import { computed, effect, untracked } from "@preact/signals";
import { MovedFrame } from "../../../viewer/moved_frame.js";
import { makeTexels } from "../../../viewer/paints.js";
import { Renderer } from "../../../viewer/renderer.js";
import { SmallPictures } from "../../../viewer/small.js";
import type { Editor } from "../app/types.js";
import type { PictureUpdate } from "../engine/types.js";
import { ExactStage } from "./exact.js";
import { isSeenThrough } from "./photo.js";
import { Scene, type SceneChange } from "./scene.js";
import { isolatedStack, type StackItem } from "./stack-parts.js";
import { keepStill } from "./still.js";

/** How long the picture must rest before it is made finer, milliseconds. */
const REST = 150;
/** A context that is lost for longer is spoken of, milliseconds. */
const PATIENCE = 1000;

type Picture = NonNullable<Scene["picture"]>;
type Paints = Picture["paints"];

export interface PictureWords {
  /** WebGL 2 is missing. */
  readonly missing: string;
  /** The graphics were taken away. */
  readonly lost: string;
}

export class PictureCanvas {
  readonly #editor: Editor;
  readonly #words: PictureWords;
  readonly #scene = new Scene();
  #canvas: HTMLCanvasElement | null = null;
  #gl: WebGL2RenderingContext | null = null;
  #renderer: Renderer | null = null;
  #small: SmallPictures | null = null;
  /** How often each layer has changed. */
  readonly #versions: number[] = [];
  readonly #exact: ExactStage;
  /** Texels of the paints that are drawn; new ones take time, and updates wait for them. */
  #texels: { readonly paints: Paints; readonly texels: Uint16Array } | null = null;
  #queue: Promise<void> = Promise.resolve();
  /** The number of the text that the picture is of. */
  #serial = -1;
  /** Whether layers and paints belong together: while textures are decoded they do not. */
  #isWhole = true;
  #isDirty = false;
  /** Whether only the view has changed since the last frame. */
  #isOnlyMoved = false;
  #lastFrame: MovedFrame | null = null;
  #frame = 0;
  #changedAt = 0;
  /** Whether frames only make exact what is drawn. */
  #isDrawn = false;
  #waiting: (() => void)[] = [];
  #stop: () => void = () => {};

  constructor(editor: Editor, words: PictureWords) {
    this.#editor = editor;
    this.#words = words;
    this.#exact = new ExactStage(editor, this, () => this.#schedule());
  }

  /** Whether chequers or photos show where the picture is clear. */
  readonly #isClear = computed(() => isSeenThrough(this.#editor));

  /** The canvas to draw into, or none any more. */
  attach(canvas: HTMLCanvasElement | null): void {
    this.#stop();
    this.#small?.free();
    this.#renderer?.free();
    this.#renderer = this.#small = null;
    this.#canvas = canvas;
    if (!canvas) return;
    canvas.classList.add("picture");
    this.#lastFrame = new MovedFrame(canvas);
    this.#open(canvas);
    const stops = [effect(() => this.#watch()), effect(() => this.#watchView()), effect(() => this.#watchIsolation())];
    this.#stop = () => stops.forEach((stop) => stop());
  }

  #open(canvas: HTMLCanvasElement) {
    // Clear where the drawing is transparent or a photo lies below.
    const wish = { alpha: true, antialias: false, depth: false, stencil: false } as const;
    this.#gl = canvas.getContext("webgl2", wish) as WebGL2RenderingContext | null;
    if (!this.#gl) return this.#editor.say(this.#words.missing);
    canvas.addEventListener("webglcontextlost", (event) => this.#lose(event));
    canvas.addEventListener("webglcontextrestored", () => this.#build());
    this.#build();
  }

  #lose(event: Event) {
    event.preventDefault();
    this.#renderer = this.#small = null;
    setTimeout(() => {
      if (!this.#renderer) this.#editor.say(this.#words.lost);
    }, PATIENCE);
  }

  /** Rebuilds everything from the page's data. */
  #build() {
    if (!this.#gl || this.#gl.isContextLost() || !this.#scene.picture || !this.#texels) return;
    this.#renderer = new Renderer(this.#gl, this.#shownPicture(this.#scene.picture), this.#texels.texels);
    this.#exact.reset();
    this.change();
  }

  /** Reads the signals that a frame depends on, besides the picture and the view. */
  #watch() {
    const { opened, stage, showMesh, settings, tool } = this.#editor;
    void [opened.value, tool.value, this.#isClear.value, stage.value, showMesh.value, settings.surround.value, settings.theme.value, settings.exactPixels.value];
    this.change();
  }

  #watchView() {
    void this.#editor.view.value;
    const isOnlyMoved = !this.#isDirty || this.#isOnlyMoved;
    this.change();
    // The loupe of the sample tool reads the pixels under the pointer from a drawn frame.
    this.#isOnlyMoved = isOnlyMoved && this.#editor.tool.peek() !== "sample";
  }

  /** What is shown in its own colours, with all others faded; null: everything. The sample tool takes colours of all. */
  readonly #isolated = computed(() => {
    const { isolated, tool } = this.#editor;
    return isolated.value !== null && tool.value !== "sample" ? isolated.value : null;
  });

  /**
   * Fades the rest of the picture while an item is isolated. It also runs when the status changes, because the engine
   * may renumber the layers of the picture before it reports one.
   */
  #watchIsolation() {
    if (this.#isolated.value !== null) void this.#editor.status.value;
    untracked(() => this.#fitIsolation());
  }

  #fitIsolation() {
    const { picture } = this.#scene;
    if (!this.#renderer || !this.#isWhole || !picture) return;
    const shown = this.#shownPicture(picture);
    if (isSameList(this.#renderer.picture.stack, shown.stack)) return;
    this.#renderer.setPicture(shown, this.#texels!.texels);
    this.change();
  }

  #shownPicture(picture: Picture): Picture {
    const editor = this.#editor;
    const handle = this.#isolated.peek();
    const item = handle === null ? undefined : editor.drawing.item(handle);
    const stack = item && isolatedStack(editor, picture.stack, item);
    return stack ? { ...picture, stack } : picture;
  }

  take(update: PictureUpdate): void {
    // One behind the other: textures are decoded in the meantime.
    this.#queue = this.#queue.then(() => this.#take(update)).catch((error: Error) => this.#editor.say(error.message));
  }

  async #take(update: PictureUpdate): Promise<void> {
    this.#isWhole = false;
    const change = this.#scene.take(update);
    for (const { layer } of update.layers) this.#versions[layer] = (this.#versions[layer] ?? 0) + 1;
    const { picture } = this.#scene;
    if (!picture || !this.#gl) return;
    const isNew = !this.#texels || !samePaints(this.#texels.paints, picture.paints);
    if (isNew) this.#texels = { paints: picture.paints, texels: await this.#texelsOf(this.#gl, picture.paints) };
    this.#isWhole = true;
    this.#serial = update.serial;
    this.#follow(change);
  }

  /** Without textures at once: a frame in between would show other paints' weights. */
  async #texelsOf(gl: WebGL2RenderingContext, paints: Paints): Promise<Uint16Array> {
    return paints.texelCount === 0 ? new Uint16Array() : makeTexels(gl, paints);
  }

  #follow({ isOther, layers }: SceneChange) {
    const { picture } = this.#scene;
    if (!this.#renderer) return this.#build();
    if (isOther || layers.length > 0) this.#renderer.setExact(null);
    if (isOther) this.#renderer.setPicture(this.#shownPicture(picture!), this.#texels!.texels);
    for (const { layer, change } of layers) this.#renderer.updateLayer(layer, change);
    this.change();
  }

  /** Something is to be seen that was not drawn yet. */
  change(): void {
    this.#isDirty = true;
    this.#isOnlyMoved = false;
    this.#isDrawn = false;
    this.#changedAt = performance.now();
    this.#exact.leave();
    this.#schedule();
  }

  #schedule() {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#tick());
  }

  #tick() {
    this.#frame = 0;
    const renderer = this.#renderer;
    // Without graphics there is nothing to wait for; what comes makes a frame itself.
    if (!renderer || !this.#isWhole) return this.#settle();
    const isBusy = renderer.isBusy;
    if (!isBusy) this.#lastFrame?.finish();
    const isMoved = this.#isOnlyMoved && this.#lastFrame?.standsIn(this.#changedAt);
    if (isMoved) this.#lastFrame?.move(this.#editor.stageFromArtboard());
    // More work would only pile up behind unfinished work of the GPU.
    if (isBusy || isMoved) return this.#schedule();
    if (!this.#isOurs) return this.#showNothing();
    if (this.#isDirty) {
      this.#isDirty = this.#isOnlyMoved = false;
      renderer.draw(this.#frameOf());
      this.#lastFrame?.begin(this.#editor.stageFromArtboard());
      this.#keep();
    } else if (!renderer.canRefine) {
      this.#settle();
      this.#isDrawn = true;
      if (!this.#exact.step(renderer, () => this.#frameOf())) return;
    } else if (performance.now() - this.#changedAt > REST) {
      renderer.refine(this.#frameOf());
      this.#keep();
    }
    this.#schedule();
  }

  /** Whether the picture is of the drawing that is open. */
  get #isOurs(): boolean {
    return this.#serial >= this.#editor.opened.peek();
  }

  #showNothing() {
    const gl = this.#gl!;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.disable(gl.SCISSOR_TEST);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    this.#keep();
    this.#isDrawn = true;
    this.#settle();
  }

  /** A copy for the loupe, of the tool that has one. */
  #keep() {
    if (this.#editor.tool.peek() === "sample") keepStill(this.#editor, this.#canvas!);
  }

  #settle() {
    for (const resolve of this.#waiting.splice(0)) resolve();
  }

  #frameOf() {
    const canvas = this.#canvas!;
    const { width, height } = this.#editor.stage.peek();
    const ratio = devicePixelRatio || 1;
    const size = [width, height].map((length) => Math.max(1, Math.round(length * ratio)));
    if (canvas.width !== size[0]) canvas.width = size[0];
    if (canvas.height !== size[1]) canvas.height = size[1];
    const map = this.#editor.stageFromArtboard();
    const pixelFromArtboard = map.map((value) => value * ratio);
    return { size, pixelFromArtboard, desk: deskOf(canvas), mesh: this.#editor.showMesh.peek(), lineScale: ratio, isClear: this.#isClear.peek() };
  }

  // Small pictures of parts.

  /** The stack of the picture that is drawn; null: there is none. */
  get stack(): readonly StackItem[] | null {
    return (this.#renderer && this.#isWhole && this.#isOurs && this.#scene.picture?.stack) || null;
  }

  /** Whether frames remain to be drawn or textures to be decoded. Exact pixels do not count. */
  get isDrawing(): boolean {
    return (this.#frame !== 0 && !this.#isDrawn) || !this.#isWhole;
  }

  /** The part of the artboard that the picture was made for. */
  get viewport(): readonly number[] {
    return this.#scene.picture?.viewport ?? [0, 0, 0, 0];
  }

  get layerCount(): number {
    return this.#scene.picture?.layers.length ?? 0;
  }

  get changedAt(): number {
    return this.#changedAt;
  }

  /** A number that grows with each change of a layer. */
  version(layer: number): number {
    return this.#versions[layer] ?? 0;
  }

  /** Whether a layer has an opacity: else it fills the plane. */
  isShape(layer: number): boolean {
    return (this.#scene.picture?.layers[layer]?.opacity ?? null) !== null;
  }

  /** Draws only these items of the stack, on nothing; null while nothing can be drawn. */
  small(items: StackItem[], size: number[], pixelFromArtboard: number[]): Uint8ClampedArray<ArrayBuffer> | null {
    if (!this.#renderer || !this.stack) return null;
    this.#small ??= new SmallPictures(this.#renderer);
    return this.#small.draw(items, size, pixelFromArtboard);
  }

  /** Draws the artboard small, on nothing; null while nothing can be drawn, or only a part of it was made. */
  whole(size: number[]): Uint8ClampedArray<ArrayBuffer> | null {
    const { stack, viewport } = this;
    const [x0, y0, x1, y1] = untracked(() => this.#editor.drawing).artboard;
    const isMade = viewport[0] <= x0 && viewport[1] <= y0 && viewport[2] >= x1 && viewport[3] >= y1;
    if (!stack || !isMade) return null;
    const [across, along] = [size[0] / (x1 - x0), size[1] / (y1 - y0)];
    return this.small([...stack], size, [across, 0, 0, along, -x0 * across, -y0 * along]);
  }

  /** When the last picture that was taken is drawn as fine as it gets. */
  async drawn(): Promise<void> {
    await this.#queue;
    await new Promise<void>((resolve) => {
      this.#waiting.push(resolve);
      this.#schedule();
    });
  }
}

/** The grey around the artboard. */
function deskOf(canvas: HTMLCanvasElement): number[] {
  const text = getComputedStyle(canvas.parentElement!).backgroundColor;
  return (text.match(/[\d.]+/g) ?? ["119", "119", "119"]).slice(0, 3).map((value) => Number(value) / 255);
}

function samePaints(a: Paints, b: Paints): boolean {
  const isSame = a.texelCount === b.texelCount && a.paint.length === b.paint.length && isSameList(a.table, b.table);
  return isSame && a.paint.every(({ file }, i) => file?.bytes.length === b.paint[i].file?.bytes.length && isSameList(file?.bytes ?? [], b.paint[i].file?.bytes ?? []));
}

function isSameList<T>(a: ArrayLike<T>, b: ArrayLike<T>): boolean {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; ++i) if (a[i] !== b[i]) return false;
  return true;
}
