/**
 * Sfumato: diffusion curves, exact and at any size. See docs/npm.md in the repository for the guide.
 *
 * Pictures, documents and contexts use memory of the WebAssembly module. `free()` or `using` releases it at once;
 * otherwise garbage collection releases it later.
 */

declare global {
  // For `using`, also in projects whose "lib" has no "esnext.disposable".
  interface SymbolConstructor {
    readonly dispose: unique symbol;
  }
}

/** An address: a URL, or anything else with `href`. */
export interface Address {
  readonly href: string;
}

/** A file, such as a Blob. */
export interface Readable {
  arrayBuffer(): Promise<ArrayBuffer>;
}

/** A drawing: its text, or its bytes. */
export type Drawing = string | ArrayBuffer | ArrayBufferView | Readable;

/** Options by the long names of the command, also in camel case: `{ maxError: 1 }` or `"max-error=1"`. */
export type Options = string | Readonly<Record<string, string | number | boolean | null | undefined>> | null;

/** Error codes. */
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

/** Explains why a call failed. Values of a wrong type throw a TypeError, invalid sizes a RangeError. */
export class SfumatoError extends Error {
  constructor(
    code: number,
    reason: string,
    place?: { file?: string; line?: number; column?: number },
    options?: ErrorOptions,
  );
  name: "SfumatoError";
  /** One of `Status`. */
  code: number;
  /** The message without its place. */
  reason: string;
  /** The name of the document; "" if unknown. */
  file: string;
  /** The line, counted from 1; 0 if unknown. */
  line: number;
  /** The column in bytes, counted from 1; 0 if unknown. */
  column: number;
}

export const Side: Readonly<{ left: 0; right: 1 }>;
export const Attribute: Readonly<{ color: 0; opacity: 1; blur: 2 }>;
/** The kinds of a side: open (rays pass), barrier (rays end and get no colour), colour stops, or a paint. */
export const Kind: Readonly<{ open: 0; barrier: 1; stops: 2; paint: 3 }>;
/** The unit of stop offsets: share of the arc length, or Bézier parameter. */
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

/** Pixels in the layout of ImageData: rows from the top; red, green, blue, alpha, not premultiplied. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray | Uint8Array;
}

/** The stops of one side of a curve. A row is [offset, red, green, blue] or [offset, value]. */
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
  /** Releases the memory. A second call does nothing; any other use afterwards throws a SfumatoError. */
  free(): void;
  /** The same, for `using`. */
  [Symbol.dispose](): void;
}

/** Diffusion curves as their author drew them. */
export class SfumatoDocument implements Handle {
  private constructor();
  free(): void;
  [Symbol.dispose](): void;
  /** The content that the reader ignored, and probable mistakes, one message each; empty for a document from `create`. */
  readonly warnings: readonly string[];
  copy(): SfumatoDocument;
  /** Solves the drawing. @param options width, scale, maxError, viewport, … */
  solve(options?: Options): SfumatoPicture;
  /** Returns the document as SVG. */
  write(): string;
  /** x, y, width, height */
  readonly artboard: Box;
  readonly layerCount: number;
  curveCount(layer: number): number;
  layerId(layer: number): string | null;
  curveId(layer: number, curve: number): string | null;
  /** Returns the place of a curve in the text that was read; null if unknown. */
  curveSource(layer: number, curve: number): { byteOffset: number; subpath: number } | null;
  /** Returns the 3 n + 1 control points of a curve with n pieces, as alternating x and y. */
  points(layer: number, curve: number): Float64Array;
  setPoints(layer: number, curve: number, xy: ArrayLike<number>): void;
  /** Inserts a curve before curve `at`; with null, adds it as the last curve. */
  insertCurve(layer: number, at: number | null, xy: ArrayLike<number>): void;
  removeCurve(layer: number, curve: number): void;
  weight(layer: number, curve: number): number;
  setWeight(layer: number, curve: number, weight: number): void;
  stops(layer: number, curve: number, side: number, attribute: number): Required<Stops>;
  setStops(layer: number, curve: number, side: number, attribute: number, stops: Stops): void;
}

/** The formats that `export` writes without further codecs. */
export type Format = "png" | "svg" | "pdf" | "eps" | "glb" | "html" | "sfv" | "npz" | "ply" | "json";

/** A solved document, which has no resolution. */
export class SfumatoPicture implements Handle {
  private constructor();
  free(): void;
  [Symbol.dispose](): void;
  /** x, y, width, height */
  readonly viewport: Box;
  readonly layerCount: number;
  /**
   * Renders pixels. Give the width or the height, and the other one follows; without both, a user unit is one
   * pixel. Other options are as for sfumato_raster: background, …
   */
  raster(options?: {
    width?: number | undefined;
    height?: number | undefined;
    [option: string]: string | number | boolean | undefined;
  }): { width: number; height: number; data: Uint8ClampedArray<ArrayBuffer> };
  /** Returns a file. @param options width, height, title, dpi, svgMode, … */
  export(format: Format, options?: Options): Uint8Array<ArrayBuffer>;
  /** Returns data that `<sfumato-picture>` shows without solving. */
  viewerPayload(options?: Options): Uint8Array<ArrayBuffer>;
  table(layer: number, table: number): DataTable;
  /** The same without a copy. The view is valid until the next call of any function of the module. */
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
  [Symbol.dispose](): void;
  /** Returns red, green, blue and opacity of each point. @param xy pairs, in the frame of the layer */
  colors(xy: ArrayLike<number>): Float32Array;
}

/** Returns the bytes of a file that a document names; null if there is no such file. */
export type Loader = (href: string) => Uint8Array | null;

/** Limits on memory and time, and the functions that read, solve and draw. */
export class SfumatoContext implements Handle {
  private constructor();
  free(): void;
  [Symbol.dispose](): void;
  /** Called while a call works, with the name of a stage and a fraction from 0 to 1. It may call cancel(). */
  onProgress: ((stage: string, fraction: number) => void) | null;
  /** The warnings of the last read() or importSvg(). */
  readonly warnings: string[];
  read(text: string | Uint8Array, from?: { name?: string; load?: Loader | null }): SfumatoDocument;
  /** Converts an ordinary SVG to a drawing. `warnings` then names the content that was left out. */
  importSvg(text: string | Uint8Array, from?: { name?: string; load?: Loader | null }): SfumatoDocument;
  /**
   * Combines two regions: path data of SVG, filled by the nonzero rule. "subtract" takes the second from the first.
   * @param tolerance accuracy of crossings, in the paths' units, above 0
   * @returns path data, its inside on the right; "" if nothing is left
   */
  combinePaths(
    operation: "unite" | "intersect" | "subtract" | "exclude",
    first: string,
    second: string,
    tolerance: number,
  ): string;
  newDocument(options: Options): SfumatoDocument;
  /** Adds the pixels of an image file that a document names or contains; null removes them. */
  addImage(file: Uint8Array, image: Pixels | null): void;
  solve(document: SfumatoDocument, options?: Options): SfumatoPicture;
  /** Updates a picture to the present state of a document. */
  solveAgain(
    document: SfumatoDocument,
    picture: SfumatoPicture,
    way?: { quick?: boolean; seconds?: number | undefined },
  ): void;
  /** Turns a picture, solved with `coherent`, into the next frame of a film; unchanged areas do not flicker. */
  solveNext(document: SfumatoDocument, picture: SfumatoPicture): void;
  expectDrag(picture: SfumatoPicture, layer: number, curves: readonly number[]): void;
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
  /** Returns the picture as a file, which `sfumato render` can also draw. */
  writePicture(picture: SfumatoPicture): Uint8Array<ArrayBuffer>;
  /** Reads a picture from such a file. The picture belongs to no document. */
  readPicture(bytes: Uint8Array): SfumatoPicture;
  viewerPayload(picture: SfumatoPicture, options?: Options): Uint8Array<ArrayBuffer>;
  pictureStack(picture: SfumatoPicture, options?: Options): Uint8Array<ArrayBuffer>;
  /** Returns the data for exact pixels of a layer. The picture must come from a solve, not from a file. */
  exactLayer(picture: SfumatoPicture, layer: number): Uint8Array<ArrayBuffer>;
  /** Returns probable mistakes. */
  lint(document: SfumatoDocument, options?: Options): { file: string; hints: Hint[]; hint_count: number };
  field(document: SfumatoDocument, layer: number, options?: Options): SfumatoField;
  cancel(): void;
  resume(): void;
}

/** The WebAssembly module. One instance computes one task at a time. */
export class Sfumato {
  private constructor();
  readonly version: string;
  readonly abi: number;
  /** Whether a trap, usually for lack of memory, has ended the module. `load()` then loads another one. */
  readonly isBroken: boolean;
  /** The module's memory in bytes; it grows and never shrinks. */
  readonly memoryBytes: number;
  /** Creates a context. @param options maxMemory (MiB), maxTime (seconds), … */
  context(options?: Options): SfumatoContext;
}

/**
 * Loads the module that `read` and `create` use; later calls return the same one.
 * @param source bytes, a WebAssembly.Module or an address; needed if sfumato.wasm is not beside the script
 */
export function load(source?: string | Address | ArrayBuffer | ArrayBufferView | object): Promise<Sfumato>;

/** Where a drawing comes from. */
export interface From {
  /** The name for messages; by default, the name of the file if `read` is given a File. */
  name?: string;
  /** Returns the files that the drawing names. */
  load?: Loader | null;
  /** In pages, the drawing's address: pictures that it names are fetched from there and decoded beforehand. */
  base?: string | Address | undefined;
}

/** Reads SVG or the XML of Orzan et al. `warnings` of the result names what was ignored. */
export function read(drawing: Drawing, from?: From): Promise<SfumatoDocument>;

/**
 * Converts an ordinary SVG to a drawing, with curves along the boundaries of its fills and strokes. The warnings
 * name the content that was left out. The parameters are as for `read`.
 */
export function importSvg(
  drawing: Drawing,
  from?: From,
): Promise<{ drawing: SfumatoDocument; warnings: readonly string[] }>;

/** Creates an empty document. @param options background, interpolation */
export function create(
  width: number,
  height: number,
  options?: Readonly<Record<string, string | number | boolean | undefined>>,
): Promise<SfumatoDocument>;
