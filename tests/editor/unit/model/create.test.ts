// New curves, layers, pictures and paints, and their texts.
import { expect, test } from "vitest";
import {
  addCurves,
  addLayer,
  addReference,
  copyItems,
  paste,
  setPaint,
} from "../../../../web/editor/src/model/commands/index.js";
import type { NewCurve } from "../../../../web/editor/src/model/commands/index.js";
import { blankText, openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { CurveItem } from "../../../../web/editor/src/model/types.js";
import { applied } from "../../../../web/editor/src/source/patch.js";
import { after, handle, modulePath, named, SAMPLES } from "../drawings.js";
import { painter } from "../picture.js";

const PATH = { points: [[0, 0], [1, 1], [2, 2], [3.14159, 3]], closed: false } as const;
const stops = <Value>(...values: Value[]) =>
  ({
    kind: "stops",
    space: "arc",
    stops: values.map((value, i) => ({ offset: values.length > 1 ? i / (values.length - 1) : 0, value })),
  }) as const;
const RED = { r: 1, g: 0, b: 0 };
const BLUE = { r: 0, g: 0, b: 1 };
const CURVE: NewCurve = { path: PATH, left: stops(RED), right: stops(RED, BLUE), blur: stops(0, 4) };
const EMPTY = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 512 512"/>';

test("a curve goes into its layer, with a thin line for other programs", () => {
  const text = blankText(512, 512, null);
  expect(after(text, (d) => addCurves(d, handle(d, "layer-1"), [CURVE], 0.01))).toBe(
    text.replace(
      '"true">\n',
      '"true">\n    <path d="M0 0 C1 1 2 2 3.14 3" sf:left="#f00" sf:right="#f00, #00f" sf:blur="0, 4" ' +
        'fill="none" stroke="#a05" stroke-width="1"/>\n',
    ).replace("#a05", "#aa0055").replace("#aa0055", "#a05"),
  );
});

test("without a layer it makes one, and declares what it needs", () => {
  const now = after(EMPTY, (d) => addCurves(d, null, [CURVE], 0.01));
  expect(now).toMatch(/^<svg xmlns="[^"]*" viewBox="0 0 512 512" xmlns:sf="urn:sfumato:1" sf:version="1">\n {2}<g sf:diffuse="true">\n {4}<path /);
  const d = openDrawing(now);
  expect(d.items.map(({ kind, children }) => [kind, children.length])).toEqual([["layer", 1]]);
});

test("behind a curve, what is new lies right above it and is selected", () => {
  const d = openDrawing(SAMPLES[0].text);
  const outcome = addCurves(d, handle(d, "c"), [CURVE, CURVE], 0.01);
  d.apply(outcome?.patch ?? []);
  const siblings = named(d, "inner").children;
  expect(siblings.map(({ name }) => name.replace(/\d+$/, "#"))).toEqual(["c", "Curve #", "Curve #", "c#"]);
  expect(outcome?.select?.map(({ at }) => d.itemAt(at))).toEqual(siblings.slice(1, 3));
});

test("a local curve goes beside layers, not into them", () => {
  const stroke = { ...CURVE, radius: stops(3, 9, 3) };
  const d = openDrawing(SAMPLES[0].text);
  d.apply(addCurves(d, handle(d, "d"), [stroke], 0.01)?.patch ?? []);
  expect(named(d, "near").children.map(({ kind }) => kind)).toEqual(["layer", "stroke", "stroke"]);
});

test("a layer has a name that no other has", () => {
  const once = after(blankText(9, 9, null), (d) => addLayer(d, null, "far away"));
  const twice = after(once, (d) => addLayer(d, handle(d, "layer-1"), "far away"));
  const names = openDrawing(twice).items.map(({ name }) => name);
  expect(names).toEqual(["layer-1", "far-away-2", "far-away"]);
  const inkscape = after(SAMPLES[2].text, (d) => addLayer(d, null, 'fär & "away"'));
  expect(openDrawing(inkscape).items.at(-1)?.name).toBe('fär & "away"');
});

test("a picture to trace over lies in the middle, as large as it fits, and locked", () => {
  const d = openDrawing(SAMPLES[0].text);
  d.apply(addReference(d, "a&b.png", 400, 100)?.patch ?? []);
  const item = d.items.at(-1);
  expect(item).toMatchObject({ kind: "reference", href: "a&b.png", box: [0, 50, 200, 100], locked: true, opacity: 1 });
  d.apply(addReference(d, "b.png", 400, 100, 0.5)?.patch ?? []);
  expect(d.items.at(-1)).toMatchObject({ locked: true, opacity: 0.5 });
  expect(addReference(d, "a.png", 0, 100)).toBeNull();
});

test("a gradient stands in <defs>, and side and stroke name it", () => {
  const d = openDrawing(SAMPLES[0].text);
  const paint = {
    kind: "linear",
    stops: [{ offset: 0, color: RED, opacity: 1 }, { offset: 1, color: BLUE, opacity: 0.5 }],
    from: [0, 0],
    to: [9, 0],
  } as const;
  d.apply(setPaint(d, handle(d, "a"), "left", "color", paint)?.patch ?? []);
  expect(d.text).toContain(
    '  <title>Hills</title>\n  <defs>\n    <linearGradient id="gradient" gradientUnits="userSpaceOnUse" x1="0" y1="0" x2="9" y2="0">' +
      '<stop offset="0" stop-color="#f00"/><stop offset="1" stop-color="#00f" stop-opacity="0.5"/></linearGradient>\n  </defs>\n',
  );
  expect((named(d, "a") as CurveItem).left.color).toEqual({ kind: "paint", href: "#gradient" });
  d.apply(setPaint(d, handle(d, "b"), "right", "opacity", { kind: "existing", id: "gradient" })?.patch ?? []);
  expect(d.text.match(/url\(#gradient\)/g)?.length).toBe(4);
  expect(setPaint(d, handle(d, "b"), "right", "color", { kind: "existing", id: "none" })).toBeNull();
});

test("an opacity's paint leaves the stroke to the colour's, which other programs draw", () => {
  const curve = '<path id="c" d="M0 0L9 9" stroke="url(#sky)" sf:left="url(#sky)"/>';
  const d = openDrawing(`<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1"><defs><linearGradient id="sky"><stop/></linearGradient><linearGradient id="fade"><stop/></linearGradient></defs><g sf:diffuse="true">${curve}</g></svg>`);
  const paint = { kind: "existing", id: "fade" } as const;
  d.apply(setPaint(d, handle(d, "c"), "left", "opacity", paint)?.patch ?? []);
  expect(d.text).toContain('stroke="url(#sky)"');
  expect(d.text).toContain('sf:left-opacity="url(#fade)"');
  expect(d.text).toContain('sf:right-opacity="1"');
  d.apply(setPaint(d, handle(d, "c"), "left", "color", paint)?.patch ?? []);
  expect(d.text).toContain('stroke="url(#fade)"');
});

test("into a document without anything, curves come with their paints", () => {
  const from = openDrawing(SAMPLES[2].text);
  const text = copyItems(from, [handle(from, "path111")]);
  for (const empty of [EMPTY, EMPTY.replace("/>", "></svg>"), EMPTY.replace("/>", ">\n</svg>")]) {
    const d = openDrawing(empty);
    const now = applied(empty, paste(d, text, null)?.patch ?? []);
    expect(now).toMatch(/<svg [^>]*>\n {2}<defs>\n {4}<linearGradient[^]*<\/defs>\n {2}<g [^>]*>\n {4}<path[^]*<\/g>\n<\/svg>$/);
  }
});

test.skipIf(!modulePath())("the module reads what was made", async () => {
  const easel = await painter();
  const d = openDrawing(EMPTY);
  d.apply(addCurves(d, null, [CURVE], 0.01)?.patch ?? []);
  d.apply(addCurves(d, null, [{ ...CURVE, radius: stops(3, 9) }], 0.01)?.patch ?? []);
  d.apply(addLayer(d, null, "top")?.patch ?? []);
  d.apply(addReference(d, "a.png", 30, 40)?.patch ?? []);
  const [curve] = d.items[0].children;
  const radial = { kind: "radial", stops: [{ offset: 0, color: RED, opacity: 1 }], from: [0, 0], to: [9, 0] } as const;
  d.apply(setPaint(d, curve.handle, "right", "color", radial)?.patch ?? []);
  expect(easel?.paint(d.text).some((value) => value > 0)).toBe(true);
});
