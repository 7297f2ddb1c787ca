// A lake below misty mountains, after sunset.
import { hash, noise, octaves } from "./random.mjs";

const FINER = 2;  // a pixel of the photo is the mean of so many by so many
const SHORE = 0.66;  // where the water begins, heights of the picture

const mix = (a, b, t) => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t,
  a[2] + (b[2] - a[2]) * t];
const ramp = (low, high, v) => {
  const t = Math.min(1, Math.max(0, (v - low) / (high - low)));
  return t * t * (3 - 2 * t);
};

const SUN = [0.63, 0.5];  // behind the ridges
const ZENITH = [0.045, 0.075, 0.19];
const HIGH = [0.2, 0.2, 0.36];
const ROSE = [0.72, 0.36, 0.32];
const GOLD = [1.5, 0.75, 0.28];
const HAZE = [0.62, 0.42, 0.42];

/** Sky with thin clouds that are lit from below. x and y in heights of the picture. */
function sky(x, y) {
  const away = Math.hypot((x / 1.333 - SUN[0]) * 0.8, y - SUN[1]);
  let color = mix(ZENITH, HIGH, ramp(-0.1, 0.25, y));
  color = mix(color, ROSE, ramp(0.08, 0.45, y) * ramp(0.95, 0.2, away));
  color = mix(color, GOLD, ramp(0.42, 0.02, away) ** 1.5);
  const drift = octaves(3, 2 * x, 5 * y) - 0.5;
  const veil = octaves(5, 1.6 * x + 3 + 0.6 * drift, 9 * y + 2.5 * x * y + 8 + drift);
  const cloud = ramp(0.5, 0.74, veil) * ramp(0.5, 0.2, y);
  const lit = mix([0.34, 0.25, 0.38], [1.25, 0.52, 0.36], ramp(0.62, 0.12, away));
  return mix(color, lit, 0.75 * cloud);
}

/**
 * Ridges, far to near. height: of the crest, in heights of the picture from the top; relief: how
 * far it rises and falls; wide: of a mountain; mist: share of haze at the crest and at the foot;
 * trees: their height.
 */
const RIDGES = [
  { height: 0.4, relief: 0.2, wide: 0.55, seed: 3, mist: [0.72, 0.97], rock: [0.2, 0.21, 0.34] },
  { height: 0.47, relief: 0.18, wide: 0.42, seed: 11, mist: [0.5, 0.92], rock: [0.13, 0.14, 0.25] },
  { height: 0.53, relief: 0.15, wide: 0.4, seed: 29, mist: [0.3, 0.85],
    rock: [0.075, 0.085, 0.15] },
  { height: 0.59, relief: 0.1, wide: 0.5, seed: 41, mist: [0.14, 0.7],
    rock: [0.035, 0.045, 0.075], trees: 0.012 },
  { height: 0.645, relief: 0.085, wide: 0.7, seed: 57, mist: [0.03, 0.3],
    rock: [0.012, 0.018, 0.028], trees: 0.03 },
];

/** How far a row of firs rises above a slope at x. */
function firs(x, size, seed) {
  let top = 0;
  for (let lane = 0; lane < 3; ++lane) {
    const step = size * (0.32 + 0.07 * lane);
    const middle = Math.floor(x / step);
    for (let i = middle - 1; i <= middle + 1; ++i) {
      const at = (i + 0.5 + 0.7 * (hash(i, lane, seed) - 0.5)) * step;
      const tall = size * (0.45 + 0.75 * hash(i, lane + 9, seed));
      const off = Math.abs(x - at) / (0.21 * tall);
      const boughs = 0.86 + 0.14 * Math.cos(26 * off + 5 * hash(i, lane, seed + 1));
      top = Math.max(top, tall * (1 - off / boughs));
    }
  }
  return top;
}

function crestOf(ridge, x) {
  const u = x / ridge.wide;
  const peaks = 1 - Math.abs(2 * noise(u + ridge.seed, ridge.seed) - 1);
  const rough = octaves(6, 3 * u, ridge.seed + 0.5) - 0.5;
  return ridge.height - ridge.relief * (0.75 * (peaks - 0.45) + 0.5 * rough);
}

/** How much lighter than others the flank of a spur is that looks at the light: about -1 to 1. */
function gullies(x, y, ridge) {
  const height = (at) => Math.abs(octaves(4, 5.5 * at / ridge.wide + ridge.seed,
    2.2 * y / ridge.wide + 0.5) - 0.5);
  return Math.max(-1, Math.min(1, 18 * (height(x + 0.006) - height(x - 0.006))));
}

/** Returns the scene above the water at x as a function of y: one search of crests per column. */
function column(x) {
  const crests = RIDGES.map((ridge) => crestOf(ridge, x));
  const tops = RIDGES.map(({ trees, seed }, i) => crests[i] - (trees ? firs(x, trees, seed) : 0));
  const glow = ramp(0.55, 0, Math.abs(x / 1.333 - SUN[0]));
  const haze = mix(mix(HAZE, [0.3, 0.29, 0.42], ramp(0.1, 0.75, Math.abs(x / 1.333 - SUN[0]))),
    GOLD, 0.3 * glow);
  return (y) => {
    for (let i = RIDGES.length - 1; i >= 0; --i) {
      if (y < tops[i]) continue;
      const ridge = RIDGES[i];
      const foot = ramp(0, 0.85 * ridge.relief + 0.02, y - crests[i]);
      const drift = octaves(4, 2.2 * x + ridge.seed, 11 * y) - 0.5;
      const spur = ridge.trees ? 0 : gullies(x - 0.5 * (y - crests[i]), y - crests[i], ridge);
      const share = ridge.mist[0] + (ridge.mist[1] - ridge.mist[0]) * foot + 0.3 * drift * foot +
        0.09 * spur * (1 - foot);
      return mix(ridge.rock.map((c) => c * (1 + 0.4 * spur)), haze,
        Math.min(1, Math.max(0, share)));
    }
    return sky(x, y);
  };
}

/** The water mirrors what is above it, the more shaken the nearer. */
function paintWater(above, light, size) {
  const [width, height] = size;
  const shore = Math.round(SHORE * height);
  for (let y = shore; y < height; ++y) {
    const near = (y - shore) / (height - shore);
    const depth = 1 / (0.06 + near);
    for (let x = 0; x < width; ++x) {
      const u = x / height;
      const swell = noise(3 * u * depth, 26 * depth) + 0.6 * noise(9 * u * depth, 60 * depth) - 0.8;
      const calm = ramp(0.42, 0.6, octaves(3, 1.2 * u * depth ** 0.5, 7 * depth ** 0.5 + 3));
      const shake = (0.006 + 0.05 * near) * (1 - 0.75 * calm) * swell;
      const from = Math.min(shore - 1, Math.max(0, Math.round(
        shore - 1 - (y - shore) * 1.25 - 1.4 * shake * height)));
      const side = Math.min(width - 1, Math.max(0, Math.round(x + 0.25 * shake * height)));
      const at = 3 * (y * width + x);
      const mirror = 0.86 - 0.42 * near;
      for (let c = 0; c < 3; ++c) {
        light[at + c] = mirror * above[3 * (from * width + side) + c] +
          (1 - mirror) * [0.012, 0.02, 0.035][c];
      }
      const band = Math.exp(-(((y / height - SHORE) / 0.012) ** 2)) *
        (0.25 + 0.5 * octaves(3, 3 * u, 7));
      for (let c = 0; c < 3; ++c) light[at + c] += band * (HAZE[c] * 0.8 - light[at + c]) * 0.6;
    }
  }
}

/** Reeds close to the camera, out of focus. Coverage of each pixel. */
function reeds([width, height]) {
  const cover = new Float32Array(width * height);
  const stroke = (x, y, r) => {
    for (let j = Math.floor(y - r); j <= y + r; ++j) {
      for (let i = Math.floor(x - r); i <= x + r; ++i) {
        if (i < 0 || j < 0 || i >= width || j >= height) continue;
        const d = Math.hypot(i + 0.5 - x, j + 0.5 - y);
        cover[j * width + i] = Math.max(cover[j * width + i], Math.min(1, r - d + 0.5));
      }
    }
  };
  for (let n = 0; n < 46; ++n) {
    const isLeft = hash(n, 1) < 0.7;
    const foot = isLeft ? 0.42 * hash(n, 2) ** 1.6 - 0.03 : 1.34 - 0.2 * hash(n, 2) ** 1.5;
    const tall = (0.2 + 0.3 * hash(n, 3)) * (isLeft ? 1 - foot : 0.6);
    const bend = 0.35 * (hash(n, 4) - 0.4);
    for (let k = 0; k <= 400; ++k) {
      const t = k / 400;
      const x = (foot + bend * tall * t * t) * height;
      const y = (1.02 - tall * t) * height;
      const isHead = n % 3 === 0 && t > 0.84 && t < 0.97;
      stroke(x, y, height * (isHead ? 0.0085 : 0.0036 * (1 - 0.75 * t)));
    }
  }
  return cover;
}

/** The mean over a square of 2 r + 1, twice: a soft disc. */
function defocused(plane, [width, height], r) {
  let from = plane;
  for (const [step, line, count, lines] of [[1, width, width, height], [width, 1, height, width],
    [1, width, width, height], [width, 1, height, width]]) {
    const to = new Float32Array(plane.length);
    for (let l = 0; l < lines; ++l) {
      const at = (i) => from[l * line + Math.min(count - 1, Math.max(0, i)) * step];
      let sum = 0;
      for (let i = -r; i <= r; ++i) sum += at(i);
      for (let i = 0; i < count; ++i) {
        to[l * line + i * step] = sum / (2 * r + 1);
        sum += at(i + r + 1) - at(i - r);
      }
    }
    from = to;
  }
  return from;
}

/** Linear light of each pixel of the photo. */
export function paintLake(size) {
  const fine = size.map((side) => FINER * side);
  const [width, height] = fine;
  const above = new Float32Array(3 * width * height);
  for (let x = 0; x < width; ++x) {
    const shown = column((x + 0.5) / height);
    for (let y = 0; y < SHORE * height; ++y) {
      above.set(shown((y + 0.5) / height), 3 * (y * width + x));
    }
  }
  const light = above.slice();
  paintWater(above, light, fine);
  const cover = defocused(reeds(fine), fine, Math.round(height / 320));
  const small = new Float32Array(3 * size[0] * size[1]);
  for (let at = 0; at < width * height; ++at) {
    const [x, y] = [(at % width) / FINER | 0, Math.floor(at / width / FINER)];
    for (let c = 0; c < 3; ++c) {
      small[3 * (y * size[0] + x) + c] += (light[3 * at + c] * (1 - cover[at]) +
        cover[at] * [0.008, 0.009, 0.012][c]) / FINER ** 2;
    }
  }
  return small;
}
