// Unpacks LZMA as tools/pack.mjs writes it: a raw stream with lc = 4, lp = 0 and pb = 0, so that where a
// byte lies says nothing of it. The states and their order are those of the LZMA specification.

/** Probabilities are of a 0 bit, in parts of 2048; they move by 1/32 towards what has come. */
const CERTAIN = 2048;
const PACE = 5;
const STATES = 12;
const LEN_LOW = 2;
const LEN_MID = LEN_LOW + 8;
const LEN_HIGH = LEN_MID + 8;
const LEN_SIZE = LEN_HIGH + 256;
/** Where the probabilities of each kind begin. */
const IS_MATCH = 0;
const IS_REP = IS_MATCH + STATES;
const IS_REP_LATER = IS_REP + STATES;
const IS_REP_THIRD = IS_REP_LATER + STATES;
const IS_REP_FOURTH = IS_REP_THIRD + STATES;
const IS_REP_LONG = IS_REP_FOURTH + STATES;
const SLOT = IS_REP_LONG + STATES;
const SPECIAL = SLOT + 4 * 64;
const ALIGN = SPECIAL + 128;
const LEN = ALIGN + 16;
const REP_LEN = LEN + LEN_SIZE;
const LITERAL = REP_LEN + LEN_SIZE;
const LITERAL_SIZE = 0x300;
const LITERAL_CONTEXTS = 16;

/** Bits by range coding. */
class RangeDecoder {
  readonly #odds = new Uint16Array(LITERAL + LITERAL_SIZE * LITERAL_CONTEXTS).fill(CERTAIN / 2);
  #range = 0xffffffff;
  #code = 0;
  #at = 1;

  constructor(private readonly input: Uint8Array) {
    for (let i = 0; i < 4; i += 1) this.#code = ((this.#code << 8) | input[this.#at++]) >>> 0;
  }

  bit(place: number): number {
    const odds = this.#odds[place];
    const bound = (this.#range >>> 11) * odds;
    const isZero = this.#code < bound;
    if (isZero) {
      this.#range = bound;
      this.#odds[place] = odds + ((CERTAIN - odds) >> PACE);
    } else {
      this.#range -= bound;
      this.#code -= bound;
      this.#odds[place] = odds - (odds >> PACE);
    }
    this.#refill();
    return isZero ? 0 : 1;
  }

  #refill() {
    if (this.#range >= 0x1000000) return;
    this.#range = (this.#range << 8) >>> 0;
    this.#code = ((this.#code << 8) | this.input[this.#at++]) >>> 0;
  }

  /** Bits that are as often 0 as 1, the highest first. */
  even(count: number): number {
    let value = 0;
    for (let i = 0; i < count; i += 1) {
      this.#range >>>= 1;
      const isOne = this.#code >= this.#range;
      if (isOne) this.#code -= this.#range;
      value = value * 2 + (isOne ? 1 : 0);
      this.#refill();
    }
    return value;
  }

  /** A number by a tree of bits, the highest first. */
  tree(base: number, count: number): number {
    let node = 1;
    for (let i = 0; i < count; i += 1) node = (node << 1) | this.bit(base + node);
    return node - (1 << count);
  }

  /** The same, the lowest first. */
  reverseTree(base: number, count: number): number {
    let node = 1;
    let value = 0;
    for (let i = 0; i < count; i += 1) {
      const bit = this.bit(base + node);
      node = (node << 1) | bit;
      value |= bit << i;
    }
    return value;
  }

  length(base: number): number {
    if (!this.bit(base)) return 2 + this.tree(base + LEN_LOW, 3);
    if (!this.bit(base + 1)) return 10 + this.tree(base + LEN_MID, 3);
    return 18 + this.tree(base + LEN_HIGH, 8);
  }

  distance(length: number): number {
    const slot = this.tree(SLOT + 64 * Math.min(length - 2, 3), 6);
    if (slot < 4) return slot;
    const count = (slot >> 1) - 1;
    const high = (2 | (slot & 1)) * 2 ** count;
    if (slot < 14) return high + this.reverseTree(SPECIAL + high - slot, count);
    return high + this.even(count - 4) * 16 + this.reverseTree(ALIGN, 4);
  }

  /** @param before the byte before; `matched`: the one at the last distance, after a match, else -1 */
  literal(before: number, matched: number): number {
    const base = LITERAL + LITERAL_SIZE * (before >> 4);
    let node = 1;
    for (let rest = matched; rest >= 0 && node < 256; ) {
      const expected = (rest >> 7) & 1;
      rest = (rest << 1) & 255;
      const bit = this.bit(base + ((1 + expected) << 8) + node);
      node = (node << 1) | bit;
      if (bit !== expected) break;
    }
    while (node < 256) node = (node << 1) | this.bit(base + node);
    return node & 255;
  }
}

/** How far back a repetition lies, where it is not the first distance: the one found becomes the first. */
function chooseDistance(decoder: RangeDecoder, state: number, distances: number[]) {
  const index = !decoder.bit(IS_REP_THIRD + state) ? 1 : !decoder.bit(IS_REP_FOURTH + state) ? 2 : 3;
  distances.unshift(...distances.splice(index, 1));
}

/** @param size of what comes out, bytes */
export function unlzma(input: Uint8Array, size: number): Uint8Array<ArrayBuffer> {
  const output = new Uint8Array(size);
  const decoder = new RangeDecoder(input);
  const distances = [0, 0, 0, 0];
  let state = 0;
  let at = 0;
  while (at < size) {
    if (!decoder.bit(IS_MATCH + state)) {
      const matched = state < 7 ? -1 : output[at - distances[0] - 1];
      output[at] = decoder.literal(at > 0 ? output[at - 1] : 0, matched);
      at += 1;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let length: number;
    if (!decoder.bit(IS_REP + state)) {
      length = decoder.length(LEN);
      distances.unshift(decoder.distance(length));
      distances.length = 4;
      state = state < 7 ? 7 : 10;
    } else {
      const isFirst = !decoder.bit(IS_REP_LATER + state);
      const isShort = isFirst && !decoder.bit(IS_REP_LONG + state);
      if (!isFirst) chooseDistance(decoder, state, distances);
      length = isShort ? 1 : decoder.length(REP_LEN);
      state = isShort ? (state < 7 ? 9 : 11) : state < 7 ? 8 : 11;
    }
    for (const end = Math.min(size, at + length); at < end; at += 1) output[at] = output[at - distances[0] - 1];
  }
  return output;
}
