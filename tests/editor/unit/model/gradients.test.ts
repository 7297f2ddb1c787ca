// Stops of gradients: read like the engine reads them, and edited only in their own attributes.
import { describe, expect, test } from "vitest";
import { deleteStop } from "../../../../web/editor/src/app/stops.js";
import {
  setGradientStops,
  setSpread,
} from "../../../../web/editor/src/model/commands/paint/gradients.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import {
  gradientOf,
  sidesWithPaint,
  type GradientStop,
  type Tint,
} from "../../../../web/editor/src/model/gradients.js";
import type { CurveItem } from "../../../../web/editor/src/model/types.js";
import { applied, inverse } from "../../../../web/editor/src/source/patch.js";
import { randomNumbers } from "../corpus.js";

const head = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 9 9"';
const layer =
  '<g id="l" sf:diffuse="true"><path id="c" d="M0 0L9 9" sf:left="url(#sky)" sf:right="url(#sky)"/></g>';

const documentWith = (defs: string, attributes = "") =>
  `${head}${attributes}>\n  <defs>\n    ${defs}\n  </defs>\n  ${layer}\n</svg>\n`;
const gradient = (stops: string, attributes = "") =>
  `<linearGradient id="sky"${attributes}>${stops}</linearGradient>`;
const plain = gradient(
  '\n      <stop offset="0" stop-color="#f00"/>\n      <stop offset=".5" stop-color="#0f0"/> <!-- the middle -->\n      <stop offset="1" stop-color="#00f" sf:kept="yes"/>\n    ',
);

const tint = (hex: string, alpha = 1): Tint => {
  const [r, g, b] = [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255);
  return { r, g, b, alpha };
};
const stopsOf = (text: string): readonly GradientStop[] =>
  gradientOf(openDrawing(text), "#sky")?.stops ?? [];

/** Returns the text after setting the gradient's stops. */
function edited(text: string, make: (stops: readonly GradientStop[]) => readonly GradientStop[]) {
  const to = make(stopsOf(text));
  const outcome = setGradientStops(openDrawing(text), "#sky", to);
  const after = outcome ? applied(text, outcome.patch) : text;
  expect(stopsOf(after)).toEqual(to);
  if (outcome) expect(applied(after, inverse(outcome.patch))).toBe(text);
  return after;
}

describe("reading", () => {
  test("offsets, colours and opacities, as attributes, styles and sheets say", () => {
    const sheet = "<style>.x { stop-color: lime; stop-opacity: 50% }</style>";
    const stops =
      '<stop stop-color="#ff000080"/><stop offset="25%" style="stop-color:currentColor;stop-opacity:.5" color="#00f"/><stop offset=".75" class="x"/><stop offset="2"/>';
    expect(stopsOf(documentWith(sheet + gradient(stops)))).toEqual([
      { offset: 0, value: tint("#ff0000", 128 / 255) },
      { offset: 0.25, value: tint("#0000ff", 0.5) },
      { offset: 0.75, value: tint("#00ff00", 0.5) },
      { offset: 1, value: tint("#000000") },
    ]);
  });

  test("a stop that goes back is drawn at the largest offset so far", () => {
    const stops = '<stop offset=".6"/><stop offset=".2"/><stop offset=".7"/>';
    expect(stopsOf(documentWith(gradient(stops))).map(({ offset }) => offset)).toEqual([0.6, 0.6, 0.7]);
  });

  test("stops and spread come by href, as far as it leads", () => {
    const base = '<radialGradient id="base" spreadMethod="reflect"><stop stop-color="#fff"/></radialGradient>';
    const text = documentWith(`${base}<linearGradient id="sky" href="#base"/>`);
    expect(gradientOf(openDrawing(text), "#sky")).toMatchObject({
      kind: "linear",
      spread: "reflect",
      stops: [{ offset: 0, value: tint("#ffffff") }],
    });
    const round = '<linearGradient id="sky" href="#b"/><linearGradient id="b" href="#sky"/>';
    expect(gradientOf(openDrawing(documentWith(round)), "#sky")).toBeNull();
  });

  test("what is no gradient, or has no stops, is none", () => {
    for (const defs of ["", '<pattern id="sky"/>', gradient(""), '<linearGradient id="sky" href="#none"/>'])
      expect(gradientOf(openDrawing(documentWith(defs)), "#sky")).toBeNull();
  });

  test("sides that show it are counted", () => {
    expect(sidesWithPaint(openDrawing(documentWith(plain)), "#sky")).toBe(2);
  });
});

describe("editing", () => {
  test("a colour changes in its attribute alone", () => {
    const text = documentWith(plain);
    const after = edited(text, ([a, b, c]) => [a, { ...b, value: tint("#112233") }, c]);
    expect(after).toBe(text.replace("#0f0", "#123"));
  });

  test("an offset changes in its attribute, in its notation", () => {
    const text = documentWith(plain.replace('".5"', '"50%"'));
    const after = edited(text, ([a, b, c]) => [a, { ...b, offset: 0.25 }, c]);
    expect(after).toBe(text.replace("50%", "25%"));
  });

  test("opacity is added, and a colour's own alpha goes into it", () => {
    const text = documentWith(plain);
    expect(edited(text, ([a, b, c]) => [a, b, { ...c, value: { ...c.value, alpha: 0.5 } }])).toBe(
      text.replace('sf:kept="yes"', 'sf:kept="yes" stop-opacity="0.5"'),
    );
    const own = documentWith(gradient('<stop stop-color="#ff000080" stop-opacity=".5"/>'));
    expect(edited(own, ([a]) => [{ ...a, value: tint("#ff0000", 0.75) }])).toBe(
      own.replace('"#ff000080" stop-opacity=".5"', '"#f00" stop-opacity="0.75"'),
    );
  });

  test("what style says is changed there", () => {
    const text = documentWith(gradient('<stop style="stop-color: red; x: y"/><stop offset="1"/>'));
    const after = edited(text, ([a, b]) => [{ ...a, value: tint("#0000ff") }, b]);
    expect(after).toBe(text.replace("red", "#00f"));
  });

  test("a new stop stands behind the one before it, written as that one", () => {
    const text = documentWith(plain);
    const added: GradientStop = { offset: 0.75, value: tint("#abcdef", 0.25) };
    expect(edited(text, ([a, b, c]) => [a, b, added, c])).toBe(
      text.replace(
        "<!-- the middle -->",
        '<!-- the middle -->\n      <stop offset="0.75" stop-color="#abcdef" stop-opacity="0.25"/>',
      ),
    );
    const styled = documentWith(gradient('<stop offset="0%" style="stop-color:red"/><stop offset="100%"/>'));
    expect(edited(styled, ([a, b]) => [a, { ...added, offset: 0.5 }, b])).toContain(
      '<stop offset="50%" style="stop-color:#abcdef;stop-opacity:0.25"/>',
    );
  });

  test("a stop goes with its line", () => {
    const text = documentWith(plain);
    expect(edited(text, ([, b, c]) => [b, c])).toBe(
      text.replace('\n      <stop offset="0" stop-color="#f00"/>', ""),
    );
  });

  test("a stop that passes another moves in the text, with all that it bears", () => {
    const text = documentWith(plain);
    const after = edited(text, ([a, b, c]) => [a, { ...c, offset: 0.4 }, b]);
    expect(after).toContain('<stop offset="0.4" stop-color="#00f" sf:kept="yes"/>\n      <stop offset=".5"');
    expect(after.match(/<stop /g)).toHaveLength(3);
  });

  test("a stop that was drawn elsewhere than written is written where it is drawn", () => {
    const text = documentWith(gradient('<stop offset=".6"/><stop offset=".2" stop-color="#fff"/>'));
    const after = edited(text, ([a, b]) => [{ ...a, offset: 0.1 }, b]);
    expect(after).toContain('<stop offset="0.1"/><stop offset="0.6" stop-color="#fff"/>');
  });

  test("inherited stops are edited where they stand", () => {
    const text = documentWith('<linearGradient id="base"><stop stop-color="#f00"/></linearGradient><linearGradient id="sky" href="#base"/>');
    expect(edited(text, ([a]) => [{ ...a, value: tint("#0000ff") }])).toBe(text.replace("#f00", "#00f"));
  });

  test("nothing changes where nothing is to; one stop at least stays", () => {
    const drawing = openDrawing(documentWith(plain));
    expect(setGradientStops(drawing, "#sky", stopsOf(drawing.text))).toBeNull();
    expect(setGradientStops(drawing, "#sky", [])).toBeNull();
    expect(setGradientStops(drawing, "#none", stopsOf(drawing.text))).toBeNull();
  });

  test("spread is written, and goes where it is the default", () => {
    const text = documentWith(plain);
    const set = (before: string, to: "pad" | "reflect" | "repeat") => {
      const outcome = setSpread(openDrawing(before), "#sky", to);
      return outcome ? applied(before, outcome.patch) : before;
    };
    const repeated = set(text, "repeat");
    expect(repeated).toBe(text.replace('id="sky"', 'id="sky" spreadMethod="repeat"'));
    expect(set(repeated, "pad")).toBe(text);
    const inheriting = documentWith('<linearGradient id="b" spreadMethod="reflect"><stop/></linearGradient><linearGradient id="sky" href="#b"/>');
    expect(set(inheriting, "pad")).toContain('href="#b" spreadMethod="pad"');
  });

  test("a chosen stop of a gradient is deleted, but for the last one", () => {
    const part = { kind: "stop", side: "left", attribute: "color", index: 1 } as const;
    const remove = (text: string) => {
      const drawing = openDrawing(text);
      const curve = [...drawing.all()].find(({ kind }) => kind === "curve") as CurveItem;
      const outcome = deleteStop(drawing, curve, part);
      return outcome && stopsOf(applied(text, outcome.patch)).length;
    };
    expect(remove(documentWith(plain))).toBe(2);
    expect(remove(documentWith(gradient("<stop/>")))).toBeNull();
  });

  test("any stops become any others, and come back", () => {
    const random = randomNumbers(7);
    const stop = (): GradientStop => ({
      offset: Math.round(100 * random()) / 100,
      value: tint(["#ff0000", "#00ff00", "#0000ff"][Math.floor(3 * random())], random() < 0.5 ? 1 : 0.5),
    });
    const some = () =>
      Array.from({ length: 1 + Math.floor(5 * random()) }, stop).sort((a, b) => a.offset - b.offset);
    let text = documentWith(plain);
    for (let turn = 0; turn < 200; turn += 1) {
      const others = some();
      const mixed = [...stopsOf(text).filter(() => random() < 0.6), ...others].sort(
        (a, b) => a.offset - b.offset,
      );
      text = edited(text, () => (random() < 0.5 ? mixed.slice(-8) : others));
    }
  });
});
