// The first page's texts about the gallery's drawings.
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import { curveCounts } from "../../../../web/editor/src/page/examples.js";

test.each([...curveCounts])("the number of curves of %s is that of its file", (id, count) => {
  const text = readFileSync(new URL(`../../../../examples/${id}.svg`, import.meta.url), "utf8");
  const kinds = [...openDrawing(text).all()].map(({ kind }) => kind);
  expect(kinds.filter((kind) => kind === "curve" || kind === "stroke")).toHaveLength(count);
});
