// Reads the exact fields of a payload, its last part (docs/viewer.md, "Exact fields"): curves as rays meet them.
// They are read when they are first needed, after the picture is shown.

import { ByteReader, PayloadError, unzigzag } from "./bytes.js";
import { GRID_MIDDLE, NO_MATE, readCurves, readGridFrame, readTopology } from "./mesh.js";

/** @import { Topology } from "./mesh.js" */

const EXACT_VERSION = 1;
/** The codes before a layer: no curves, curves on the vertices of its patches, or on their own grid. */
const NONE = 0;
const WITH_PATCHES = 1;
const ALONE = 2;

/** Returns the half-edge after h in its triangle. @param {number} h */
export const nextEdge = (h) => (h % 3 === 2 ? h - 2 : h + 1);

/** Returns the half-edge before h in its triangle. @param {number} h */
export const previousEdge = (h) => (h % 3 === 0 ? h + 2 : h - 1);

/** The same limit as in the writer. */
const EDGES_LOOKED_AT = 64;
const LARGEST_NUMBER = 2 ** 28;
const SMALL_MISS = 3;

/** The kinds of half-edges for rays: RayEdge of picture.hpp. */
export const OPEN = 0;
export const STOP = 1;
export const SIDE = 2;

/**
 * The free end of a curve.
 * @typedef {object} ExactEnd
 * @property {number[]} position relative to the layer's origin
 * @property {number[]} direction
 * @property {number} bend
 * @property {number} reach
 * @property {number} weight
 * @property {number[]} blur of the positive and the negative side
 * @property {number[]} positive values
 * @property {number[]} negative
 */

/**
 * One attribute.
 * @typedef {object} ExactField
 * @property {number} channelCount 3 for a colour, 1 for an opacity
 * @property {Uint8Array} edge per half-edge: OPEN, STOP or SIDE
 * @property {Uint32Array} sideOf per half-edge: its side, if it is one
 * @property {Float32Array} from channelCount a side: values at the half-edge's origin
 * @property {Float32Array} to and at its target
 * @property {Float32Array} blurFrom per side: radius, layer units
 * @property {Float32Array} blurTo
 * @property {Float32Array} weight per side
 * @property {ExactEnd[]} ends
 */

/**
 * Half-edge 3 t + k runs from corner k of triangle t to the next.
 * @typedef {object} ExactLayer
 * @property {number} tolerance how far edges are from their curves, layer units
 * @property {number[]} origin what positions are relative to, layer frame
 * @property {Float32Array | Float64Array} positions 2 a vertex
 * @property {Uint32Array} triangleVertex 3 a triangle
 * @property {Uint32Array} twin per half-edge: the one across, or NO_MATE
 * @property {ExactField[]} fields colour, and opacity where there is one
 */


/**
 * Returns the half-edge across each half-edge.
 * @param {Topology} topology
 */
function twinsOf({ mate, cornerVertex }) {
  const twin = new Uint32Array(mate.length).fill(NO_MATE);
  for (let h = 0; h < mate.length; ++h) {
    const other = mate[h];
    if (other === NO_MATE) continue;
    const isAcross =
      cornerVertex[other] === cornerVertex[nextEdge(h)] &&
      cornerVertex[nextEdge(other)] === cornerVertex[h];
    if (!isAcross || twin[other] !== NO_MATE)
      throw new PayloadError("its curves stand in no triangulation");
    twin[h] = other;
    twin[other] = h;
  }
  return twin;
}

/**
 * A half-edge on a curve.
 * @typedef {object} CurveEdge
 * @property {number} h
 * @property {boolean} continues the one before
 * @property {number} length
 */

/**
 * The part of a picture's layer that reading its curves needs.
 * @typedef {object} LayerOfCurves
 * @property {number[]} origin
 * @property {Float32Array} positions
 * @property {object | null} opacity
 */

/** Reads triangles and the curves that run along their edges. */
class CurveReader {
  /**
   * @param {ByteReader} reader
   * @param {LayerOfCurves | null} layer null: the curves stand alone
   */
  constructor(reader, layer) {
    this.reader = reader;
    const topology = readTopology(reader);
    this.corner = topology.cornerVertex;
    this.vertexCount = topology.vertexCount;
    this.twin = twinsOf(topology);
    this.isCurve = readCurves(reader, topology.triangleCount);
    this.order = this.findOrder();
    this.origin = layer?.origin ?? [0, 0];
    this.positions = this.readPositions(layer);
  }

  /**
   * Returns the edge that rays meet after h, in the order of `turn`, or NO_MATE.
   * @param {number} h
   * @param {(h: number) => number} turn
   */
  neighbour(h, turn) {
    const { isCurve, twin } = this;
    let g = turn(h);
    for (let i = 0; i < EDGES_LOOKED_AT && !isCurve[g]; ++i) {
      if (twin[g] === NO_MATE) return NO_MATE;
      g = turn(twin[g]);
    }
    return isCurve[g] ? g : NO_MATE;
  }

  /** Sorts the edges along the curves; edges where a curve begins come first. */
  findOrder() {
    const { isCurve } = this;
    const isListed = new Uint8Array(isCurve.length);
    /** @type {CurveEdge[]} */
    const order = [];
    for (const onlyStarts of [true, false]) {
      for (let h = 0; h < isCurve.length; ++h) {
        if (!isCurve[h] || isListed[h]) continue;
        if (onlyStarts && this.neighbour(h, previousEdge) !== NO_MATE) continue;
        for (let g = h; g !== NO_MATE && !isListed[g]; g = this.neighbour(g, nextEdge)) {
          order.push({ h: g, continues: g !== h, length: 0 });
          isListed[g] = 1;
        }
      }
    }
    return order;
  }

  /** Reads positions; most vertices are vertices of patches. @param {LayerOfCurves | null} layer */
  readPositions(layer) {
    const { reader, corner, vertexCount } = this;
    const numbers = reader.planes(vertexCount, 4);
    const { min, step } = readGridFrame(reader);
    const middle = min.map((low, axis) => low + GRID_MIDDLE * step[axis]);
    if (!layer) this.origin = middle;
    const known = layer?.positions ?? new Float32Array();
    const shift = middle.map((place, axis) => place - this.origin[axis]);
    const others = reader.count(8);
    const misses = [reader.planes(others, 4), reader.planes(others, 4)];
    const positions = layer ? new Float32Array(2 * vertexCount) : new Float64Array(2 * vertexCount);
    const isPlaced = new Uint8Array(vertexCount);
    const last = [0, 0];
    let lastNumber = 0,
      count = 0,
      other = 0;
    const put = (/** @type {number} */ vertex) => {
      if (isPlaced[vertex]) return;
      isPlaced[vertex] = 1;
      const number = numbers[count++];
      if (number > 0) {
        lastNumber += unzigzag(number - 1);
        if (!(lastNumber >= 0 && 2 * lastNumber < known.length))
          throw new PayloadError("a vertex of it is not there");
        positions.set(known.subarray(2 * lastNumber, 2 * lastNumber + 2), 2 * vertex);
        return;
      }
      if (other === others) throw new PayloadError("a vertex of it is not there");
      for (const axis of [0, 1]) {
        last[axis] = (last[axis] + unzigzag(misses[axis][other])) | 0;
        positions[2 * vertex + axis] = (last[axis] - GRID_MIDDLE) * step[axis] + shift[axis];
      }
      other += 1;
    };
    for (const edge of this.order) {
      const a = corner[edge.h],
        b = corner[nextEdge(edge.h)];
      put(a);
      put(b);
      const [x, y] = [0, 1].map(
        (axis) => Math.fround(positions[2 * b + axis]) - Math.fround(positions[2 * a + axis]),
      );
      edge.length = Math.sqrt(x * x + y * y);
    }
    for (let vertex = 0; vertex < vertexCount; ++vertex) put(vertex);
    return positions;
  }
}

class FieldReader {
  /**
   * @param {ByteReader} reader
   * @param {number} channelCount
   * @param {CurveReader} curves
   */
  constructor(reader, channelCount, curves) {
    this.reader = reader;
    this.channelCount = channelCount;
    this.edge = new Uint8Array(curves.corner.length);
    this.sideOf = new Uint32Array(curves.corner.length);
    /** The sides, in the order of their numbers. @type {CurveEdge[]} */
    this.sides = [];
    this.readKinds(curves);
  }

  /** @returns {ExactField} */
  run() {
    const { reader, channelCount, edge, sideOf, sides } = this;
    const count = sides.length;
    const step = this.positive();
    const from = new Float32Array(channelCount * count),
      to = new Float32Array(channelCount * count);
    for (let c = 0; c < channelCount; ++c) this.readNumbers(step, from, to, channelCount, c);
    const unit = this.positive();
    const blurFrom = new Float32Array(count),
      blurTo = new Float32Array(count);
    this.readNumbers(unit, blurFrom, blurTo, 1, 0);
    const weight = reader.floatPlanes(count);
    if (!weight.every((k) => k > 0 && k < Infinity))
      throw new PayloadError("a weight of it is not above 0");
    const ends = this.readEnds(step, unit);
    return { channelCount, edge, sideOf, from, to, blurFrom, blurTo, weight, ends };
  }

  positive() {
    const value = this.reader.f32();
    if (!(value > 0 && value < Infinity)) throw new PayloadError("a step of it is not above 0");
    return value;
  }

  /** @param {CurveReader} curves */
  readKinds({ order, twin }) {
    const { edge, reader } = this;
    for (let h = 0; h < twin.length; ++h) if (twin[h] === NO_MATE) edge[h] = STOP;
    let continues = false;
    for (const curve of order) {
      const kind = reader.u8();
      if (kind > SIDE) throw new PayloadError("a number in it is too large");
      if (kind !== OPEN) edge[curve.h] = kind;
      if (kind === SIDE) {
        this.sideOf[curve.h] = this.sides.length;
        this.sides.push({ ...curve, continues: curve.continues && continues });
      }
      continues = kind === SIDE;
    }
  }

  /**
   * Reads one number at both ends of each side: number `place` of `size`. Each number is predicted to keep its
   * former slope.
   * @param {number} step
   * @param {Float32Array} from
   * @param {Float32Array} to
   * @param {number} size
   * @param {number} place
   */
  readNumbers(step, from, to, size, place) {
    const { sides, reader } = this;
    const [fromMiss, toMiss] = [reader.planes(sides.length, 4), reader.planes(sides.length, 4)];
    let last = 0,
      base = 0,
      length = 0;
    sides.forEach((side, i) => {
      let change = 0;
      if (side.continues && length > 0)
        change = Math.floor(((last - base) * side.length) / length + 0.5);
      if (!(Math.abs(change) <= LARGEST_NUMBER)) change = 0;
      const miss = unzigzag(toMiss[i]);
      const start = (last + unzigzag(fromMiss[i])) | 0,
        end = (start + change + miss) | 0;
      const goesOn = side.continues && start === last && Math.abs(miss) <= SMALL_MISS;
      if (!goesOn) [base, length] = [start, 0];
      length += side.length;
      last = end;
      from[size * i + place] = step * start;
      to[size * i + place] = step * end;
    });
  }

  /**
   * Reads the free ends, column by column.
   * @param {number} step
   * @param {number} unit
   * @returns {ExactEnd[]}
   */
  readEnds(step, unit) {
    const { reader, channelCount } = this;
    const count = reader.count(36 + 8 * channelCount);
    const steps = (/** @type {number} */ size) =>
      Float32Array.from(reader.planes(count, 4), (miss) => size * unzigzag(miss));
    const columns = [
      ...Array.from({ length: 7 }, () => reader.floatPlanes(count)),
      ...Array.from({ length: 2 }, () => steps(unit)),
      ...Array.from({ length: 2 * channelCount }, () => steps(step)),
    ];
    if (!columns.every((column) => column.every(Number.isFinite)))
      throw new PayloadError("a number in it is not finite");
    return Array.from({ length: count }, (_, i) => {
      const [x, y, dx, dy, bend, reach, weight, positiveBlur, negativeBlur, ...values] =
        columns.map((column) => column[i]);
      return {
        position: [x, y],
        direction: [dx, dy],
        bend,
        reach,
        weight,
        blur: [positiveBlur, negativeBlur],
        positive: values.filter((_value, c) => c % 2 === 0),
        negative: values.filter((_value, c) => c % 2 === 1),
      };
    });
  }
}

/**
 * @param {ByteReader} reader
 * @param {boolean} hasOpacity
 * @param {LayerOfCurves | null} layer null: the curves stand alone
 * @returns {ExactLayer}
 */
function readCurvesOf(reader, hasOpacity, layer) {
  const channels = hasOpacity ? [3, 1] : [3];
  const tolerance = reader.f32();
  if (!(tolerance >= 0 && tolerance < Infinity))
    throw new PayloadError("a number in it is not finite");
  const curves = new CurveReader(reader, layer);
  const fields = channels.map((count) => new FieldReader(reader, count, curves).run());
  const { origin, positions, corner, twin } = curves;
  return { tolerance, origin, positions, triangleVertex: corner, twin, fields };
}

/**
 * Reads the next layer, or returns null if it has no curves.
 * @param {ByteReader} reader
 * @param {boolean} hasOpacity
 * @param {LayerOfCurves | null} layer null: the layer has no patches
 */
function readNext(reader, hasOpacity, layer) {
  const kind = reader.u8();
  if (kind === NONE) return null;
  if (kind === ALONE) return readCurvesOf(reader, hasOpacity, null);
  if (kind !== WITH_PATCHES || !layer) throw new PayloadError("a number in it is too large");
  return readCurvesOf(reader, hasOpacity, layer);
}

/** @param {Uint8Array} bytes */
function readerOf(bytes) {
  const reader = new ByteReader(bytes);
  if (reader.u8() !== EXACT_VERSION)
    throw new PayloadError("its exact fields have another version");
  return reader;
}

/**
 * Reads the layers as rays meet them; null for a layer that has none. Throws PayloadError.
 * @param {Uint8Array} bytes of the last part; may be empty
 * @param {LayerOfCurves[]} layers of the picture
 * @returns {(ExactLayer | null)[]}
 */
export function readExactLayers(bytes, layers) {
  if (bytes.length === 0) return layers.map(() => null);
  const reader = readerOf(bytes);
  return layers.map((layer) => readNext(reader, layer.opacity !== null, layer));
}

/**
 * Reads one layer as rays meet it, from the bytes of sfumato_exact_layer. Throws PayloadError.
 * @param {Uint8Array} bytes
 * @param {boolean} hasOpacity whether the layer has one
 * @returns {ExactLayer | null} null if it has no curves that rays meet
 */
export function readExactLayer(bytes, hasOpacity) {
  return readNext(readerOf(bytes), hasOpacity, null);
}
