// The exact texts after commands that change the structure.
import { expect, test } from "vitest";
import {
  deleteItems,
  duplicate,
  group,
  makeInstance,
  makeUnique,
  moveInto,
  restack,
  ungroup,
} from "../../../../web/editor/src/model/commands/index.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { CurveItem, Drawing, Item } from "../../../../web/editor/src/model/types.js";
import { mapped } from "../../../../web/editor/src/geometry/affine.js";
import { applied } from "../../../../web/editor/src/source/patch.js";
import { after, handle, named, SAMPLES } from "../drawings.js";
import { Random } from "../random.js";

const svg = (inner: string, more = "") =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 90 90" sf:version="1"${more}>${inner}</svg>`;
const layer = (inner: string) => `\n  <g id="l" sf:diffuse="true">${inner}\n  </g>\n`;
const curve = (id: string) => `<path id="${id}" d="M0 0L9 9" sf:left="red" sf:right="blue"/>`;
const [A, B, C] = ["a", "b", "c"].map(curve);

test("a deleted curve takes its line with it, and nothing else", () => {
  const text = svg(layer(`\n    ${A}\n    <!-- b -->\n\n    ${B}  \n    ${C}`));
  const gone = after(text, (d) => deleteItems(d, [handle(d, "b")]));
  expect(gone).toBe(svg(layer(`\n    ${A}\n    <!-- b -->\n\n    ${C}`)));
});

test("curves that share a line go without a hole, alone and together", () => {
  const text = svg(layer(`\n    ${A} ${B} ${C}`));
  const without = (...ids: string[]) => after(text, (d) => deleteItems(d, ids.map((id) => handle(d, id))));
  expect(without("a")).toBe(svg(layer(`\n    ${B} ${C}`)));
  expect(without("b")).toBe(svg(layer(`\n    ${A} ${C}`)));
  expect(without("c")).toBe(svg(layer(`\n    ${A} ${B}`)));
  expect(without("a", "b", "c")).toBe(svg(layer("")));
  expect(without("c", "a", "l")).toBe(svg("\n"));
});

test("a deleted layer that an instance shows goes to <defs>", () => {
  const text = svg(`\n  <g id="g">\n    <g id="l" sf:diffuse="true">${A}</g>\n  </g>\n  <use href="#l" x="3"/>\n`);
  expect(after(text, (d) => deleteItems(d, [handle(d, "g")]))).toBe(
    svg(`\n  <defs>\n    <g id="l" sf:diffuse="true">${A}</g>\n  </defs>\n  <use href="#l" x="3"/>\n`),
  );
});

test("restack moves the chosen alone, in order, and not beyond the end", () => {
  const text = svg(layer(`\n    ${A}\n    ${B}\n    ${C}`));
  const order = (steps: number, ...ids: string[]) => {
    const made = after(text, (d) => restack(d, ids.map((id) => handle(d, id)), steps));
    expect(made.length).toBe(text.length);
    return [...made.matchAll(/<path id="(.)"/g)].map(([, id]) => id).join("");
  };
  expect(order(1, "a")).toBe("bac");
  expect(order(-1, "c")).toBe("acb");
  expect(order(Infinity, "a")).toBe("bca");
  expect(order(-Infinity, "c", "b")).toBe("bca");
  expect(order(1, "b", "c")).toBe("abc");
  expect(order(1, "a", "c")).toBe("bac");
});

test("a step up and one down leave the very text", () => {
  for (const { text } of SAMPLES.filter(({ name }) => !name.startsWith("indented"))) {
    const d = openDrawing(text);
    for (const { handle: h } of openDrawing(text).all()) {
      const up = restack(d, [h], 1);
      if (!up) continue;
      d.apply(up.patch);
      const moved = d.itemAt(up.select?.[0].at ?? -1) as Item;
      d.apply(restack(d, [moved.handle], -1)?.patch ?? []);
      expect(d.text).toBe(text);
      break;
    }
  }
});

test("a group takes the place of its items, and ungrouping gives the text back", () => {
  const text = svg(layer(`\n    ${A}\n    <!-- of both -->\n    ${B}\n    ${C}`));
  const grouped = after(text, (d) => group(d, [handle(d, "a"), handle(d, "b")]));
  expect(grouped).toBe(
    svg(layer(`\n    <g>\n      ${A}\n    <!-- of both -->\n      ${B}\n    </g>\n    ${C}`)),
  );
  const back = after(grouped, (d) => ungroup(d, [(named(d, "a").parent as Item).handle]));
  expect(back).toBe(text);
});

test("items apart from each other are grouped where the topmost stands", () => {
  const text = svg(layer(`\n    ${A}\n    ${B}\n    ${C}`));
  expect(after(text, (d) => group(d, [handle(d, "a"), handle(d, "c")]))).toBe(
    svg(layer(`\n    ${B}\n    <g>\n      ${A}\n      ${C}\n    </g>`)),
  );
});

test("a group hands down what it says to an only child", () => {
  const child = '<g id="l" sf:diffuse="true" opacity=".5" transform="translate(1 2)"/>';
  const text = svg(`\n  <g id="g" opacity=".5" style="mix-blend-mode:multiply" transform="translate(10 20)" fill="red">\n    ${child}\n  </g>\n`);
  expect(after(text, (d) => ungroup(d, [handle(d, "g")]))).toBe(
    svg('\n  <g id="l" sf:diffuse="true" opacity="0.25" transform="translate(11 22)" fill="red" style="mix-blend-mode:multiply"/>\n'),
  );
});

test("a group that composites several, is named, clips or declares custom properties cannot be taken apart", () => {
  const layers = '<g id="l" sf:diffuse="true"/><g sf:diffuse="true"/>';
  for (const said of [
    'opacity=".5"',
    'style="mix-blend-mode:screen"',
    'clip-path="url(#x)"',
    'style="--x:red"',
  ]) {
    const d = openDrawing(svg(`<g id="g" ${said}>${layers}</g>`));
    expect(ungroup(d, [handle(d, "g")])).toBeNull();
  }
  const used = openDrawing(svg(`<g id="g">${layers}</g><use href="#g"/>`));
  expect(ungroup(used, [handle(used, "g")])).toBeNull();
  expect(ungroup(used, [handle(used, "l")])).toBeNull();
});

test("an instance gives its layer an id, and stands on top of it", () => {
  const text = svg(`\n  <g sf:diffuse='true'>${A}</g>\n`);
  expect(after(text, (d) => makeInstance(d, d.items[0].handle, [5, 0]))).toBe(
    svg(`\n  <g sf:diffuse='true' id='layer'>${A}</g>\n  <use href='#layer' transform='translate(5 0)'/>\n`),
  );
});

test("an instance made unique is its layer again, with ids of its own", () => {
  const text = svg(`<g id="l" sf:diffuse="true" transform="scale(2)">${A}</g><use id="u" href="#l" x="3" transform="translate(1 1)"/>`);
  expect(after(text, (d) => makeUnique(d, handle(d, "u")))).toBe(
    svg(
      `<g id="l" sf:diffuse="true" transform="scale(2)">${A}</g>` +
        `<g id="u" sf:diffuse="true" transform="matrix(2 0 0 2 4 1)">${curve("a-2")}</g>`,
    ),
  );
});

test("what an instance says besides stays around its copy", () => {
  const text = svg(`<g id="l" sf:diffuse="true">${A}</g><use href="#l" opacity=".5" y="4"/>`);
  const use = (d: Drawing) => [...d.all()].find(({ kind }) => kind === "use") as Item;
  expect(after(text, (d) => makeUnique(d, use(d).handle))).toBe(
    svg(
      `<g id="l" sf:diffuse="true">${A}</g><g transform="translate(0 4)" opacity=".5">` +
        `<g id="l-2" sf:diffuse="true">${curve("a-2")}</g></g>`,
    ),
  );
});

test("a copy refers to itself where it did", () => {
  const text = svg(`<g id="g">\n  <g id="l" sf:diffuse="true"/>\n  <use href="#l"/>\n</g>`);
  expect(after(text, (d) => duplicate(d, [handle(d, "g")], [0, 0]))).toContain(
    '<g id="g-2">\n  <g id="l-2" sf:diffuse="true"/>\n  <use href="#l-2"/>\n</g>',
  );
});

test("what does not belong into a container does not go there", () => {
  const { text } = SAMPLES[0];
  const d = openDrawing(text);
  const into = (id: string, parent: string | null) =>
    moveInto(d, [handle(d, id)], parent === null ? null : handle(d, parent), 0);
  expect(into("a", null)).toBeNull();
  expect(into("a", "plain")).toBeNull();
  expect(into("tree", "far")).toBeNull();
  expect(into("e", "far")).toBeNull();
  expect(into("near", "near")).toBeNull();
  expect(into("plain", "a")).toBeNull();
  expect(into("tree", "plain")).not.toBeNull();
  expect(into("a", "inner")).not.toBeNull();
  expect(into("far", "plain")).not.toBeNull();
});

/** Returns the points of all curves of an item, on the artboard. */
function pointsOf(item: Item): number[][] {
  const own = item.kind === "curve" || item.kind === "stroke" ? (item as CurveItem).paths : [];
  const here = own.flatMap(({ points }) => points.map((p) => [...mapped(item.artboardFromItem, p)]));
  return [...here, ...item.children.flatMap(pointsOf)];
}

test("what moves into another container stays where it is seen", () => {
  const random = new Random(8);
  let moved = 0;
  for (let i = 0; i < 400; i += 1) {
    const { text } = random.pick(SAMPLES);
    const d = openDrawing(text);
    const all = [...d.all()].filter(({ kind }) => kind !== "use");
    const [item, parent] = [random.pick(all), random.pick([null, ...all])];
    const outcome = moveInto(d, [item.handle], parent?.handle ?? null, random.below(4));
    if (!outcome) continue;
    moved += 1;
    const before = pointsOf(item);
    const made = openDrawing(applied(text, outcome.patch));
    const now = made.itemAt(outcome.select?.[0].at ?? -1) as Item;
    expect(pointsOf(now).length).toBe(before.length);
    pointsOf(now).forEach(([x, y], k) => {
      expect(Math.hypot(x - before[k][0], y - before[k][1]), `${i} ${item.name}`).toBeLessThan(1e-3);
    });
    expect(now.parent?.name).toBe(parent?.name);
  }
  expect(moved).toBeGreaterThan(50);
});
