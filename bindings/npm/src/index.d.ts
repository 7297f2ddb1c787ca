/**
 * Sfumato: diffusion curves, exact and at any size. docs/npm.md of the repository is the guide.
 *
 * Pictures, documents and contexts live in the module's memory: `free()` or `using` gives them back at once,
 * the collector at some time.
 */

/** Options by the long names of the command, also in camel case: `{ maxError: 1 }`; or `"max-error=1"`. */
export type Options = string | Readonly<Record<string, string | number | boolean | null | undefined>> | null;

/** Codes of errors. */
export const Status: Readonly<{
  ok: 0;
  badInput: 1;
  limit: 2;
  cancelled: 3;
  io: 4;
  outOfMemory: 5;
  unavailable: 6;
  internal: 7;
  badUsage: 8;
}>;

/** Why a call failed; wrong types are a TypeError, sizes that are none a RangeError. */
export class SfumatoError extends Error {
  constructor(
    code: number,
    reason: string,
    place?: { file?: string; line?: number; column?: number },
    options?: ErrorOptions,
  );
  name: "SfumatoError";
  /** Of `Status`. */
  code: number;
  /** The message without its place. */
  reason: string;
  /** The name of the document; "" where unknown. */
  file: string;
  /** From 1; 0 where unknown. */
  line: number;
  /** From 1, in bytes; 0 where unknown. */
  column: number;
}

export const Side: Readonly<{ left: 0; right: 1 }>;
export const Attribute: Readonly<{ color: 0; opacity: 1; blur: 2 }>;
/** What a side bears: nothing, nothing but an end, stops, or a paint. */
export const Kind: Readonly<{ open: 0; barrier: 1; stops: 2; paint: 3 }>;
/** What offsets of stops count. */
export const Space: Readonly<{ arcLength: 0; parameter: 1 }>;
/** Tables of a solved layer. */
export const Table: Readonly<{
  vertices: 0;
  triangles: 1;
  curveEdges: 2;
  colorNodes: 3;
  colorValues: 4;
  opacityNodes: 5;
  opacityValues: 6;
}>;

/** Pixels as ImageData has them: rows from the top, red, green, blue, alpha, not premultiplied. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray | Uint8Array;
}

/** What a side of a curve bears; a row is [offset, red, green, blue] or [offset, value]. */
export interface Stops {
  kind: number;
  space?: number;
  rows?: readonly (readonly number[])[];
}

export interface Box extends Array<number> {
  0: number;
  1: number;
  2: number;
  3: number;
}

export interface DataTable {
  rows: number;
  columns: number;
  data: Uint8Array | Uint32Array | Float32Array | Float64Array;
}

export interface Hint {
  rule: string;
  message: string;
  [more: string]: unknown;
}

interface Handle {
  /** Gives it back; a second time does nothing. Any other use afterwards is a SfumatoError. */
  free(): void;
}

/** Diffusion curves as their author drew them. */
export class SfumatoDocument implements Handle {
  private constructor();
  free(): void;
  copy(): SfumatoDocument;
  /** @param options width, scale, maxError, viewport, … */
  solve(options?: Options): SfumatoPicture;
  /** The document as SVG. */
  write(): string;
  /** x, y, width, height */
  readonly artboard: Box;
  readonly layerCount: number;
  curveCount(layer: number): number;
  layerId(layer: number): string | null;
  curveId(layer: number, curve: number): string | null;
  /** Where a curve stands in the text that was read. */
  curveSource(layer: number, curve: number): { byteOffset: number; subpath: number } | null;
  /** 3 n + 1 control points, x and y in turn. */
  points(layer: number, curve: number): Float64Array;
  setPoints(layer: number, curve: number, xy: ArrayLike<number>): void;
  /** Before curve `at` or, with null, as the last. */
  insertCurve(layer: number, at: number | null, xy: ArrayLike<number>): void;
  removeCurve(layer: number, curve: number): void;
  weight(layer: number, curve: number): number;
  setWeight(layer: number, curve: number, weight: number): void;
  stops(layer: number, curve: number, side: number, attribute: number): Required<Stops>;
  setStops(layer: number, curve: number, side: number, attribute: number, stops: Stops): void;
}

/** The formats that `export` makes without further codecs. */
export type Format = "png" | "svg" | "pdf" | "eps" | "glb" | "html" | "sfv" | "npz" | "ply" | "json";

/** A solved document, of no resolution. */
export class SfumatoPicture implements Handle {
  private constructor();
  free(): void;
  /** x, y, width, height */
  readonly viewport: Box;
  readonly layerCount: number;
  /**
   * Pixels of the width or the height that is given, the other to fit; of a pixel to a unit where none is.
   * Other options are those of sfumato_raster: background, …
   */
  raster(options?: {
    width?: number | undefined;
    height?: number | undefined;
    [option: string]: string | number | boolean | undefined;
  }): { width: number; height: number; data: Uint8ClampedArray<ArrayBuffer> };
  /** A file. @param options width, height, title, dpi, svgMode, … */
  export(format: Format, options?: Options): Uint8Array<ArrayBuffer>;
  /** What `<sfumato-picture>` shows without solving anything. */
  viewerPayload(options?: Options): Uint8Array<ArrayBuffer>;
  table(layer: number, table: number): DataTable;
  /** The same without a copy: good until the next call of anything of the module. */
  tableView(layer: number, table: number): DataTable;
  changes(layer: number, table: number): [number, number][];
  readonly statistics: Record<
    | "curves"
    | "segments"
    | "triangles"
    | "vertices"
    | "nodes"
    | "geometrySeconds"
    | "triangulationSeconds"
    | "gatherSeconds"
    | "waitingNodes"
    | "keptLayers"
    | "continuedLayers"
    | "begunLayers",
    number
  >;
}

/** Exact colours of one layer at points. */
export class SfumatoField implements Handle {
  private constructor();
  free(): void;
  /** Red, green, blue, opacity of each point. @param xy pairs, in the frame of the layer */
  colors(xy: ArrayLike<number>): Float32Array;
}

/** Brings the files that a document names; null: it does not. */
export type Loader = (href: string) => Uint8Array | null;

/** Bounds on memory and time; reads, solves and draws. */
export class SfumatoContext implements Handle {
  private constructor();
  free(): void;
  /** Called with a word and a fraction from 0 to 1 while a call works; it may call cancel(). */
  onProgress: ((stage: string, fraction: number) => void) | null;
  /** Of the last read(). */
  readonly warnings: string[];
  read(text: string | Uint8Array, from?: { name?: string; load?: Loader | null }): SfumatoDocument;
  newDocument(options: Options): SfumatoDocument;
  /** Hands in the pixels of an image file that a document names or holds; null forgets them. */
  addImage(file: Uint8Array, image: Pixels | null): void;
  solve(document: SfumatoDocument, options?: Options): SfumatoPicture;
  /** Makes a picture that of a document which has changed. */
  solveAgain(
    document: SfumatoDocument,
    picture: SfumatoPicture,
    way?: { quick?: boolean; seconds?: number | undefined },
  ): void;
  /** Makes a picture, solved with `coherent`, that of the next frame of a film: nothing flickers where nothing moves. */
  solveNext(document: SfumatoDocument, picture: SfumatoPicture): void;
  expectDrag(picture: SfumatoPicture, layer: number, curve: number): void;
  raster(
    picture: SfumatoPicture,
    image: { width: number; height: number; format?: "rgb8" | "rgba8" },
    options?: Options,
  ): Uint8ClampedArray<ArrayBuffer>;
  raster(
    picture: SfumatoPicture,
    image: { width: number; height: number; format: "rgb16" | "rgba16" },
    options?: Options,
  ): Uint16Array<ArrayBuffer>;
  export(picture: SfumatoPicture, format: Format, options?: Options): Uint8Array<ArrayBuffer>;
  /** The picture itself as a file, which `sfumato render` draws, too. */
  writePicture(picture: SfumatoPicture): Uint8Array<ArrayBuffer>;
  /** A picture of such a file. It follows no document. */
  readPicture(bytes: Uint8Array): SfumatoPicture;
  viewerPayload(picture: SfumatoPicture, options?: Options): Uint8Array<ArrayBuffer>;
  pictureStack(picture: SfumatoPicture, options?: Options): Uint8Array<ArrayBuffer>;
  /** What exact pixels of a layer are gathered from, of a picture that was solved. */
  exactLayer(picture: SfumatoPicture, layer: number): Uint8Array<ArrayBuffer>;
  /** Probable mistakes. */
  lint(document: SfumatoDocument, options?: Options): { file: string; hints: Hint[]; hint_count: number };
  field(document: SfumatoDocument, layer: number, options?: Options): SfumatoField;
  cancel(): void;
  resume(): void;
}

/** The module. One instance computes one thing at a time. */
export class Sfumato {
  private constructor();
  readonly version: string;
  readonly abi: number;
  /** Whether a trap, likely out of memory, has ended it; `load()` then loads another. */
  readonly isBroken: boolean;
  /** Of the module, which grow and never shrink. */
  readonly memoryBytes: number;
  /** @param options maxMemory (MiB), maxTime (seconds), … */
  context(options?: Options): SfumatoContext;
}

/**
 * The module that `read` and `create` use, loaded once.
 * @param source bytes, a module or an address, where sfumato.wasm does not lie beside the script
 */
export function load(source?: BufferSource | WebAssembly.Module | string | URL): Promise<Sfumato>;

/**
 * Reads SVG or Orzan's XML.
 * @param from `name` is for messages; `load` brings files that the drawing names. In pages `base` is its
 *   address: pictures that it names are fetched from there, and decoded, before it is read.
 */
export function read(
  text: string | Uint8Array,
  from?: { name?: string; load?: Loader | null; base?: string | URL | undefined },
): Promise<SfumatoDocument>;

/** An empty document. @param options background, interpolation */
export function create(
  width: number,
  height: number,
  options?: Readonly<Record<string, string | number | boolean | undefined>>,
): Promise<SfumatoDocument>;
