// Path data: written, read back, and rewritten with the smallest change.
import { describe, expect, test } from "vitest";
import { pieceCount, type CubicPath } from "../../../../web/editor/src/geometry/cubic.js";
import {
  numberText,
  readPath,
  readPathText,
  rewritePath,
  writePath,
} from "../../../../web/editor/src/geometry/path.js";
import { distance, isSame } from "../../../../web/editor/src/geometry/vector.js";
import { Random } from "../random.js";

const STEP = 0.001;
const COUNT: Record<string, number> = { M: 2, L: 2, H: 1, V: 1, C: 6, S: 4, Q: 4, T: 2, Z: 0 };

/** Returns path data in all notations of the grammar. */
function randomData(random: Random): string {
  const blank = () => random.pick([" ", "  ", "\n", "\t ", ""]);
  const separator = random.pick([() => " ", () => ",", () => random.pick([" ", ",", " , ", "\n"])]);
  const decimals = random.below(7);
  const number = () => random.between(-60, 60).toFixed(decimals);
  const numbers = (op: string): string => {
    if (op === "A") {
      const flags = random.pick(["0 1", "1,0", "11", "00"]);
      return `${Math.abs(Number(number())) + 1} 7.5 ${number()} ${flags} ${number()} ${number()}`;
    }
    return Array.from({ length: COUNT[op] }, number).join(separator());
  };
  let d = "";
  for (let subpath = random.below(3); subpath >= 0; --subpath) {
    if (d === "" || !/[zZ]\s*$/.test(d) || random.chance(0.7))
      d += random.pick("Mm".split("")) + blank() + numbers("M");
    else d += random.pick(["L", "l"]) + blank() + numbers("L");
    let last = "";
    for (let i = 1 + random.below(7); i > 0; --i) {
      const again = last !== "" && random.chance(0.4);
      if (!again) last = random.pick("LlHhVvCcSsQqTtAaCcLl".split(""));
      d +=
        (again ? random.pick([" ", " ,", "\n "]) : blank() + last + blank()) +
        numbers(last.toUpperCase());
    }
    if (random.chance(0.5)) d += blank() + random.pick(["Z", "z"]);
    d += blank();
  }
  return d;
}

function moved(path: CubicPath, node: number, by: readonly [number, number]): CubicPath {
  const nodes = pieceCount(path);
  const near = new Set([3 * node - 1, 3 * node, 3 * node + 1]);
  if (path.closed && node === 0) [3 * nodes - 1, 3 * nodes].forEach((i) => near.add(i));
  const points = path.points.map((p, i) =>
    near.has(i) ? ([p[0] + by[0], p[1] + by[1]] as const) : p,
  );
  return { points, closed: path.closed };
}

/** Returns the largest distance of points that must be equal. */
function miss(a: CubicPath, b: CubicPath): number {
  expect(a.points.length).toBe(b.points.length);
  expect(a.closed).toBe(b.closed);
  return Math.max(...a.points.map((p, i) => distance(p, b.points[i])));
}

const HALF = 0.5 * STEP * Math.SQRT2 + 1e-9;

describe("numbers", () => {
  test("are the shortest within half a step", () => {
    const random = new Random(1);
    for (let i = 0; i < 3000; ++i) {
      const value = random.between(-1, 1) * 10 ** random.between(-5, 6);
      const step = 10 ** random.between(-6, 1);
      const text = numberText(value, step);
      expect(Math.abs(Number(text) - value)).toBeLessThanOrEqual(Math.max(0.5, 0.5 * step));
      if (step < 1) expect(Math.abs(Number(text) - value)).toBeLessThanOrEqual(0.5 * step + 1e-12);
      expect(text).not.toMatch(/^-0$|\.\d*0$|\.$|e/);
    }
    expect(numberText(-0.0001, 0.001)).toBe("0");
    expect(numberText(100, 0.001)).toBe("100");
    expect(numberText(0.5, 0.001)).toBe("0.5");
  });
});

describe("a path that is written", () => {
  test("reads back as it was, within half a step", () => {
    for (let seed = 0; seed < 1500; ++seed) {
      for (const path of readPath(randomData(new Random(seed)))) {
        const [back, ...rest] = readPath(writePath(path, STEP));
        expect(rest).toEqual([]);
        expect(miss(back, path), `seed ${seed}`).toBeLessThan(HALF);
      }
    }
  });
});

describe("rewriting", () => {
  test("what did not change leaves the text as it is", () => {
    for (let seed = 0; seed < 1500; ++seed) {
      const d = randomData(new Random(seed));
      readPath(d).forEach((path, i) =>
        expect(rewritePath(d, i, path, path, STEP), `seed ${seed}`).toBe(d),
      );
    }
  });

  test("a node that moves changes the commands beside it alone", () => {
    let kept = 0;
    for (let seed = 0; seed < 2500; ++seed) {
      const random = new Random(seed);
      const d = randomData(random);
      const paths = readPath(d);
      if (paths.length === 0) continue;
      const index = random.below(paths.length);
      const before = paths[index];
      const node = random.below(pieceCount(before) + (before.closed ? 0 : 1));
      const after = moved(before, node, random.point(20));
      const result = rewritePath(d, index, before, after, STEP);
      const found = readPath(result);
      expect(found.length, `seed ${seed}\n${d}\n${result}`).toBe(paths.length);
      paths.forEach((path, i) => {
        const limit = i === index ? HALF : HALF / 100;
        expect(
          miss(found[i], i === index ? after : path),
          `seed ${seed}\n${d}\n${result}`,
        ).toBeLessThan(limit);
      });
      const old = readPathText(d)!.commands;
      const now = readPathText(result)!.commands;
      if (old.length !== now.length || node === 0 || before.segments) continue;
      // Commands before the node's, and commands from the second one after it.
      const text = (data: string, { start, end }: { start: number; end: number }) =>
        data.slice(start, end);
      const subpath = readPathText(d)!.paths.findIndex(({ points }) =>
        points.every((p, i) => isSame(p, before.points[i])),
      );
      old.forEach((command, i) => {
        const { drawn, op, isRelative } = command;
        // T continues from the control point of the previous command, m from its end.
        if (op === "T" || (op === "M" && isRelative)) return;
        if (drawn?.subpath === subpath && drawn.segment >= node - 1 && drawn.segment <= node + 1)
          return;
        const bare = (s: string) => s.replace(/^[a-zA-Z]\s*/, "");
        expect(
          bare(text(result, now[i])),
          `seed ${seed}, command ${i}, node ${node}\n${d}\n${result}`,
        ).toBe(bare(text(d, command)));
        ++kept;
      });
    }
    expect(kept).toBeGreaterThan(2000);
  });

  test("any other curve in its place is read back, and the others stay", () => {
    for (let seed = 0; seed < 2000; ++seed) {
      const random = new Random(seed);
      const d = randomData(random);
      const paths = readPath(d);
      if (paths.length === 0) continue;
      const index = random.below(paths.length);
      const after = random.chance(0.15) ? null : edited(paths[index], random);
      const result = rewritePath(d, index, paths[index], after, STEP);
      const found = readPath(result);
      const wanted = paths.flatMap((path, i) => (i !== index ? [path] : after ? [after] : []));
      expect(found.length, `seed ${seed}\n${d}\n${result}`).toBe(wanted.length);
      wanted.forEach((path, i) =>
        expect(miss(found[i], path), `seed ${seed}\n${d}\n${result}`).toBeLessThan(HALF),
      );
    }
  });

  test("many small moves do not let the other nodes drift", () => {
    let d = "m 10.123,20.456 c 1.5,2.25 3,4 5.5,6 7,8 9,10 11,12 l 3,4 5,6 h 7";
    const first = readPath(d)[0];
    const random = new Random(5);
    for (let i = 0; i < 500; ++i) {
      const [path] = readPath(d);
      d = rewritePath(d, 0, path, moved(path, 1, random.point(0.1)), STEP);
    }
    const last = readPath(d)[0];
    for (const i of [0, 6, 9, 12, 15])
      expect(distance(first.points[i], last.points[i])).toBeLessThan(STEP);
    expect(d).toMatch(/^m 10\.123,20\.456 c .* l 3,4 5,6 h 7$/);
  });

  test("a circle keeps the quarters that did not change as arcs", () => {
    const d =
      "M50 30 A20 20 0 0 1 30 50 A20 20 0 0 1 10 30 A20 20 0 0 1 30 10 A20 20 0 0 1 50 30 Z";
    const [path] = readPath(d);
    const result = rewritePath(d, 0, path, moved(path, 6, [1, 0]), STEP);
    expect(result).toContain("M50 30 A20 20 0 0 1 30 50 C");
    expect(result).toContain("A20 20 0 0 1 30 10 A20 20 0 0 1 50 30 Z");
  });
});

/** Removes, adds and exchanges pieces, and opens and closes ends. */
function edited(path: CubicPath, random: Random): CubicPath {
  let points = [...path.points];
  for (let edits = random.below(3); edits >= 0; --edits) {
    const at = 3 * random.below((points.length - 1) / 3);
    const pieces = Array.from({ length: 3 * random.below(3) }, () => random.point());
    const removed = points.length > 4 ? 3 * random.below(2) : 0;
    points = [...points.slice(0, at + 1), ...pieces, ...points.slice(at + 1 + removed)];
  }
  const closed = random.chance(0.5);
  if (closed) points[points.length - 1] = points[0];
  return { points, closed };
}
