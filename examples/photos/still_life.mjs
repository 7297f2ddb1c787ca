// Fruit and glazed pots by a window.
import { noise, octaves } from "./random.mjs";
import { place, turned } from "./solid.mjs";

const mix = (a, b, t) => a.map((v, i) => v + (b[i] - v) * t);
const ramp = (low, high, v) => {
  const t = Math.min(1, Math.max(0, (v - low) / (high - low)));
  return t * t * (3 - 2 * t);
};

const VASE = turned([[0, 0], [0.5, 0], [0.5, 0], [0.54, 0], [0.72, 0.2], [0.98, 0.6], [1.12, 1.1],
  [0.98, 1.6], [0.46, 2.0], [0.24, 2.35], [0.22, 2.75], [0.4, 3.0], [0.47, 3.08], [0.42, 3.1],
  [0.17, 2.8], [0.15, 2.4], [0.3, 2.0], [0, 1.7]]);
const BOWL = turned([[0, 0.12], [0.42, 0.12], [0.44, 0], [0.44, 0], [0.54, 0], [0.54, 0], [0.54, 0],
  [0.56, 0.14], [0.56, 0.14], [1.0, 0.3], [1.36, 0.72], [1.44, 1.16], [1.46, 1.24], [1.4, 1.24],
  [1.36, 1.16], [1.24, 0.76], [0.9, 0.4], [0.45, 0.25], [0, 0.22]]);
const JAR = turned([[0, 0], [0.55, 0], [0.55, 0], [0.58, 0], [0.66, 0.1], [0.9, 0.7], [0.78, 1.3],
  [0.46, 1.44], [0.46, 1.56], [0.66, 1.68], [0.66, 1.72], [0.5, 1.7], [0.4, 1.5], [0.6, 1.2],
  [0, 0.9]]);
const PEAR = turned([[0, 0.06], [0.12, 0.02], [0.42, -0.02], [0.68, 0.36], [0.64, 0.82],
  [0.36, 1.18], [0.27, 1.46], [0.2, 1.62], [0.06, 1.62], [0, 1.56]]);
const ORANGE = turned([[0, 0.03], [0.3, -0.03], [0.62, 0.22], [0.68, 0.58], [0.56, 1.0],
  [0.26, 1.18], [0.06, 1.14], [0, 1.11]]);
const LEMON = turned([[0, 0], [0.07, 0.0], [0.1, 0.12], [0.36, 0.26], [0.5, 0.62], [0.4, 1.0],
  [0.15, 1.13], [0.1, 1.26], [0, 1.27]]);
const PLUM = turned([[0, 0.02], [0.18, 0.0], [0.42, 0.18], [0.44, 0.42], [0.34, 0.7], [0.1, 0.77],
  [0, 0.72]]);
const STEM = turned([[0, 0], [0.045, 0], [0.035, 0.12], [0.032, 0.26], [0.06, 0.38], [0.06, 0.4],
  [0, 0.4]]);
const LEAF = turned([[0, 0], [0.02, 0.05], [0.2, 0.25], [0.3, 0.5], [0.18, 0.8], [0.02, 1.02],
  [0, 1.05]]);

/** Celadon that gathers, darker, below and in the throat; a band scratched at the shoulder. */
function celadon(p) {
  const flow = 0.16 * (noise(3 * Math.atan2(p[2], p[0]) + 9, 2) - 0.5);
  const depth = ramp(1.3, 0.2, p[1] + flow);
  const band = ramp(0.035, 0.015, Math.abs(p[1] - 1.66));
  const glaze = mix([0.36, 0.55, 0.47], [0.12, 0.3, 0.27], Math.max(depth, 0.8 * band));
  return { color: mix(glaze, [0.6, 0.55, 0.42], ramp(2.96, 3.03, p[1])), gloss: 0.075,
    roughness: 0.02 };
}

/** Cobalt outside, cream inside, the bare clay at the foot. */
function cobalt(p, n) {
  const angle = Math.atan2(p[2], p[0]);
  const rim = 1.06 + 0.035 * Math.sin(5 * angle) + 0.03 * Math.sin(8 * angle + 1);
  const isInside = p[1] > 0.2 && n[0] * p[0] + n[2] * p[2] < 0.02;
  if (isInside) return { color: [0.72, 0.66, 0.52], gloss: 0.06, roughness: 0.05 };
  const glaze = mix([0.03, 0.075, 0.25], [0.72, 0.66, 0.52], ramp(rim - 0.02, rim + 0.02, p[1]));
  const foot = ramp(0.15, 0.1, p[1]);
  return { color: mix(glaze, [0.42, 0.26, 0.16], foot), gloss: 0.07 * (1 - foot), roughness: 0.02 };
}

function terracotta(p) {
  const tint = octaves(3, 1.4 * p[0], 2 * p[1], 1.4 * p[2]);
  return { color: mix([0.4, 0.15, 0.075], [0.55, 0.25, 0.13], tint), gloss: 0.02, roughness: 0.4 };
}

/** A pear that the sun has reddened on one side. */
function pear(p) {
  const blush = ramp(0.1, 0.75, 0.5 + 0.75 * p[0] - 0.3 * p[2] + 0.3 * (noise(3 * p[0], 3 * p[1],
    3 * p[2]) - 0.5));
  const skin = mix([0.48, 0.46, 0.08], [0.5, 0.11, 0.04], 0.85 * blush);
  return { color: mix(skin, [0.2, 0.12, 0.04], ramp(0.12, 0.03, Math.hypot(p[0], p[2])) * 0.8),
    gloss: 0.035, roughness: 0.17 };
}

/** Small bumps of a rind, as a vector to add to the normal. */
function rind(p, fine, height) {
  const at = (x, y, z) => noise(fine * x + 50, fine * y + 50, fine * z + 50.5);
  const [d, here] = [0.25 / fine, at(...p)];
  return [at(p[0] + d, p[1], p[2]) - here, at(p[0], p[1] + d, p[2]) - here,
    at(p[0], p[1], p[2] + d) - here].map((v) => height * v);
}

function orange(p) {
  const pole = ramp(0.12, 0.03, Math.hypot(p[0], p[2])) * ramp(0.9, 1.1, p[1]);
  return { color: mix([0.74, 0.24, 0.025], [0.2, 0.2, 0.05], pole), gloss: 0.035, roughness: 0.16,
    bump: rind(p, 16, 0.16) };
}

function lemon(p) {
  const green = ramp(1.02, 1.24, p[1]) * 0.6;
  return { color: mix([0.8, 0.56, 0.05], [0.4, 0.42, 0.06], green), gloss: 0.035, roughness: 0.16,
    bump: rind(p, 13, 0.16) };
}

/** Plums with their bloom. */
function plum(p) {
  const bloom = ramp(0.35, 0.75, octaves(3, 4 * p[0] + 7, 4 * p[1], 4 * p[2]));
  return { color: mix([0.09, 0.018, 0.05], [0.2, 0.15, 0.27], 0.75 * bloom), gloss: 0.04,
    roughness: 0.1 + 0.25 * bloom };
}

const stem = () => ({ color: [0.13, 0.075, 0.03], gloss: 0.02, roughness: 0.4 });

function leaf(p) {
  const rib = ramp(0.02, 0.006, Math.abs(p[0]));
  return { color: mix([0.1, 0.22, 0.04], [0.24, 0.36, 0.12], rib), gloss: 0.04, roughness: 0.22 };
}

/** A table of dark wood that was oiled; a wall of plaster, lighter where the window looks at it. */
function table([x, , z]) {
  const grain = octaves(3, 0.5 * x + 3, 5 * z + 0.4 * noise(x, z));
  const gap = ramp(0.03, 0.012, Math.abs(((z + 21.35) % 1.9) - 0.95));
  return { color: mix(mix([0.13, 0.066, 0.034], [0.2, 0.108, 0.058], grain), [0.02, 0.01, 0.006],
    0.85 * gap), gloss: 0.035, roughness: 0.13 };
}

function wall([x, y]) {
  const stain = octaves(4, 0.35 * x + 11, 0.35 * y + 4);
  return { color: mix([0.2, 0.235, 0.24], [0.3, 0.325, 0.31], stain), gloss: 0, roughness: 1 };
}

export const stillLife = {
  size: [640, 480],
  exposure: 1.45,
  grain: 1.1,
  wallZ: -4.2,
  tableZ: 3.4,
  camera: { at: [0.3, 2.55, 8.6], target: [0.05, 1.08, 0], width: 0.72, lens: 0.085, focus: 8.25 },
  window: { at: [-7, 4.6, 3.2], right: [1.92, 0, 2.72], up: [0, 3.7, 0], panes: [2, 3],
    normal: [0.817, 0, -0.577], color: [21, 20.6, 20] },
  room: (d) => [0.19, 0.15, 0.12].map((c) => c * (0.75 + 0.45 * d[1] + 0.4 * Math.max(0, d[0]))),
  table,
  wall,
  solids: [
    place(VASE, celadon, [-1.55, 0, -0.9]),
    place(JAR, terracotta, [2.15, 0, -2.3], { size: 1.25 }),
    place(BOWL, cobalt, [1.0, 0, -0.25]),
    place(LEMON, lemon, [0.35, 0.66, -0.2], { lean: 1.2, heading: 0.5 }),
    place(ORANGE, orange, [1.45, 0.52, -0.55], { lean: 0.3, heading: 2 }),
    place(LEMON, lemon, [1.1, 0.72, 0.35], { lean: 1.35, heading: -0.5 }),
    place(PEAR, pear, [-0.62, 0, 0.75], { lean: 0.06, heading: 0.4, spin: -0.4 }),
    place(STEM, stem, [-0.53, 1.5, 0.79], { lean: 0.4, heading: 0.3, size: 1.1 }),
    place(PEAR, pear, [-2.35, 0.6, 0.45], { lean: 1.63, heading: 0.45, spin: 1.3 }),
    place(ORANGE, orange, [0.25, 0, 1.35], { lean: 0.5, heading: 2.5 }),
    place(PLUM, plum, [1.35, 0, 1.6], { lean: 0.3, heading: 1 }),
    place(PLUM, plum, [1.83, 0.26, 1.05], { lean: 1.2, heading: 0.2 }),
    place(LEAF, leaf, [-0.52, 1.66, 0.8], { lean: 1.25, heading: 0.35, spin: 1.15,
      size: [0.62, 0.76, 0.14] }),
  ],
};
