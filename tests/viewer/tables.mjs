// The tables of changing layers on a simulated GPU: their content and size.
import { isDeepStrictEqual } from "node:util";
import { LayerTables } from "../../web/viewer/layer_tables.js";
import { check, randomNumbers } from "./harness.mjs";

const NUMBERS = { RED_INTEGER: 1, RED: 1, RG: 2, RGBA: 4 };
const ARRAYS = { UNSIGNED_INT: Uint32Array, UNSIGNED_BYTE: Uint8Array, FLOAT: Float32Array };
const MOST_ROWS = 16384;

/** The part of WebGL 2 that tables need: textures are arrays of rows. */
class PlayedGl {
  bound = null;
  live = new Set();
  made = 0;
  uploaded = 0;
  /** Whether it stores its data. */
  keeps = true;

  createTexture() {
    const texture = { rows: null, width: 0, numbers: 0 };
    this.live.add(texture);
    this.made += 1;
    return texture;
  }
  deleteTexture(texture) {
    check(texture === null || this.live.delete(texture), "a texture is deleted twice");
  }
  bindTexture(_target, texture) {
    this.bound = texture;
  }
  texStorage2D(_target, _levels, _format, width, height) {
    check(this.bound.rows === null, "storage is given twice");
    Object.assign(this.bound, { width, rows: Array.from({ length: height }, () => []) });
  }
  texSubImage2D(_target, _level, x, y, width, height, format, type, values) {
    const { bound } = this;
    const numbers = NUMBERS[format];
    check(this.live.has(bound) && x === 0, "no whole row of a texture");
    check(width <= bound.width && y + height <= bound.rows.length, "beyond the texture");
    check(values instanceof ARRAYS[type], "numbers of another type");
    check(values.length === width * height * numbers, "too many numbers or too few");
    this.uploaded += width * height;
    if (!this.keeps) return;
    for (let row = 0; row < height; ++row) {
      const part = values.subarray(row * width * numbers, (row + 1) * width * numbers);
      bound.rows[y + row].splice(0, part.length, ...part);
    }
  }
  pixelStorei() {}
  texParameteri() {}
  getParameter() {
    return MOST_ROWS;
  }
  get rowCount() {
    return [...this.live].reduce((sum, texture) => sum + texture.rows.length, 0);
  }
}

/** A number of WebGL is its name. */
const playedGl = () =>
  new Proxy(new PlayedGl(), {
    get: (gl, name) => (/^[A-Z_0-9]+$/.test(name) ? name : Reflect.get(gl, name)),
  });

/** Numbers of a table, with `columns` per row, and their changes. */
class Rows {
  constructor(type, columns, random) {
    Object.assign(this, { type, columns, random, values: new type(0) });
  }
  below(bound) {
    return this.random.next().value % bound;
  }
  /** Gives the table another length and new numbers to some rows. Returns their ranges. */
  change(count, rangeCount) {
    const before = this.values.length / this.columns;
    const values = new this.type(count * this.columns);
    values.set(this.values.subarray(0, values.length));
    this.values = values;
    const ranges = Array.from({ length: rangeCount }, () => {
      const from = this.below(count);
      return [from, Math.min(count, from + 1 + this.below(40))];
    });
    if (count > before) ranges.push([before, count]);
    for (const [from, to] of ranges) {
      for (let i = from * this.columns; i < to * this.columns; ++i) values[i] = this.below(200);
    }
    return ranges;
  }
}

/** A layer that changes at random, and the ranges of its changes. */
class ChangingLayer {
  constructor(random, size) {
    Object.assign(this, { random, size });
    this.vertices = new Rows(Float32Array, 2, random);
    this.triangles = new Rows(Uint32Array, 3, random);
    this.curveEdges = new Rows(Uint8Array, 3, random);
    this.layer = { order: 2, origin: [0, 0], bounds: [0, 0, 1, 1] };
    this.takeShape(0, null);
  }
  below(bound) {
    return this.random.next().value % bound;
  }
  /** Sets the shaders of the colour, and of the opacity: null for none. */
  takeShape(colorShaders, opacityShaders) {
    const field = (own, count) => ({
      shaders: Array.from({ length: count }, (_, i) => i),
      nodes: new Rows(Uint32Array, 10, this.random),
      values: new Rows(Float32Array, own + count, this.random),
    });
    this.color = field(3, colorShaders);
    this.opacity = opacityShaders === null ? null : field(1, opacityShaders);
    this.change(0);
  }
  near(count) {
    return Math.floor(count * (0.9 + this.below(200) / 1000));
  }
  change(rangeCount) {
    const triangles = this.near(this.size);
    const fieldChange = ({ nodes, values }) => [
      nodes.change(triangles, rangeCount),
      values.change(this.near(5 * this.size), rangeCount),
    ];
    const [colorNodes, colorValues] = fieldChange(this.color);
    const [opacityNodes, opacityValues] = this.opacity ? fieldChange(this.opacity) : [];
    const delta = {
      vertices: this.vertices.change(this.near(this.size), rangeCount),
      triangles: this.triangles.change(triangles, rangeCount),
      curveEdges: this.curveEdges.change(triangles, rangeCount),
      colorNodes,
      colorValues,
      opacityNodes,
      opacityValues,
    };
    const fieldOf = ({ shaders, nodes, values }) => ({
      channelCount: values.columns,
      shaders,
      triangleNode: nodes.values,
      value: values.values,
    });
    Object.assign(this.layer, {
      positions: this.vertices.values,
      triangleVertex: this.triangles.values,
      edgeIsCurve: this.curveEdges.values,
      color: fieldOf(this.color),
      opacity: this.opacity && fieldOf(this.opacity),
    });
    return delta;
  }
}

/** Expects the content of newly made tables in each table, perhaps with old rows after it. */
function checkAsFresh(tables, step) {
  const gl = playedGl();
  const fresh = new LayerTables(gl, tables.layer);
  fresh.wantEdges();
  check(isDeepStrictEqual([...tables.tables.keys()].sort(), [...fresh.tables.keys()].sort()), step);
  for (const [name, { texture }] of fresh.tables) {
    const { rows } = tables.texture(name);
    texture.rows.forEach((row, i) => {
      const isSame = isDeepStrictEqual(rows[i].slice(0, row.length), row);
      check(isSame, `${step}: row ${i} of ${name}`);
    });
  }
}

function followChanges() {
  const random = randomNumbers(11);
  const gl = playedGl();
  const changing = new ChangingLayer(random, 900);
  const tables = new LayerTables(gl, changing.layer);
  for (let i = 0; i < 150; ++i) {
    const isOther = i % 10 === 9;
    if (isOther) changing.takeShape(i % 7, i % 4 === 1 ? null : i % 6);
    const delta = changing.change(i % 5);
    tables.update(i % 25 === 24 ? null : delta);
    if (isOther) check(tables.texture("edgeIsCurve") === null, "edges that nobody wants");
    tables.wantEdges();
    checkAsFresh(tables, `step ${i}`);
  }
  tables.free();
  check(gl.live.size === 0, "textures are left");
}

const UPDATES = 10000;

function stayFlat() {
  const gl = playedGl();
  const changing = new ChangingLayer(randomNumbers(3), 900);
  changing.takeShape(2, 0);
  const tables = new LayerTables(gl, changing.layer);
  const [count, rows] = [gl.live.size, gl.rowCount];
  gl.uploaded = 0;
  gl.keeps = false;
  for (let i = 0; i < UPDATES; ++i) tables.update(changing.change(1));
  check(gl.live.size === count, `${gl.live.size} textures of ${count}`);
  check(gl.made <= 2 * count, `${gl.made} textures were made for ${count}`);
  // 1.3 times the largest layer, and whole rows.
  check(gl.rowCount <= 1.3 * 1.25 * rows + count, `${gl.rowCount} rows of ${rows}`);
  const each = gl.uploaded / UPDATES / 2048;
  check(each < 0.75 * rows, `an update uploads ${each} of ${rows} rows`);
}

function checkTooLarge(body) {
  let message = "";
  try {
    body();
  } catch (error) {
    ({ message } = error);
  }
  check(/too large/.test(message), `"${message}"`);
}

function refuseTooLarge() {
  const changing = new ChangingLayer(randomNumbers(5), 10);
  const gl = playedGl();
  const tables = new LayerTables(gl, changing.layer);
  tables.wantEdges();
  const count = gl.live.size;
  changing.change(1);
  changing.layer.color.triangleNode = new Uint32Array(2048 * MOST_ROWS + 1);
  checkTooLarge(() => tables.update({}));
  checkTooLarge(() => new LayerTables(gl, changing.layer));
  check(gl.live.size === count, "what was refused left textures");
  // The next update repairs a change that was refused.
  changing.change(1);
  tables.update({});
  tables.wantEdges();
  checkAsFresh(tables, "after a refusal");
}

export async function testTables(tap) {
  await tap.test("tables follow a layer whatever changes", followChanges);
  await tap.test(`tables take no more memory after ${UPDATES} updates`, stayFlat);
  await tap.test("what is too large is refused in words, and harms nothing else", refuseTooLarge);
}
