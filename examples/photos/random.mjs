// Numbers that look random and are the same at every run: hashes, noise, sequences of samples.

/** A hash of up to three integers, from 0 to 1. */
export function hash(x, y = 0, z = 0) {
  let h = Math.imul(x, 0x27d4eb2f) ^ Math.imul(y, 0x165667b1) ^ Math.imul(z, 0x9e3779b1);
  h = Math.imul(h ^ (h >>> 15), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return ((h ^ (h >>> 16)) >>> 0) / 4294967296;
}

const ease = (t) => t * t * t * (t * (6 * t - 15) + 10);
const mix = (a, b, t) => a + (b - a) * t;

/** Value noise from 0 to 1 over a lattice of unit cells. */
export function noise(x, y, z = 0) {
  const [i, j, k] = [Math.floor(x), Math.floor(y), Math.floor(z)];
  const [u, v, w] = [ease(x - i), ease(y - j), ease(z - k)];
  const plane = (n) => mix(mix(hash(i, j, n), hash(i + 1, j, n), u),
    mix(hash(i, j + 1, n), hash(i + 1, j + 1, n), u), v);
  return w === 0 ? plane(k) : mix(plane(k), plane(k + 1), w);
}

/** Octaves of noise, each twice as fine and half as strong; from 0 to 1. */
export function octaves(count, x, y, z = 0) {
  let [sum, weight, total] = [0, 1, 0];
  for (let i = 0; i < count; ++i) {
    sum += weight * noise(x, y, z + 17 * i);
    total += weight;
    weight /= 2;
    x = 2 * x + 5.2;
    y = 2 * y + 1.3;
    z *= 2;
  }
  return sum / total;
}

/** A number of the standard normal distribution for a pixel and a channel. */
export function normal(x, y, channel) {
  const radius = Math.sqrt(-2 * Math.log(1 - hash(x, y, 2 * channel + 101)));
  return radius * Math.cos(2 * Math.PI * hash(x, y, 2 * channel + 102));
}

/** How many numbers of a sample are spread evenly over the samples of a pixel. */
const EVEN = 8;
// Roberts' sequence: powers of the positive root of r^(EVEN + 1) = r + 1.
let root = 1;
for (let i = 0; i < 60; ++i) root = (1 + root) ** (1 / (EVEN + 1));
const STEPS = Array.from({ length: EVEN }, (_, i) => (1 / root) ** (i + 1) % 1);

/** The numbers of one sample of one pixel, one after another. */
export class Samples {
  begin(x, y, sample) {
    this.x = x;
    this.y = y;
    this.sample = sample;
    this.used = 0;
  }

  next() {
    const i = this.used++;
    if (i >= EVEN) return hash(this.x * 4099 + i, this.y, this.sample * 31 + i);
    return (hash(this.x, this.y, 1000 + i) + this.sample * STEPS[i]) % 1;
  }
}
