// The page's copy of a layer's tables, which the renderer draws from and builds up again from after
// the graphics card has lost them.
import type { FieldUpdate, LayerUpdate, RowRanges } from "./types.js";

type Numbers = Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer> | Uint8Array<ArrayBuffer>;

/** Spare room for more rows, as a share of the present rows. */
const SPARE = 0.3;

/** A table whose rows change and grow. */
export class Rows<Data extends Numbers> {
  #data: Data;
  #make: (length: number) => Data;
  #length = 0;
  /** Whether others keep the data, which may not change then. */
  #isKept = false;

  constructor(
    readonly columns: number,
    make: (length: number) => Data,
  ) {
    this.#make = make;
    this.#data = make(0);
  }

  /** The numbers that count; a view that lasts until the next change. */
  get values(): Data {
    return this.#data.subarray(0, this.#length) as Data;
  }

  /**
   * @param given the ranges' rows, one behind the other: all rows are used as the table, without a copy
   * @param isKept whether others keep `given`, so that later changes need a copy
   * @throws RangeError where they do not fit
   */
  change(rows: number, ranges: RowRanges, given: Data, isKept = false): void {
    if (ranges.length === 1 && ranges[0][0] === 0 && given.length === rows * this.columns) {
      this.#data = given;
      this.#length = given.length;
      this.#isKept = isKept;
      return;
    }
    this.#resize(rows * this.columns);
    let at = 0;
    for (const [from, to] of ranges) {
      const count = this.columns * (to - from);
      this.#data.set(given.subarray(at, at + count) as never, this.columns * from);
      at += count;
    }
  }

  #resize(length: number) {
    this.#length = length;
    if (length <= this.#data.length && !this.#isKept) return;
    const larger = this.#make(Math.max(this.#data.length, Math.ceil(length * (1 + SPARE))));
    larger.set(this.#data as never);
    this.#data = larger;
    this.#isKept = false;
  }
}

/** Rows that are not as before, by the names of web/wasm/sfumato.mjs; null: all may be new. */
export type LayerChange = Readonly<Record<string, RowRanges>> | null;

class FieldRows {
  readonly nodes = new Rows(10, (length) => new Uint32Array(length));
  readonly values: Rows<Float32Array<ArrayBuffer>>;

  constructor(readonly channelCount: number) {
    this.values = new Rows(channelCount, (length) => new Float32Array(length));
  }

  change(update: FieldUpdate, isKept: boolean): void {
    this.nodes.change(update.nodeRows, update.nodeRanges, update.nodes, isKept);
    this.values.change(update.valueRows, update.valueRanges, update.values, isKept);
  }

  /** The same as in web/viewer/field.js. */
  get field() {
    const { channelCount } = this;
    return { channelCount, triangleNode: this.nodes.values, value: this.values.values };
  }
}

/** Tables of a layer as web/viewer's renderer takes them, without the data of its stack. */
export interface MirroredLayer {
  origin: number[];
  bounds: number[];
  positions: Float32Array;
  triangleVertex: Uint32Array;
  edgeIsCurve: Uint8Array;
  color: FieldRows["field"];
  opacity: FieldRows["field"] | null;
}

export class LayerMirror {
  #positions = new Rows(2, (length) => new Float32Array(length));
  #triangles = new Rows(3, (length) => new Uint32Array(length));
  #edges = new Rows(3, (length) => new Uint8Array(length));
  #color = new FieldRows(3);
  #opacity: FieldRows | null = null;

  /** @returns what the renderer has to look at */
  change(update: LayerUpdate): LayerChange {
    // FormerPictures may keep whole tables for undo: a later change must not write into them.
    const { color, opacity, isWhole } = update;
    this.#positions.change(update.vertexRows, update.positionRanges, update.positions, isWhole);
    this.#triangles.change(update.triangleRows, update.triangleRanges, update.triangles, isWhole);
    this.#edges.change(update.triangleRows, update.edgeRanges, update.edges, isWhole);
    this.#color = changed(this.#color, color, isWhole);
    this.#opacity = opacity && changed(this.#opacity, opacity, isWhole);
    if (update.isWhole) return null;
    return {
      vertices: update.positionRanges,
      triangles: update.triangleRanges,
      curveEdges: update.edgeRanges,
      colorNodes: color.nodeRanges,
      colorValues: color.valueRanges,
      opacityNodes: opacity?.nodeRanges ?? [],
      opacityValues: opacity?.valueRanges ?? [],
    };
  }

  /** Views of the tables, which last until the next change. */
  tables(update: Pick<LayerUpdate, "origin" | "bounds">): MirroredLayer {
    return {
      origin: [...update.origin],
      bounds: [...update.bounds],
      positions: this.#positions.values,
      triangleVertex: this.#triangles.values,
      edgeIsCurve: this.#edges.values,
      color: this.#color.field,
      opacity: this.#opacity?.field ?? null,
    };
  }
}

/** A field of other channels is a new one; its update is whole then. */
function changed(field: FieldRows | null, update: FieldUpdate, isKept: boolean): FieldRows {
  const fits = field?.channelCount === update.channelCount ? field : new FieldRows(update.channelCount);
  fits.change(update, isKept);
  return fits;
}
