// Edits of stop lists in ribbons and profiles.
import { describe, expect, it } from "vitest";
import { withOffset } from "../../../web/editor/src/canvas/sides.js";
import { openDrawing } from "../../../web/editor/src/model/drawing.js";
import type { CurveItem } from "../../../web/editor/src/model/types.js";
import {
  backwards,
  distributed,
  mixNumbers,
  movedStop,
  settled,
  valueAt,
  withStop,
  withoutStop,
  type Stops,
} from "../../../web/editor/src/panels/stops.js";
import { tinted, type Tints } from "../../../web/editor/src/panels/tints.js";
import { randomFrom } from "./random.js";

const list = (...stops: readonly [number, number][]): Stops<number> => ({
  kind: "stops",
  space: "arc",
  stops: stops.map(([offset, value]) => ({ offset, value })),
});
const offsets = ({ stops }: Stops<number>) => stops.map(({ offset }) => offset);
const values = ({ stops }: Stops<number>) => stops.map(({ value }) => value);

const SQUARE = curveOfText("M0 0H100V100H0Z");
const LINE = curveOfText("M0 0H100H400");

function curveOfText(d: string): CurveItem {
  const source = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 400 400"><g sf:diffuse="true"><path d="${d}" sf:left="red"/></g></svg>`;
  return [...openDrawing(source).all()].find(({ kind }) => kind === "curve") as CurveItem;
}

describe("the stops of a side", () => {
  it("are distributed from end to end, and around a ring", () => {
    expect(offsets(distributed(LINE, list([0.1, 1], [0.2, 2], [0.3, 3])))).toEqual([0, 0.5, 1]);
    expect(offsets(distributed(SQUARE, list([0, 1], [0.1, 2], [0.2, 3], [1, 1])))).toEqual([0, 0.3333, 0.6667, 1]);
    expect(offsets(distributed(LINE, list([0.7, 1])))).toEqual([0]);
    const segments = { ...list([0, 1], [1, 2], [2, 3]), space: "parameter" as const };
    expect(offsets(distributed(LINE, segments))[1]).toBeCloseTo(1 + 100 / 300, 4);
  });

  it("are reversed, and twice reversed as they were", () => {
    const before = list([0, 1], [0.3, 2], [0.3, 3], [0.9, 4]);
    const once = backwards(LINE, before);
    expect(once).toEqual(list([0.1, 4], [0.7, 3], [0.7, 2], [1, 1]));
    expect(backwards(LINE, once)).toEqual(before);
  });

  it("close a ring: a new one at the end stands before that, and the one that closes it is the first", () => {
    const ring = list([0, 1], [0.5, 2], [1, 1]);
    const added = settled(SQUARE, ring, withStop(ring, { offset: 1, value: 7 }));
    expect([values(added.value), added.index]).toEqual([[1, 2, 7, 1], 2]);
    expect(settled(SQUARE, list([0, 1], [0.5, 2], [0.9, 1]), movedStop(list([0, 1], [0.5, 2], [0.9, 1]), 2, 1)).index).toBe(0);
    const opened = settled(LINE, ring, withStop(ring, { offset: 1, value: 7 }));
    expect([values(opened.value), opened.index]).toEqual([[1, 2, 1, 7], 3]);
  });

  it("wait at the start of a closed curve when they are dragged past it on the stage", () => {
    const to = (stops: Stops<number>, index: number, offset: number, end: number | null) =>
      offsets(withOffset(stops, index, offset, end) as Stops<number>);
    const ring = list([0.1, 1], [0.5, 2], [0.9, 3]);
    expect(to(ring, 0, 0.97, 1)).toEqual([0, 0.5, 0.9]);
    expect(to(ring, 2, 0.04, 1)).toEqual([0.1, 0.5, 1]);
    expect(to(ring, 1, 0.95, 1)).toEqual([0.1, 0.9, 0.9]);
    expect(to(list([0.4, 1]), 0, 0.98, 1)).toEqual([0.98]);
    expect(to(ring, 0, 0.97, null)).toEqual([0.5, 0.5, 0.9]);
  });
});

describe("a list of stops", () => {
  it("is linear between stops and constant beyond them", () => {
    const { stops } = list([0.2, 10], [0.6, 30]);
    expect(valueAt(stops, 0, mixNumbers)).toBe(10);
    expect(valueAt(stops, 0.4, mixNumbers)).toBeCloseTo(20, 12);
    expect(valueAt(stops, 1, mixNumbers)).toBe(30);
  });

  it("has, at a hard step, the value behind it", () => {
    expect(valueAt(list([0, 1], [0.5, 2], [0.5, 8], [1, 9]).stops, 0.5, mixNumbers)).toBe(8);
  });

  it("keeps its order when a stop passes others, and tells where it went", () => {
    const { value, index } = movedStop(list([0, 1], [0.3, 2], [0.6, 3], [1, 4]), 1, 0.8);
    expect(values(value)).toEqual([1, 3, 2, 4]);
    expect(index).toBe(2);
  });

  it("keeps a hard step that is moved onto its own place", () => {
    const step = list([0, 1], [0.5, 2], [0.5, 8], [1, 9]);
    expect(values(movedStop(step, 1, 0.5).value)).toEqual([1, 2, 8, 9]);
    expect(values(movedStop(step, 2, 0.5).value)).toEqual([1, 2, 8, 9]);
  });

  it("stays in order, keeps what it holds and its values, whatever is done", () => {
    const random = randomFrom(11);
    let now = list([0, 0], [1, 1]);
    for (let i = 0; i < 2000; ++i) {
      const at = Math.round(random() * 20) / 20;
      const index = Math.floor(random() * now.stops.length);
      const before = now;
      if (random() < 0.4) {
        const placed = withStop(now, { offset: at, value: valueAt(now.stops, at, mixNumbers) });
        expect(placed.value.stops[placed.index].offset).toBe(at);
        now = placed.value;
        // A new stop with the present value there changes nothing visible.
        for (const t of [0, 0.13, 0.5, 0.77, 1]) {
          expect(valueAt(now.stops, t, mixNumbers)).toBeCloseTo(
            valueAt(before.stops, t, mixNumbers),
            9,
          );
        }
      } else if (random() < 0.5 && now.stops.length > 2) {
        now = withoutStop(now, index);
        expect(now.stops.length).toBe(before.stops.length - 1);
      } else {
        const placed = movedStop(now, index, at);
        expect(placed.value.stops[placed.index]).toEqual({
          offset: at,
          value: before.stops[index].value,
        });
        expect([...values(placed.value)].sort()).toEqual([...values(before)].sort());
        now = placed.value;
      }
      expect(offsets(now)).toEqual([...offsets(now)].sort((a, b) => a - b));
    }
  });
});

describe("tinted()", () => {
  const grey = (k: number, alpha = 1) => ({ r: k, g: k, b: k, alpha });
  const tints = (gradient: object | null): Tints =>
    ({
      list: { kind: "stops", space: "arc", stops: [0, 0.5, 1].map((k) => ({ offset: k, value: grey(k, gradient ? k : 1) })) },
      gradient,
    }) as unknown as Tints;
  const red = { r: 1, g: 0, b: 0 };

  it("recolours the selected stops", () => {
    const { stops } = tinted(tints(null), [0, 2], red);
    expect(stops.map(({ value }) => value.g)).toEqual([0, 0.5, 0]);
    expect(stops.map(({ value }) => value.r)).toEqual([1, 0.5, 1]);
  });

  it("replaces all stops of a side by a single one", () => {
    expect(tinted(tints(null), null, red).stops).toEqual([{ offset: 0, value: { ...red, alpha: 1 } }]);
  });

  it("keeps the places and the alpha of a gradient's stops", () => {
    const { stops } = tinted(tints({}), null, red);
    expect(stops.map(({ offset }) => offset)).toEqual([0, 0.5, 1]);
    expect(stops.map(({ value }) => value)).toEqual([0, 0.5, 1].map((alpha) => ({ ...red, alpha })));
  });
});
