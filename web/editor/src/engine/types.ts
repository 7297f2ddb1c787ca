// contract: the engine, as the page sees it. It works in workers.
import type { ExactLayer } from "../../../viewer/exact_fields.js";
import type { Box } from "../geometry/affine.js";
import type { CubicPath } from "../geometry/cubic.js";

/** An image that a document names or holds: its file's bytes, and its pixels. */
export interface GivenImage {
  readonly href: string;
  readonly bytes: Uint8Array;
  readonly pixels: { readonly width: number; readonly height: number; readonly data: Uint8ClampedArray };
}

export type EngineStatus =
  | { readonly kind: "empty" }
  /**
   * The picture is the one that `sfumato render` would draw from the text. `milliseconds`: time of the last
   * solve.
   */
  | { readonly kind: "exact"; readonly milliseconds: number }
  | { readonly kind: "refining"; readonly milliseconds: number }
  /** The text cannot be drawn; the last picture of the same drawing stays. Line and column from 1, 0 where unknown. */
  | { readonly kind: "problem"; readonly reason: string; readonly line: number; readonly column: number }
  /** WebAssembly or workers are missing, or memory is out. */
  | { readonly kind: "failed"; readonly reason: string };

/** Where a curve is, as the engine counts them. */
export interface CurvePlace {
  readonly layer: number;
  readonly curve: number;
}

/** Curves of one layer. */
export interface LayerCurves {
  readonly layer: number;
  readonly curves: readonly number[];
}

export interface EngineCurve extends CurvePlace {
  /** Where its element's `<` stands in the text, UTF-16 units; which of its subpaths. */
  readonly offset: number;
  readonly subpath: number;
}

/** A probable mistake, of `sfumato lint` (docs/cli.md). */
export interface Hint {
  readonly severity: "warning" | "note";
  /** Its kind, as "crossing". */
  readonly rule: string;
  readonly message: string;
  readonly layer: number | null;
  readonly curve: number | null;
  readonly side: "left" | "right" | null;
  /** Place of its curve's element in the text that was read, and which subpath; or null. */
  readonly offset: number | null;
  readonly subpath: number | null;
  /** The number on the picture's stack of an object without a curve of a layer, or null. */
  readonly stackItem: number | null;
  /** The point that the message names, in the frame of the layer, or null. */
  readonly at: readonly [number, number] | null;
}

/** A small change since the last text: the points of one curve, in the frame of its layer, or stops. */
export type QuickChange =
  | { readonly kind: "points"; readonly layer: number; readonly curve: number; readonly xy: Float64Array }
  | {
      readonly kind: "stops";
      readonly layer: number;
      readonly curve: number;
      readonly side: 0 | 1;
      readonly attribute: 0 | 1 | 2;
      /** 0 arc length, 1 parameter. */
      readonly space: 0 | 1;
      /** [offset, red, green, blue] or [offset, value]. */
      readonly rows: readonly (readonly number[])[];
    };

export interface RasterWish {
  readonly width: number;
  readonly height: number;
  /** Part of the artboard; null: all. */
  readonly viewport: Box | null;
  /** CSS colour, "none", or null for the document's. */
  readonly background: string | null;
  readonly depth: 8 | 16;
  /** To look at for a while: the mesh is not refined where it misses. */
  readonly isDraft?: boolean;
}

/** A file without a size in pixels, as `sfumato render` writes it. */
export interface FileWish {
  readonly format: "pdf" | "svg";
  /** Part of the artboard. */
  readonly viewport: Box;
  /** Options of `sfumato_export` (docs/c-api.md). */
  readonly options: Readonly<Record<string, string>>;
  /** How fine curves are relative to their size on the page: the command's default is 1 for vectors in SVG, else 2. */
  readonly detail: 1 | 2;
}

export interface WrittenFile {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Differences between the file and the drawing, in words. */
  readonly warnings: readonly string[];
}

/** The result of importing an ordinary SVG. */
export interface ImportedSvg {
  readonly text: string;
  /** The parts that were left out, one line each. */
  readonly warnings: readonly string[];
}

/** RGBA in the layout of ImageData. */
export interface PhotoPixels {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray<ArrayBuffer>;
}

/** How a photo is traced: `sfumato_trace`'s options (docs/c-api.md). */
export interface TraceOptions {
  readonly points: number;
  /** Pixels: what is finer is texture, which no curve follows. */
  readonly smooth: number;
  readonly stops: "few" | "normal" | "many";
  readonly blur: "on" | "off";
}

export interface TraceWish {
  readonly photo: PhotoPixels;
  readonly options: TraceOptions;
}

/** The state of a trace after a round, and the drawing as SVG. */
export interface TraceRound {
  readonly text: string;
  /** 0: edges of the photo alone; later rounds: edges of what is still missing. */
  readonly round: number;
  readonly roundCount: number;
  readonly curves: number;
  readonly controlPoints: number;
  readonly stops: number;
  /** Decibels to the photo. */
  readonly psnr: number;
}

/** Stops of one side of all curves of an element, before they are fitted. */
export interface SideStops {
  /** Where the element's `<` stands in the text, UTF-16 units. */
  readonly offset: number;
  readonly side: 0 | 1;
  readonly space: 0 | 1;
  /** [offset, value] */
  readonly rows: readonly (readonly number[])[];
}

/** Curves whose colours, or blur, are to be fitted to a photo. */
export interface FitWish {
  readonly text: string;
  /** Fills the artboard; where it is clear, nothing is to change. */
  readonly photo: PhotoPixels;
  readonly fits: "colors" | "blur";
  /** The elements that are fitted, where their `<` stand in the text. */
  readonly offsets: readonly number[];
  /** Radii of blur to begin with, of curves that have none. */
  readonly radii: readonly SideStops[];
}

/** The fitted values of an element's curves: mean values where it has several. */
export interface FittedCurve {
  readonly offset: number;
  /** [offset, red, green, blue] of the left and of the right side. */
  readonly colors: readonly [readonly (readonly number[])[], readonly (readonly number[])[]];
  /** Factor of its blur radii, relative to the present or initial ones. */
  readonly factor: number;
  /** The largest radius, artboard units of the layer's frame; 0: none. */
  readonly radius: number;
}

/** A curve to be moved to a photo's edges, in pixels. */
export interface SnapWish {
  readonly photo: PhotoPixels;
  readonly paths: readonly CubicPath[];
  /** At most so far, pixels. */
  readonly reach: number;
}

export interface Engine {
  /**
   * The text from now on. While `moving`, pictures come quickly, within the frame's time; once it is
   * said without, the exact picture follows. `quick`: the change since the last call, where it is one
   * of these alone; ignored where the engine cannot follow it. The latest wins.
   * @returns the number of this text
   */
  show(text: string, moving: boolean, quick?: readonly QuickChange[]): number;
  /** CSS pixels times the device's ratio to an artboard unit, and what is seen: how fine is enough. */
  look(pixelsPerUnit: number, seen: Box, artboard: Box): void;
  /** Announces the next curves to move, numbered as `index`: the first frame of their drag comes sooner. */
  expect(curves: LayerCurves | null): void;
  /** Version of the library; "" until it has started. */
  readonly version: string;
  /** The last text that was read: its number, and its curves; changes of curves since leave both. */
  readonly index: { readonly serial: number; readonly curves: readonly EngineCurve[] };
  /** Pixels of images that texts name: for other workers that read them. */
  readonly images: readonly GivenImage[];
  /** Exact colours (red, green, blue, opacity; 0 to 1) of a layer's last exact state at points, xy in its frame. */
  colors(layer: number, xy: Float64Array): Promise<Float32Array>;
  raster(wish: RasterWish): Promise<Uint8ClampedArray<ArrayBuffer> | Uint16Array<ArrayBuffer>>;
  /**
   * A layer of the exact picture that is shown as rays meet it; null: it has no curves that exact pixels
   * can be gathered from. "busy": there is no such picture now, or the engine has something else to do.
   * @throws Error in words, as where memory is lacking
   */
  exactLayer(layer: number): Promise<ExactLayer | null | "busy">;
  /** The bytes of the HTML viewer's payload. */
  payload(): Promise<Uint8Array>;
  /** The drawing as PDF or plain SVG. @throws EngineError */
  write(wish: FileWish): Promise<WrittenFile>;
  /** null: the text has changed, or is not exact yet. */
  lint(): Promise<readonly Hint[] | null>;
  /** Orzan's XML as SVG. @throws Error with line and column in words */
  convert(text: string): Promise<string>;
  /**
   * The combination of the first region with each of the others, as path data; "" if nothing is left.
   * @param paths path data, filled by the nonzero rule
   * @param tolerance accuracy of crossings, in the paths' units
   * @throws EngineError
   */
  combinePaths(operation: RegionOperation, paths: readonly string[], tolerance: number): Promise<string>;
  onPicture: (update: PictureUpdate) => void;
  onStatus: (status: EngineStatus) => void;
  free(): void;
}

/** Ways to combine regions; "subtract": the first one without the others. */
export type RegionOperation = "unite" | "subtract" | "intersect" | "exclude";

/** Rows of a table that are new: ranges from, and up to, ascending. */
export type RowRanges = readonly (readonly [number, number])[];

/** The data that canvas/renderer.ts passes to the viewer's renderer. Its shape follows web/viewer/layers.js. */
export interface PictureUpdate {
  /** The number of its text, as show() gave it. */
  readonly serial: number;
  /** Bytes that web/viewer's readStack() reads; null: as before. */
  readonly stack: Uint8Array | null;
  readonly layers: readonly LayerUpdate[];
  /** Layers beyond are gone. */
  readonly layerCount: number;
  readonly isExact: boolean;
}

export interface FieldUpdate {
  readonly channelCount: number;
  readonly nodeRows: number;
  readonly valueRows: number;
  /** 10 a triangle and channelCount a node, of the rows that changed, one range behind the other. */
  readonly nodes: Uint32Array<ArrayBuffer>;
  readonly nodeRanges: RowRanges;
  readonly values: Float32Array<ArrayBuffer>;
  readonly valueRanges: RowRanges;
}

export interface LayerUpdate {
  readonly layer: number;
  /** All tables are whole and new. */
  readonly isWhole: boolean;
  readonly origin: readonly [number, number];
  readonly bounds: Box;
  readonly vertexRows: number;
  readonly triangleRows: number;
  readonly positions: Float32Array<ArrayBuffer>;
  readonly positionRanges: RowRanges;
  readonly triangles: Uint32Array<ArrayBuffer>;
  readonly triangleRanges: RowRanges;
  readonly edges: Uint8Array<ArrayBuffer>;
  readonly edgeRanges: RowRanges;
  readonly color: FieldUpdate;
  readonly opacity: FieldUpdate | null;
}
