// Colours of closed curves meet at the seam, whatever is edited.
import { describe, expect, test } from "vitest";
import { deleteStop } from "../../../../web/editor/src/app/stops.js";
import { shownStops } from "../../../../web/editor/src/model/seams.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import { setColor, setNumbers } from "../../../../web/editor/src/model/commands/index.js";
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
    ["first of four", "#f00, #00f 30%, #0f0 60%, #f00", 0, "#00f 30%, #0f0 60%, #00f"],
    ["middle", "#f00, #00f, #f00", 1, "#f00, #f00"],
  ])("the %s stop is deleted, and no seam shows", (_, before, index, expected) => {
    const text = after(drawing(before), (d) => deleteStop(d, curve(d), { kind: "stop", side: "right", attribute: "color", index }));
    expect(/sf:right="([^"]*)"/.exec(text)![1]).toBe(expected);
  });

  test.each([
    ["the first stop in front of the others", "#f00 10%, #00f 50%, #f00", stops([0.05, BLUE], [0.1, RED], [1, RED]), "#00f 5%, #f00 10%, #00f"],
    ["one that was added at the end", "#f00, #00f, #f00", stops([0, RED], [0.5, BLUE], [1, RED], [1, LIME]), "#f00, #00f 50%, #0f0 100%, #f00"],
    ["the first colour, which is not at the start", "#f00 20%, #00f 50%, #f00", stops([0.2, LIME], [0.5, BLUE], [1, RED]), "#0f0 20%, #00f 50%, #0f0"],
    ["a stop moved to the end", "#f00, #00f, #f00", stops([0, RED], [1, BLUE], [1, RED]), "#f00, #00f 100%, #f00"],
    ["a single stop beside a new one at the end", "#f00", stops([0, RED], [1, BLUE]), "#f00, #00f 100%, #f00"],
    ["the order reversed", "#f00 20%, #00f 50%, #f00", stops([0, RED], [0.5, BLUE], [0.8, RED]), "#f00, #00f 50%, #f00 80%"],
  ])("no colour is lost: %s", (_, before, list, expected) => {
    expect(written(before, list)).toBe(expected);
  });

  test("colours of a side that had none end as they begin", () => {
    const to = (list: ReturnType<typeof stops>): SideValue<Rgb> => ({ kind: "stops", space: "arc", stops: list });
    const set = (list: ReturnType<typeof stops>) =>
      after(drawing("none"), (d) => setColor(d, curve(d).handle, "right", to(list)));
    expect(set(stops([0, RED], [0.5, BLUE], [1, LIME]))).toContain('sf:right="#f00, #00f 50%, #f00"');
    expect(set(stops([0, RED], [0.5, BLUE]))).toContain('sf:right="#f00, #00f 50%, #f00"');
  });

  test.each(["opacity", "blur"] as const)("%s meets as colours do", (attribute) => {
    const to: SideValue<number> = { kind: "stops", space: "arc", stops: [{ offset: 0, value: 1 }, { offset: 0.4, value: 0.5 }] };
    const one = drawing("#f00").replace("/></g>", ` sf:left-${attribute}="1"/></g>`);
    const ends = after(one, (d) => setNumbers(d, curve(d).handle, "left", attribute, to));
    expect(ends).toContain(`sf:left-${attribute}="1, .5 40%, 1"`);
  });

  test.each([
    ["#f00, #00f, #f00", 2],
    ["#f00 10%, #00f, #f00", 2],
    ["#f00, #f00", 1],
    ["#f00", 1],
    ["#f00, #00f", 2],
    ["#f00, #00f 80%, #f00 90%", 3],
    ["#f00 @0, #00f @1, #f00 @2", 2],
    ["#f00, #00f 100%, #f00", 2],
  ])("%s shows %d stops", (colors, count) => {
    const { color } = curve(openDrawing(drawing(colors))).right;
    expect(color.kind === "stops" && shownStops(curve(openDrawing(drawing(colors))), color)).toBe(count);
  });

  test("the last stop that is shown leaves an open side", () => {
    const opened = after(drawing("#f00, #f00"), (d) => deleteStop(d, curve(d), { kind: "stop", side: "right", attribute: "color", index: 0 }));
    expect(opened).not.toContain("sf:right");
  });

  test("ends that meet without Z are closed, and one open subpath makes no ring", () => {
    const bare = CIRCLE.replace("Z", "");
    expect(written("#f00", stops([0, RED], [0.5, BLUE]), bare)).toBe("#f00, #00f 50%, #f00");
    expect(written("#f00", stops([0, RED], [0.5, BLUE]), `${CIRCLE}M10 10H20`)).toBe("#f00, #00f 50%");
  });

  test("a seam that the drawing has stays until somebody closes it", () => {
    expect(written("#f00, #00f", stops([0, RED], [0.5, LIME], [1, BLUE]))).toBe("#f00, #0f0 50%, #00f");
  });
});

test("an open curve may end with any colour", () => {
  expect(written("#f00", stops([0, RED], [0.5, BLUE]), OPEN)).toBe("#f00, #00f 50%");
});
