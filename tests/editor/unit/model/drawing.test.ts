// The document's items: after an edit they equal the items from reading the text again.
import { describe, expect, test, vi } from "vitest";
import { blankText, openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { CurveItem, Drawing, Item, UseItem } from "../../../../web/editor/src/model/types.js";
import { patchOf, setAttribute, sf } from "../../../../web/editor/src/source/attributes.js";
import type { AttributeName } from "../../../../web/editor/src/source/attributes.js";
import { elementsOf } from "../../../../web/editor/src/source/nodes.js";
import { inverse } from "../../../../web/editor/src/source/patch.js";
import type { Patch } from "../../../../web/editor/src/source/patch.js";
import { SourceError } from "../../../../web/editor/src/source/tree.js";
import { examples, fuzzed, pick, randomNumbers } from "../corpus.js";
import { randomDocument } from "../documents.js";

// These tests generate much input, and machines may be busy.
vi.setConfig({ testTimeout: 120_000 });

function svg(content: string, attributes = 'viewBox="0 0 100 100"'): string {
  return `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" xmlns:xlink="http://www.w3.org/1999/xlink" ${attributes}>${content}</svg>`;
}

function open(content: string, attributes?: string): Drawing {
  return openDrawing(svg(content, attributes));
}

function named(d: Drawing, name: string): Item {
  const found = [...d.all()].find((item) => item.name === name);
  if (!found) throw new Error(`there is no ${name}`);
  return found;
}

const start = (item: Item | null) => item && item.element.range.start;

/** Returns all properties of an item, with places instead of objects. */
function said(item: Item): unknown {
  const { kind, name, hidden, locked, opacity, blend, artboardFromItem } = item;
  const children = item.children.map(start);
  const common = [
    kind,
    name,
    start(item),
    start(item.parent),
    children,
    hidden,
    locked,
    opacity,
    blend,
    artboardFromItem,
  ];
  if (item.kind === "use") return [...common, start(item.target)];
  if (item.kind === "reference") return [...common, item.href, item.box];
  if (item.kind !== "curve" && item.kind !== "stroke") return common;
  const { paths, isPath, left, right, radius, layerFromItem, copies } = item;
  return [...common, paths, isPath, left, right, radius, layerFromItem, copies];
}

/** Returns all properties of a drawing. */
function dump(d: Drawing): string {
  const elements = [...elementsOf(d.root)].map(
    ({ name, namespace, range, startTag, content, attributes }) => [
      name,
      namespace,
      range,
      startTag,
      content,
      attributes.map((a) => [a.name, a.namespace, a.value, a.range, a.valueRange, a.quote]),
    ],
  );
  const items = [...d.all()].map(said);
  const outermost = d.items.map(start);
  const { text, artboard, interpolation, background, readOnly } = d;
  return JSON.stringify([
    text,
    artboard,
    interpolation,
    background,
    readOnly,
    outermost,
    items,
    [...d.ids].map(([id, { range }]) => [id, range]),
    elements,
  ]);
}

/** Names and values of attributes; changing one of them affects other properties. */
const SETTINGS: readonly (readonly [AttributeName, readonly (string | null)[]])[] = [
  ["d", ["M0 0L9 9", "M1 2 C3 4 5 6 7 8 Z", "nonsense", null]],
  ["transform", ["translate(3 4)", "scale(-1 2)", null, "rotate("]],
  ["display", ["none", "inline", null]],
  ["visibility", ["hidden", null]],
  ["opacity", [".5", "1", null]],
  ["style", ["display:none", "opacity:.25;mix-blend-mode:multiply", null]],
  ["class", ["off", "on", "curve", null]],
  ["id", ["a", "b", "c", null]],
  ["href", ["#a", "#b", "#c", null]],
  ["viewBox", ["0 0 50 80", null]],
  ["width", ["30", "50%", null]],
  ["xmlns:sf", ["urn:sfumato:1", "urn:other"]],
  ["xmlns", ["http://www.w3.org/2000/svg", "urn:other"]],
  [sf("left"), ["red", "gold, #123 30%", "none", "url(#a)", "red @1", null]],
  [sf("blur"), ["0, 4 50%, 0", "3", null]],
  [sf("radius"), ["3", "1, 4", null]],
  [sf("diffuse"), ["true", "false", null]],
  [sf("reference"), ["true", null]],
  [sf("background"), ["#abc", "none", null]],
  [sf("interpolation"), ["oklab", null]],
  [
    { namespace: "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd", local: "insensitive" },
    ["true", null],
  ],
  [{ namespace: "http://www.inkscape.org/namespaces/inkscape", local: "label" }, ["A b", "", null]],
];

function attributeEdit(d: Drawing, random: () => number): Patch {
  const [name, values] = pick(SETTINGS, random);
  const element = random() < 0.1 ? d.root : pick([...elementsOf(d.root)], random);
  return patchOf(setAttribute(d.text, element, name, pick(values, random)));
}

/** Cuts, inserts and moves text anywhere. */
function textEdit(d: Drawing, random: () => number): Patch {
  const elements = [...elementsOf(d.root)].slice(1);
  if (elements.length === 0) return [];
  const { range } = pick(elements, random);
  const markup = d.text.slice(range.start, range.end);
  const target = pick(elements, random).range;
  if (random() < 0.4) return [{ at: range.start, removed: markup, inserted: "" }];
  if (random() < 0.5) return [{ at: target.start, removed: "", inserted: markup }];
  const at = Math.floor(random() * d.text.length);
  const removed = d.text.slice(at, at + Math.floor(random() * 12));
  return [
    {
      at,
      removed,
      inserted: pick(["", " ", ">", '"', "<!---->", '<g id="a"/>', " x='1'"], random),
    },
  ];
}

test("after any edit the drawing is what reading its text again says", () => {
  const random = randomNumbers(17);
  const texts = [
    ...examples()
      .filter(({ text }) => text.length < 20_000)
      .map(({ text }) => text),
    ...Array.from({ length: 20 }, (_, i) => randomDocument(randomNumbers(1000 + i))),
    ...fuzzed()
      .map(({ text }) => text)
      .filter((t) => t.length < 3000 && t.includes("<use"))
      .slice(0, 60),
  ];
  let structural = 0;
  let refused = 0;
  let within = 0;
  for (const text of texts) {
    let d: Drawing;
    try {
      d = openDrawing(text);
    } catch {
      continue;
    }
    for (let i = 0; i < 25; i += 1) {
      const patch = random() < 0.75 ? attributeEdit(d, random) : textEdit(d, random);
      const [before, revision] = [dump(d), d.revision];
      try {
        const change = d.apply(patch);
        if (change.isStructural) structural += 1;
        else within += 1;
        expect(d.revision).toBe(revision + 1);
      } catch (error) {
        if (!(error instanceof SourceError)) throw error;
        refused += 1;
        expect(dump(d) === before && d.revision === revision).toBe(true);
        continue;
      }
      const again = openDrawing(d.text);
      if (dump(d) !== dump(again)) expect(JSON.parse(dump(d))).toEqual(JSON.parse(dump(again)));
      for (const item of d.all()) {
        if (d.item(item.handle) !== item || d.itemAt(item.element.range.start) !== item) {
          throw new Error(`${item.name} is not found`);
        }
        if (item.children.some((child) => child.parent !== item)) throw new Error("a wrong parent");
      }
      if (i % 5 === 4) {
        d.apply(inverse(patch));
        if (dump(d) !== before) expect(JSON.parse(dump(d))).toEqual(JSON.parse(before));
      }
    }
  }
  expect(Math.min(structural, within, refused)).toBeGreaterThan(40);
});

describe("handles", () => {
  const text = svg(
    '<g sf:diffuse="true" id="a"><path id="p" d="M0 0L1 1"/><path id="q" d="M0 0L1 1"/></g><g id="b"/>',
  );

  test("live as long as their element, whatever goes on beside it", () => {
    const d = openDrawing(text);
    const [p, q, b] = ["p", "q", "b"].map((name) => named(d, name));
    d.apply([{ at: q.element.range.start, removed: "", inserted: "<path/><!-- x -->" }]);
    d.apply(patchOf(setAttribute(d.text, d.root.children[0].children[0], "id", "other")));
    expect(d.item(p.handle)?.name).toBe("other");
    expect(d.item(q.handle)?.name).toBe("q");
    const { range } = (d.item(p.handle) as Item).element;
    d.apply([{ at: range.start, removed: d.text.slice(range.start, range.end), inserted: "" }]);
    expect(d.item(p.handle)).toBeUndefined();
    expect(d.item(q.handle)?.name).toBe("q");
    expect(d.item(b.handle)?.name).toBe("b");
    d.apply([{ at: range.start, removed: "", inserted: '<path id="p"/>' }]);
    expect(named(d, "p").handle).not.toBe(p.handle);
  });

  test("lead to a new object where an element changed, and to the old one elsewhere", () => {
    const d = openDrawing(text);
    const [a, p, q, b] = ["a", "p", "q", "b"].map((name) => named(d, name));
    const change = d.apply(patchOf(setAttribute(d.text, p.element, "d", "M5 5L6 6")));
    expect(change.isStructural).toBe(false);
    expect([...change.touched]).toEqual([[p.handle, new Set(["d"])]]);
    const now = d.item(p.handle) as CurveItem;
    expect(now).not.toBe(p);
    expect(now.paths[0].points[0]).toEqual([5, 5]);
    expect(d.item(q.handle)).toBe(q);
    expect(d.item(b.handle)).toBe(b);
    // The item that contains it has another content, too.
    expect(d.item(a.handle)).not.toBe(a);
    expect(d.items[0].children).toEqual([now, q]);
    expect(q.parent).toBe(d.items[0]);
    const layer = d.apply(patchOf(setAttribute(d.text, d.items[0].element, "opacity", ".5")));
    expect([...layer.touched.keys()]).toEqual([a.handle]);
    expect(d.item(a.handle)?.opacity).toBe(0.5);
    expect(d.item(q.handle)).toBe(q);
  });

  test("an edit of a style, an id, a class or what makes a thing a layer is structural", () => {
    for (const [name, value] of [
      ["id", "z"],
      ["class", "z"],
      ["style", "opacity:1"],
      [sf("radius"), "1"],
    ] as const) {
      const d = openDrawing(text);
      const change = d.apply(patchOf(setAttribute(d.text, named(d, "p").element, name, value)));
      expect(change.isStructural).toBe(true);
    }
  });

  test("a patch of another text is refused, and changes nothing", () => {
    const d = openDrawing(text);
    const before = dump(d);
    expect(() => d.apply([{ at: 3, removed: "nonsense", inserted: "" }])).toThrow(RangeError);
    expect(() => d.apply([{ at: 5, removed: "", inserted: "<" }])).toThrow(SourceError);
    expect(dump(d)).toBe(before);
  });
});

describe("items", () => {
  test("are layers, groups, curves, local curves, instances and photos, the last on top", () => {
    const d = open(
      '<defs><g id="no" sf:diffuse="true"/></defs><g id="outer"><g sf:diffuse="true"><g><circle r="3"/></g>' +
        '<path d="M0 0L1 1"/></g><path sf:radius="3" d="M0 0L1 1" sf:left="red"/></g><rect width="5"/>' +
        '<image sf:reference="true" xlink:href="a.png" x="1" y="2" width="3" height="50%"/><image/><text/>',
    );
    const shape = (item: Item): unknown => [item.kind, item.name, ...item.children.map(shape)];
    expect(d.items.map(shape)).toEqual([
      [
        "group",
        "outer",
        ["layer", "Layer 1", ["group", "Group 2", ["curve", "Curve 1"]], ["curve", "Curve 2"]],
        ["stroke", "Stroke 1"],
      ],
      ["reference", "Photo 1"],
    ]);
    const photo = named(d, "Photo 1");
    expect(photo).toMatchObject({ href: "a.png", box: [1, 2, 4, 52] });
    expect(named(d, "Stroke 1")).toMatchObject({
      left: { color: { kind: "stops" } },
      right: { color: { kind: "stops" } },
      radius: { kind: "stops" },
      isPath: true,
    });
  });

  test("bear what one attribute says for both sides, and their own before it", () => {
    const d = open(
      '<g sf:diffuse="true"><path id="p" d="M0 0L1 1" sf:opacity=".5" sf:left-opacity="none" sf:blur="2" sf:right="url(#x)"/></g>',
    );
    expect(named(d, "p")).toMatchObject({
      left: { color: { kind: "open" }, opacity: { kind: "barrier" } },
      right: { color: { kind: "paint", href: "#x" }, opacity: { stops: [{ value: 0.5 }] } },
    });
    expect((named(d, "p") as CurveItem).left.blur).toEqual((named(d, "p") as CurveItem).right.blur);
  });

  test("stand where transforms, nested pictures and symbols put them", () => {
    const d = open(
      '<g transform="translate(10 0)"><g id="l" sf:diffuse="true" transform="scale(2)"><g transform="translate(1 1)">' +
        '<path id="p" transform="scale(3)" d="M0 0L1 1"/></g></g></g>' +
        '<svg id="n" x="5" width="20" height="20" viewBox="0 0 10 10"/>' +
        '<symbol id="s" viewBox="0 0 1 1"><g id="in" sf:diffuse="true"/></symbol>' +
        '<use id="u" href="#s" x="7" width="50" height="50" transform="scale(2)"/>',
    );
    expect(named(d, "p").artboardFromItem).toEqual([6, 0, 0, 6, 12, 2]);
    expect((named(d, "p") as CurveItem).layerFromItem).toEqual([3, 0, 0, 3, 1, 1]);
    expect(named(d, "n").artboardFromItem).toEqual([2, 0, 0, 2, 5, 0]);
    expect(named(d, "in").artboardFromItem).toEqual([100, 0, 0, 100, 14, 0]);
    expect(named(d, "u").artboardFromItem).toEqual([2, 0, 0, 2, 0, 0]);
  });

  test("that <use> copies are found wherever they stand, and count their places", () => {
    const d = open(
      '<defs><g id="l" sf:diffuse="true"><path id="p" d="M0 0L1 1"/></g><g id="twice"><use id="u1" href="#l"/>' +
        '<use id="u2" xlink:href=" #l "/></g></defs><use id="v" href="#twice"/><use id="w" href="#twice"/><use id="x" href="#none"/><use/>',
    );
    expect(d.items.map(({ name }) => name)).toEqual(["v", "w", "x", "Instance 4"]);
    expect((named(d, "v") as UseItem).target).toBe(named(d, "twice"));
    expect((named(d, "u2") as UseItem).target).toBe(d.item(named(d, "l").handle));
    expect((named(d, "x") as UseItem).target).toBeNull();
    expect(named(d, "p")).toMatchObject({ copies: 4 });
    expect(d.itemAt(named(d, "p").element.range.start)).toBe(named(d, "p"));
  });

  test("that copy themselves copy nothing", () => {
    const d = open(
      '<g id="a"><use id="u" href="#a"/></g><defs><g id="b"><use id="v" href="#c"/></g><g id="c"><use id="w" href="#b"/></g></defs><use id="x" href="#b"/>',
    );
    const follow = (item: Item | null, depth = 0): number =>
      item === null
        ? depth
        : Math.max(
            depth,
            ...item.children.map((c) => follow(c, depth + 1)),
            item.kind === "use" ? follow(item.target, depth + 1) : 0,
          );
    expect(follow(named(d, "a"))).toBeLessThan(10);
    expect(follow(named(d, "x"))).toBeLessThan(10);
    expect((named(d, "x") as UseItem).target).toBe(named(d, "b"));
  });

  test("are hidden, locked, see-through and blended by attributes and styles", () => {
    const d = open(
      '<style>.off{display:none}#k{mix-blend-mode:screen}</style><g id="a" class="off"/><g id="b" visibility="hidden"><g id="c"/><g id="d" visibility="visible"/></g>' +
        '<g id="k" opacity="50%" xmlns:s="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" s:insensitive="true" style="opacity:.25"/>',
    );
    expect(["a", "b", "c", "d", "k"].map((name) => named(d, name).hidden)).toEqual([
      true,
      true,
      true,
      false,
      false,
    ]);
    expect(named(d, "k")).toMatchObject({ locked: true, opacity: 0.25, blend: "screen" });
  });

  test("have labels before ids", () => {
    const d = open(
      '<g id="a" xmlns:i="http://www.inkscape.org/namespaces/inkscape" i:label="Sky &amp; sea"/>',
    );
    expect(d.items[0].name).toBe("Sky & sea");
  });

  test("of 100,000 levels, of long chains of uses and of doubling uses do no harm", () => {
    const deep = "<g>".repeat(100_000) + "</g>".repeat(100_000);
    expect([...open(deep).all()].length).toBeLessThan(1000);
    const chain = Array.from(
      { length: 20_000 },
      (_, i) => `<use id="c${i}" href="#c${i + 1}"/>`,
    ).join("");
    expect([...open(chain).all()].length).toBe(20_000);
    const doubling = Array.from(
      { length: 60 },
      (_, i) => `<g id="d${i}"><use href="#d${i + 1}"/><use href="#d${i + 1}"/></g>`,
    ).join("");
    const d = open(
      `<defs>${doubling}<g id="d60" sf:diffuse="true"><path id="p" d="M0 0L1 1"/></g></defs><use href="#d0"/>`,
    );
    expect((named(d, "p") as CurveItem).copies).toBe(Number.MAX_SAFE_INTEGER);
  });
});

describe("the artboard", () => {
  test("is the viewBox, or width and height, and more or less of the plane where aspects differ", () => {
    expect(open("", 'viewBox="-10,5 30 40"').artboard).toEqual([-10, 5, 20, 45]);
    expect(open("", 'width="2in" height="96"').artboard).toEqual([0, 0, 192, 96]);
    expect(open("", 'viewBox="0 0 100 100" width="200" height="100"').artboard).toEqual([
      -50, 0, 150, 100,
    ]);
    expect(
      open(
        "",
        'viewBox="0 0 100 100" width="200" height="100" preserveAspectRatio="xMinYMin slice"',
      ).artboard,
    ).toEqual([0, 0, 100, 50]);
    const stretched = open(
      '<g id="a"/>',
      'viewBox="0 0 100 100" width="100" height="200" preserveAspectRatio="none"',
    );
    expect(stretched.artboard).toEqual([0, 0, 100, 200]);
    expect(named(stretched, "a").artboardFromItem).toEqual([1, 0, 0, 2, 0, 0]);
  });

  test("has the background that is said, else that of a <rect> before all else that covers it", () => {
    const rect = '<rect width="100%" height="100%" fill="#fff"/>';
    const white = { r: 1, g: 1, b: 1 };
    expect(open(rect).background).toEqual(white);
    expect(
      open(`<g style="color:#fff" fill="currentColor"><rect width="100" height="101"/></g>`)
        .background,
    ).toEqual(white);
    for (const none of [
      `<rect width="99" height="100"/>`,
      `<g display="none">${rect}</g>`,
      `<g sf:diffuse="true"/>${rect}`,
      `<g opacity="1">${rect.replace("#fff", "none")}</g>`,
      rect.replace("/>", ' fill-opacity=".5"/>'),
    ]) {
      expect(open(none).background, none).toBeNull();
    }
    expect(open(rect, 'viewBox="0 0 100 100" sf:background="black"').background).toEqual({
      r: 0,
      g: 0,
      b: 0,
    });
    expect(open(rect, 'viewBox="0 0 100 100" sf:background="none"').background).toBeNull();
  });

  test("mixes colours where the document says", () => {
    expect(open("").interpolation).toBe("srgb");
    expect(open("", 'viewBox="0 0 1 1" sf:interpolation="oklab"').interpolation).toBe("oklab");
  });
});

test("a document that defines entities may not be edited", () => {
  expect(openDrawing(`<!DOCTYPE svg [<!ENTITY a "b">]>${svg("")}`).readOnly).not.toBeNull();
  expect(openDrawing(svg("")).readOnly).toBeNull();
});

test("what is no <svg> is refused in words", () => {
  expect(() => openDrawing("\n<html/>")).toThrow(/^Line 2, column 1: the document is a <html>/);
});

test("a blank drawing has its size, a layer and the background", () => {
  const d = openDrawing(blankText(640, 480, "#fff"));
  expect(d.artboard).toEqual([0, 0, 640, 480]);
  expect(d.background).toEqual({ r: 1, g: 1, b: 1 });
  expect(d.items.map(({ kind }) => kind)).toEqual(["layer"]);
  expect(openDrawing(blankText(10, 10, null)).background).toBeNull();
});
