// Colours, stop lists and styles: read and written.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, test } from "vitest";
import { colorText, parseColor, parseOpaque } from "../../../../web/editor/src/source/colors.js";
import * as limits from "../../../../web/editor/src/source/limits.js";
import { elementsOf } from "../../../../web/editor/src/source/nodes.js";
import { parse } from "../../../../web/editor/src/source/parse.js";
import { applied } from "../../../../web/editor/src/source/patch.js";
import { patchOf } from "../../../../web/editor/src/source/attributes.js";
import { isValue, PROPERTIES } from "../../../../web/editor/src/source/properties.js";
import { setStyle, setStyles } from "../../../../web/editor/src/source/set-style.js";
import { COLORS, RADII, readSide, SHARES, sideText } from "../../../../web/editor/src/source/stops.js";
import type { Notation, SideValue } from "../../../../web/editor/src/source/stops.js";
import { Styles } from "../../../../web/editor/src/source/styles.js";
import type { Property } from "../../../../web/editor/src/source/styles.js";
import { pick, randomNumbers, repository } from "../corpus.js";

test("every property that the editor reads has values of a kind that it knows", () => {
  for (const property of PROPERTIES) expect(isValue(property, "none of all values"), property).toBe(false);
});

describe("colours", () => {
  const bytes = (text: string) => {
    const color = parseColor(text);
    return color && [color.rgb.r, color.rgb.g, color.rgb.b].map((c) => Math.round(255 * c));
  };

  test("in all notations", () => {
    expect(bytes("#c21")).toEqual([204, 34, 17]);
    expect(bytes("RebeccaPurple")).toEqual([102, 51, 153]);
    expect(bytes("rgb(1 2 3)")).toEqual([1, 2, 3]);
    expect(bytes("rgb(1,2,3,50%)")).toEqual([1, 2, 3]);
    expect(bytes("hsl(120deg 100% 25%)")).toEqual([0, 128, 0]);
    expect(bytes("hwb(0 40% 80%)")).toEqual([85, 85, 85]);
    expect(parseColor("#11223380")?.alpha).toBeCloseTo(128 / 255, 12);
    expect(parseColor("transparent")?.alpha).toBe(0);
  });

  test("that are none, or are not opaque", () => {
    for (const text of [
      "",
      "#12",
      "#12345",
      "gray50",
      "rgb(1 2)",
      "rgb(1,2 3)",
      "rgb(1,2,none)",
      "rgb(1%,2,3)",
      "hwb(0,1%,2%)",
      "hwb(50% 50% 50%)",
      "hsl(10px 0% 50%)",
      "lch(50 0 10%)",
      "hsl(0,1,2)",
      "rgb(1 2 3, 1)",
      "red blue",
      "currentColor",
      "url(#a)",
    ]) {
      expect(parseColor(text), text).toBeNull();
    }
    expect(parseOpaque("rgb(1 2 3 / .99)")).toBeNull();
  });

  test("are written in the shortest way that reads back the same", () => {
    expect(colorText({ r: 1, g: 0, b: 0 })).toBe("#f00");
    expect(colorText({ r: 0x12 / 255, g: 0, b: 1 })).toBe("#1200ff");
    expect(colorText({ r: 0.125, g: 0.5, b: 1 / 3 })).toBe("rgb(12.5% 50% 33.333333%)");
    const random = randomNumbers(3);
    for (let i = 0; i < 2000; i += 1) {
      const byte = () => Math.floor(random() * 256) / 255;
      const channel = i % 2 ? random : byte;
      const color = { r: channel(), g: channel(), b: channel() };
      const back = parseOpaque(colorText(color));
      expect([back?.r, back?.g, back?.b].map((c) => Math.fround(c ?? NaN))).toEqual(
        [color.r, color.g, color.b].map(Math.fround),
      );
      if (i % 2 === 0) expect(colorText(color)).toMatch(/^#[0-9a-f]{3,6}$/);
    }
  });
});

/** Converts numbers to single precision, as in the engine. */
function singles(value: unknown): unknown {
  if (typeof value === "number") return Math.fround(value);
  const channels = Object.entries(value as object);
  return Object.fromEntries(channels.map(([key, channel]) => [key, Math.fround(channel)]));
}

describe("stop lists", () => {
  const offsets = (text: string, segments = 4) => {
    const side = readSide(text, COLORS, segments);
    return side.kind === "stops"
      ? [side.space, ...side.stops.map(({ offset }) => offset)]
      : side.kind;
  };

  test("have the missing offsets spread between their neighbours", () => {
    expect(offsets("red")).toEqual(["arc", 0]);
    expect(offsets("red, gold")).toEqual(["arc", 0, 1]);
    expect(offsets("red, gold, blue, white 60%, black")).toEqual(
      ["arc", 0, 0.6 / 3, 0.4, 0.6, 1].map((v) =>
        typeof v === "number" ? expect.closeTo(v, 12) : v,
      ),
    );
    expect(offsets("red 50%, gold 20%")).toEqual(["arc", 0.5, 0.5]);
    expect(offsets("red @1, gold 75%, white @9")).toEqual(["parameter", 1, 3, 4]);
    expect(offsets("red @1, gold, white")).toEqual(["parameter", 1, 2.5, 4]);
  });

  test("can be nothing, none, a paint, or what cannot be read", () => {
    expect(readSide(undefined, COLORS, 1)).toEqual({ kind: "open" });
    expect(readSide(" none ", COLORS, 1)).toEqual({ kind: "barrier" });
    expect(readSide("url( '#a' )", COLORS, 1)).toEqual({ kind: "paint", href: "#a" });
    expect(readSide("navy", COLORS, 1).kind).toBe("stops");
    for (const bad of ["", "red,", "red 120%", "red 1", "red 10% x", "none, red", "red @-1"]) {
      expect(readSide(bad, COLORS, 1), bad).toEqual({ kind: "open" });
    }
    expect(readSide("2mm, 1in 50%", RADII, 1)).toMatchObject({
      stops: [{ value: (2 * 96) / 25.4 }, { value: 96 }],
    });
    expect(readSide("5%", RADII, 1)).toEqual({ kind: "open" });
    expect(readSide("1.5", SHARES, 1)).toEqual({ kind: "open" });
  });

  test("keep % or @, and how values were written", () => {
    const again = (text: string) => sideText(readSide(text, COLORS, 4), COLORS, text);
    expect(again("gold, RED 30.0%, #ffffff")).toBe("gold, RED 30.0%, #ffffff");
    expect(again("red @0, gold @2.5, white @4")).toBe("red @0, gold @2.5, white @4");
    expect(again("red, gold @2.5, white")).toBe("red @0, gold @2.5, white @4");
    expect(again("red, gold, white")).toBe("red, gold 50%, white");
    expect(again("red 40%")).toBe("red");
    const side = readSide("gold, red 30%, white", COLORS, 4);
    expect(sideText(side, COLORS)).toBe("#ffd700, #f00 30%, #fff");
    expect(sideText({ kind: "paint", href: "#a b" }, COLORS)).toBe('url("#a b")');
    expect(sideText(readSide("0.50, .25 1e1%", SHARES, 1), SHARES)).toBe(".5, .25 10%");
  });

  test("written and read again say the same", () => {
    const random = randomNumbers(5);
    const check = <Value>(notation: Notation<Value>, value: () => Value) => {
      for (let i = 0; i < 500; i += 1) {
        const space = pick(["arc", "parameter"] as const, random);
        const count = 1 + Math.floor(random() * 5);
        const end = space === "arc" ? 1 : 4;
        const places = Array.from({ length: count }, () => end * random()).sort((a, b) => a - b);
        if (random() < 0.3) places[0] = 0;
        if (random() < 0.3) places[count - 1] = end;
        if (count === 1) places[0] = 0;
        const stops = places.map((offset) => ({ offset: Math.fround(offset), value: value() }));
        const side: SideValue<Value> = { kind: "stops", space, stops };
        const back = readSide(sideText(side, notation) ?? "", notation, 4);
        expect(back.kind).toBe("stops");
        if (back.kind !== "stops") return;
        expect(count === 1 ? "" : back.space).toBe(count === 1 ? "" : space);
        expect(back.stops.length).toBe(count);
        back.stops.forEach((stop, k) => {
          expect(stop.offset).toBeCloseTo(stops[k].offset, 6);
          expect(singles(stop.value)).toEqual(singles(stops[k].value));
        });
      }
    };
    check(COLORS, () => ({ r: random(), g: 1, b: Math.floor(random() * 256) / 255 }));
    check(SHARES, random);
    check(RADII, () => 10 ** (8 * random() - 4));
  });

  test("of 100,000 stops or brackets are read in linear time", () => {
    const many = "red 1%, ".repeat(100_000) + "red";
    expect(readSide(many, COLORS, 1).kind).toBe("stops");
    expect(readSide("rgb(".repeat(100_000), COLORS, 1).kind).toBe("open");
    expect(readSide("/*".repeat(100_000), COLORS, 1).kind).toBe("open");
    expect(readSide("red ".repeat(100_000) + '"', COLORS, 1).kind).toBe("open");
  });
});

function document(
  sheet: string,
  attributes: string,
  around = "",
): { text: string; styles: Styles; element: ReturnType<typeof parse> } {
  const text = `<svg xmlns="http://www.w3.org/2000/svg"><style>${sheet}</style><g ${around}><path ${attributes}/></g></svg>`;
  const root = parse(text);
  return { text, styles: new Styles(text, root), element: root.children[1].children[0] };
}

describe("the cascade", () => {
  const cases: [sheet: string, attributes: string, property: Property, value: string | null][] = [
    ["", 'opacity=" .5 "', "opacity", ".5"],
    ["", 'opacity=".5" style="opacity:.25"', "opacity", ".25"],
    ["path{opacity:.1}", 'opacity=".5"', "opacity", ".1"],
    ["path{opacity:.1}", 'style="opacity:.25"', "opacity", ".25"],
    ["path{opacity:.1!important}", 'style="opacity:.25"', "opacity", ".1"],
    ["path{opacity:.1!important}", 'style="opacity:.25 ! IMPORTANT"', "opacity", ".25"],
    [
      "*{opacity:.1}path{opacity:.2}.a{opacity:.3}#b{opacity:.4}",
      'id="b" class="x a"',
      "opacity",
      ".4",
    ],
    ["#b{opacity:.4}.a{opacity:.3}path{opacity:.2}*{opacity:.1}", 'class="x a"', "opacity", ".3"],
    [".a{opacity:.3}.b{opacity:.4}", 'class="b a"', "opacity", ".4"],
    ["path{opacity:.1}path{opacity:.2;opacity:x}", "", "opacity", ".2"],
    ["path{opacity:.1;opacity:.3!important;opacity:.2}", "", "opacity", ".3"],
    ["g path{opacity:.1}", "", "opacity", ".1"],
    ["path path{opacity:.1}", "", "opacity", null],
    ["svg>path{opacity:.1}", "", "opacity", null],
    ["svg > g > path{opacity:.1}", "", "opacity", ".1"],
    ["style + g path{opacity:.1}", "", "opacity", ".1"],
    ["g ~ g path{opacity:.1}", "", "opacity", null],
    ["g path{opacity:.1}path{opacity:.2}", "", "opacity", ".1"],
    ["path.a{opacity:.1}.a{opacity:.2}", 'class="a"', "opacity", ".1"],
    ["g path:not(#b):root,#b{opacity:.1}", 'id="b"', "opacity", ".1"],
    [":first-child{opacity:.1}", "", "opacity", ".1"],
    ["g:first-child path{opacity:.1}", "", "opacity", null],
    ["path:only-child:last-child{opacity:.1}", "", "opacity", ".1"],
    [":root path:not(:hover){opacity:.1}", "", "opacity", ".1"],
    ["[data-k]{opacity:.1}", 'data-k=""', "opacity", ".1"],
    ["[data-k^=x i]{opacity:.1}", 'data-k="Xy"', "opacity", ".1"],
    ["[data-k^=x]{opacity:.1}", 'data-k="Xy"', "opacity", null],
    ["[data-k~='b']{opacity:.1}", 'data-k="a b"', "opacity", ".1"],
    ["[data-k|=a]{opacity:.1}", 'data-k="a-b"', "opacity", ".1"],
    ["[data-k$='']{opacity:.1}", 'data-k="a"', "opacity", null],
    ["path:nth-child(1),path{opacity:.1}", "", "opacity", ".1"],
    ["path!,path{opacity:.1}", "", "opacity", null],
    ["path{opacity:var(--o)}g{--o:.1}", "", "opacity", ".1"],
    ["path{opacity:var(--o,.3)}", 'opacity=".5"', "opacity", ".3"],
    ["path{opacity:var(--o)}", 'opacity=".5"', "opacity", null],
    ["", 'opacity="var(--o)" style="--o:.7"', "opacity", ".7"],
    ["path{--a:var(--b);--b:var(--a);opacity:var(--a,.3)}", "", "opacity", ".3"],
    ["path{--a:var(--b);--b:var(--a);opacity:var(--c,.3)}", "", "opacity", ".3"],
    ["g{--c:red}path{--c:var(--c);color:var(--c,lime)}", "", "color", "lime"],
    ["path{--a:var(--b,red);--b:var(--a,red);--c:var(--a,red);color:var(--b)}", "", "color", null],
    ["g{color:var(--x)}svg{color:red;--x:inherit}", "", "color", "red"],
    ["path{--x:lime!important;--X:red;--x:gold;color:var(--x)}", "", "color", "lime"],
    ["g{--x:red}path{--x:initial;color:var(--x,gold)}", "", "color", "gold"],
    ["g{color:red}path{color:currentColor}", "", "color", "red"],
    ["path{opacity:.1;opacity:var(--,)x)}", "", "opacity", ".1"],
    ["path{g{opacity:.3}opacity:.1}", "", "opacity", ".1"],
    ["path{fill:red;fill:url(a b)}", "", "fill", "red"],
    ["path{--s:'\\61\n}';fill:url(\\61 b)}", "", "fill", "url(\\61 b)"],
    ["path{fill:red;--s:'\\62 x\n;fill:lime}path{fill:gold}", "", "fill", "gold"],
    ["path{fill:url(#a) lime}", "", "fill", "url(#a) lime"],
    ["@media not print and (color){path{opacity:.1}}", "", "opacity", ".1"],
    ["path{opacity:.1}", 'style="opacity:revert-layer"', "opacity", ".1"],
    ["path{opacity:.1}", 'style="all:unset"', "opacity", null],
    ["g{opacity:.1}", "", "opacity", null],
    ["g{opacity:.1}", 'style="opacity:inherit"', "opacity", ".1"],
    ["g{visibility:hidden}", "", "visibility", "hidden"],
    ["g{visibility:hidden}", 'style="visibility:initial"', "visibility", null],
    ["@media print{path{opacity:.1}}@media not print{path{opacity:.2}}", "", "opacity", ".2"],
    ["@font-face{src:url(x)}path{opacity:.1}", "", "opacity", ".1"],
    ["&lt;!-- path{opacity:.1} -->", "", "opacity", ".1"],
    ["/* } */path{opacity/**/:/**/.1}", "", "opacity", ".1"],
    [".\\61 {opacity:.1}", 'class="a"', "opacity", ".1"],
    ["path{mix-blend-mode:banana}", "", "mix-blend-mode", null],
  ];
  test.each(cases)("%s · %s · %s: %s", (sheet, attributes, property, value) => {
    const { styles, element } = document(sheet, attributes);
    expect(styles.value(element, property)).toBe(value);
  });

  test("is read in linear time, however it is nested or broken", () => {
    for (const sheet of [
      "{".repeat(50_000),
      "@media screen{".repeat(20_000),
      "a,".repeat(50_000) + "b{}",
      "'".repeat(50_001),
      "\\".repeat(50_000),
      `path{${"--a:{}".repeat(20_000)})}`,
      "\\61".repeat(20_000),
      `path{fill:"${"\\61".repeat(20_000)}\n;fill:url(${"\\61".repeat(20_000)}"}`,
      `path{opacity:1${"\\61".repeat(20_000)}}`,
      `path{fill:${"url(a) ".repeat(50_000)}}`,
      `${"path,".repeat(50_000)}path{${"opacity:1;".repeat(5000)}}`,
      `path{opacity:${"var(--a,".repeat(20_000)}`,
    ]) {
      const { styles, element } = document(sheet.replaceAll("<", "&lt;"), "");
      expect(styles.value(element, "opacity")).toBeOneOf([null, "1"]);
    }
  });

  test("has the limits of the engine", () => {
    const header = (name: string) => readFileSync(join(repository, name), "utf8");
    const texts = [
      "include/sfumato/base/limits.hpp",
      "src/formats/css/selector.hpp",
      "src/formats/css/style.hpp",
      "src/formats/css/variables.hpp",
      "src/formats/svg/style/variable_values.hpp",
    ].map(header);
    const engines = (name: string) => {
      const camel = name.toLowerCase().replace(/(?:^|_)(\w)/g, (_, letter) => letter.toUpperCase());
      const [, value] = new RegExp(` k${camel} = (.*);`).exec(texts.join("")) ?? [];
      const [, base, shift] = /(\d+)}? << (\d+)$/.exec(value) ?? [];
      return base ? Number(base) * 2 ** Number(shift) : Number(value.replaceAll("'", ""));
    };
    for (const [name, value] of Object.entries(limits)) expect(engines(name), name).toBe(value);
  });

  test("leaves out what exceeds them", () => {
    const depth = (count: number) => {
      const chain = Array.from({ length: count }, (_, i) => `--v${i}:var(--v${i + 1});`).join("");
      const { styles, element } = document(`path{${chain}--v${count}:.5;opacity:var(--v0,1)}`, "");
      return styles.value(element, "opacity");
    };
    expect(depth(limits.VARIABLE_DEPTH - 2)).toBe(".5");
    expect(depth(limits.VARIABLE_DEPTH - 1)).toBeNull();
    const doubled = Array.from(
      { length: 20 },
      (_, i) => `--v${i}:var(--v${i + 1})var(--v${i + 1});`,
    );
    const { styles, element } = document(
      `path{${doubled.join("")}opacity:var(--v0)}`,
      "opacity='1'",
    );
    expect(styles.value(element, "opacity")).toBeNull();
    const groups = "<g>".repeat(200) + "<path/>".repeat(2000) + "</g>".repeat(200);
    const rules = `${"g ".repeat(20)}x path{opacity:.5}`.repeat(30);
    const text = `<svg xmlns="http://www.w3.org/2000/svg"><style>g path{opacity:.1}${rules}</style>${groups}</svg>`;
    const root = parse(text);
    const paths = [...elementsOf(root)].filter(({ local }) => local === "path");
    const deep = new Styles(text, root);
    expect(deep.value(paths[0], "opacity")).toBe(".1");
    expect(deep.value(paths[1999], "opacity")).toBeNull();
  });

  test("sees an attribute that changed", () => {
    const around = 'data-k="x"';
    const { styles, element } = document("[data-k=x] path{opacity:.1}", 'd=""', around);
    expect(styles.value(element, "opacity")).toBe(".1");
    expect(styles.attributesChanged(element.attributes)).toBe(false);
    const group = element.parent!;
    const before = group.attributes;
    group.attributes = [];
    expect(styles.attributesChanged(before)).toBe(true);
    expect(styles.value(element, "opacity")).toBeNull();
  });
});

describe("a property that is set holds", () => {
  const sheets = [
    "",
    "path{opacity:.1}",
    "*{opacity:.1!important}",
    ".a{display:none}",
    "g > path{opacity:.1!important} svg path.a:last-child{display:none}",
    "g path{opacity:var(--o);display:var(--d)} svg{--o:.1;--d:none}",
    "path[opacity]{opacity:.1} path[style]{opacity:.2!important} [display]{display:none!important}",
    "path:not([style]){opacity:.3}",
  ];
  const attributes = [
    "",
    'opacity=".5"',
    'style="opacity:.25"',
    'class="a" style="fill:red; opacity : .2 ;"',
    'style="opacity:.1!important;opacity:.3"',
    'class="a" display="none" style=";"',
  ];

  test("whatever styles say, and says nothing else", () => {
    for (const sheet of sheets) {
      for (const attribute of attributes) {
        const { text, styles, element } = document(sheet, attribute);
        const edits = setStyles(text, styles, element, { opacity: ".75", display: "inline" });
        const after = applied(text, patchOf(edits));
        const root = parse(after);
        const path = root.children[1].children[0];
        const now = new Styles(after, root);
        expect(now.value(path, "opacity"), after).toBe(".75");
        expect(now.value(path, "display"), after).toBe("inline");
        expect(now.value(path, "fill"), after).toBe(styles.value(element, "fill"));
      }
    }
  });

  test("in the attribute where nothing else would win, and in style otherwise", () => {
    const set = (sheet: string, attribute: string, value: string | null) => {
      const { text, styles, element } = document(sheet, attribute);
      const after = applied(text, patchOf(setStyle(text, styles, element, "opacity", value)));
      return /<path ?(.*)\/>/.exec(after)?.[1];
    };
    expect(set("", 'd=""', ".5")).toBe('d="" opacity=".5"');
    expect(set("", 'style="fill:red;opacity:.5;stroke:none"', "1")).toBe(
      'style="fill:red;opacity:1;stroke:none"',
    );
    expect(set("", 'style="fill:red;opacity:.5;stroke:none"', null)).toBe(
      'style="fill:red;stroke:none"',
    );
    expect(set("", 'style="opacity:.5"', null)).toBe("");
    expect(set("path{opacity:1}", 'd=""', ".5")).toBe('d="" style="opacity:.5"');
    expect(set("", 'opacity=".5" d=""', null)).toBe(' d=""'.trimStart());
  });
});
