// Copying and pasting, between drawings and from other programs.
import { describe, expect, test } from "vitest";
import { copyItems, insertCentred, paste } from "../../../../web/editor/src/model/commands/index.js";
import { blankText, openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { CurveItem } from "../../../../web/editor/src/model/types.js";
import { Styles } from "../../../../web/editor/src/source/styles.js";
import { SourceError } from "../../../../web/editor/src/source/tree.js";
import { after, handle, named, SAMPLES } from "../drawings.js";

const svg = (inner: string) =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 90 90" sf:version="1">${inner}</svg>`;
const PAINTED = svg(
  '\n  <defs>\n    <linearGradient id="g"><stop offset="0" stop-color="red"/></linearGradient>\n  </defs>' +
    '\n  <g id="l" sf:diffuse="true" transform="translate(5 6)">' +
    '\n    <path id="a" d="M0 0L9 9" sf:left="url(#g)"/>\n    <path id="b" d="M0 0L9 0" sf:left="red"/>\n  </g>\n',
);

const copied = (text: string, ...ids: string[]) => {
  const d = openDrawing(text);
  return copyItems(d, ids.map((id) => handle(d, id)));
};
const pasted = (text: string, what: string, into: string | null = null) =>
  after(text, (d) => paste(d, what, into === null ? null : handle(d, into)));

test("a curve pasted into its own layer gets another id, and keeps its paint", () => {
  const now = pasted(PAINTED, copied(PAINTED, "a"), "l");
  expect(now).toBe(PAINTED.replace('red"/>\n  </g>', 'red"/>\n    <path id="a-2" d="M0 0L9 9" sf:left="url(#g)"/>\n  </g>'));
});

test("a curve pasted behind another stands on top of it", () => {
  const now = pasted(PAINTED, copied(PAINTED, "b"), "a");
  expect(now.indexOf('id="b-2"')).toBeLessThan(now.indexOf('id="b"'));
});

test("what is pasted elsewhere brings its paints, where it was on the artboard", () => {
  const blank = blankText(90, 90, null);
  const now = pasted(blank, copied(PAINTED, "a", "b"), "layer-1");
  expect(now).toContain('<linearGradient id="g"><stop offset="0" stop-color="red"/></linearGradient>');
  const d = openDrawing(now);
  expect(named(d, "a").artboardFromItem).toEqual([1, 0, 0, 1, 5, 6]);
  expect((named(d, "b") as CurveItem).paths[0].points[0]).toEqual([5, 6]);
});

test("curves without a layer to go to get one", () => {
  const d = openDrawing(pasted(PAINTED, copied(PAINTED, "b")));
  expect(d.items.map(({ kind }) => kind)).toEqual(["layer", "layer"]);
  expect(d.items[1].children.map(({ name }) => name)).toEqual(["b-2"]);
});

test("an instance brings its layer, once", () => {
  const { text } = SAMPLES[0];
  const once = pasted(blankText(200, 150, null), copied(text, "again"));
  expect(once.match(/<g id="tree"/g)?.length).toBe(1);
  const twice = pasted(once, copied(text, "again"));
  expect(twice.match(/<g id="tree"/g)?.length).toBe(1);
  expect(twice.match(/<use/g)?.length).toBe(2);
});

test("prefixes become those of the drawing, and strangers' attributes stay behind", () => {
  const inkscape = SAMPLES[2].text;
  const prefixed = SAMPLES[4].text;
  const now = pasted(prefixed, copied(inkscape, "layer2"));
  expect(now).toContain("<s:ellipse");
  expect(now).toContain('f:right="#fe8"');
  expect(now).not.toContain("inkscape");
  expect(now).toContain('style="mix-blend-mode:screen;opacity:0.9"');
});

test("layers of a pasted drawing stay layers, and its background stays behind", () => {
  const d = openDrawing(pasted(blankText(200, 150, null), SAMPLES[0].text, "layer-1"));
  expect(d.items.map(({ kind }) => kind)).toEqual(["layer", "layer", "group", "use", "group"]);
  expect(d.text).not.toContain("<rect");
});

test("what is no SVG is refused with a place", () => {
  const d = openDrawing(PAINTED);
  expect(() => paste(d, "good morning", null)).toThrow(SourceError);
  expect(() => paste(d, "<html/>", null)).toThrow(SourceError);
  expect(() => paste(d, "<svg><g></svg>", null)).toThrow(SourceError);
  expect(paste(d, "<svg/>", null)).toBeNull();
  expect(paste(d, '<svg xmlns="http://www.w3.org/2000/svg"/>', null)).toBeNull();
});

test("shapes of another program are no curves: the engine makes a drawing of them first", () => {
  const plain = svg('<path d="M0 0H9V9Z" fill="red"/>');
  expect(paste(openDrawing(PAINTED), plain, null)).toBeNull();
});

describe("a drawing that is inserted", () => {
  const placed = (box: string, curve = '<path id="new" d="M0 0H9V9Z" sf:left="red" sf:right="blue"/>') =>
    `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="${box}" sf:version="1"><g sf:diffuse="true">${curve}</g></svg>`;
  const frame = (box: string) => {
    const d = openDrawing(after(PAINTED, (at) => insertCentred(at, placed(box), null)));
    return named(d, "new").artboardFromItem.map((value) => Number(value.toFixed(4)));
  };

  test.each([
    ["stays where it is on an artboard of the same size", "0 0 90 90", [1, 0, 0, 1, 0, 0]],
    ["keeps its size where it is smaller, in the middle", "0 0 30 10", [1, 0, 0, 1, 30, 40]],
    ["is reduced where it is larger", "0 0 180 90", [0.5, 0, 0, 0.5, 0, 22.5]],
    ["may have its artboard anywhere", "-45 -45 90 90", [1, 0, 0, 1, 45, 45]],
  ])("%s", (_, box, map) => expect(frame(box)).toEqual(map));

  test("is a layer of its own above the given one", () => {
    const d = openDrawing(after(PAINTED, (at) => insertCentred(at, placed("0 0 90 90"), handle(at, "l"))));
    expect(d.items.map(({ kind, children }) => [kind, children.length])).toEqual([["layer", 2], ["layer", 1]]);
  });
});

const SHEETS = svg(
  "<style>.soft{opacity:.5;mix-blend-mode:multiply} #low{visibility:hidden!important} .warm{color:#f80} path{stroke:#123456}</style>" +
    '<g id="l" class="warm soft" sf:diffuse="true"><path id="a" class="soft" style="opacity:.25" d="M0 0L9 9" sf:left="currentcolor"/>' +
    '<path id="low" visibility="visible" d="M0 5L9 9" sf:left="red"/></g>',
);
const property = (text: string, id: string, name: Parameters<Styles["value"]>[1]) => {
  const d = openDrawing(text);
  return new Styles(text, d.root).value(named(d, id).element, name);
};

test("what style sheets say goes with what is copied, and with what is pasted", () => {
  const blank = blankText(90, 90, null);
  for (const text of [copied(SHEETS, "l"), SHEETS]) {
    const now = pasted(blank, text);
    expect(now).not.toContain("<style");
    for (const [id, name] of [["l", "opacity"], ["l", "mix-blend-mode"], ["a", "opacity"], ["a", "stroke"], ["low", "visibility"], ["a", "color"]] as const)
      expect(property(now, id, name), `${id} ${name}`).toBe(property(SHEETS, id, name));
  }
});

test("a curve copied by itself keeps what it inherited, and its own style wins as before", () => {
  const now = pasted(blankText(90, 90, null), copied(SHEETS, "a"));
  expect(property(now, "a", "color")).toBe("#f80");
  expect(property(now, "a", "opacity")).toBe(".25");
  expect(property(now, "a", "mix-blend-mode")).toBe("multiply");
});

const VARIABLES = svg(
  "<style>svg{--a:.5} #l > path + path{color:var(--c,red)} #a{opacity:var(--none)}</style>" +
    '<g id="l" sf:diffuse="true" style="--c:#f80"><path id="a" opacity=".3" visibility="var(--v,hidden)" d="M0 0L9 9" sf:left="red"/>' +
    '<path id="b" opacity="var(--a)" d="M0 5L9 9" sf:left="red"/></g>',
);

test("what var() and selectors of several parts say goes with what is copied", () => {
  for (const text of [copied(VARIABLES, "a", "b"), copied(VARIABLES, "l"), VARIABLES]) {
    const now = pasted(blankText(90, 90, null), text);
    expect(now).not.toContain("var(");
    for (const [id, name] of [["a", "opacity"], ["a", "visibility"], ["b", "opacity"], ["b", "color"]] as const)
      expect(property(now, id, name), `${id} ${name}`).toBe(property(VARIABLES, id, name));
  }
});

test("the sheets of the drawing that it comes into do not change what is pasted", () => {
  const other = svg('<style>.soft{opacity:.1}</style><g id="m" sf:diffuse="true"><path d="M0 0h1" sf:left="red"/></g>');
  const now = pasted(other, copied(SHEETS, "l"));
  expect(property(now, "l", "opacity")).toBe(".5");
});

test("without sheets the text of what is copied is as it was", () => {
  expect(copied(PAINTED, "b")).toContain('<path id="b" d="M0 0L9 0" sf:left="red"/>');
});
