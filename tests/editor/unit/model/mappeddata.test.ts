// Path data under transforms: the same curve as its transformed points, command for command.
import { expect, test } from "vitest";
import { mapped } from "../../../../web/editor/src/geometry/affine.js";
import type { Affine } from "../../../../web/editor/src/geometry/affine.js";
import { mappedData } from "../../../../web/editor/src/geometry/mappeddata.js";
import { readPath, readPathText } from "../../../../web/editor/src/geometry/path.js";
import { Random } from "../random.js";

const STEP = 1e-5;
const SEPARATORS = [" ", ",", " , ", "\n"];
const COUNTS: Readonly<Record<string, number>> = { M: 2, L: 2, H: 1, V: 1, C: 6, S: 4, Q: 4, T: 2, A: 7, Z: 0 };

function randomData(random: Random, ops: string): string {
  let d = "";
  for (let i = 0; i < 2 + random.below(8); i += 1) {
    const op = i === 0 ? "M" : random.pick([...ops]);
    const letter = random.chance(0.5) ? op.toLowerCase() : op;
    const numbers: string[] = [];
    const count = COUNTS[op] * (1 + random.below(op === "M" ? 1 : 2));
    for (let k = 0; k < count; k += 1) {
      const isFlag = op === "A" && (k % 7 === 3 || k % 7 === 4);
      const value = op === "A" && k % 7 < 2 ? random.between(40, 80) : random.between(-30, 30);
      const places = random.below(4);
      numbers.push(isFlag ? String(random.below(2)) : value.toFixed(places).replace(/^(-?)0\./, "$1."));
    }
    d += letter + numbers.join(random.pick(SEPARATORS));
  }
  return d;
}

function randomMap(random: Random, kind: string): Affine {
  const [x, y] = random.point();
  if (kind === "translation") return [1, 0, 0, 1, x, y];
  if (kind === "scaling") return [random.between(0.3, 3), 0, 0, random.between(-3, -0.3), x, y];
  const angle = random.between(0, 7);
  const [c, s] = [2 * Math.cos(angle), 2 * Math.sin(angle)];
  if (kind === "similarity") return random.chance(0.5) ? [c, s, -s, c, x, y] : [c, s, s, -c, x, y];
  return [c, s, random.between(-2, 2), random.between(-2, 2), x, y];
}

test.each([
  ["translation", "LHVCSQTAZM"],
  ["similarity", "LHVCSQTAZM"],
  ["scaling", "LHVCSQTZM"],
  ["any", "LHVCSQTZM"],
])("%s", (kind, ops) => {
  const random = new Random(kind.length);
  for (let i = 0; i < 600; i += 1) {
    const data = randomData(random, ops);
    const map = randomMap(random, kind);
    const written = mappedData(data, map, STEP) as string;
    const context = `${data} by ${map} became ${written}`;
    const [before, now] = [readPath(data), readPath(written)];
    expect(readPathText(written)?.commands.length, context).toBe(readPathText(data)?.commands.length);
    expect(now.map(({ points }) => points.length), context).toEqual(before.map(({ points }) => points.length));
    before.forEach(({ points, closed }, k) => {
      expect(now[k].closed, context).toBe(closed);
      points.forEach((p, n) => {
        const [x, y] = mapped(map, p);
        const apart = Math.hypot(now[k].points[n][0] - x, now[k].points[n][1] - y);
        expect(apart, context).toBeLessThan(data.match(/[aA]/) ? 1e-2 : 2e-4);
      });
    });
  }
});

test("relative commands stay letter for letter under a translation", () => {
  expect(mappedData("m 10,20 c1-2 3,4 5 6 h4z m1.5.5l2,2", [1, 0, 0, 1, 5, -5], 0.01)).toBe(
    "m15 15 c1-2 3,4 5 6 h4z m1.5.5l2,2",
  );
});

test("an arc that the map bends, and a mistake, are left to others", () => {
  expect(mappedData("M0 0A5 5 0 0 1 9 9", [2, 0, 0, 1, 0, 0], 0.01)).toBeNull();
  expect(mappedData("M0 0L", [1, 0, 0, 1, 1, 0], 0.01)).toBeNull();
});
