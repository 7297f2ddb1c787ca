// The syntax of colours that C++ and TypeScript share, and the further colours that fields accept.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, test } from "vitest";
import { hexOf } from "../../../../web/editor/src/geometry/colortext.js";
import { parseColor, parseTyped } from "../../../../web/editor/src/source/colors.js";
import { repository } from "../corpus.js";

const rows = readFileSync(join(repository, "tests/color/colors.txt"), "utf8")
  .split("\n")
  .filter((line) => line !== "" && !line.startsWith("//"))
  .map((line) => {
    const mark = line.lastIndexOf(" | ");
    return [line.slice(0, mark), line.slice(mark + 3)] as const;
  });

describe("the table of colours", () => {
  test("is a long one", () => expect(rows.length).toBeGreaterThan(150));

  test.each(rows)("%s is %s", (text, expected) => {
    const color = parseColor(text);
    if (expected === "error") return expect(color).toBeNull();
    const values = expected.split(" ").slice(0, 4).map(Number);
    const found = color ? [color.rgb.r, color.rgb.g, color.rgb.b, color.alpha] : [];
    expect(found).toHaveLength(4);
    found.forEach((value, i) => expect(Math.abs(value - values[i])).toBeLessThan(1e-5));
  });
});

describe("a field", () => {
  test.each([
    ["F80", "#ff8800"],
    ["  #Ff8800 ", "#ff8800"],
    ["ff8800ff", "#ff8800"],
    [" rebeccapurple ", "#663399"],
    ["rgba(255,136,0,1)", "#ff8800"],
    ["oklch(51.975% 0.17686 142.495)", "#008000"],
    ["color(display-p3 0 1 0)", "#00fb29"],
  ])("takes %s as %s", (text, hex) => {
    const color = parseTyped(text);
    expect(color && hexOf(color)).toBe(hex);
  });

  test.each(["", "#", "12", "f808", "#12345678", "constructor", "toString(1 2 3)", "transparent"])(
    "takes %j for no opaque colour",
    (text) => expect(parseTyped(text)).toBeNull(),
  );
});
