// Commands that set attributes of curves and of the document: the text then has that attribute, and no other
// change.
import { describe, expect, test, vi } from "vitest";
import {
  recolor,
  setBoth,
  setColor,
  setNumber,
  setNumbers,
  setRadius,
  setSideOpacity,
  swapSides,
} from "../../../../web/editor/src/model/commands/attributes.js";
import {
  rename,
  setArtboard,
  setBackground,
  setBlend,
  setHidden,
  setInterpolation,
  setLocked,
  setOpacity,
} from "../../../../web/editor/src/model/commands/document.js";
import {
  curvesOf,
  isContainer,
  together,
} from "../../../../web/editor/src/model/commands/structure/together.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type {
  CurveItem,
  Drawing,
  Item,
  Outcome,
  SideValue,
  SideValues,
} from "../../../../web/editor/src/model/types.js";
import { parseOpaque } from "../../../../web/editor/src/source/colors.js";
import { applied, inverse } from "../../../../web/editor/src/source/patch.js";
import type { Rgb } from "../../../../web/editor/src/geometry/color.js";
import { examples, pick, randomNumbers } from "../corpus.js";

// These tests generate much input, and machines may be busy.
vi.setConfig({ testTimeout: 120_000 });

const HEAD =
  '<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 100 100">';

function open(content: string, head = HEAD): Drawing {
  return openDrawing(`${head}${content}</svg>`);
}

/** Returns a layer of one curve. */
function curve(attributes: string): { d: Drawing; h: number; item: () => CurveItem } {
  const d = open(`<g sf:diffuse="true"><path id="p" d="M0 0L9 9L8 1" ${attributes}/></g>`);
  return withItem(d);
}

function stroke(attributes: string) {
  return withItem(open(`<path id="p" d="M0 0L9 9" ${attributes}/>`));
}

function withItem(d: Drawing) {
  const h = named(d, "p").handle;
  return { d, h, item: () => d.item(h) as CurveItem };
}

function named(d: Drawing, name: string): Item {
  return [...d.all()].find((item) => item.name === name) as Item;
}

function after(d: Drawing, outcome: Outcome | null): string {
  return outcome ? applied(d.text, outcome.patch) : d.text;
}

/** Returns the attributes of #p after a command, from d="…" on. */
function attributes(d: Drawing, outcome: Outcome | null): string {
  return /id="p" d="[^"]*" ?([^>]*)\/>/.exec(after(d, outcome))?.[1].trim() ?? "none";
}

const rgb = (text: string) => parseOpaque(text) as Rgb;

function colors(...names: string[]): SideValue<Rgb> {
  const stops = names.map((name, i) => ({
    offset: i / Math.max(names.length - 1, 1),
    value: rgb(name),
  }));
  return { kind: "stops", space: "arc", stops };
}

function numbers(...values: number[]): SideValue<number> {
  const stops = values.map((value, i) => ({ offset: i / Math.max(values.length - 1, 1), value }));
  return { kind: "stops", space: "arc", stops };
}

const OPEN = { kind: "open" } as const;

describe("a side's colour", () => {
  test("keeps the notation of what stays", () => {
    const { d, h, item } = curve('sf:left="gold, RED 30.0%, #ffffff"');
    const { left } = item();
    if (left.color.kind !== "stops") throw new Error("no stops");
    const stops = left.color.stops.map((s, i) => (i === 2 ? { ...s, value: rgb("#123456") } : s));
    const outcome = setColor(d, h, "left", { ...left.color, stops });
    expect(attributes(d, outcome)).toBe('sf:left="gold, RED 30.0%, #123456"');
  });

  test("can be nothing, none and a paint, and is not written where nothing changes", () => {
    const { d, h, item } = curve('sf:left="red"');
    expect(attributes(d, setColor(d, h, "left", OPEN))).toBe("");
    expect(attributes(d, setColor(d, h, "right", { kind: "barrier" }))).toBe(
      'sf:left="red" sf:right="none"',
    );
    expect(attributes(d, setColor(d, h, "left", { kind: "paint", href: "#a" }))).toBe(
      'sf:left="url(#a)"',
    );
    expect(setColor(d, h, "left", item().left.color)).toBeNull();
    expect(setColor(d, h, "right", OPEN)).toBeNull();
    expect(setColor(d, 999, "left", OPEN)).toBeNull();
  });

  test("has few decimals where the hand put it", () => {
    const { d, h } = curve("");
    const stops = [
      { offset: 1 / 3, value: rgb("red") },
      { offset: 0.5000001, value: rgb("gold") },
    ];
    const outcome = setColor(d, h, "left", { kind: "stops", space: "arc", stops });
    expect(attributes(d, outcome)).toBe('sf:left="#f00 33.333%, #ffd700 50%"');
    const at = setColor(d, h, "left", { kind: "stops", space: "parameter", stops });
    expect(attributes(d, at)).toBe('sf:left="#f00 @.3333, #ffd700 @.5"');
  });

  test("of a local curve leaves the other side as it is seen", () => {
    const { d, h } = stroke('sf:left="red" sf:radius="3"');
    expect(attributes(d, setColor(d, h, "left", colors("blue")))).toBe(
      'sf:left="#00f" sf:radius="3" sf:right="red"',
    );
    expect(attributes(d, setColor(d, h, "right", colors("blue")))).toBe(
      'sf:left="red" sf:radius="3" sf:right="#00f"',
    );
  });
});

describe("opacity and blur", () => {
  test("of one side leave the other one, also where one attribute serves both", () => {
    const { d, h } = curve('sf:blur="3"');
    expect(attributes(d, setNumbers(d, h, "left", "blur", numbers(1, 2)))).toBe(
      'sf:blur="3" sf:left-blur="1, 2"',
    );
    expect(attributes(d, setNumbers(d, h, "left", "blur", OPEN))).toBe('sf:right-blur="3"');
    expect(attributes(d, setNumbers(d, h, "right", "opacity", numbers(0.25)))).toBe(
      'sf:blur="3" sf:right-opacity=".25"',
    );
  });

  test("of both sides take one attribute", () => {
    const { d, h } = curve('sf:left-blur="3" sf:right-blur="4"');
    expect(attributes(d, setBoth(d, h, "blur", numbers(5)))).toBe('sf:blur="5"');
    expect(attributes(d, setBoth(d, h, "blur", OPEN))).toBe("");
  });

  test("of a local curve are for both sides, and opacity is none", () => {
    const { d, h } = stroke('sf:left="red" sf:radius="3"');
    expect(attributes(d, setNumbers(d, h, "right", "blur", numbers(2)))).toBe(
      'sf:left="red" sf:radius="3" sf:blur="2"',
    );
    expect(setNumbers(d, h, "left", "opacity", numbers(1))).toBeNull();
    expect(setBoth(d, h, "opacity", numbers(1))).toBeNull();
  });

  test("by chance say on that side what was asked, and on the other what was there", () => {
    const random = randomNumbers(23);
    const written = [
      "",
      'sf:blur="3"',
      'sf:blur="1, 2" sf:left-blur="0"',
      'sf:opacity=".5" sf:right-opacity="none"',
      'sf:left-opacity="0, 1"',
    ];
    for (let i = 0; i < 300; i += 1) {
      const { d, h, item } = curve(pick(written, random));
      const side = pick(["left", "right"] as const, random);
      const name = pick(["opacity", "blur"] as const, random);
      const to = pick([OPEN, numbers(Math.fround(random())), numbers(0, 0.5, 1)], random);
      const before = item();
      const outcome = setNumbers(d, h, side, name, to);
      if (outcome) d.apply(outcome.patch);
      const now = item();
      const other = side === "left" ? "right" : "left";
      expect(now[other]).toEqual(before[other]);
      expect({ ...now[side], [name]: null }).toEqual({ ...before[side], [name]: null });
      const digits = (value: SideValue<number>) =>
        value.kind === "stops" ? value.stops.map(({ value: v }) => v.toPrecision(6)) : value;
      expect(digits(now[side][name])).toEqual(digits(to));
    }
  });
});

test("the side beside a first opacity stays opaque; one that takes part is left alone", () => {
  const first = curve('sf:left="red"');
  first.d.apply(setSideOpacity(first.d, first.h, "right", numbers(0.5))!.patch);
  expect([first.item().left.opacity, first.item().right.opacity]).toEqual([numbers(1), numbers(0.5)]);
  const { d, h, item } = curve('sf:left-opacity="0.2"');
  d.apply(setSideOpacity(d, h, "right", numbers(0.5))!.patch);
  expect([item().left.opacity, item().right.opacity]).toEqual([numbers(0.2), numbers(0.5)]);
  const gone = curve('sf:left-opacity=".5"');
  expect(attributes(gone.d, setSideOpacity(gone.d, gone.h, "left", OPEN))).toBe("");
});

test("the radius of a local curve is set, and does not go", () => {
  const { d, h } = stroke('sf:left="red" sf:radius="3mm"');
  expect(attributes(d, setRadius(d, h, numbers(1, 14, 3)))).toBe(
    'sf:left="red" sf:radius="1, 14 50%, 3"',
  );
  expect(attributes(d, setRadius(d, h, numbers(0, 2)))).toBe('sf:left="red" sf:radius="0, 2"');
  // Without any radius the whole drawing could not be read.
  expect(attributes(d, setRadius(d, h, numbers(0, 0)))).toMatch(/^sf:left="red" sf:radius="\.001, \.001"$/);
  expect(setRadius(d, h, OPEN)).toBeNull();
  const of = curve("");
  expect(setRadius(of.d, of.h, numbers(1))).toBeNull();
});

test("weights are of diffusion curves, alphas of local ones", () => {
  const { d, h } = curve("");
  expect(attributes(d, setNumber(d, [h], "weight", 2.5))).toBe('sf:weight="2.5"');
  expect(setNumber(d, [h], "alpha", 1)).toBeNull();
  const s = stroke('sf:radius="1" sf:alpha=".5"');
  expect(attributes(s.d, setNumber(s.d, [s.h], "alpha", null))).toBe('sf:radius="1"');
});

test("sides that are swapped twice are as they were, and once the other way round", () => {
  for (const { text } of examples()) {
    const d = openDrawing(text);
    const items = [...d.all()].filter((item): item is CurveItem => item.kind === "curve");
    const handles = items.map(({ handle }) => handle);
    const before = new Map(
      items.map((item) => [item.handle, [item.left, item.right] as [SideValues, SideValues]]),
    );
    const outcome = swapSides(d, handles);
    if (!outcome) continue;
    d.apply(outcome.patch);
    for (const [handle, [left, right]] of before) {
      const now = d.item(handle) as CurveItem;
      expect([now.right, now.left]).toEqual([left, right]);
    }
    d.apply((swapSides(d, handles) as Outcome).patch);
    expect(d.text).toBe(text);
  }
});

test("one colour is exchanged for another everywhere, and nothing else", () => {
  const d = open(
    '<g sf:diffuse="true" id="l"><path d="M0 0L1 1" sf:left="#f00, gold 20%" sf:right="red @0, RED @1"/><path d="M0 0L1 1" sf:left="#f10"/></g>',
  );
  const handles = curvesOf(d, [{ handle: named(d, "l").handle, part: { kind: "whole" } }]);
  expect(handles.length).toBe(2);
  const outcome = recolor(d, handles, rgb("red"), rgb("blue"));
  expect(after(d, outcome)).toBe(
    d.text
      .replace("#f00, gold 20%", "#00f, gold 20%")
      .replace("red @0, RED @1", "#00f @0, #00f @1"),
  );
  expect(recolor(d, handles, rgb("lime"), rgb("blue"))).toBeNull();
});

describe("a name", () => {
  test("is a label where the document knows Inkscape", () => {
    const head = HEAD.replace(">", ' xmlns:ink="http://www.inkscape.org/namespaces/inkscape">');
    const d = open('<g id="a" ink:label="b"/><use href="#a"/>', head);
    const outcome = rename(d, named(d, "b").handle, "Sky & sea");
    expect(after(d, outcome)).toBe(d.text.replace('"b"', '"Sky &amp; sea"'));
  });

  test("is an id, valid and by itself, and all that refers to it follows", () => {
    const content = (id: string) =>
      `<style>#${id}{opacity:1} #aa{} path{fill:url(#${id})} .x{color:#a00}</style><g id="${id}" sf:diffuse="true"/><g id="taken"/><use href="#${id}"/>` +
      `<use xmlns:x="http://www.w3.org/1999/xlink" x:href=" #${id}"/>`.replace(" #", "#") +
      `<path fill="url(#${id})" sf:left="url( '#${id}' )" style="fill:url(&quot;#${id}&quot;)"/><use href="#aa"/><text>#a</text>`;
    const d = open(content("a"));
    const h = named(d, "a").handle;
    expect(after(d, rename(d, h, " My layer! "))).toBe(after(open(content("My-layer")), null));
    expect(after(d, rename(d, h, "taken"))).toContain('id="taken-2"');
    expect(after(d, rename(d, h, "1st"))).toContain('id="_1st"');
    expect(rename(d, h, "a")).toBeNull();
    expect(rename(d, h, "")).toBeNull();
    const taken = named(d, "taken").handle;
    expect(after(d, rename(d, taken, "!"))).toBe(d.text.replace(' id="taken"', ""));
  });

  test("of a second element with the same id leaves what refers to the first", () => {
    const d = open('<g id="a"/><g id="a"/><use href="#a"/>');
    expect(after(d, rename(d, d.items[1].handle, "b"))).toBe(
      d.text.replace('<g id="a"/><use', '<g id="b"/><use'),
    );
  });
});

describe("what is hidden", () => {
  const cases = [
    "",
    'display="none"',
    'style="display:none"',
    'class="off"',
    'visibility="hidden"',
    'class="off" style="display:none; visibility:hidden"',
    'class="hard"',
  ];
  test.each(cases)("is shown, hidden and shown again: %s", (own) => {
    const d = open(
      `<style>.off{display:none}.hard{display:none!important}</style><g visibility="hidden"><g id="a" ${own}/></g>`,
    );
    const h = named(d, "a").handle;
    for (const hidden of [false, true, false]) {
      const outcome = setHidden(d, [h], hidden);
      if (outcome) d.apply(outcome.patch);
      expect(d.item(h)?.hidden, d.text).toBe(hidden);
      expect(setHidden(d, [h], hidden)).toBeNull();
    }
  });

  test("leaves nothing behind once it is shown", () => {
    const d = open('<g id="a"/>');
    const [{ handle }] = d.items;
    const before = d.text;
    d.apply((setHidden(d, [handle], true) as Outcome).patch);
    d.apply((setHidden(d, [handle], false) as Outcome).patch);
    expect(d.text).toBe(before);
  });
});

describe("layers and groups", () => {
  test("are locked as Inkscape locks them", () => {
    const d = open('<g id="a"/><g id="b"/>');
    const handles = d.items.map(({ handle }) => handle);
    d.apply((setLocked(d, handles, true) as Outcome).patch);
    expect(d.items.map(({ locked }) => locked)).toEqual([true, true]);
    expect(d.text.match(/xmlns:sodipodi=/g)?.length).toBe(1);
    expect(setLocked(d, handles, true)).toBeNull();
    d.apply((setLocked(d, handles, false) as Outcome).patch);
    expect(d.items.map(({ locked }) => locked)).toEqual([false, false]);
  });

  test("have an opacity and a blend mode, of which the initial ones are not written", () => {
    const d = open('<g id="a"/>');
    const [{ handle }] = d.items;
    const before = d.text;
    d.apply((setOpacity(d, handle, 0.123456) as Outcome).patch);
    expect(d.items[0].opacity).toBe(0.1235);
    d.apply((setBlend(d, handle, "multiply") as Outcome).patch);
    expect(d.text).toContain('style="mix-blend-mode:multiply"');
    expect(d.items[0].blend).toBe("multiply");
    expect(setBlend(d, handle, "banana")).toBeNull();
    expect(setOpacity(d, handle, 0.123456)).toBeNull();
    d.apply((setOpacity(d, handle, 7) as Outcome).patch);
    d.apply((setBlend(d, handle, "normal") as Outcome).patch);
    expect(d.text).toBe(before);
  });
});

describe("the document", () => {
  test("has another artboard, and a unit stays as long as it was", () => {
    const head = HEAD.replace(">", ' width="20cm" height="300">');
    const d = open("", head);
    d.apply((setArtboard(d, [-10, 0, 40, 20]) as Outcome).patch);
    expect(d.text).toContain('viewBox="-10 0 50 20"');
    expect(d.text).toContain('width="10cm" height="60"');
    const plain = open("", '<svg xmlns="http://www.w3.org/2000/svg" width="50" height="40">');
    plain.apply((setArtboard(plain, [0, 0, 100, 40]) as Outcome).patch);
    expect(plain.artboard).toEqual([0, 0, 100, 40]);
    expect(plain.text).toContain('width="100" height="40" viewBox="0 0 100 40"');
    expect(setArtboard(plain, [0, 0, 100, 40])).toBeNull();
    expect(setArtboard(plain, [0, 0, 0, 40])).toBeNull();
  });

  test("has an interpolation and a background", () => {
    const d = open('<rect width="100" height="100" fill="red"/>');
    d.apply((setInterpolation(d, "oklab") as Outcome).patch);
    expect(d.interpolation).toBe("oklab");
    d.apply((setInterpolation(d, "srgb") as Outcome).patch);
    expect(d.text).not.toContain("interpolation");
    expect(setInterpolation(d, "srgb")).toBeNull();
    d.apply((setBackground(d, rgb("#abc")) as Outcome).patch);
    expect(d.background).toEqual(rgb("#abc"));
    d.apply((setBackground(d, null) as Outcome).patch);
    expect(d.background).toBeNull();
    expect(setBackground(d, null)).toBeNull();
  });
});

describe("patches side by side", () => {
  test("are one, with what each selects", () => {
    const text = "<svg><a/><b/></svg>";
    const first = { patch: [{ at: 5, removed: "", inserted: "<n/>" }], select: [{ at: 5 }] };
    const second = {
      patch: [{ at: 9, removed: "<b/>", inserted: "<mm/><m/>" }],
      select: [{ at: 14 }, { at: 5 }],
    };
    const both = together([second, null, first]) as Outcome;
    const now = applied(text, both.patch);
    expect(now).toBe("<svg><n/><a/><mm/><m/></svg>");
    expect(both.select?.map(({ at }) => now.slice(at, at + 3))).toEqual([
      "<m/>".slice(0, 3),
      "<a/",
      "<n/",
    ]);
    expect(applied(now, inverse(both.patch))).toBe(text);
    expect(together([])).toBeNull();
    expect(together([null, first])).toBe(first);
  });

  test("that overlap are refused", () => {
    const one = { patch: [{ at: 0, removed: "abc", inserted: "" }] };
    const two = { patch: [{ at: 2, removed: "cd", inserted: "" }] };
    expect(() => together([one, two])).toThrow(RangeError);
  });

  test("by chance are what they are one after the other", () => {
    const random = randomNumbers(29);
    for (const { text } of examples()) {
      const [d, again] = [openDrawing(text), openDrawing(text)];
      const items = [...d.all()].filter((item): item is CurveItem => item.kind === "curve");
      for (let i = 0; i < 20 && items.length > 1; i += 1) {
        const one = pick(items, random).handle;
        const two = pick(
          items.filter(({ handle }) => handle !== one),
          random,
        ).handle;
        const commands = [
          (now: Drawing) => setColor(now, one, "left", colors("#123", "#456")),
          (now: Drawing) => setBoth(now, two, "blur", numbers(i, 1)),
        ];
        const both = together(commands.map((command) => command(d)));
        const patches = commands.map((command) => {
          const patch = command(again)?.patch ?? [];
          again.apply(patch);
          return patch;
        });
        expect(after(d, both) === again.text).toBe(true);
        for (const patch of patches.reverse()) again.apply(inverse(patch));
        expect(again.text === text).toBe(true);
      }
    }
  });
});

test("containers hold others", () => {
  const d = open('<g id="a"/><use id="u"/>');
  expect(["a", "u"].map((name) => isContainer(named(d, name)))).toEqual([true, false]);
});
