// Colours of closed curves meet at the seam, whatever is edited.
import { describe, expect, test } from "vitest";
import { deleteStop } from "../../../../web/editor/src/app/stops.js";
import { setColor } from "../../../../web/editor/src/model/commands/index.js";
import type { CurveItem, Drawing, SideValue, StopSpace } from "../../../../web/editor/src/model/types.js";
import type { Rgb } from "../../../../web/editor/src/geometry/color.js";
import { after, named } from "../drawings.js";

const RED = { r: 1, g: 0, b: 0 };
const LIME = { r: 0, g: 1, b: 0 };
const BLUE = { r: 0, g: 0, b: 1 };
const CIRCLE = "M200 100C300 100 300 300 200 300C100 300 100 100 200 100Z";
const OPEN = CIRCLE.replace("200 100Z", "200 110");

const drawing = (colors: string, shape = CIRCLE) =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 400 400"><g sf:diffuse="true"><path id="c" d="${shape}" sf:left="#eee" sf:right="${colors}"/></g></svg>`;
const curve = (d: Drawing) => named(d, "c") as CurveItem;
const stops = (...list: readonly (readonly [number, Rgb])[]) => list.map(([offset, value]) => ({ offset, value }));

/** Returns the right side's colours as they are written after an edit to these stops. */
function written(before: string, list: ReturnType<typeof stops>, shape = CIRCLE, space: StopSpace = "arc"): string {
  const to: SideValue<Rgb> = { kind: "stops", space, stops: list };
  const text = after(drawing(before, shape), (d) => setColor(d, curve(d).handle, "right", to));
  return /sf:right="([^"]*)"/.exec(text)![1];
}

describe("on a closed curve", () => {
  test("a stop with another colour gets the first colour behind it", () => {
    expect(written("#f00", stops([0, RED], [0.5, BLUE]))).toBe("#f00, #00f 50%, #f00");
  });

  test("the end of a list that counts segments is the last node", () => {
    expect(written("#f00 @0", stops([0, RED], [1, BLUE]), CIRCLE, "parameter")).toBe("#f00 @0, #00f @1, #f00 @2");
  });

  test.each([
    ["first", stops([0, LIME], [0.5, BLUE], [1, RED])],
    ["last", stops([0, RED], [0.5, BLUE], [1, LIME])],
  ])("the %s stop gives its colour to the other one at the seam", (_, list) => {
    expect(written("#f00, #00f, #f00", list)).toBe("#0f0, #00f 50%, #0f0");
  });

  test("a stop that comes before the first one ends the list", () => {
    expect(written("#f00 20%", stops([0.1, BLUE], [0.2, RED]))).toBe("#00f 10%, #f00 20%, #00f");
  });

  test.each([
    ["first", "#f00, #00f, #f00", 0, "#00f"],
    ["last", "#f00, #00f, #f00", 2, "#00f"],
    ["first of four", "#f00, #00f 30%, #0f0 60%, #f00", 0, "#00f 30%, #0f0 60%, #00f"],
    ["middle", "#f00, #00f, #f00", 1, "#f00, #f00"],
  ])("the %s stop is deleted, and no seam shows", (_, before, index, expected) => {
    const text = after(drawing(before), (d) => deleteStop(d, curve(d), { kind: "stop", side: "right", attribute: "color", index }));
    expect(/sf:right="([^"]*)"/.exec(text)![1]).toBe(expected);
  });

  test("a seam that the drawing has stays until somebody closes it", () => {
    expect(written("#f00, #00f", stops([0, RED], [0.5, LIME], [1, BLUE]))).toBe("#f00, #0f0 50%, #00f");
  });
});

test("an open curve may end with any colour", () => {
  expect(written("#f00", stops([0, RED], [0.5, BLUE]), OPEN)).toBe("#f00, #00f 50%");
});
