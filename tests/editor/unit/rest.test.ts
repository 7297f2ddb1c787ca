// When a picture is made exact.
import { describe, expect, it } from "vitest";
import { Rest } from "../../../web/editor/src/engine/rest.js";

describe("a hand that rests", () => {
  it("does not keep what opens a drawing, or changes once, waiting", () => {
    const rest = new Rest();
    expect(rest.afterChange(false, 0)).toBe(0);
    expect(rest.afterChange(false, 5000)).toBe(0);
  });

  it("is waited for after changes that follow each other", () => {
    const rest = new Rest();
    rest.afterChange(false, 0);
    expect(rest.afterChange(false, 200)).toBeGreaterThan(0);
    expect(rest.afterChange(false, 400)).toBeGreaterThan(0);
  });

  it("is waited for longest within a gesture, also at its beginning", () => {
    const rest = new Rest();
    const held = rest.afterChange(true, 0);
    expect(held).toBeGreaterThan(rest.afterChange(false, 100));
    expect(rest.again(true)).toBe(held);
  });

  it("is waited for longer yet where it would be held up", () => {
    const rest = new Rest();
    const held = rest.afterChange(true, 1000);
    const left = rest.left(1000 + held);
    expect(left).toBeGreaterThan(held);
    expect(rest.left(1000 + held + left)).toBe(0);
    expect(rest.left(20_000)).toBe(0);
  });
});
