// Places where rows of the tree may be dropped, and the results.
import { describe, expect, it } from "vitest";
import { openDrawing } from "../../../web/editor/src/model/drawing.js";
import type { Drawing } from "../../../web/editor/src/model/types.js";
import { moveInto } from "../../../web/editor/src/model/commands/index.js";
import { dropAt } from "../../../web/editor/src/panels/layers/drop.js";
import { nextBeginning } from "../../../web/editor/src/panels/controls/typed.js";
import { rowsOf } from "../../../web/editor/src/panels/layers/rows.js";

const curve = (id: string) => `<path id="${id}" d="M0 0L9 9" sf:left="red"/>`;
const text = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 90 90">
<g id="ground" sf:diffuse="true">${curve("a")}${curve("b")}</g>
<g id="both"><g id="inner" sf:diffuse="true">${curve("c")}</g></g>
<g id="sky" sf:diffuse="true">${curve("d")}</g>
</svg>`;

const all = (drawing: Drawing) => new Set([...drawing.all()].map(({ handle }) => handle));
const named = (drawing: Drawing, name: string) =>
  [...drawing.all()].find((item) => item.name === name)!;
const names = (drawing: Drawing, open = all(drawing)) =>
  rowsOf(drawing, open).map(({ item }) => item.name);

describe("rows", () => {
  it("stand with the uppermost first, and those within what is unfolded", () => {
    const drawing = openDrawing(text);
    expect(names(drawing)).toEqual(["sky", "d", "both", "inner", "c", "ground", "b", "a"]);
    expect(names(drawing, new Set())).toEqual(["sky", "both", "ground"]);
  });

  it("are found by their first letters, going round", () => {
    const shown = ["Sky", "both", "ground", "green"];
    expect(nextBeginning(shown, 1, "s")).toBe(0);
    expect(nextBeginning(shown, 2, "g")).toBe(3);
    expect(nextBeginning(shown, 2, "gr")).toBe(2);
    expect(nextBeginning(shown, 2, "gre")).toBe(3);
    expect(nextBeginning(shown, 0, "x")).toBe(-1);
    expect(nextBeginning([], 0, "x")).toBe(-1);
  });
});

/** Returns the rows after dropping `what` at a height (in rows) and depth. */
function dropped(what: string, y: number, depth: number): string[] | null {
  const drawing = openDrawing(text);
  const item = named(drawing, what);
  const drop = dropAt(drawing, rowsOf(drawing, all(drawing)), y, depth, [item]);
  if (!drop) return null;
  const outcome = moveInto(drawing, [item.handle], drop.parent?.handle ?? null, drop.index);
  if (outcome) drawing.apply(outcome.patch);
  return names(drawing);
}

describe("a dragged row", () => {
  it("goes above the row over whose upper part it is let go", () => {
    expect(dropped("ground", 0.1, 0)).toEqual([
      "ground",
      "b",
      "a",
      "sky",
      "d",
      "both",
      "inner",
      "c",
    ]);
  });

  it("goes to the bottom below the last row", () => {
    expect(dropped("sky", 7.9, 0)).toEqual(["both", "inner", "c", "ground", "b", "a", "sky", "d"]);
  });

  it("goes into a container over whose middle it is let go", () => {
    expect(dropped("d", 5.5, 1)).toEqual(["sky", "both", "inner", "c", "ground", "d", "b", "a"]);
  });

  it("goes to the top of what is unfolded, just below its row", () => {
    expect(dropped("a", 1.0, 1)).toEqual(["sky", "a", "d", "both", "inner", "c", "ground", "b"]);
  });

  it("takes the depth of the pointer at the end of a group", () => {
    expect(dropped("sky", 4.9, 1)).toEqual(["both", "inner", "c", "sky", "d", "ground", "b", "a"]);
    expect(dropped("sky", 4.9, 0)).toEqual(["both", "inner", "c", "sky", "d", "ground", "b", "a"]);
  });

  it("does not go into itself, nor a curve out of the layers", () => {
    expect(dropped("both", 3.5, 1)).toBeNull();
    expect(dropped("a", 0.0, 0)).toBeNull();
    expect(dropped("sky", 5.5, 1)).not.toEqual([
      "both",
      "inner",
      "c",
      "ground",
      "sky",
      "d",
      "b",
      "a",
    ]);
  });
});
