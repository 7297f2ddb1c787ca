// A layer's curves on the GPU, as the walk reads them for what is seen of the layer.

import { inverted, mapped, mappedBox } from "./affine.js";
import { END, exactTables } from "./exact_tables.js";
import { ExactMesh } from "./exact_mesh.js";
import { MOST_STRAY, Refiner } from "./exact_refine.js";
import { arraySource, DataTable } from "./tables.js";

/** @import { Affine } from "./affine.js" */
/** @import { Program } from "./gl.js" */
/** @import { ExactLayer } from "./exact_fields.js" */
/** @import { ExactTables } from "./exact_tables.js" */

/** So many windows away from the origin single precision still holds a hundredth of a pixel. */
const MOST_WINDOWS = 32;
/** Chords are made finer in so much around the window, of its extent, for views near to this one. */
const ROOM_AROUND = 0.5;
/** And so much finer than they need be. */
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
    /** Where chords are fine enough for a scale; none: everywhere. @type {number[]} */
    this.fineBox = [];
    this.fineScale = 0;
  }

  /**
   * Makes the tables right for a view.
   * @param {Affine} pixelFromLayer
   * @param {number[]} size pixels of the window
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
   * Whether chords are fine enough, and not much too fine.
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

  /** Whether chords are fine enough as they are. @param {number} scale */
  needsNone(scale) {
    return this.layer.tolerance * scale <= MOST_STRAY;
  }

  /** Whether some chords are finer than those of the patches. */
  get isRefined() {
    return this.fineScale > 0;
  }

  /**
   * @param {number[]} origin
   * @param {number[]} box of what is seen, layer frame
   * @param {number} scale pixels to a layer unit
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

  /** What was made for the view. */
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
   * Gives a program the tables.
   * @param {Program} program
   */
  bind(program) {
    for (const name of NAMES) {
      const texture = this.tables.get(name)?.texture ?? null;
      program.texture(`${name}_table`, texture);
    }
  }

  /**
   * The free ends that reach a box, for the program.
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

/** Pixels to a layer unit, where that is most. @param {Affine} map */
function largestScale([a, b, c, d]) {
  const squares = a * a + b * b + c * c + d * d,
    area = a * d - b * c;
  return Math.sqrt((squares + Math.sqrt(Math.max(0, squares * squares - 4 * area * area))) / 2);
}

/**
 * Whether two maps are the same but for whole pixels; how many, then.
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
