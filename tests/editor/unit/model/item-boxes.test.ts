// The box that the panel's fields show and change.
import { expect, test } from "vitest";
import { turning } from "../../../../web/editor/src/geometry/affine.js";
import { transform } from "../../../../web/editor/src/model/commands/index.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { Drawing } from "../../../../web/editor/src/model/types.js";
import { boxOf } from "../../../../web/editor/src/model/item-boxes.js";

const drawingWith = (use: string) =>
  openDrawing(`<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 200 100">
  <g id="a" sf:diffuse="true"><path d="M10 10L30 10L30 40" sf:left="red"/></g>
  <g id="b" transform="translate(5 0)">${use}</g>
  <image id="p" sf:reference="true" href="data:," x="1" y="2" width="30" height="20" transform="scale(2)"/>
</svg>`);

const named = (drawing: Drawing, id: string) =>
  [...drawing.all()].find(({ element }) => element.attributes.some(({ value, name }) => name === "id" && value === id))!;

test("of an instance is where it shows its original", () => {
  const drawing = drawingWith('<use id="u" href="#a" x="20" y="3" transform="scale(2)"/>');
  expect(boxOf([named(drawing, "u")])).toEqual([65, 26, 105, 86]);
  expect(boxOf([named(drawing, "a")])).toEqual([10, 10, 30, 40]);
  expect(boxOf([named(drawing, "p")])).toEqual([2, 4, 62, 44]);
});

test("of what follows nothing is none, and of an instance of an instance is the inner one's", () => {
  expect(boxOf([named(drawingWith('<use id="u" href="#none"/>'), "u")])).toBeNull();
  const nested = drawingWith('<use id="v" href="#a" x="10"/><use id="u" href="#v" y="7"/>');
  const box = boxOf([named(nested, "u")]);
  expect(box).toEqual([25, 17, 45, 47]);
});

test("of a turned instance turns about its middle", () => {
  const drawing = drawingWith('<use id="u" href="#a"/>');
  const use = named(drawing, "u");
  const [x0, y0, x1, y1] = boxOf([use])!;
  const made = transform(drawing, [use.handle], turning([(x0 + x1) / 2, (y0 + y1) / 2], Math.PI / 2), 1e-3);
  drawing.apply(made!.patch);
  const now = named(drawing, "u");
  boxOf([now])!.forEach((value, k) => expect(value).toBeCloseTo([10, 15, 40, 35][k], 2));
  expect((Math.atan2(now.artboardFromItem[1], now.artboardFromItem[0]) * 180) / Math.PI).toBeCloseTo(90);
});
