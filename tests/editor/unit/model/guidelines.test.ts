// Guides in the form of Inkscape: read, written, and kept where they are when the page changes.
import { describe, expect, test } from "vitest";
import {
  addGuide,
  moveGuide,
  removeGuides,
  setArtboard,
  setGuidesLocked,
  setGuidesShown,
} from "../../../../web/editor/src/model/commands/index.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import { areLocked, guidelinesOf } from "../../../../web/editor/src/model/guidelines.js";
import type { Drawing, Outcome } from "../../../../web/editor/src/model/types.js";

const SODIPODI = "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd";
const INKSCAPE = "http://www.inkscape.org/namespaces/inkscape";

/** Returns a document as Inkscape writes it. */
const documentOf = (size: string, guides: string, view = "") =>
  openDrawing(`<svg ${size} xmlns="http://www.w3.org/2000/svg" xmlns:sodipodi="${SODIPODI}" xmlns:inkscape="${INKSCAPE}" xmlns:sf="urn:sfumato:1">
  <sodipodi:namedview id="base" pagecolor="#ffffff"${view}>
    ${guides}
  </sodipodi:namedview>
  <g sf:diffuse="true"><path d="M0 0L9 9" sf:left="red" sf:right="blue"/></g>
</svg>
`);

const guide = (position: string, orientation: string, more = "") =>
  `<sodipodi:guide position="${position}" orientation="${orientation}"${more} />`;

/** Returns each guide as "x 20", "y 30" or "slanted". */
const placesOf = (drawing: Drawing) =>
  guidelinesOf(drawing).all.map(({ axis, point }) =>
    axis === null ? "slanted" : `${"xy"[axis]} ${Number(point[axis].toFixed(6))}`,
  );

function after(drawing: Drawing, outcome: Outcome | null): Drawing {
  expect(outcome).not.toBeNull();
  const next = openDrawing(drawing.text);
  next.apply(outcome!.patch);
  return next;
}

const both = `${guide("20,30", "1,0")}${guide("20,30", "0,-1")}`;

describe("guides of Inkscape", () => {
  test("count from the lower left corner of the page, in units of the viewBox", () => {
    expect(placesOf(documentOf('viewBox="0 0 200 100"', both))).toEqual(["x 20", "y 70"]);
    expect(placesOf(documentOf('width="100mm" height="50mm" viewBox="0 0 200 100"', both))).toEqual(["x 20", "y 70"]);
    expect(placesOf(documentOf('width="200" height="100"', both))).toEqual(["x 20", "y 70"]);
  });

  test("do not count x and y of the viewBox", () => {
    expect(placesOf(documentOf('viewBox="-50 10 200 100"', both))).toEqual(["x -30", "y 80"]);
  });

  test("count shares of the page where its proportions are not the viewBox's", () => {
    // The picture is 400 units wide: 100 more on each side.
    const wide = 'width="400" height="100" viewBox="0 0 200 100"';
    expect(placesOf(documentOf(wide, both))).toEqual(["x -60", "y 70"]);
    const stretched = `${wide} preserveAspectRatio="none"`;
    // The artboard is 200 × 50: pixels are square on it.
    expect(placesOf(documentOf(stretched, both))).toEqual(["x 20", "y 35"]);
  });

  test("have a normal of any length, or the words of old versions", () => {
    const found = documentOf(
      'viewBox="0 0 200 100"',
      [guide("20,30", "793.7,0"), guide("20,30", "horizontal"), guide("40", "vertical"), guide("20,30", "1,1")].join(""),
    );
    expect(placesOf(found)).toEqual(["x 20", "y 70", "x 40", "slanted"]);
    // Up on the page: y of the normal is turned around.
    const [, , , { normal }] = guidelinesOf(found).all;
    expect(normal[0]).toBeCloseTo(Math.SQRT1_2, 9);
    expect(normal[1]).toBeCloseTo(-Math.SQRT1_2, 9);
  });

  test("are vertical where the normal is unreadable, as in Inkscape", () => {
    const odd = ["", "0,0", "a,b", "NaN,1", "1e999,0", "1"].map((normal) => guide("5,5", normal)).join("");
    expect(placesOf(documentOf('viewBox="0 0 200 100"', odd))).toEqual(Array(6).fill("x 5"));
  });

  test("are left out where the place is unreadable or too far, and stay in the file", () => {
    const odd = ["", "a,b", "1", "NaN,NaN", "1e999,3", "9e9,0", "1,", "1 2", "1;2,3"].map((at) => guide(at, "0,1")).join("");
    const drawing = documentOf('viewBox="0 0 200 100"', `${odd}<sodipodi:guide/><other position="1,1"/>`);
    expect(placesOf(drawing)).toEqual(["y 99"]);
    const next = after(drawing, addGuide(drawing, 0, 10));
    expect(next.text).toContain(odd);
  });

  test("hide and lock as the attributes say", () => {
    const size = 'viewBox="0 0 200 100"';
    expect(guidelinesOf(documentOf(size, both)).shown).toBe(true);
    expect(guidelinesOf(documentOf(size, both, ' showguides="true"')).shown).toBe(true);
    expect(guidelinesOf(documentOf(size, both, ' showguides="false"')).shown).toBe(false);
    expect(areLocked(guidelinesOf(documentOf(size, both, ' inkscape:lockguides="true"')).all)).toBe(true);
    const one = documentOf(size, `${both}${guide("1,1", "0,1", ' inkscape:locked="true"')}`);
    expect(guidelinesOf(one).all.map(({ locked }) => locked)).toEqual([false, false, true]);
    expect(areLocked(guidelinesOf(one).all)).toBe(false);
    expect(areLocked([])).toBe(false);
  });

  test("of other namespaces or places are none", () => {
    const drawing = openDrawing(
      `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><namedview><guide position="1,1"/></namedview><g xmlns:s="${SODIPODI}"><s:namedview>${'<s:guide position="1,1"/>'}</s:namedview></g></svg>`,
    );
    expect(guidelinesOf(drawing)).toEqual({ view: null, shown: true, all: [] });
  });
});

describe("a new guide", () => {
  const plain = openDrawing(
    '<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="10 20 200 100">\n  <g sf:diffuse="true"/>\n</svg>\n',
  );

  test("is written as Inkscape reads it, in a file that had none", () => {
    const next = after(plain, addGuide(plain, 1, 50));
    expect(next.text).toBe(
      `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="10 20 200 100" xmlns:sodipodi="${SODIPODI}">
  <sodipodi:namedview><sodipodi:guide position="0,70" orientation="0,1"/></sodipodi:namedview>
  <g sf:diffuse="true"/>
</svg>
`,
    );
    expect(placesOf(next)).toEqual(["y 50"]);
  });

  test("stands behind the others, in their prefix, and shows hidden ones", () => {
    const text = documentOf('viewBox="0 0 200 100"', both, ' showguides="false"').text;
    const drawing = openDrawing(text.replaceAll("sodipodi:", "s:").replace("xmlns:s:", "xmlns:").replace("xmlns:sodipodi", "xmlns:s"));
    const next = after(drawing, addGuide(drawing, 0, 12.5));
    expect(placesOf(next)).toEqual(["x 20", "y 70", "x 12.5"]);
    expect(next.text).toContain('<s:guide position="12.5,0" orientation="1,0"/>');
    expect(guidelinesOf(next).shown).toBe(true);
  });

  test("goes away without a trace but the namespace", () => {
    const added = after(plain, addGuide(plain, 0, 33));
    const less = after(added, removeGuides(added, guidelinesOf(added).all));
    expect(less.text).toBe(plain.text.replace('100">', `100" xmlns:sodipodi="${SODIPODI}">`));
  });

  test("is added to an element that closes itself, and to an empty document", () => {
    const closed = openDrawing(`<svg xmlns="http://www.w3.org/2000/svg" xmlns:sodipodi="${SODIPODI}" viewBox="0 0 9 9"><sodipodi:namedview showguides="0"/></svg>`);
    const next = after(closed, addGuide(closed, 0, 3));
    expect(next.text).toContain('<sodipodi:namedview showguides="true"><sodipodi:guide position="3,0" orientation="1,0"/></sodipodi:namedview>');
    const empty = openDrawing('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"/>');
    expect(placesOf(after(empty, addGuide(empty, 1, 4)))).toEqual(["y 4"]);
  });

  test("keeps its place in pictures of any size", () => {
    for (const [size, at] of [[0.001, 0.000371], [1e6, 123456.5], [3e-6, 1.3e-6]] as const) {
      const drawing = openDrawing(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size} ${size}"/>`);
      for (const axis of [0, 1] as const) {
        const [{ point }] = guidelinesOf(after(drawing, addGuide(drawing, axis, at))).all;
        expect(Math.abs(point[axis] - at)).toBeLessThan(size * 1e-8);
      }
    }
  });
});

describe("a guide", () => {
  const drawing = documentOf('viewBox="0 0 200 100"', `${guide("20.00,30.50", "1,0", ' id="a"')}${guide(" 7 , 30.50", "0,1")}`);

  test("is moved, and its other coordinate stays as it is written", () => {
    const [a, b] = guidelinesOf(drawing).all;
    expect(after(drawing, moveGuide(drawing, a.handle, 25)).text).toBe(drawing.text.replace("20.00,", "25,"));
    expect(after(drawing, moveGuide(drawing, b.handle, 10)).text).toBe(drawing.text.replace(" 7 , 30.50", " 7 ,90"));
    expect(moveGuide(drawing, 99999, 10)).toBeNull();
  });

  test("that is slanted is not moved", () => {
    const slanted = documentOf('viewBox="0 0 200 100"', guide("1,2", "1,2"));
    expect(moveGuide(slanted, guidelinesOf(slanted).all[0].handle, 3)).toBeNull();
  });

  test("is removed with its line, and others stay", () => {
    const lined = documentOf('viewBox="0 0 200 100"', `${guide("1,2", "1,0")}\n    ${guide("3,4", "1,0")}\n    ${guide("5,6", "1,0")}`);
    const { all } = guidelinesOf(lined);
    const next = after(lined, removeGuides(lined, [all[1]]));
    expect(next.text).toBe(lined.text.replace(`\n    ${guide("3,4", "1,0")}`, ""));
    const none = after(lined, removeGuides(lined, all));
    expect(none.text).toMatch(/<sodipodi:namedview id="base" pagecolor="#ffffff">\s*<\/sodipodi:namedview>/);
    expect(removeGuides(lined, [])).toBeNull();
  });

  test("hides, shows and locks with all others, and the text comes back", () => {
    const hidden = after(drawing, setGuidesShown(drawing, false));
    expect(hidden.text).toContain('pagecolor="#ffffff" showguides="false"');
    expect(guidelinesOf(after(hidden, setGuidesShown(hidden, true))).shown).toBe(true);
    const marked = documentOf('viewBox="0 0 9 9"', `${guide("1,1", "1,0", ' inkscape:locked="false"')}${guide("2,2", "1,0")}`);
    const locked = after(marked, setGuidesLocked(marked, true));
    expect(locked.text).toContain('inkscape:lockguides="true"');
    expect(locked.text).toContain('orientation="1,0" inkscape:locked="true"');
    expect(areLocked(guidelinesOf(locked).all)).toBe(true);
    expect(guidelinesOf(after(locked, setGuidesLocked(locked, false))).all.map((one) => one.locked)).toEqual([false, false]);
  });
});

describe("when the page changes", () => {
  const kept = [
    'viewBox="0 0 200 100"',
    'width="400" height="200" viewBox="0 0 200 100"',
    'width="100mm" height="50mm" viewBox="-5 -5 200 100"',
    'width="300" height="100" viewBox="0 0 200 100"',
    'width="300" height="100" viewBox="0 0 200 100" preserveAspectRatio="none"',
    'width="200" height="100"',
  ];

  test("guides stay where they are on the drawing", () => {
    for (const size of kept) {
      const drawing = documentOf(size, `${both}${guide("20,30", "1,1")}`);
      const next = after(drawing, setArtboard(drawing, [-30, 15, 270, 315]));
      const [before, now] = [drawing, next].map((one) => guidelinesOf(one).all.map(({ point }) => point));
      now.flat().forEach((value, k) => expect(value, size).toBeCloseTo(before.flat()[k], 5));
      expect(next.artboard, size).not.toEqual(drawing.artboard);
    }
  });

  test("a guide whose numbers still fit is not written again", () => {
    const drawing = documentOf('viewBox="0 0 200 100"', guide("20.000,030", "1,0"));
    const next = after(drawing, setArtboard(drawing, [0, 0, 300, 100]));
    expect(next.text).toContain('position="20.000,030"');
    const lower = after(drawing, setArtboard(drawing, [0, 0, 200, 150]));
    expect(lower.text).toContain('position="20.000,80"');
  });
});
