// A drawing with some of its objects alone.
import { expect, test } from "vitest";
import { onlyItems } from "../../../../web/editor/src/model/commands/index.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";

const text = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 9 9">
  <defs><linearGradient id="g"/></defs>
  <g id="low" sf:diffuse="true"><path id="a" d="M0 0L9 9"/></g>
  <g id="group"><g id="inner" sf:diffuse="true"><path id="b" d="M0 9L9 0"/></g></g>
  <use id="copy" href="#low" x="3"/>
</svg>`;

const drawing = openDrawing(text);
const handleOf = (name: string) => [...drawing.all()].find((item) => item.name === name)!.handle;

test("only the objects with the selection are drawn, originals of linked copies too", () => {
  const now = onlyItems(drawing, [handleOf("copy")]);
  expect(now).toContain('<defs><g id="low" sf:diffuse="true"><path id="a" d="M0 0L9 9"/></g></defs>');
  expect(now).toContain('<defs><g id="group">');
  expect(now).toMatch(/\n {2}<use id="copy"/);
  expect(openDrawing(now).items.map(({ name }) => name)).toEqual(["copy"]);
});

test("a curve brings its layer, and that its group", () => {
  const now = onlyItems(drawing, [handleOf("b")]);
  expect(openDrawing(now).items.map(({ name }) => name)).toEqual(["group"]);
  expect(onlyItems(drawing, [handleOf("a"), handleOf("b"), handleOf("copy")])).toBe(text);
});
