// The curves of a layer on the GPU, as the walk reads them for the visible part of the layer.

import { inverted, mapped, mappedBox } from "./affine.js";
import { END, exactTables } from "./exact_tables.js";
import { ExactMesh } from "./exact_mesh.js";
import { MOST_STRAY, Refiner } from "./exact_refine.js";
import { arraySource, DataTable } from "./tables.js";

/** @import { Affine } from "./affine.js" */
/** @import { Program } from "./gl.js" */
/** @import { ExactLayer } from "./exact_fields.js" */
/** @import { ExactTables } from "./exact_tables.js" */

/** Within this many windows of the origin, single precision resolves a hundredth of a pixel. */
const MOST_WINDOWS = 32;
/** Margin around the window in which chords are refined, for nearby views; a share of the window's extent. */
const ROOM_AROUND = 0.5;
/** Extra refinement of the chords. */
const FINER = 1.5;

const NAMES = /** @type {const} */ (["beyond", "hit", "blend", "triangle"]);

export class ExactScene {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {ExactLayer} layer
   */
  constructor(gl, layer) {
    this.gl = gl;
    this.layer = layer;
    /** @type {Map<string, DataTable>} */
    this.tables = new Map(
      NAMES.map((name) => [name, new DataTable(gl, "bits")]),
    );
    this.ends = new DataTable(gl, "vector");
    /** @type {ExactTables | null} */
    this.made = null;
    /** Where chords are fine enough for a scale; empty: everywhere. @type {number[]} */
    this.fineBox = [];
    this.fineScale = 0;
  }

  /**
   * Updates the tables for a view.
   * @param {Affine} pixelFromLayer
   * @param {number[]} size of the window, pixels
   */
  look(pixelFromLayer, size) {
    const seen = mappedBox(inverted(pixelFromLayer), [0, 0, ...size]);
    const middle = [(seen[0] + seen[2]) / 2, (seen[1] + seen[3]) / 2];
    const extent = Math.max(seen[2] - seen[0], seen[3] - seen[1]);
    const { made } = this;
    const isNear =
      made !== null &&
      Math.hypot(middle[0] - made.origin[0], middle[1] - made.origin[1]) < MOST_WINDOWS * extent;
    const scale = largestScale(pixelFromLayer);
    if (isNear && this.isFine(seen, scale)) return;
    const room = ROOM_AROUND * extent;
    const box = [seen[0] - room, seen[1] - room, seen[2] + room, seen[3] + room];
    this.make(middle, box, scale);
  }

  /**
   * Returns whether chords are fine enough, and not much too fine.
   * @param {number[]} box
   * @param {number} scale
   */
  isFine(box, scale) {
    const { fineBox, fineScale } = this;
    if (this.needsNone(scale)) return fineScale === 0;
    const isInside =
      box[0] >= fineBox[0] && box[1] >= fineBox[1] && box[2] <= fineBox[2] && box[3] <= fineBox[3];
    return isInside && scale <= fineScale && scale > fineScale / 8;
  }

  /** Returns whether chords are fine enough without refinement. @param {number} scale */
  needsNone(scale) {
    return this.layer.tolerance * scale <= MOST_STRAY;
  }

  /** Whether some chords are finer than the patches' chords. */
  get isRefined() {
    return this.fineScale > 0;
  }

  /**
   * @param {number[]} origin
   * @param {number[]} box the visible part, layer frame
   * @param {number} scale pixels per layer unit
   */
  make(origin, box, scale) {
    const mesh = new ExactMesh(this.layer);
    this.fineScale = this.needsNone(scale) ? 0 : FINER * scale;
    this.fineBox = box;
    if (this.isRefined) {
      const [x, y] = mesh.origin;
      const near = [box[0] - x, box[1] - y, box[2] - x, box[3] - y];
      new Refiner(mesh, this.layer.tolerance).refine(near, this.fineScale);
    }
    const made = exactTables(mesh, origin);
    for (const name of NAMES) this.tables.get(name)?.write(arraySource(made[name], 4));
    this.made = made;
  }

  /** The tables for the present view. */
  get tablesMade() {
    if (!this.made) throw new Error("The tables of the layer are not there.");
    return this.made;
  }

  get defines() {
    const { made, layer } = this;
    const names = ["WITH_WALK"];
    if (made?.isBlurred) names.push("WITH_BLUR");
    if (layer.fields.length > 1) names.push("WITH_OPACITY");
    return names;
  }

  /**
   * Binds the tables to a program.
   * @param {Program} program
   */
  bind(program) {
    for (const name of NAMES) {
      const texture = this.tables.get(name)?.texture ?? null;
      program.texture(`${name}_table`, texture);
    }
  }

  /**
   * Binds the free ends that reach a box to the program.
   * @param {Program} program
   * @param {number[]} box relative to the tables' origin
   */
  bindEnds(program, box) {
    const near = (this.made?.ends ?? []).map((ends) =>
      ends.filter(({ position: [x, y], reach }) => {
        const dx = Math.max(box[0] - x, 0, x - box[2]),
          dy = Math.max(box[1] - y, 0, y - box[3]);
        return dx * dx + dy * dy < reach * reach;
      }),
    );
    const all = near.flat();
    const numbers = new Float32Array(END * Math.max(1, all.length));
    all.forEach((end, i) => numbers.set(end.numbers, END * i));
    this.ends.write(arraySource(numbers, 4));
    program.texture("end_table", this.ends.texture);
    this.gl.uniform2i(program.place("end_count"), near[0]?.length ?? 0, near[1]?.length ?? 0);
  }

  free() {
    for (const table of this.tables.values()) table.free();
    this.ends.free();
    this.made = null;
  }
}

/** Returns pixels per layer unit, in the direction where that is most. @param {Affine} map */
function largestScale([a, b, c, d]) {
  const squares = a * a + b * b + c * c + d * d,
    area = a * d - b * c;
  return Math.sqrt((squares + Math.sqrt(Math.max(0, squares * squares - 4 * area * area))) / 2);
}

/**
 * Returns the shift between two maps if they differ only by whole pixels, else null.
 * @param {Affine} before
 * @param {Affine} now
 * @returns {number[] | null}
 */
export function wholeShift(before, now) {
  const scale = Math.max(...before.slice(0, 4).map(Math.abs));
  const isSame = [0, 1, 2, 3].every((i) => Math.abs(before[i] - now[i]) <= 1e-9 * scale);
  const shift = mapped(now, 0, 0).map((v, axis) => v - before[4 + axis]);
  const whole = shift.map(Math.round);
  return isSame && shift.every((v, axis) => Math.abs(v - whole[axis]) < 1e-3) ? whole : null;
}
