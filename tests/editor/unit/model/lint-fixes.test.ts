// A fix removes its hint, and can be undone like any edit.
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import { FIXABLE_RULES, fixOf } from "../../../../web/editor/src/model/lint-fixes.js";
import { isWorthTelling } from "../../../../web/editor/src/model/lint-worth.js";
import { applied } from "../../../../web/editor/src/source/patch.js";
import { placeOf } from "../../../../web/editor/src/panels/hints/show.js";
import * as en from "../../../../web/editor/src/strings/en.js";
import { file, handle, modulePath } from "../drawings.js";

const frame = '<path id="frame" d="M0 0H512V512H0Z" sf:right="#abc" sf:left="none"/>';
const text = (inner: string, outer = "", before = "") =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 512 512" sf:version="1">` +
  `${before}<g sf:diffuse="true">${inner}</g>${outer}</svg>`;
const curve = (d: string, said: string) => `<path d="${d}" ${said}/>`;
const RING = "M200 100C300 100 300 300 200 300C100 300 100 100 200 100";

/** For each rule, a drawing with one hint. */
const FAULTY: Readonly<Record<string, string>> = {
  "open-loop": text(frame + curve(`${RING.slice(0, -7)}202 100`, 'sf:left="#abc" sf:right="red"')),
  "inside-empty": text(frame + curve(`${RING}Z`, 'sf:left="red"')),
  "no-attribute": text(frame + curve("M90 90L300 200", "")),
  outside: text(frame + curve("M900 900L930 950", 'sf:left="red"')),
  duplicate: text(frame + curve("M90 90L300 200", 'sf:left="red" sf:right="red"') + curve("M90 90L300 200", 'sf:left="blue" sf:right="blue"')),
  "blur-without-shader": text(frame + curve("M90 90L300 200", 'sf:left="red" sf:blur="9"')),
  "stroke-blur": text(frame, curve("M90 90L300 200", 'sf:left="red" sf:right="red" sf:radius="9" sf:blur="4"')),
  seam: text(frame + curve(`${RING}Z`, 'sf:left="#abc" sf:right="red, gold, blue"')),
  gap: text(frame + curve("M100 50V400", 'sf:left="red" sf:right="red"') + curve("M102 200H400", 'sf:left="#fff" sf:right="#000"')),
  overshoot: text(frame + curve("M100 50V400", 'sf:left="red" sf:right="red"') + curve("M98 200H400", 'sf:left="#fff" sf:right="#000"')),
  flood: text(curve(`${RING}Z`, 'sf:right="red"')),
  "unseen-side": text(frame + curve("M90 90L300 200", 'sf:left="red"') + curve("M90 90L510 310", 'sf:left="blue" sf:right="blue"')),
  "empty-layer": text(frame, '<g sf:diffuse="true"></g>'),
  leak: text(frame, `<g id="it" sf:diffuse="true">${curve(`${RING}Z`, 'sf:left="red" sf:right="gold"')}${curve("M180 180L220 220", 'sf:left="#fff"')}</g>`),
  invisible: text(frame, `<g id="it" opacity="0"><g sf:diffuse="true">${curve(`${RING}Z`, 'sf:right="gold" sf:left-opacity="0" sf:right-opacity="1"')}</g></g>`),
  "instance-outside": text(frame, `<g id="shape" sf:diffuse="true">${curve(`${RING}Z`, 'sf:right="gold" sf:left="gold" sf:left-opacity="0" sf:right-opacity="1"')}</g><use id="it" href="#shape" x="900" y="-20"/>`),
};

interface Found {
  readonly kind: string;
  readonly layer?: number;
  readonly curve?: number;
  readonly side?: "left" | "right";
  readonly stack_item?: number;
}

async function linter() {
  const { loadSfumato } = await import(file("../../../web/wasm/sfumato.mjs"));
  const library = await loadSfumato(readFileSync(modulePath() as string));
  return (source: string) => {
    const context = library.context();
    const document = context.read(source);
    const hints = context.lint(document).hints as Found[];
    const found = hints.map(({ kind, layer, curve: index, side }) => {
      const place = layer === undefined || index === undefined ? null : document.curveSource(layer, index);
      // Local curves have no such place; the drawing has only one.
      const offset = place?.byteOffset ?? (kind.startsWith("stroke") ? source.lastIndexOf("<path") : null);
      return { rule: kind, offset, side };
    });
    context.free();
    return found;
  };
}

test("every rule with a fix has a drawing here, and words", () => {
  expect(Object.keys(FAULTY).sort()).toEqual([...FIXABLE_RULES].sort());
});

test.skipIf(!modulePath()).each(Object.keys(FAULTY))("%s: the fix takes the hint away", async (rule) => {
  const lint = await linter();
  const source = FAULTY[rule];
  const hint = lint(source).find((found) => found.rule === rule);
  expect(hint, JSON.stringify(lint(source))).toBeDefined();
  const d = openDrawing(source);
  const fix = fixOf(d, { offset: null, ...hint, rule, handle: source.includes('id="it"') ? handle(d, "it") : null });
  expect(fix).not.toBeNull();
  expect(en.commands.lintFixes[fix?.label ?? "closeCurve"]).toMatch(/^[A-Z]/);
  const repaired = applied(source, fix?.outcome.patch ?? []);
  expect(lint(repaired).filter((found) => found.rule === rule), repaired).toEqual([]);
});

test("the fix of a seam loses no colour, wherever the last one stands", () => {
  const square = "M100 100H400V400H100Z";
  const repaired = (left: string, d = square) => {
    const source = text(frame + curve(d, `id="it" sf:left="${left}" sf:right="#abc"`));
    const drawing = openDrawing(source);
    const offset = source.lastIndexOf("<path");
    const { outcome } = fixOf(drawing, { rule: "seam", offset })!;
    return /id="it"[^>]* sf:left="([^"]*)"/.exec(applied(source, outcome.patch))?.[1];
  };
  expect(repaired("#c33, #fa8 40%, #612 70%, #00f 85%")).toBe("#c33, #fa8 40%, #612 70%, #00f 85%, #c33");
  expect(repaired("#c33 10%, #00f 85%")).toBe("#c33 10%, #00f 85%, #c33");
  expect(repaired("#c33, #fa8 40%, #00f")).toBe("#c33, #fa8 40%, #00f 70%, #c33");
  expect(repaired("#c33 @0, #00f @2.5")).toBe("#c33 @0, #00f @2.5, #c33 @4");
  expect(repaired("#c33 @0, #00f @4")).toBe("#c33 @0, #00f @2, #c33 @4");
  // A list of two subpaths ends with the longer one.
  expect(repaired("#c33 @0, #00f @3", `${square}M150 150H200L170 190Z`)).toBe("#c33 @0, #00f @3, #c33 @4");
});

test("a layer of a drawing without curves is not told to be empty", () => {
  const told = (source: string) => isWorthTelling(openDrawing(source), { rule: "empty-layer" }, null);
  expect(told(text(""))).toBe(false);
  expect(told(FAULTY["empty-layer"])).toBe(true);
  expect(isWorthTelling(openDrawing(text("")), { rule: "leak" }, null)).toBe(true);
});

test("an empty layer is not told while it is the layer at work", () => {
  const d = openDrawing(FAULTY["empty-layer"]);
  const layers = [...d.all()].filter(({ kind }) => kind === "layer");
  const told = layers.map((layer) => isWorthTelling(d, { rule: "empty-layer" }, layer));
  expect(told).toEqual(layers.map(({ children }) => children.length > 0));
  expect(told).toContain(false);
  expect(told).toContain(true);
});

test("a hint that has no curve any more, or a rule without a fix, has none", () => {
  const d = openDrawing(FAULTY.seam);
  expect(fixOf(d, { rule: "seam", offset: 3 })).toBeNull();
  expect(fixOf(d, { rule: "seam", offset: null })).toBeNull();
  expect(fixOf(d, { rule: "leak", offset: null })).toBeNull();
  expect(fixOf(d, { rule: "toString", offset: 0 })).toBeNull();
  expect(fixOf(d, { rule: "empty-layer", offset: null })).toBeNull();
});

const wholes = (source: string, rule: string, id = "it") => {
  const d = openDrawing(source);
  return fixOf(d, { rule, offset: null, handle: handle(d, id) });
};

test("a layer ends at its outline alone where all of it lies within closed curves", () => {
  const line = curve("M20 20L90 30", 'sf:left="red"');
  expect(wholes(FAULTY.leak.replace("</g></svg>", `${line}</g></svg>`), "leak")).toBeNull();
  expect(wholes(text(frame, `<g id="it" sf:diffuse="true">${line}</g>`), "leak")).toBeNull();
  expect(wholes(text(frame, '<g id="it" sf:diffuse="true"></g>'), "leak")).toBeNull();
  const eight = curve("M10 10L90 90V10L10 90Z", 'sf:left="red" sf:right="red"');
  expect(wholes(text(frame, `<g id="it" sf:diffuse="true">${eight}</g>`), "leak")).toBeNull();
});

test("an outline ends its layer whichever way it turns, and inner curves stay as they are", () => {
  const turned = 'd="M200 100V300H100V100Z" sf:left="red" sf:right="gold"';
  const inner = 'd="M120 120H150V150Z" sf:left="#fff" sf:right="#000"';
  const source = text(frame, `<g id="it" sf:diffuse="true"><path ${turned}/><path ${inner}/></g>`);
  const clockwise = wholes(source, "leak")?.outcome.patch ?? [];
  expect(applied(source, clockwise)).toContain(`<path ${turned} sf:left-opacity="0" sf:right-opacity="1"/><path ${inner}/>`);
  const other = source.replace("M200 100V300H100V100Z", "M200 100H100V300H200Z");
  expect(applied(other, wholes(other, "leak")?.outcome.patch ?? [])).toContain('sf:right-opacity="0" sf:left-opacity="1"');
});

test("what is seen again, or lies in the picture, is neither deleted nor moved", () => {
  expect(wholes(FAULTY.invisible.replace('opacity="0"', 'opacity="0.1"'), "invisible")).toBeNull();
  expect(wholes(FAULTY["instance-outside"].replace('x="900"', 'x="9"'), "instance-outside")).toBeNull();
  const inner = FAULTY.invisible.replace('<g sf:diffuse="true"><path d="M200', '<g id="in" sf:diffuse="true"><path d="M200');
  expect(applied(inner, wholes(inner, "invisible", "in")?.outcome.patch ?? [])).toBe(text(frame));
  const stroke = text(frame, '<path id="it" d="M9 9L90 90" sf:radius="9" sf:left="red" sf:alpha="0"/>');
  expect(applied(stroke, wholes(stroke, "invisible")?.outcome.patch ?? [])).toBe(text(frame));
});

test.skipIf(!modulePath())("the place of a hint is on the artboard, whatever transforms its curve and layer", async () => {
  const { loadSfumato } = await import(file("../../../web/wasm/sfumato.mjs"));
  const context = (await loadSfumato(readFileSync(modulePath() as string))).context();
  const placeIn = (layer: string, item: string, d: string) => {
    const post = curve("M100 50V400", 'sf:left="red" sf:right="red"');
    const rail = `<g transform="${item}"><path d="${d}" sf:left="#fff" sf:right="#000"/></g>`;
    const source = text(frame + post + rail).replace("<g sf:diff", `<g transform="${layer}" sf:diff`);
    const document = context.read(source);
    const { at, layer: index, curve: number } = (context.lint(document).hints as (Found & { at?: [number, number] })[])
      .find(({ kind }) => kind === "gap") ?? {};
    const offset = document.curveSource(index, number).byteOffset;
    return placeOf({ drawing: openDrawing(source) }, { at: at ?? null, offset });
  };
  for (const [layer, item, d, expected] of [
    ["translate(0 0)", "scale(1)", "M102 200H400", [102, 200]],
    ["translate(30 -50)", "scale(1)", "M102 200H400", [132, 150]],
    ["translate(10 0) scale(.5)", "translate(20 40) scale(.5)", "M164 320H760", [61, 100]],
    ["rotate(90) translate(0 -500)", "scale(1)", "M102 200H400", [300, 102]],
  ] as const) {
    const place = placeIn(layer, item, d);
    for (const axis of [0, 1]) expect(place?.[axis], layer).toBeCloseTo(expected[axis], 3);
  }
  context.free();
});
