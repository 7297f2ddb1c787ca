// The page's copy of a layer's tables, which the renderer draws from and builds up again from after
// the graphics card has lost them.
import type { Box } from "../geometry/affine.js";
import type { FieldUpdate, LayerUpdate, RowRanges } from "./types.js";

type Numbers = Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer> | Uint8Array<ArrayBuffer>;

/** Room for more rows, in parts of those that are there. */
const SPARE = 0.3;

/** A table whose rows change and grow. */
export class Rows<Data extends Numbers> {
  #data: Data;
  #make: (length: number) => Data;
  #length = 0;

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

  /** @param given the ranges' rows, one behind the other; @throws RangeError where they do not fit */
  change(rows: number, ranges: RowRanges, given: Data): void {
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
    if (length <= this.#data.length) return;
    const larger = this.#make(Math.ceil(length * (1 + SPARE)));
    larger.set(this.#data as never);
    this.#data = larger;
  }
}

export class FieldMirror {
  readonly nodes = new Rows(10, (length) => new Uint32Array(length));
  readonly values: Rows<Float32Array<ArrayBuffer>>;

  constructor(readonly channelCount: number) {
    this.values = new Rows(channelCount, (length) => new Float32Array(length));
  }

  change(update: FieldUpdate): void {
    this.nodes.change(update.nodeRows, update.nodeRanges, update.nodes);
    this.values.change(update.valueRows, update.valueRanges, update.values);
  }
}

export class LayerMirror {
  readonly positions = new Rows(2, (length) => new Float32Array(length));
  readonly triangles = new Rows(3, (length) => new Uint32Array(length));
  readonly edges = new Rows(3, (length) => new Uint8Array(length));
  origin: readonly [number, number] = [0, 0];
  bounds: Box = [0, 0, 0, 0];
  color = new FieldMirror(3);
  opacity: FieldMirror | null = null;

  change(update: LayerUpdate): void {
    this.origin = update.origin;
    this.bounds = update.bounds;
    this.positions.change(update.vertexRows, update.positionRanges, update.positions);
    this.triangles.change(update.triangleRows, update.triangleRanges, update.triangles);
    this.edges.change(update.triangleRows, update.edgeRanges, update.edges);
    this.color = changed(this.color, update.color);
    this.opacity = update.opacity && changed(this.opacity, update.opacity);
  }
}

/** A field of other channels is a new one; its update is whole then. */
function changed(field: FieldMirror | null, update: FieldUpdate): FieldMirror {
  const fits = field?.channelCount === update.channelCount ? field : new FieldMirror(update.channelCount);
  fits.change(update);
  return fits;
}
