// The palette of a document: read from any program's swatches, added to and removed from.
import { describe, expect, test } from "vitest";
import { hexOf } from "../../../../web/editor/src/geometry/colortext.js";
import { addSwatches, removeSwatch } from "../../../../web/editor/src/model/commands/index.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import { swatchesOf } from "../../../../web/editor/src/model/swatches.js";
import type { Drawing } from "../../../../web/editor/src/model/types.js";
import { after, documentOf } from "../support/shapes.js";

const RED = { r: 1, g: 0, b: 0 };
const BLUE = { r: 0, g: 0, b: 1 };
const hexes = (drawing: Drawing) => swatchesOf(drawing).map(({ color }) => hexOf(color));

const inkscapes = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" xmlns:i="http://www.inkscape.org/namespaces/inkscape"
  xmlns:osb="http://www.openswatchbook.org/uri/2009/osb" viewBox="0 0 9 9">
  <defs>
    <linearGradient id="new" i:swatch="solid"><stop style="stop-color:#ff0000;stop-opacity:1"/></linearGradient>
    <linearGradient id="old" osb:paint="solid"><stop stop-color="gold"/></linearGradient>
    <linearGradient id="plain"><stop stop-color="lime"/></linearGradient>
    <linearGradient id="two" i:swatch="gradient"><stop/><stop/></linearGradient>
  </defs>
  <g sf:diffuse="true"><path id="p" d="M0 0L9 9" sf:left="url(#new)"/></g>
</svg>`;

describe("a palette", () => {
  test("is what Inkscape marks as swatches", () => {
    const found = swatchesOf(openDrawing(inkscapes));
    expect(found.map(({ name, color }) => [name, hexOf(color)])).toEqual([["new", "#ff0000"], ["old", "#ffd700"]]);
  });

  test("is read again when its elements change, and not for an edit of a curve", () => {
    const drawing = openDrawing(inkscapes);
    const before = swatchesOf(drawing);
    const edit = (from: string, to: string) => drawing.apply([{ at: drawing.text.indexOf(from), removed: from, inserted: to }]);
    edit('d="M0 0L9 9"', 'd="M0 0L5 5"');
    expect(swatchesOf(drawing)).toBe(before);
    edit('stop-color="gold"', 'stop-color="tan"');
    expect(hexes(drawing)).toEqual(["#ff0000", "#d2b48c"]);
    edit('id="old"', 'id="tan"');
    expect(swatchesOf(drawing).map(({ name }) => name)).toEqual(["new", "tan"]);
    edit('stop-color="tan"', 'stop-color="currentColor"');
    edit('viewBox="0 0 9 9"', 'viewBox="0 0 9 9" color="blue"');
    expect(hexes(drawing)).toEqual(["#ff0000", "#0000ff"]);
  });

  test("gets each colour once, in a file that had none", () => {
    const drawing = openDrawing(documentOf('<path d="M0 0L9 9"/>'));
    const next = after(drawing, addSwatches(drawing, [RED, BLUE, RED]));
    expect(hexes(next)).toEqual(["#ff0000", "#0000ff"]);
    expect(next.text).toMatch(/<defs>\s*<linearGradient id="color-ff0000" inkscape:swatch="solid"><stop stop-color="#f00"\/>/);
    expect(addSwatches(next, [BLUE])).toBeNull();
    expect(addSwatches(next, [])).toBeNull();
  });

  test("is added to where it is, with names that are free", () => {
    const drawing = openDrawing(inkscapes.replace('id="plain"', 'id="color-0000ff"'));
    const next = after(drawing, addSwatches(drawing, [BLUE]));
    expect(next.text).toContain('<linearGradient id="color-0000ff-2" i:swatch="solid">');
    expect(hexes(next)).toEqual(["#ff0000", "#ffd700", "#0000ff"]);
  });

  test("loses a colour, and the text is as before", () => {
    const drawing = openDrawing(documentOf('<path d="M0 0L9 9"/>'));
    const more = after(drawing, addSwatches(drawing, [RED]));
    const both = after(more, addSwatches(more, [BLUE]));
    const less = after(both, removeSwatch(both, swatchesOf(both)[1]));
    expect(less.text).toBe(more.text);
  });

  test("loses a colour that a curve shows: its gradient stays", () => {
    const drawing = openDrawing(inkscapes);
    const next = after(drawing, removeSwatch(drawing, swatchesOf(drawing)[0]));
    expect(next.text).toContain('<linearGradient id="new">');
    expect(hexes(next)).toEqual(["#ffd700"]);
  });
});
