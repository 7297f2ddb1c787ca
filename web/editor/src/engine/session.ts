// One instance of the module: a document, its picture, and what the page has of it. Runs in a
// worker, and in node for tests.
import { readExactLayer, type ExactLayer } from "../../../viewer/exact_fields.js";
import {
  loadSfumato,
  Table,
  type Sfumato,
  type SfumatoContext,
  type SfumatoDocument,
  type SfumatoField,
  type SfumatoPicture,
} from "../../../wasm/sfumato.mjs";
import {
  isAllNew,
  isChanged,
  layerStamp,
  layerUpdate,
  recentre,
  rowCounts,
  stampOf,
  type Origins,
  type RowCounts,
} from "./tables.js";
import { fittedCurves } from "./fit.js";
import type {
  EngineCurve,
  FileWish,
  FittedCurve,
  FitWish,
  GivenImage,
  ImportedSvg,
  LayerCurves,
  LayerUpdate,
  PhotoPixels,
  QuickChange,
  RasterWish,
  TraceRound,
  TraceWish,
  RegionOperation,
  WrittenFile,
} from "./types.js";

/** Drags begin at once in the layers that were dragged last, up to this many triangles in all: 1 kB each. */
const DRAG_TRIANGLES = 8_000;

/** How fine a picture is to be: `sfumato_solve`'s options. */
export type SolveOptions = Readonly<Record<string, string | number>>;

export type Way =
  /** The picture that `sfumato render` draws. */
  | { readonly kind: "exact" }
  /** To look at while something moves: of one curve in this time, of more roughly. */
  | { readonly kind: "quick"; readonly seconds: number };

export interface SolveWish {
  readonly way: Way;
  readonly options: SolveOptions;
  /** The stamp of each layer that the page shows. */
  readonly have: readonly string[];
  /** That of the stack. */
  readonly haveStack: string;
}

export interface Solved {
  /** As web/viewer's readStack() takes them; null: the page has them. */
  readonly stack: Uint8Array | null;
  readonly stackStamp: string;
  readonly stamps: readonly string[];
  readonly layers: readonly LayerUpdate[];
  /** Values that wait for time: solve again, with the same text, goes on. */
  readonly waiting: number;
  /** Triangles of the layers that an exact picture would solve again; infinite before the first one. */
  readonly unsettled: number;
  /** Triangles of the layer that has the most. */
  readonly largest: number;
  readonly milliseconds: number;
}

export interface ReadResult {
  readonly curves: readonly EngineCurve[];
  readonly warnings: readonly string[];
}

/** Tables that show one document, and the stamps by which the page knows what it has. */
class Shown {
  readonly origins: Origins = new Map();
  stamps: string[] = [];
  rows: RowCounts[] = [];
  /** The last exact picture; null: there was none. */
  #exact: { readonly stamps: ReadonlySet<string>; readonly triangles: readonly number[] } | null = null;
  constructor(
    readonly picture: SfumatoPicture,
    readonly key: string,
  ) {}

  markExact(): void {
    const triangles = this.stamps.map((_, layer) => this.triangles(layer));
    this.#exact = { stamps: new Set(this.stamps), triangles };
  }

  /** The same as in Solved: a rough picture of a layer has fewer than its final one. */
  get unsettled(): number {
    const exact = this.#exact;
    if (!exact) return Infinity;
    const costs = this.stamps.map((stamp, layer) =>
      exact.stamps.has(stamp) ? 0 : Math.max(exact.triangles[layer] ?? 0, this.triangles(layer)),
    );
    return costs.reduce((sum, cost) => sum + cost, 0);
  }

  get largest(): number {
    return Math.max(0, ...this.stamps.map((_, layer) => this.triangles(layer)));
  }

  triangles(layer: number): number {
    return this.picture.tableView(layer, Table.triangles).rows;
  }
}

export class Session {
  #context: SfumatoContext;
  #document: SfumatoDocument | null = null;
  #shown: Shown | null = null;
  #fields = new Map<number, SfumatoField>();
  #images = new Map<string, Uint8Array>();
  /** The stack of the present document; null: not made yet. */
  #stack: { readonly bytes: Uint8Array; readonly stamp: string } | null = null;
  #serial = 0;
  readonly #name: string;
  /** Version of the library. */
  readonly version: string;

  private constructor(sfumato: Sfumato, name: string) {
    this.version = sfumato.version ?? "";
    this.#context = sfumato.context({ "max-memory": 3000 });
    this.#name = name;
  }

  /** @param name distinguishes this instance's stamps from others' */
  static async start(module: WebAssembly.Module | BufferSource, name: string): Promise<Session> {
    return new Session(await loadSfumato(module), name);
  }

  addImages(images: readonly GivenImage[]): void {
    for (const { href, bytes, pixels } of images) {
      this.#context.addImage(bytes, pixels);
      this.#images.set(href, bytes);
    }
  }

  /** Takes a text; the picture is that of the text before until it is solved. @throws SfumatoError */
  read(text: string): ReadResult {
    const load = (href: string) => this.#images.get(href) ?? null;
    const next = this.#context.read(text, { load });
    this.#document?.free();
    this.#document = next;
    this.#stack = null;
    this.#dropFields();
    return { curves: curvesOf(next, text), warnings: this.#context.warnings };
  }

  /** Changes curves without a text. @throws SfumatoError; the document is as before then */
  change(changes: readonly QuickChange[]): void {
    const document = this.#read();
    this.#dropFields();
    for (const change of changes) {
      const { layer, curve } = change;
      if (change.kind === "points") {
        document.setPoints(layer, curve, change.xy);
      } else {
        const { side, attribute, space, rows } = change;
        document.setStops(layer, curve, side, attribute, { kind: 2, space, rows });
      }
    }
  }

  /** Points of a curve, in the frame of its layer. */
  points(layer: number, curve: number): Float64Array {
    return this.#read().points(layer, curve) as Float64Array;
  }

  solve({ way, options, have, haveStack }: SolveWish): Solved {
    const began = performance.now();
    const shown = this.#solved(way, options);
    const isExact = way.kind === "exact";
    const layers = this.#stamp(shown, isExact, have);
    if (isExact) shown.markExact();
    const milliseconds = performance.now() - began;
    const waiting = isExact ? 0 : shown.picture.statistics.waitingNodes;
    this.#stack ??= this.#stackOf(shown.picture);
    const { bytes, stamp } = this.#stack;
    const stack = stamp === haveStack ? null : bytes;
    const { unsettled, largest } = shown;
    const stamps = [...shown.stamps];
    return { stack, stackStamp: stamp, stamps, layers, waiting, unsettled, largest, milliseconds };
  }

  #solved(way: Way, options: SolveOptions): Shown {
    const document = this.#read();
    const key = JSON.stringify(options);
    if (this.#shown?.key !== key) {
      this.#shown?.picture.free();
      this.#shown = null;
      this.#shown = new Shown(this.#begun(way, options), key);
    }
    const quick = way.kind === "quick" ? { seconds: way.seconds } : {};
    this.#context.solveAgain(document, this.#shown.picture, quick);
    return this.#shown;
  }

  /** A picture to go on from: for a quick one that of an empty drawing, so that all is rough. */
  #begun(way: Way, options: SolveOptions): SfumatoPicture {
    const solving = { ...options, "drag-triangles": DRAG_TRIANGLES };
    if (way.kind === "exact") return this.#context.solve(this.#read(), solving);
    const empty = this.#context.newDocument({ artboard: this.#read().artboard.join(",") });
    try {
      return this.#context.solve(empty, solving);
    } finally {
      empty.free();
    }
  }

  /** Returns the parts of a new picture that the page lacks. */
  #stamp(shown: Shown, isExact: boolean, have: readonly string[]): LayerUpdate[] {
    const { picture, stamps, rows, origins } = shown;
    const updates: LayerUpdate[] = [];
    stamps.length = picture.layerCount;
    for (let layer = 0; layer < picture.layerCount; ++layer) {
      const before = stamps[layer];
      if (before === undefined || isChanged(picture, layer, rows[layer])) {
        // A layer that has only moved in the stack is known by its content.
        const isOther = isExact || isAllNew(picture, layer);
        if (isOther) recentre(picture, layer, origins);
        stamps[layer] = isOther ? layerStamp(picture, layer) : `${this.#name}.${++this.#serial}`;
        rows[layer] = rowCounts(picture, layer);
      }
      if (have[layer] === stamps[layer]) continue;
      // The page keeps exact layers for undo.
      const isWhole = isExact || before === undefined || have[layer] !== before || !origins.has(layer);
      updates.push(layerUpdate(picture, layer, isWhole, origins));
    }
    return updates;
  }

  /** The curves that are to be dragged next, of a picture that is exact. */
  expect({ layer, curves }: LayerCurves): void {
    if (this.#shown) this.#context.expectDrag(this.#shown.picture, layer, curves);
  }

  /** A layer of the last picture as rays meet it; null: it has no curves that exact pixels can be gathered from. */
  exactLayer(layer: number): ExactLayer | null {
    const picture = this.#shown?.picture;
    if (!picture || layer >= picture.layerCount) return null;
    const hasOpacity = picture.tableView(layer, Table.opacityNodes).rows > 0;
    return readExactLayer(this.#context.exactLayer(picture, layer) as Uint8Array, hasOpacity);
  }

  #stackOf(picture: SfumatoPicture) {
    const bytes = this.#context.pictureStack(picture) as Uint8Array;
    return { bytes, stamp: stampOf([bytes]) };
  }

  /** Red, green, blue, opacity of points of a layer's frame. */
  colors(layer: number, xy: Float64Array): Float32Array {
    let field = this.#fields.get(layer);
    if (!field) {
      field = this.#context.field(this.#read(), layer) as SfumatoField;
      this.#fields.set(layer, field);
    }
    return field.colors(xy);
  }

  /** The pixels that the command draws. */
  raster({ width, height, viewport, background, depth, isDraft }: RasterWish): Uint8ClampedArray | Uint16Array {
    const options: Record<string, string | number> = { width, height };
    if (depth === 16) options["max-error"] = 0.25;
    else if (isDraft) options["max-error"] = "off";
    if (viewport) {
      const [x0, y0, x1, y1] = viewport;
      options.viewport = [x0, y0, x1 - x0, y1 - y0].join(",");
    }
    const picture = this.#context.solve(this.#read(), options);
    try {
      const format = depth === 16 ? "rgba16" : "rgba8";
      // As the command does: 8 bits show bands in a smooth picture that is not dithered.
      const shown = { dither: depth === 8, ...(background ? { background } : {}) };
      return this.#context.raster(picture, { width, height, format }, shown);
    } finally {
      picture.free();
    }
  }

  /** Returns the picture for the HTML viewer: fine enough to be enlarged, as the command makes it. */
  payload(): Uint8Array {
    const picture = this.#context.solve(this.#read(), { detail: 2 });
    try {
      const exact = Array.from({ length: picture.layerCount }, (_, layer) => this.#context.exactLayer(picture, layer));
      // One version for all of them.
      const parts = exact.map((bytes: Uint8Array, i) => bytes.subarray(i === 0 ? 0 : 1));
      return joined([this.#context.viewerPayload(picture) as Uint8Array, ...parts]);
    } finally {
      picture.free();
    }
  }

  /** Returns the bytes that the command writes. @throws SfumatoError */
  write({ format, viewport, options, detail }: FileWish): WrittenFile {
    const [x0, y0, x1, y1] = viewport;
    const document = this.#read();
    const picture = this.#context.solve(document, {
      ...(isSameBox(viewport, document.artboard) ? {} : { viewport: [x0, y0, x1 - x0, y1 - y0].join(",") }),
      ...(detail === 1 ? {} : { detail }),
    });
    try {
      const bytes = this.#context.export(picture, format, options) as Uint8Array<ArrayBuffer>;
      return { bytes, warnings: this.#context.warnings };
    } finally {
      picture.free();
    }
  }

  lint(): LintReport {
    return this.#context.lint(this.#read()) as LintReport;
  }

  /** Orzan's XML, or SVG, as SVG. */
  convert(text: string): string {
    const document = this.#context.read(text) as SfumatoDocument;
    try {
      return document.write();
    } finally {
      document.free();
    }
  }

  /** See Engine.combinePaths. @throws SfumatoError */
  combinePaths(operation: RegionOperation, [first, ...rest]: readonly string[], tolerance: number): string {
    const add = (whole: string, path: string) =>
      this.#context.combinePaths(operation, whole, path, tolerance) as string;
    return rest.reduce(add, first);
  }

  /**
   * The shapes of an ordinary SVG as curves (docs/import.md).
   * @param heard is called with the share that is done, each time a hundredth more is
   * @throws SfumatoError
   */
  importSvg(text: string, heard: (share: number) => void): ImportedSvg {
    const context = this.#context;
    const load = (href: string) => this.#images.get(href) ?? null;
    let last = 0;
    context.onProgress = (stage: string, share: number) => {
      if (stage === "import" && share >= last + 0.01) heard((last = share));
    };
    try {
      const document = context.importSvg(text, { load }) as SfumatoDocument;
      const { warnings } = context;
      const made = document.write() as string;
      document.free();
      return { text: made, warnings };
    } finally {
      context.onProgress = null;
    }
  }

  /**
   * The curves of a text with the colours, or the blur, of a photo.
   * @throws SfumatoError
   */
  fit(wish: FitWish): readonly FittedCurve[] {
    const { curves } = this.read(wish.text);
    const draw = (asked: RasterWish) => this.raster(asked) as PhotoPixels["data"];
    return fittedCurves(this.#context, this.#read(), curves, wish, draw);
  }

  /**
   * Returns a picture traced to SVG. Reports its progress, and the SVG so far, after each round.
   * @throws SfumatoError
   */
  trace({ photo, options }: TraceWish, told: (round: TraceRound) => void): string {
    const drawing = this.#context.trace(photo, { ...options }, (state, reached) =>
      told({ ...state, text: reached.write() }),
    );
    try {
      return drawing.write();
    } finally {
      drawing.free();
    }
  }

  #read(): SfumatoDocument {
    if (!this.#document) throw new Error("no document was read");
    return this.#document;
  }

  #dropFields() {
    for (const field of this.#fields.values()) field.free();
    this.#fields.clear();
  }
}

/** Whether a box is that of a position and a size. */
const isSameBox = ([x0, y0, x1, y1]: readonly number[], [x, y, width, height]: Iterable<number>) =>
  x0 === x && y0 === y && x1 === x + width && y1 === y + height;

function joined(parts: readonly Uint8Array[]): Uint8Array {
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** As `sfumato lint --json` prints it. */
export interface LintReport {
  readonly hints: readonly Readonly<Record<string, unknown>>[];
}

/** Byte offsets of UTF-8 text as places in the text. */
function placesOf(text: string): (byteOffset: number) => number {
  // Where all is ASCII a byte is a place.
  const bytes = new TextEncoder().encode(text);
  if (bytes.length === text.length) return (offset) => offset;
  const places = new Uint32Array(bytes.length + 1);
  let at = 0;
  for (let i = 0; i < bytes.length; ++i) {
    const isLead = (bytes[i] & 0xc0) !== 0x80;
    places[i] = at;
    if (isLead) at += bytes[i] >= 0xf0 ? 2 : 1;
  }
  places[bytes.length] = at;
  return (offset) => places[offset];
}

function curvesOf(document: SfumatoDocument, text: string): EngineCurve[] {
  const place = placesOf(text);
  const curves: EngineCurve[] = [];
  for (let layer = 0; layer < document.layerCount; ++layer) {
    for (let curve = 0; curve < document.curveCount(layer); ++curve) {
      const source = document.curveSource(layer, curve);
      if (source) curves.push({ layer, curve, offset: place(source.byteOffset), subpath: source.subpath });
    }
  }
  return curves;
}
