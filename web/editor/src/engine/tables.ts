// A solved layer's tables out of the module, as messages to the page: whole, or the rows that are new.
import { Table, type SfumatoPicture } from "../../../wasm/sfumato.mjs";
import type { Box } from "../geometry/affine.js";
import type { FieldUpdate, LayerUpdate, RowRanges } from "./types.js";

/** Returns the rows of each table to send. */
type Wanted = (table: number, rows: number) => RowRanges;

const all: Wanted = (_, rows) => (rows > 0 ? [[0, rows]] : []);

function within(ranges: RowRanges, rows: number): RowRanges {
  return ranges
    .map(([from, to]) => [from, Math.min(to, rows)] as const)
    .filter(([from, to]) => from < to);
}

/** Returns the rows that the last solve changed. */
function changed(picture: SfumatoPicture, layer: number): Wanted {
  return (table, rows) => within(picture.changes(layer, table) as [number, number][], rows);
}

type Numbers = Float64Array | Float32Array | Uint32Array | Uint8Array;

/** A view of a table; it lasts until the next call of the module. */
interface View {
  readonly rows: number;
  readonly columns: number;
  readonly data: Numbers;
}

function look(picture: SfumatoPicture, layer: number, table: number): View {
  return picture.tableView(layer, table) as View;
}

/** Rows one behind the other, copied. */
function gathered<Out extends Numbers>(view: View, ranges: RowRanges, make: (n: number) => Out): Out {
  const { columns, data } = view;
  const out = make(columns * ranges.reduce((sum, [from, to]) => sum + to - from, 0));
  let at = 0;
  for (const [from, to] of ranges) {
    out.set(data.subarray(columns * from, columns * to) as never, at);
    at += columns * (to - from);
  }
  return out;
}

/** Positions relative to an origin: single precision holds them near it. */
function relative(view: View, ranges: RowRanges, origin: readonly [number, number]): Float32Array<ArrayBuffer> {
  const exact = gathered(view, ranges, (n) => new Float64Array(n));
  const out = new Float32Array(exact.length);
  for (let i = 0; i < exact.length; ++i) out[i] = exact[i] - origin[i % 2];
  return out;
}

function boundsOf({ data }: View): Box {
  const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < data.length; i += 2) {
    box[0] = Math.min(box[0], data[i]);
    box[1] = Math.min(box[1], data[i + 1]);
    box[2] = Math.max(box[2], data[i]);
    box[3] = Math.max(box[3], data[i + 1]);
  }
  return data.length > 0 ? box : [0, 0, 0, 0];
}

function field(
  picture: SfumatoPicture,
  layer: number,
  [nodeTable, valueTable]: readonly [number, number],
  wanted: Wanted,
): FieldUpdate {
  const { rows: nodeRows } = look(picture, layer, nodeTable);
  const { rows: valueRows, columns: channelCount } = look(picture, layer, valueTable);
  const nodeRanges = wanted(nodeTable, nodeRows);
  const valueRanges = wanted(valueTable, valueRows);
  return {
    channelCount,
    nodeRows,
    valueRows,
    nodeRanges,
    valueRanges,
    nodes: gathered(look(picture, layer, nodeTable), nodeRanges, (n) => new Uint32Array(n)),
    values: gathered(look(picture, layer, valueTable), valueRanges, (n) => new Float32Array(n)),
  };
}

const colorTables = [Table.colorNodes, Table.colorValues] as const;
const opacityTables = [Table.opacityNodes, Table.opacityValues] as const;

/** The frame that a layer's positions are sent in: it stays while deltas follow. */
export type Origins = Map<number, readonly [number, number]>;

const middleOf = ([x0, y0, x1, y1]: Box) => [(x0 + x1) / 2, (y0 + y1) / 2] as const;

/** Where a layer has left its frame's middle it gets another: the same content is drawn to the same bits. */
export function recentre(picture: SfumatoPicture, layer: number, origins: Origins): void {
  const middle = middleOf(boundsOf(look(picture, layer, Table.vertices)));
  const origin = origins.get(layer);
  if (origin && middle.some((value, axis) => value !== origin[axis])) origins.delete(layer);
}

/** A layer as it is, or its new rows where the page has the rest. */
export function layerUpdate(
  picture: SfumatoPicture,
  layer: number,
  isWhole: boolean,
  origins: Origins,
): LayerUpdate {
  const bounds = boundsOf(look(picture, layer, Table.vertices));
  if (isWhole || !origins.has(layer)) origins.set(layer, middleOf(bounds));
  const origin = origins.get(layer)!;
  const wanted = isWhole ? all : changed(picture, layer);
  const rowsOf = (table: number) => look(picture, layer, table).rows;
  const positionRanges = wanted(Table.vertices, rowsOf(Table.vertices));
  const triangleRanges = wanted(Table.triangles, rowsOf(Table.triangles));
  const edgeRanges = wanted(Table.curveEdges, rowsOf(Table.curveEdges));
  const copied = <Out extends Numbers>(table: number, ranges: RowRanges, make: (n: number) => Out) =>
    gathered(look(picture, layer, table), ranges, make);
  return {
    layer,
    isWhole,
    origin,
    bounds,
    vertexRows: rowsOf(Table.vertices),
    triangleRows: rowsOf(Table.triangles),
    positionRanges,
    triangleRanges,
    edgeRanges,
    positions: relative(look(picture, layer, Table.vertices), positionRanges, origin),
    triangles: copied(Table.triangles, triangleRanges, (n) => new Uint32Array(n)),
    edges: copied(Table.curveEdges, edgeRanges, (n) => new Uint8Array(n)),
    color: field(picture, layer, colorTables, wanted),
    opacity:
      rowsOf(Table.opacityNodes) > 0 ? field(picture, layer, opacityTables, wanted) : null,
  };
}

/** Returns whether the last solve changed or removed any row of a layer. */
export function isChanged(picture: SfumatoPicture, layer: number, rowsBefore: RowCounts): boolean {
  const rows = rowCounts(picture, layer);
  return Object.values(Table).some(
    (table, i) => rows[i] !== rowsBefore[i] || picture.changes(layer, table).length > 0,
  );
}

/** Returns whether the last solve replaced all triangles of a layer. */
export function isAllNew(picture: SfumatoPicture, layer: number): boolean {
  const { rows } = look(picture, layer, Table.triangles);
  const [first] = picture.changes(layer, Table.triangles);
  return first !== undefined && first[0] === 0 && first[1] >= rows;
}

export type RowCounts = readonly number[];

export function rowCounts(picture: SfumatoPicture, layer: number): RowCounts {
  return Object.values(Table).map((table) => look(picture, layer, table).rows);
}

/** Returns a word that differs for bytes of different content. */
export function stampOf(parts: Iterable<ArrayBufferView>): string {
  let [a, b] = [0x811c9dc5, 0x1b873593];
  const add = (word: number) => {
    a = Math.imul(a ^ word, 0x01000193);
    b = Math.imul(b ^ a ^ (word >>> 15), 0x85ebca6b);
  };
  for (const { buffer, byteOffset, byteLength } of parts) {
    const isWhole = byteOffset % 4 === 0;
    const words = isWhole ? new Uint32Array(buffer, byteOffset, byteLength >> 2) : [];
    for (let i = 0; i < words.length; ++i) add(words[i]);
    const rest = new Uint8Array(buffer, byteOffset + 4 * words.length, byteLength - 4 * words.length);
    for (let i = 0; i < rest.length; ++i) add(rest[i]);
    add(byteLength);
  }
  return `${(a >>> 0).toString(36)}.${(b >>> 0).toString(36)}`;
}

export function layerStamp(picture: SfumatoPicture, layer: number): string {
  return stampOf(tablesOf(picture, layer));
}

function* tablesOf(picture: SfumatoPicture, layer: number) {
  for (const table of Object.values(Table)) yield look(picture, layer, table).data;
}

/** The buffers of updates, to be handed over. */
export function buffersOf(updates: readonly LayerUpdate[]): ArrayBuffer[] {
  return updates.flatMap(({ positions, triangles, edges, color, opacity }) =>
    [positions, triangles, edges, color.nodes, color.values, opacity?.nodes, opacity?.values]
      .filter((array) => array !== undefined)
      .map((array) => array.buffer as ArrayBuffer),
  );
}
