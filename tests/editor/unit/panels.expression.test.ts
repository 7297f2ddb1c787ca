// Sums in fields.
import { describe, expect, it } from "vitest";
import { evaluate } from "../../../web/editor/src/panels/controls/expression.js";
import { randomFrom } from "./random.js";

describe("a field's sum", () => {
  it.each([
    ["30*2", 60],
    ["1+2*3", 7],
    ["(1+2)*3", 9],
    ["8/4/2", 1],
    ["10-4-3", 3],
    ["-3.5", -3.5],
    ["--2", 2],
    ["2*-3", -6],
    [".5", 0.5],
    ["5.", 5],
    ["1,5", 1.5],
    ["1e3", 1000],
    [" 1 + 1 ", 2],
    ["3×4÷2−1", 5],
  ])("%s is %d", (text, value) => expect(evaluate(text)).toBeCloseTo(value, 12));

  it.each([
    "",
    " ",
    "abc",
    "1+",
    "*2",
    "(1",
    "1)",
    "1 2",
    "1..2",
    "2px",
    "1/0",
    "0/0",
    "1e999",
    "alert(1)",
    "()",
    "+",
    "1e",
  ])("%j is none", (text) => expect(evaluate(text)).toBeNull());

  it("of any depth ends", () => {
    expect(evaluate(`${"(".repeat(1e5)}1${")".repeat(1e5)}`)).toBeNull();
    expect(evaluate(`${"-".repeat(1e5)}1`)).toBeNull();
  });

  it("agrees with the language on sums that are made at random", () => {
    const random = randomFrom(5);
    const made = (depth: number): string => {
      if (depth === 0 || random() < 0.3) return (random() * 20).toFixed(2);
      const op = "+-*/"[Math.floor(random() * 4)];
      const text = `${made(depth - 1)}${op}${made(depth - 1)}`;
      return random() < 0.5 ? `(${text})` : text;
    };
    for (let i = 0; i < 500; ++i) {
      const text = made(4);
      const wanted = new Function(`return ${text}`)() as number;
      if (Number.isFinite(wanted)) expect(evaluate(text)).toBeCloseTo(wanted, 6);
    }
  });
});
