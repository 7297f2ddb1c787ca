// Properties of all commands that change the structure, on all kinds of files.
import { expect, test } from "vitest";
import {
  addCurves,
  addLayer,
  addReference,
  copyItems,
  deleteItems,
  duplicate,
  group,
  makeInstance,
  makeUnique,
  moveInto,
  paste,
  restack,
  setPaint,
  transform,
  ungroup,
} from "../../../../web/editor/src/model/commands/index.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { Drawing, Item, Outcome } from "../../../../web/editor/src/model/types.js";
import { applied, inverse } from "../../../../web/editor/src/source/patch.js";
import { examples, SAMPLES } from "../drawings.js";
import { painter } from "../picture.js";
import { Random } from "../random.js";

const PATH = { points: [[1, 2], [3, 4], [5, 6], [7, 8]], closed: false } as const;
const RED = { kind: "stops", space: "arc", stops: [{ offset: 0, value: { r: 1, g: 0, b: 0 } }] } as const;

type Trial = (d: Drawing, items: readonly Item[], random: Random) => Outcome | null;
const handles = (items: readonly Item[]) => items.map(({ handle }) => handle);

const COMMANDS: Readonly<Record<string, Trial>> = {
  delete: (d, items) => deleteItems(d, handles(items)),
  restack: (d, items, random) => restack(d, handles(items), random.pick([1, -1, 2, Infinity, -Infinity])),
  group: (d, items) => group(d, handles(items)),
  ungroup: (d, items) => ungroup(d, handles(items)),
  duplicate: (d, items, random) => duplicate(d, handles(items), random.point(20)),
  moveInto: (d, items, random) =>
    moveInto(d, handles(items), random.chance(0.3) ? null : random.pick([...d.all()]).handle, random.below(4)),
  makeInstance: (d, [item], random) => makeInstance(d, item.handle, random.point(20)),
  makeUnique: (d, [item]) => makeUnique(d, item.handle),
  transform: (d, items, random) =>
    transform(d, handles(items), [...Array(4)].map(() => random.between(-2, 2)).concat(random.point(9)), 0.001),
  paste: (d, items, random) => {
    const into = random.chance(0.3) ? null : random.pick([...d.all()]).handle;
    return paste(d, copyItems(d, handles(items)), into);
  },
  addCurves: (d, [item], random) =>
    addCurves(d, random.chance(0.2) ? null : item.handle, [{ path: PATH, left: RED, right: RED }], 0.01),
  addStroke: (d, [item]) =>
    addCurves(d, item.handle, [
      { path: PATH, left: RED, right: RED, radius: { kind: "stops", space: "arc", stops: [{ offset: 0, value: 3 }] } },
    ], 0.01),
  addLayer: (d, [item]) => addLayer(d, item.handle, "Néw läyer & <more>"),
  addReference: (d) => addReference(d, "photo & me.png", 300, 200),
  setPaint: (d, [item]) =>
    setPaint(d, item.handle, "left", "color", { kind: "texture", href: "a.png", width: 4, height: 5 }),
};

function blankLines(text: string): number {
  return text.split(/\r?\n/).filter((line) => line.trim() === "").length;
}

/** Commands that copy whole lines, including blank ones. */
const COPY = ["duplicate", "paste", "makeUnique"];
/** Commands for items of one kind. */
const KINDS: Readonly<Record<string, Item["kind"]>> = { ungroup: "group", makeUnique: "use" };

const texts = [...SAMPLES, ...examples().filter(({ text }) => text.length < 40000)];

test.each(Object.keys(COMMANDS))("%s: what it makes can be read, undone and selected", async (name) => {
  const module = await painter();
  const random = new Random(name.length * 977 + 5);
  let done = 0;
  for (let i = 0; i < 150; i += 1) {
    const { text } = random.pick(texts);
    const d = openDrawing(text);
    const all = [...d.all()].filter(({ kind }) => kind === (KINDS[name] ?? kind));
    if (all.length === 0) continue;
    const items = [...Array(1 + random.below(3))].map(() => random.pick(all));
    const outcome = COMMANDS[name](d, items, random);
    if (!outcome) continue;
    done += 1;
    const context = `${name} ${i} of ${items.map((item) => item.name).join(", ")}`;
    const after = applied(text, outcome.patch);
    expect(after, context).not.toBe(text);
    expect(applied(after, inverse(outcome.patch)), context).toBe(text);
    if (!COPY.includes(name)) expect(blankLines(after), context).toBeLessThanOrEqual(blankLines(text));
    if (text.includes("\r\n")) expect(after, context).not.toMatch(/[^\r]\n/);
    expect(() => module?.read(after), `${context}\n${after}`).not.toThrow();
    d.apply(outcome.patch);
    const fresh = openDrawing(after);
    expect([...d.all()].length, context).toBe([...fresh.all()].length);
    for (const { at } of outcome.select ?? []) expect(d.itemAt(at), context).toBeDefined();
    const ids = [...after.matchAll(/\bid=["']([^"']*)/g)].map(([, id]) => id);
    expect(new Set(ids).size, context).toBe(ids.length);
  }
  expect(done).toBeGreaterThan(20);
}, 60_000);

test.each(Object.keys(COMMANDS))("%s: of items that are not there, or not fit for it, says so", (name) => {
  const d = openDrawing('<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" sf:diffuse="true"/>');
  const outcome = COMMANDS[name](d, [...d.all()], new Random(1));
  if (outcome) expect(() => openDrawing(applied(d.text, outcome.patch))).not.toThrow();
});
